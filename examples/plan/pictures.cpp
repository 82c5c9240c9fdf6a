// SPDX-License-Identifier: MIT
#include "pictures.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "planning_space.hpp"
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
std::vector<Obstacle> blocked_rectangles(const CellSpace& space) {
  std::vector<Obstacle> rectangles;
  const double side = space.frame().resolution;
  const Point origin = space.bounds().min;
  std::vector<Run> open;
  for (int y = 0; y <= space.cells().height(); ++y) {
    std::vector<Run> row = blocked_runs(space.cells(), y);
    for (const Run& run : open) {
      const auto same = std::find_if(row.begin(), row.end(), [&](const Run& other) {
        return other.first == run.first && other.last == run.last;
      });
      if (same != row.end()) {
        same->from_row = run.from_row;
        continue;
      }
      const Point low = origin + side * Point(run.first, run.from_row);
      const Point high = origin + side * Point(run.last + 1, y);
      rectangles.emplace_back(
          Polygon{{low, Point{high.x(), low.y()}, high, Point{low.x(), high.y()}}});
    }
    open = std::move(row);
  }
  return rectangles;
}

void add_event(const SearchRecord::Event& event, SvgOptions& options) {
  const auto& [kind, a, b, side] = event;
  if (kind == SearchRecord::Event::Kind::edge) options.tree.push_back({a, b});
  if (kind == SearchRecord::Event::Kind::rectangle) options.rectangles.push_back({a, b});
  if (kind == SearchRecord::Event::Kind::interval) options.intervals.push_back({a, b});
}

}  // namespace

void draw(const std::string& path, const Task& task, std::vector<Group> groups) {
  Workspace workspace = task.scene.workspace;
  if (const auto* cells = std::get_if<CellSpace>(&task.space)) {
    workspace.obstacles = blocked_rectangles(*cells);
  }
  SvgOptions options{.title = task.scene.name, .y_down = task.y_down};
  std::vector<Plan> plans;
  for (Group& group : groups) {
    for (Result& result : group) {
      for (const SearchRecord::Event& event : result.drawings) add_event(event, options);
      if (!result.plan) continue;
      if (result.algorithms.smoother == DeltaSmoother::name) {
        const auto corners = critical_corners_of(task.space, result.plan->route.curve,
                                                 result.algorithms.smoother_options.front());
        options.critical_corners.insert(options.critical_corners.end(), corners.begin(),
                                        corners.end());
      }
      plans.push_back(std::move(*result.plan));
    }
  }
  throw_failure(write_svg(path, workspace, plans, options));
}

}  // namespace plan_program
