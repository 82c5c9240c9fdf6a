// SPDX-License-Identifier: MIT
#include "plan_goals.hpp"

#include <optional>
#include <utility>

#include "tutavia/core/budget.hpp"

namespace plan_program {

namespace {

/// Adds the figures that take longer than most queries. They are those of a point, so vehicles have
/// none.
void add_figures(const PlanningSpace& space, const Query& query, Result& result) {
  if (!result.plan) return;
  PathMetrics& metrics = result.plan->metrics;
  metrics.mean_clearance = mean_clearance_of(space, result.plan->curve);
  result.optimum = optimum_of(space, query, metrics.length);
}

/// Adds to a failure of the lattice what would find a path.
void add_remedy(const PlanningSpace& space, const Query& query, Failure& failure) {
  if (failure.code != PlanError::unreachable_at_resolution) return;
  failure.detail += remedy_of(space, query);
}

/// What the picture shows of a search.
SearchRecord drawings_of(SearchRecord record, const ShownParts& shown) {
  using Kind = SearchRecord::Event::Kind;
  std::erase_if(record.events, [&](const SearchRecord::Event& event) {
    switch (event.kind) {
      case Kind::expanded:
        return !shown.visited;
      case Kind::edge:
        return !shown.tree;
      case Kind::interval:
      case Kind::rectangle:
        return !shown.passages;
      case Kind::generated:
        break;
    }
    return true;
  });
  if (!shown.tree) record.tree_path = {};
  return record;
}

}  // namespace

Group plan_goals(const Task& task, const Arguments& args, TraceFile& trace,
                 const PipelineText& search, const PipelineText& smoother) {
  const bool is_drawn = !args.svg.empty() && !args.compare;
  const ShownParts shown = args.shown();
  const bool is_traced = trace.takes(search.text);
  const ChosenPlanner planner =
      make_planner(task.space, task.costs, search, smoother, args.vehicle);
  const bool is_vehicle = planner.algorithms.for_vehicle;
  const bool has_all_figures = !is_vehicle && (args.compare || !args.json.empty());
  MapFrame frame = task.frame;
  const Point start = frame.to_grid(task.scene.start);
  const auto heading_in_grid = [&](const std::optional<double>& in_map) {
    return in_map ? std::optional(frame.heading_to_grid(*in_map)) : std::nullopt;
  };
  Group group;
  for (const Point& goal : task.scene.goals) {
    SearchRecord record{.keeps_nodes = is_traced || (is_drawn && shown.visited)};
    Query query{.start = start,
                .goal = frame.to_grid(goal),
                .start_heading = heading_in_grid(args.vehicle.start_heading),
                .goal_heading = heading_in_grid(args.vehicle.goal_heading(group.size())),
                .seed = args.seed};
    if (args.time_limit) query.budget = Budget::for_seconds(*args.time_limit);
    group.push_back({search.text, smoother.text, planner.algorithms, goal,
                     planner.plan(query, is_drawn || is_traced ? &record : nullptr)});
    Result& result = group.back();
    if (!result.plan && !args.compare && !is_vehicle)
      add_remedy(task.space, query, result.plan.error());
    if (has_all_figures) add_figures(task.space, query, result);
    if (result.plan) result.route_in_grid = result.plan->route.curve;
    result.plan = frame.to_map(std::move(result.plan));
    if (is_traced) trace.write(task, result, frame.to_map(record));
    if (is_drawn) result.drawings = drawings_of(std::move(record), shown);
  }
  return group;
}

}  // namespace plan_program
