// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/registry/option_value.hpp"
#include "tutavia/search/search_record.hpp"

/// \file
/// Result: one query and its result.

namespace plan_program {

using namespace tutavia;

/// The algorithms of a result, by their plain names, with all their options.
struct UsedAlgorithms {
  std::string search;
  std::string smoother;
  OptionSettings search_options{};
  std::vector<OptionSettings> smoother_options{};  ///< of each stage of a pipeline
  bool for_vehicle = false;                        ///< whether the search plans headings
};

/// The result for one goal, with all data for tables, files and pictures; in the map's frame.
struct Result {
  std::string search;    ///< as the user wrote it, with the options given
  std::string smoother;  ///< the same
  UsedAlgorithms algorithms;
  Point goal;
  Expected<Plan, Failure> plan;
  std::optional<double> optimum{};      ///< length of the shortest path [m], if it is known
  std::optional<double> taut_length{};  ///< of the route when pulled taut [m], if requested
  /// What the search recorded for the picture, in the frame of the grid.
  SearchRecord drawings{};
  Curve route_in_grid{};  ///< the route in the frame of the grid; empty without a plan
};

/// The results of one search with one smoother for every goal.
using Group = std::vector<Result>;

}  // namespace plan_program
