// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tutavia/planner.hpp"
#include "tutavia/search/search_record.hpp"

/// \file
/// Result: one query and its answer.

namespace plan_program {

using namespace tutavia;

/// The answer for one goal, with everything that tables, files and pictures show of it.
struct Result {
  std::string search;
  std::string smoother;
  Point goal;
  Expected<Plan, Failure> plan;
  std::optional<double> optimum{};      ///< length of the shortest path [m], if it is known
  std::optional<double> taut_length{};  ///< of the route when pulled taut [m], if it is asked for
  std::vector<SearchRecord::Event> drawings{};  ///< parts of the search that the picture shows
};

/// The results of one search with one smoother for every goal.
using Group = std::vector<Result>;

}  // namespace plan_program
