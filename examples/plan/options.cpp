// SPDX-License-Identifier: MIT
#include "options.hpp"

#include <CLI/CLI.hpp>
#include <string_view>

#include "help.hpp"
#include "input_options.hpp"
#include "usage_error.hpp"

namespace plan_program {

namespace {

void define_ends(CLI::App& app, Arguments& args) {
  app.add_option(
      "--start", args.start,
      "Start, as X,Y in metres, or X,Y,DEG with a heading in degrees, measured from the x "
      "axis of the map's frame towards its y axis (of .map files: downwards)");
  app.add_option("--goal", args.goals,
                 "Goal, as X,Y or X,Y,DEG; may be repeated. Default: every goal given")
      ->allow_extra_args(false);
}

void define_vehicle(CLI::App& app, Arguments& args) {
  app.add_option_function<std::string>(
      "--turning-radius",
      [&args](const std::string& text) {
        args.vehicle.turning_radius = parse_turning_radius(text);
      },
      "Plan for a vehicle with this least turning radius in metres; 0: it turns on the spot. A "
      "heading, --reverse and --footprint mean a vehicle, too; its default radius is 1");
  app.add_flag("--reverse", args.vehicle.reverse, "The vehicle may drive backwards");
  app.add_option_function<std::string>(
      "--footprint",
      [&args](const std::string& text) { args.vehicle.footprint = parse_footprint(text); },
      "Discs of the vehicle, which keep the safety radius, in metres: disc:R, car:L,W,WB (length, "
      "width, wheelbase; the middle of the rear axle is planned) or 'discs:X,Y,R;X,Y,R;...' (X "
      "ahead, Y to the left). Default: a point");
}

/// Takes the headings out of --start and --goal.
void split_headings(Arguments& args) {
  VehicleArguments& vehicle = args.vehicle;
  if (!args.start.empty()) vehicle.start_heading = split_heading("--start", args.start);
  for (std::string& goal : args.goals) {
    vehicle.goal_headings.push_back(split_heading("--goal", goal));
  }
}

void define_planning_options(CLI::App& app, Arguments& args) {
  app.add_option("--search", args.search,
                 "Search, or a comma list of them, with options as NAME:OPTION=VALUE,... "
                 "(any_angle: on grids). Default: auto; for a vehicle hybrid_astar");
  app.add_option("--smoother", args.smoother,
                 "Smoother, or a comma list of them, with options as for --search; A+B is a "
                 "pipeline: B smooths the result of A. Default: clothoid; for a vehicle "
                 "vehicle_shortcut");
  app.add_option("--seed", args.seed, "Seed for searches that draw random numbers");
  app.add_option("--time-limit", args.time_limit, "Seconds per query");
}

void define_output_options(CLI::App& app, Arguments& args) {
  app.add_option("--json", args.json, "Write the results as JSON; - for stdout");
  app.add_option("--svg", args.svg, "Draw the plans");
  app.add_option_function<std::string>(
      "--show", [&args](const std::string& text) { args.show = parse_shown_parts(text); },
      "What --svg draws besides map, routes and curves: a comma list of visited, tree, zones, "
      "passages, profile, footprint. Default: tree,zones,passages,footprint");
  app.add_option("--steps", args.steps,
                 "Draw the search in so many pictures side by side, the last one with the result")
      ->check(CLI::Range(2, 12));
  app.add_flag("--animate", args.animate, "Draw an animated picture of the search and its result");
  app.add_flag("--smoothing-steps", args.smoothing_steps,
               "Draw the smoothing in three pictures side by side: the route, how the curve is "
               "built, and where it comes nearest to an obstacle");
  app.add_option(
      "--trace", args.trace,
      "Write the events of the searches, one line of JSON each; NAME.trace.json: one search for "
      "Posthoc");
  app.add_flag("--compare", args.compare,
               "All searches with the smoother, and all smoothers with the search");
  app.add_flag("--list", args.list, "Print the names of searches and smoothers");
}

/// The picture is of a curve, not of its search.
void check_smoothing_steps(const Arguments& args) {
  const std::string option = "--smoothing-steps: ";
  if (args.smoother == "none") throw UsageError{option + "--smoother none smooths nothing"};
  if (args.show && args.show->has_search()) {
    throw UsageError{option + "it draws no search; --show takes zones, profile and footprint"};
  }
}

/// Pictures of how a plan comes about are of one query.
void check_proceeding(const Arguments& args) {
  const std::string option = args.proceeding_option();
  if (option.empty()) return;
  if (args.steps && args.animate) throw UsageError{"--steps and --animate are two pictures"};
  if (args.smoothing_steps && option != "--smoothing-steps") {
    throw UsageError{option + " and --smoothing-steps are two pictures"};
  }
  if (args.svg.empty()) throw UsageError{option + ": give --svg FILE, too"};
  if (args.compare) throw UsageError{option + ": --compare runs many searches"};
  if (args.goals.size() > 1) throw UsageError{option + ": give one --goal alone"};
  if (args.smoothing_steps) return check_smoothing_steps(args);
  if (args.show && args.show->profile) throw UsageError{option + ": it has no profile to --show"};
}

/// Throws a UsageError for a --show that no picture can obey.
void check_shown_parts(const Arguments& args) {
  if (!args.show) return;
  if (args.svg.empty()) throw UsageError{"--show is for a picture; give --svg FILE"};
  if (args.compare && args.show->has_search()) {
    throw UsageError{
        "--compare draws curves of many searches; --show takes zones, profile and footprint there"};
  }
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

}  // namespace

std::optional<Arguments> parse_command_line(int argc, const char* const* argv) {
  CLI::App app{
      "Plans safe, smooth, short paths for a disc-shaped robot or a vehicle; every path is "
      "proved.",
      "tutavia-plan"};
  app.footer("--help-NAME prints the options of a search or a smoother: --help-rrt_star");
  Arguments args;
  if (const auto topic = help_topic(argc, argv)) {
    print_help_of(*topic);
    return std::nullopt;
  }
  define_input_options(app, args);
  define_ends(app, args);
  define_vehicle(app, args);
  define_planning_options(app, args);
  define_output_options(app, args);
  if (!parse(app, argc, argv)) return std::nullopt;
  check_proceeding(args);
  check_shown_parts(args);
  split_headings(args);
  check_vehicle(args.vehicle);
  unknown_cost(args);
  if (argc == 1) args.svg = "maze.svg";
  return args;
}

}  // namespace plan_program
