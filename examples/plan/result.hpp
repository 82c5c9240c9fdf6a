// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tutavia/planner.hpp"
#include "tutavia/search/search_record.hpp"

/// \file
/// Result: one query and its result.

namespace plan_program {

using namespace tutavia;

/// The result for one goal, with all data for tables, files and pictures.
struct Result {
  std::string search;
  std::string smoother;
  Point goal;
  Expected<Plan, Failure> plan;
  std::optional<double> optimum{};              ///< length of the shortest path [m], if it is known
  std::optional<double> taut_length{};          ///< of the route when pulled taut [m], if requested
  std::vector<SearchRecord::Event> drawings{};  ///< events of the search for the picture
};

/// The results of one search with one smoother for every goal.
using Group = std::vector<Result>;

}  // namespace plan_program
