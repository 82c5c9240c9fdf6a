// SPDX-License-Identifier: MIT
#include "pictures.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <variant>

#include "planning_space.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/io/svg.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "usage_error.hpp"

namespace plan_program {

namespace {

/// A run of blocked cells from `first` to `last`, the same in all rows from `from_row` on.
struct Run {
  int first, last, from_row;
};

std::vector<Run> blocked_runs(const OccupancyGrid& cells, int y) {
  std::vector<Run> runs;
  if (y == cells.height()) return runs;
  cells.for_each_run(y, false, [&](int first, int last) { runs.push_back({first, last, y}); });
  return runs;
}

/// The blocked cells as rectangles. Runs of equal extent in neighbouring rows share one.
std::vector<Box> blocked_boxes(const OccupancyGrid& cells, const Point& origin, double side) {
  std::vector<Box> boxes;
  std::vector<Run> open;
  for (int y = 0; y <= cells.height(); ++y) {
    std::vector<Run> row = blocked_runs(cells, y);
    for (const Run& run : open) {
      const auto same = std::find_if(row.begin(), row.end(), [&](const Run& other) {
        return other.first == run.first && other.last == run.last;
      });
      if (same != row.end()) {
        same->from_row = run.from_row;
        continue;
      }
      boxes.push_back(
          {origin + side * Point(run.first, run.from_row), origin + side * Point(run.last + 1, y)});
    }
    open = std::move(row);
  }
  return boxes;
}

/// A grid where just those cells are blocked that are so in `cells` and not in `before`.
OccupancyGrid newly_blocked(OccupancyGrid cells, const OccupancyGrid& before) {
  for (int y = 0; y < before.height(); ++y) {
    before.for_each_run(y, false,
                        [&](int first, int last) { cells.set_run(y, first, last, true); });
  }
  return cells;
}

/// Adds the blocked cells as obstacles, and the buffer as an area of its own.
void add_cells(const Task& task, const CellSpace& space, Workspace& workspace,
               SvgOptions& options) {
  const Point origin = space.bounds().min;
  const double side = space.frame().resolution;
  const OccupancyGrid& map = task.without_buffer ? *task.without_buffer : space.cells();
  for (const Box& box : blocked_boxes(map, origin, side)) {
    workspace.obstacles.emplace_back(Polygon{
        {box.min, Point{box.max.x(), box.min.y()}, box.max, Point{box.min.x(), box.max.y()}}});
  }
  if (!task.without_buffer) return;
  options.buffer = blocked_boxes(newly_blocked(space.cells(), map), origin, side);
}

/// What the legend and the notes call a result.
std::string label_of(const Result& result, std::size_t goals) {
  const std::string name = result.search + ", " + result.smoother;
  return goals > 1 ? name + ", to " + detail::to_text(result.goal) : name;
}

/// Marks a goal without a plan.
void add_failure(const Task& task, const Result& result, std::size_t goals, SvgOptions& options) {
  options.starts = {task.scene.start};
  options.goals.push_back(result.goal);
  options.notes.push_back(label_of(result, goals) + ": no plan (" +
                          std::string(to_string(result.plan.error().code)) + ")");
}

void add_critical_corners(const Task& task, const Result& result, SvgOptions& options) {
  if (result.algorithms.smoother != DeltaSmoother::name) return;
  const auto corners = critical_corners_of(task.space, result.plan->route.curve,
                                           result.algorithms.smoother_options.front());
  options.critical_corners.insert(options.critical_corners.end(), corners.begin(), corners.end());
}

}  // namespace

void draw(const Arguments& args, const Task& task, std::vector<Group> groups) {
  const ShownParts shown = args.show.value_or(default_parts());
  Workspace workspace = task.scene.workspace;
  SvgOptions options{.zones = shown.zones,
                     .risk_zones = shown.zones && (args.show || !args.compare),
                     .profile = shown.profile,
                     .title = task.scene.name,
                     .y_down = task.y_down};
  std::visit([&](const auto& space) { options.cell_size = space.frame().resolution; }, task.space);
  if (const auto* cells = std::get_if<CellSpace>(&task.space)) {
    add_cells(task, *cells, workspace, options);
  }
  std::vector<Plan> plans;
  std::set<std::string> searches;  // those already drawn: every smoother has the same
  for (Group& group : groups) {
    const bool is_new = searches.insert(group.front().search).second;
    for (Result& result : group) {
      if (is_new) {
        add_search(options, result.drawings, result.plan ? result.plan->route.curve : Curve{});
      }
      if (!result.plan) {
        add_failure(task, result, group.size(), options);
        continue;
      }
      add_critical_corners(task, result, options);
      options.labels.push_back(label_of(result, group.size()));
      plans.push_back(std::move(*result.plan));
    }
  }
  throw_failure(write_svg(args.svg, workspace, plans, options));
}

}  // namespace plan_program
