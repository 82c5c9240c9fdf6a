// SPDX-License-Identifier: MIT
#include "input_options.hpp"

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "text_arguments.hpp"
#include "tutavia/registry/movement_name.hpp"
#include "tutavia/registry/nearest_name.hpp"
#include "usage_error.hpp"

namespace plan_program {

namespace {

/// What is wrong with an argument that is no option.
std::string unexpected_argument(const CLI::App& app, const std::string& argument) {
  const std::string name = argument.substr(0, argument.find('='));
  if (name.rfind("--", 0) != 0) return "unexpected argument \"" + argument + "\"";
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& known : option->get_lnames()) names.push_back(known);
  }
  const auto nearest = tutavia::nearest_name(std::string_view(name).substr(2), names);
  std::string message = "unknown option " + name;
  return message + (nearest ? "; did you mean --" + *nearest + "?" : "; see --help");
}

}  // namespace

void define_input_options(CLI::App& app, Arguments& args) {
  auto* map = app.add_option("--map", args.map,
                             "Built-in map: array, complex, maze, rrt_scene_1 or rrt_scene_2");
  app.add_option("--workspace", args.workspace, "Workspace file (.json, .geojson, .wkt or .csv)")
      ->excludes(map);
  app.add_option("--wkt-column", args.wkt_column, "The column of a .csv file that holds WKT");
  app.add_option("--grid", args.grid, "Grid map: MovingAI (.map) or ROS map_server (.yaml)")
      ->excludes(map)
      ->excludes("--workspace");
  app.add_option("--unknown", args.unknown,
                 "Unknown cells of a ROS map: blocked, free, or cost:N for cells that auto, astar "
                 "and dijkstra cross at N times their length")
      ->capture_default_str();
  app.add_option("--terrain", args.terrain,
                 "Swamp and water (S, W) of a MovingAI map: refused, blocked or free")
      ->capture_default_str()
      ->check(CLI::IsMember({"refused", "blocked", "free"}));
  app.add_option("--radius", args.radius, "Safety radius in metres");
  app.add_option("--bounds", args.bounds, "Bounds as X0,Y0,X1,Y1 in metres");
  app.add_flag("--strict", args.strict, "Reject polygons that cross themselves");
  app.add_option("--resolution", args.resolution, "Lattice spacing in metres");
  app.add_option_function<std::string>(
      "--movement",
      [&args](const std::string& text) {
        auto rule = tutavia::parse_movement_rule(text);
        if (!rule) throw UsageError{"--movement: " + rule.error().detail};
        args.movement = *rule;
      },
      "Diagonal steps: no_cut (default), no_squeeze, allow, or four_connected for none");
  app.add_option_function<std::string>(
      "--edges",
      [&args](const std::string& text) {
        auto rule = tutavia::parse_edge_rule(text);
        if (!rule) throw UsageError{"--edges: " + rule.error().detail};
        args.edges = *rule;
      },
      "Lattice edges: uniform (default), or paper_strict as in the DSP paper");
  app.add_option("--buffer", args.buffer,
                 "With --grid: also block the cells within this many cells of a blocked one; the "
                 "cells of start and goals stay free");
}

bool parse(CLI::App& app, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError& error) {
    const std::vector<std::string> extras = app.remaining();
    throw UsageError{extras.empty() ? error.what() : unexpected_argument(app, extras.front())};
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw UsageError{error.what()};
    app.exit(error);  // --help
    return false;
  }
  return true;
}

std::optional<double> unknown_cost(const Arguments& args) {
  if (args.unknown == "blocked" || args.unknown == "free") return std::nullopt;
  constexpr std::string_view prefix = "cost:";
  const std::string_view text = args.unknown;
  if (text.substr(0, prefix.size()) != prefix) {
    throw UsageError{"--unknown: expected blocked, free or cost:N, got \"" + args.unknown + "\""};
  }
  const auto factor = parse_number(text.substr(prefix.size()));
  if (!factor || !(*factor >= 1 && *factor <= 8.96)) {
    throw UsageError{"--unknown cost:N: expected N from 1 to 8.96, got \"" + args.unknown + "\""};
  }
  return factor;
}

}  // namespace plan_program
