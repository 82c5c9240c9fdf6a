// SPDX-License-Identifier: MIT
#include "options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>
#include <utility>

#include "help.hpp"
#include "tutavia/registry/movement_name.hpp"
#include "tutavia/registry/nearest_name.hpp"
#include "usage_error.hpp"

namespace plan_program {

namespace {

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
  app.add_option("--start", args.start, "Start, as X,Y in metres");
  app.add_option("--goal", args.goals, "Goal, as X,Y; may be repeated. Default: every goal given")
      ->allow_extra_args(false);
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

void define_planning_options(CLI::App& app, Arguments& args) {
  app.add_option("--search", args.search,
                 "Search, or a comma list of them, with options as NAME:OPTION=VALUE,... "
                 "(any_angle: on grids)")
      ->capture_default_str();
  app.add_option("--smoother", args.smoother,
                 "Smoother, or a comma list of them, with options as for --search; A+B is a "
                 "pipeline: B smooths the result of A")
      ->capture_default_str();
  app.add_option("--seed", args.seed, "Seed for searches that draw random numbers");
  app.add_option("--time-limit", args.time_limit, "Seconds per query");
}

void define_output_options(CLI::App& app, Arguments& args) {
  app.add_option("--json", args.json, "Write the results as JSON; - for stdout");
  app.add_option("--svg", args.svg, "Draw the plans");
  app.add_option_function<std::string>(
      "--show", [&args](const std::string& text) { args.show = parse_shown_parts(text); },
      "What --svg draws besides map, routes and curves: a comma list of visited, tree, zones, "
      "passages, profile. Default: tree,zones,passages");
  app.add_option("--trace", args.trace, "Write the events of the searches, one line of JSON each");
  app.add_flag("--compare", args.compare,
               "All searches with the smoother, and all smoothers with the search");
  app.add_flag("--list", args.list, "Print the names of searches and smoothers");
}

/// Throws a UsageError for a --show that no picture can obey.
void check_shown_parts(const Arguments& args) {
  if (!args.show) return;
  if (args.svg.empty()) throw UsageError{"--show is for a picture; give --svg FILE"};
  const bool shows_search = args.show->visited || args.show->tree || args.show->passages;
  if (args.compare && shows_search) {
    throw UsageError{
        "--compare draws curves of many searches; --show takes zones and profile there"};
  }
}

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

/// The NAME of an argument --help-NAME.
std::optional<std::string> help_topic(int argc, const char* const* argv) {
  constexpr std::string_view prefix = "--help-";
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument.substr(0, prefix.size()) == prefix) {
      return std::string(argument.substr(prefix.size()));
    }
  }
  return std::nullopt;
}

std::optional<double> parse_number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<Arguments> parse_command_line(int argc, const char* const* argv) {
  CLI::App app{"Plans safe, smooth, short paths for a disc-shaped robot; every path is proved.",
               "tutavia-plan"};
  app.footer("--help-NAME prints the options of a search or a smoother: --help-rrt_star");
  Arguments args;
  if (const auto topic = help_topic(argc, argv)) {
    print_help_of(*topic);
    return std::nullopt;
  }
  define_input_options(app, args);
  define_planning_options(app, args);
  define_output_options(app, args);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError& error) {
    const std::vector<std::string> extras = app.remaining();
    throw UsageError{extras.empty() ? error.what() : unexpected_argument(app, extras.front())};
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw UsageError{error.what()};
    app.exit(error);  // --help
    return std::nullopt;
  }
  check_shown_parts(args);
  unknown_cost(args);
  if (argc == 1) args.svg = "maze.svg";
  return args;
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

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

std::vector<double> parse_numbers(const std::string& option, const std::string& text,
                                  std::size_t count, const char* form) {
  const std::vector<std::string> parts = split(text, ',');
  std::vector<double> numbers;
  for (const std::string& part : parts) {
    const auto number = parse_number(part);
    if (number && std::isfinite(*number)) numbers.push_back(*number);
  }
  if (parts.size() == count && numbers.size() == count) return numbers;
  throw UsageError{option + ": expected " + form + " with finite numbers, got \"" + text + "\""};
}

Point parse_point(const std::string& option, const std::string& text) {
  const std::vector<double> numbers = parse_numbers(option, text, 2, "X,Y");
  return {numbers[0], numbers[1]};
}

}  // namespace plan_program
