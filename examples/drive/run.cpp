// SPDX-License-Identifier: MIT
#include "run.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <string>
#include <variant>

#include "../plan/input.hpp"
#include "../plan/usage_error.hpp"
#include "animation.hpp"
#include "csv_output.hpp"
#include "drive.hpp"
#include "tutavia/core/parts/number_text.hpp"

namespace drive_program {

namespace {

using plan_program::MapFrame;
using plan_program::Task;

/// Rewrites one line on stderr; nothing where no terminal shows it.
Progress progress_on_terminal() {
  if (::isatty(STDERR_FILENO) == 0) return {};
  return [](double time, double length) {
    const auto periods = std::lround(time * 10);
    if (periods % 50 == 0) std::fprintf(stderr, "\r%8.1f s  %8.2f m\r", time, length);
  };
}

void print_row(const char* name, const std::string& value) {
  std::printf("%-14s %s\n", name, value.c_str());
}

std::string in_metres(double x, int digits = 2) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f m", digits, x);
  return text;
}

void print_task(const Task& task, const Arguments& args, const Drive& drive) {
  using tutavia::detail::number_text;
  print_row("map", task.scene.name.empty() ? args.input.workspace : task.scene.name);
  print_row("safety radius", number_text(task.scene.workspace.safety_radius) + " m");
  print_row("controller", std::string(to_string(args.controller)));
  std::string path = in_metres(drive.path.curve.length());
  path += drive.path.margin > 0
              ? ", " + number_text(drive.path.margin) + " m and more beyond the safety radius"
              : ", without room beyond the safety radius";
  print_row("path", path);
}

void print_result(const DriveResult& result, std::size_t appeared) {
  std::string ending(to_string(result.ending));
  if (!result.reason.empty()) ending += ": " + result.reason;
  print_row("result", ending);
  if (result.is_connected) {
    print_row("way to goal", *result.is_connected ? "left open by what stays" : "closed");
  }
  char time[64];
  std::snprintf(time, sizeof time, "%.1f s", result.time);
  print_row("time", time);
  print_row("driven", in_metres(result.length));
  print_row("least gap", in_metres(result.min_clearance, 3));
  print_row("obstacles", std::to_string(appeared) + " appeared");
  print_row("contacts", std::to_string(result.own_contacts) + " of its own, driven into " +
                            std::to_string(result.driven_into) + " times");
  print_row("emergencies", std::to_string(result.emergencies));
  print_row("replans", std::to_string(result.replans));
  print_row("limits", std::to_string(result.limit_violations) + " violations");
}

/// Converts what is drawn and written to the frame of the map.
void to_map(const MapFrame& frame, Drive& drive) {
  if (!frame.is_turned()) return;
  for (TraceRow& row : drive.result.trace) {
    row.pose.position = frame.to_map(row.pose.position);
    row.pose.heading += frame.yaw();
  }
  drive.path.curve = frame.to_map(drive.path.curve);
  for (FollowedPath& path : drive.result.paths) path.curve = frame.to_map(path.curve);
  const Point origin = frame.to_map(Point(0, 0));
  for (Encounter& e : drive.encounters) {
    e.obstacle.velocity = frame.to_map(e.obstacle.velocity) - origin;
    if (Disc* disc = std::get_if<Disc>(&e.obstacle.shape)) {
      disc->center = frame.to_map(disc->center);
    } else {
      for (Point& p : std::get<Polygon>(e.obstacle.shape).outer) p = frame.to_map(p);
    }
  }
}

}  // namespace

int run(const Arguments& args) {
  const Task task = plan_program::load_task(args.input);
  if (!(task.scene.workspace.safety_radius > 0)) {
    throw plan_program::UsageError{"a robot needs a size: give --radius R"};
  }
  const Progress progress = progress_on_terminal();
  auto drive = std::visit(
      [&](const auto& space) { return drive_program::drive(space, task, args, progress); },
      task.space);
  if (!drive) {
    const auto shown = task.frame.to_map(Expected<Plan, Failure>(Unexpected{drive.error()}));
    std::cout << "no path: " << shown.error() << '\n';
    return 1;
  }
  print_task(task, args, *drive);
  print_result(drive->result, drive->encounters.size());
  std::fflush(stdout);
  to_map(task.frame, *drive);
  if (!args.csv.empty()) write_csv(args.csv, drive->result.trace);
  if (!args.svg.empty()) write_animation(args.svg, task, *drive);
  return drive->result.ending == Ending::reached ? 0 : 1;
}

}  // namespace drive_program
