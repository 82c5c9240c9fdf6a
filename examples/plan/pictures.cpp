// SPDX-License-Identifier: MIT
#include "pictures.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <variant>

#include "blocked_boxes.hpp"
#include "planning_space.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/io/svg.hpp"
#include "tutavia/io/svg_search.hpp"
#include "tutavia/io/svg_smoothing.hpp"
#include "tutavia/io/text/write_file.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "usage_error.hpp"

namespace plan_program {

namespace {

/// A grid where just those cells are blocked that are so in `cells` and not in `before`.
OccupancyGrid newly_blocked(OccupancyGrid cells, const OccupancyGrid& before) {
  for (int y = 0; y < before.height(); ++y) {
    before.for_each_run(y, false,
                        [&](int first, int last) { cells.set_run(y, first, last, true); });
  }
  return cells;
}

/// Draws a box by its edges: pictures have no turned boxes.
void add_outline(const Box& box, const MapFrame& frame, SvgOptions& options) {
  const Ring ring = corners_of(box, frame);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    options.outlines.push_back({ring[i], ring[(i + 1) % ring.size()]});
  }
}

/// Adds the blocked cells as obstacles, and the buffer as an area of its own. A turned map has its
/// border and its buffer as outlines.
void add_cells(const Task& task, const CellSpace& space, Workspace& workspace,
               SvgOptions& options) {
  const MapFrame& frame = task.frame;
  const Point origin = space.bounds().min;
  const double side = space.frame().resolution;
  const OccupancyGrid& map = task.without_buffer ? *task.without_buffer : space.cells();
  add_blocked_cells(map, origin, side, frame, workspace);
  if (task.without_buffer) {
    options.buffer = blocked_boxes(newly_blocked(space.cells(), map), origin, side);
  }
  if (!frame.is_turned()) return;
  workspace.bounds = Box::around({});
  for (const Point& corner : corners_of(space.bounds(), frame)) workspace.bounds.include(corner);
  add_outline(space.bounds(), frame, options);
  for (const Box& box : std::exchange(options.buffer, {})) add_outline(box, frame, options);
  options.cell_size = 0;  // no cell of the picture is a cell of the map
}

/// What a search recorded, in the frame of the map. Rectangles of a turned map are outlines round
/// their cells, which are added to the options.
SearchRecord drawn_record(const Task& task, const Result& result, SvgOptions& options) {
  using Kind = SearchRecord::Event::Kind;
  SearchRecord record = result.drawings;
  if (const auto* cells = std::get_if<CellSpace>(&task.space); cells && task.frame.is_turned()) {
    for (const SearchRecord::Event& event : record.events) {
      if (event.kind != Kind::rectangle) continue;
      const Box rectangle{event.a, event.b};
      add_outline(rectangle.inflated(cells->frame().resolution / 2), task.frame, options);
    }
    std::erase_if(record.events,
                  [](const SearchRecord::Event& event) { return event.kind == Kind::rectangle; });
  }
  return task.frame.to_map(std::move(record));
}

/// Adds what a search recorded.
void add_drawings(const Task& task, const Result& result, SvgOptions& options) {
  add_search(options, drawn_record(task, result, options),
             result.plan ? result.plan->route.curve : Curve{});
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
  for (const Point& corner : critical_corners_of(task.space, result.route_in_grid,
                                                 result.algorithms.smoother_options.front())) {
    options.critical_corners.push_back(task.frame.to_map(corner));
  }
}

/// The result of the only query. Throws UsageError if there are several.
const Result& only_result(const Arguments& args, const std::vector<Group>& groups) {
  if (groups.size() == 1 && groups.front().size() == 1) return groups.front().front();
  throw UsageError{args.proceeding_option() + ": give one --goal, one --search and one --smoother"};
}

/// Draws how a plan comes about: how its search proceeds, or how its route is smoothed.
std::string proceeding(const Arguments& args, const Task& task, const Result& result,
                       const Workspace& workspace, SvgOptions& options) {
  options.labels.push_back(label_of(result, 1));
  if (args.smoothing_steps) {
    add_critical_corners(task, result, options);
    return to_svg_smoothing(workspace, *result.plan, options);
  }
  const SearchRecord record = drawn_record(task, result, options);
  if (args.animate) return to_animated_svg(workspace, *result.plan, record, options);
  return to_svg_steps(workspace, *result.plan, record, static_cast<std::size_t>(*args.steps),
                      options);
}

}  // namespace

void draw(const Arguments& args, const Task& task, std::vector<Group> groups) {
  const ShownParts shown = args.shown();
  Workspace workspace = task.scene.workspace;
  SvgOptions options{.zones = shown.zones,
                     .risk_zones = shown.zones && (args.show || !args.compare),
                     .footprints = shown.footprint && (args.show || !args.compare),
                     .profile = shown.profile,
                     .title = task.scene.name,
                     .y_down = task.y_down};
  std::visit([&](const auto& space) { options.cell_size = space.frame().resolution; }, task.space);
  if (const auto* cells = std::get_if<CellSpace>(&task.space)) {
    add_cells(task, *cells, workspace, options);
  }
  if (!args.proceeding_option().empty()) {
    const Result& result = only_result(args, groups);
    if (!args.animate) options.width = 300;
    if (result.plan) {
      const std::string svg = proceeding(args, task, result, workspace, options);
      return throw_failure(detail::write_file(args.svg, svg));
    }
  }
  std::vector<Plan> plans;
  std::set<std::string> searches;  // those already drawn: every smoother has the same
  for (Group& group : groups) {
    const bool is_new = searches.insert(group.front().search).second;
    for (Result& result : group) {
      if (is_new) add_drawings(task, result, options);
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
