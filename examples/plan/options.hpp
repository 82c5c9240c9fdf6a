// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "shown_parts.hpp"
#include "tutavia/grid/movement.hpp"
#include "tutavia/space/lattice_space.hpp"
#include "vehicle_arguments.hpp"

/// \file
/// The command line of tutavia-plan.

namespace plan_program {

/// The options as given. An empty text means that the option was not given.
struct Arguments {
  std::string program = "tutavia-plan";  ///< its name in warnings
  std::string map{};
  std::string workspace{};
  std::string wkt_column{};
  std::string grid{};
  std::string unknown = "blocked";  ///< or free, or cost:N
  std::string terrain = "refused";
  std::string start{};
  std::vector<std::string> goals{};
  std::optional<double> radius{};
  std::string bounds{};
  bool strict = false;
  std::optional<double> resolution{};
  tutavia::MovementRule movement = tutavia::MovementRule::no_cut;
  tutavia::EdgeRule edges = tutavia::EdgeRule::uniform;
  std::optional<int> buffer{};            ///< [cells]
  std::optional<std::string> search{};    ///< default: auto, or hybrid_astar for a vehicle
  std::optional<std::string> smoother{};  ///< default: clothoid, or vehicle_shortcut for a vehicle
  VehicleArguments vehicle{};
  std::uint64_t seed = 0;
  std::optional<double> time_limit{};
  std::string json{};
  std::string svg{};
  std::optional<int> steps{};        ///< panels of the picture
  bool animate = false;              ///< the picture
  bool smoothing_steps = false;      ///< the picture shows how the route is smoothed
  std::optional<ShownParts> show{};  ///< in the picture; default: default_parts()
  std::string trace{};
  bool compare = false;
  bool list = false;

  /// Whether stdout shows tables; `--json -` puts the results there instead.
  bool prints_tables() const { return json != "-"; }
  /// The option that asks for a picture of how one plan comes about; empty without one.
  std::string proceeding_option() const {
    return steps ? "--steps" : animate ? "--animate" : smoothing_steps ? "--smoothing-steps" : "";
  }
  /// What the picture shows. One of how a search proceeds shows visited nodes if not told
  /// otherwise.
  ShownParts shown() const {
    ShownParts parts = show.value_or(default_parts());
    if (!show && (animate || steps)) parts.visited = true;
    return parts;
  }
};

/// Reads the command line. For --help and --help-NAME it prints the help and returns nothing.
/// Without any option the picture goes to maze.svg. Throws UsageError.
std::optional<Arguments> parse_command_line(int argc, const char* const* argv);

}  // namespace plan_program
