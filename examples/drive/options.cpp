// SPDX-License-Identifier: MIT
#include "options.hpp"

#include <CLI/CLI.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "../plan/input_options.hpp"
#include "../plan/text_arguments.hpp"
#include "../plan/usage_error.hpp"

namespace drive_program {

namespace {

using plan_program::UsageError;

void define_options(CLI::App& app, Arguments& args, std::string& start, std::string& goal) {
  plan_program::define_input_options(app, args.input);
  app.add_option("--start", start, "Start, as X,Y in metres, or X,Y,DEG with a heading in degrees");
  app.add_option("--goal", goal, "Goal, as X,Y in metres. Default: the first one of the map");
  app.add_option_function<std::string>(
      "--controller",
      [&args](const std::string& text) {
        if (text != "band" && text != "pursuit") {
          throw UsageError{"--controller: unknown name \"" + text + "\" (band or pursuit)"};
        }
        args.controller = text == "band" ? ControllerKind::band : ControllerKind::pursuit;
      },
      "What drives the robot: band (default; drives around obstacles) or pursuit (stops, and asks "
      "for another path)");
  app.add_option("--obstacles", args.obstacles, "How many obstacles appear in front of the robot")
      ->check(CLI::Range(0, 1000));
  app.add_option("--seed", args.seed, "Seed for the obstacles and the noise");
  app.add_option("--noise", args.noise,
                 "Bound on the odometry's error, in metres for the position and radians for the "
                 "heading")
      ->check(CLI::Range(0.0, 1.0));
  app.add_option("--latency", args.latency, "Seconds until a command takes effect")
      ->check(CLI::Range(0.0, 2.0));
  app.add_option("--time-limit", args.time_limit, "Seconds that the robot may drive")
      ->check(CLI::PositiveNumber);
  app.add_option("--csv", args.csv, "Write the drive, one line per period");
  app.add_option("--svg", args.svg, "Draw the drive as an animated picture");
}

/// Splits off the heading of X,Y,DEG.
void read_start(const std::string& text, Arguments& args) {
  if (plan_program::split(text, ',').size() != 3) {
    args.input.start = text;
    return;
  }
  const auto numbers = plan_program::parse_numbers("--start", text, 3, "X,Y or X,Y,DEG");
  args.heading = numbers[2] * std::numbers::pi / 180;
  args.input.start = text.substr(0, text.rfind(','));
}

}  // namespace

std::optional<Arguments> parse_command_line(int argc, const char* const* argv) {
  CLI::App app{"Drives a simulated robot along a proved path while obstacles appear.",
               "tutavia-drive"};
  Arguments args;
  args.input.program = "tutavia-drive";
  std::string start, goal;
  define_options(app, args, start, goal);
  if (!plan_program::parse(app, argc, argv)) return std::nullopt;
  if (plan_program::unknown_cost(args.input)) {
    throw UsageError{"--unknown: tutavia-drive takes blocked or free"};
  }
  if (!start.empty()) read_start(start, args);
  if (!goal.empty()) args.input.goals = {goal};
  return args;
}

}  // namespace drive_program
