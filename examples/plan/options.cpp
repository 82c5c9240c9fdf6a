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
  app.add_option("--start", args.start, "Start, as X,Y in metres");
  app.add_option("--goal", args.goals, "Goal, as X,Y; may be repeated. Default: every goal given")
      ->allow_extra_args(false);
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
  CLI::App app{"Plans safe, smooth, short paths for a disc-shaped robot; every path is proved.",
               "tutavia-plan"};
  app.footer("--help-NAME prints the options of a search or a smoother: --help-rrt_star");
  Arguments args;
  if (const auto topic = help_topic(argc, argv)) {
    print_help_of(*topic);
    return std::nullopt;
  }
  define_input_options(app, args);
  define_ends(app, args);
  define_planning_options(app, args);
  define_output_options(app, args);
  if (!parse(app, argc, argv)) return std::nullopt;
  check_shown_parts(args);
  unknown_cost(args);
  if (argc == 1) args.svg = "maze.svg";
  return args;
}

}  // namespace plan_program
