// SPDX-License-Identifier: MIT
#include "run.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <iostream>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "input.hpp"
#include "input_options.hpp"
#include "json_output.hpp"
#include "names.hpp"
#include "pictures.hpp"
#include "plan_goals.hpp"
#include "planning_space.hpp"
#include "registry.hpp"
#include "table.hpp"
#include "usage_error.hpp"

namespace plan_program {

namespace {

void add_taut_lengths(const PlanningSpace& space, Group& group) {
  for (Result& result : group) {
    if (!result.plan || result.algorithms.for_vehicle) continue;
    result.taut_length = taut_length_of(space, result.route_in_grid);
  }
}

/// All names with default options, and last the choice if it differs from those.
std::vector<PipelineText> rivals(const std::vector<std::string>& names,
                                 const PipelineText& chosen) {
  std::vector<PipelineText> all;
  all.reserve(names.size() + 1);
  for (const std::string& name : names) all.push_back(default_choice(name));
  const bool is_known = std::find(names.begin(), names.end(), chosen.text) != names.end();
  if (!is_known) all.push_back(chosen);
  return all;
}

/// Runs all searches with the chosen smoother, then all smoothers with the chosen search, which
/// finds the same routes each time. A chosen pipeline and chosen options take part. For a vehicle
/// it is all that plans headings.
std::vector<Group> compare(const Task& task, const Arguments& args, const Choices& chosen,
                           TraceFile& trace) {
  const PipelineText &search = chosen.searches.front(), &smoother = chosen.smoothers.front();
  const Names all = chosen.for_vehicle ? vehicle_names() : known_names(task.space);
  std::vector<Group> groups;
  for (const PipelineText& other : rivals(all.searches, search)) {
    groups.push_back(plan_goals(task, args, trace, other, smoother));
  }
  const std::size_t searches = groups.size();
  if (args.prints_tables()) print_searches(groups);
  for (const PipelineText& other : rivals(all.smoothers, smoother)) {
    groups.push_back(plan_goals(task, args, trace, search, other));
    if (args.prints_tables()) add_taut_lengths(task.space, groups.back());
  }
  if (args.prints_tables()) print_smoothers(std::span<const Group>(groups).subspan(searches));
  return groups;
}

/// Runs every combination of the chosen searches and smoothers.
std::vector<Group> combine(const Task& task, const Arguments& args, const Choices& chosen,
                           TraceFile& trace) {
  std::vector<Group> groups;
  for (const PipelineText& search : chosen.searches) {
    for (const PipelineText& smoother : chosen.smoothers) {
      groups.push_back(plan_goals(task, args, trace, search, smoother));
      if (args.prints_tables()) print_plans(groups.back());
    }
  }
  return groups;
}

/// Costs of cells are for searches that take them.
void check_costs(const Arguments& args, const Choices& chosen) {
  if (!unknown_cost(args)) return;
  const std::string option = "--unknown " + args.unknown;
  if (args.compare) throw UsageError{option + ": --compare runs searches that take no costs"};
  for (const PipelineText& search : chosen.searches) {
    const std::string& name = search.stages.front().name;
    if (takes_costs(name)) continue;
    std::string message = option;
    message.append(": ").append(name);
    throw UsageError{message + " takes no costs of cells; give --search auto, astar or dijkstra"};
  }
  for (const PipelineText& smoother : chosen.smoothers) {
    if (smoother.text == "none") continue;
    std::cerr << "tutavia-plan: " << option << ": smoothers know no costs, and " << smoother.text
              << " may lead through unknown cells that the search avoids; --smoother none keeps "
                 "its route\n";
  }
}

bool is_complete(const std::vector<Group>& groups) {
  return std::all_of(groups.begin(), groups.end(), [](const Group& group) {
    return std::all_of(group.begin(), group.end(),
                       [](const Result& result) { return result.plan.has_value(); });
  });
}

}  // namespace

int run(const Arguments& args) {
  if (args.list) {
    print_names(lattice_names(), cell_names(), vehicle_names());
    return 0;
  }
  // Unknown names and options are rejected before any file is loaded.
  const Choices chosen = parse_choices(args, vehicle_names());
  check_choices(chosen, args.vehicle, !args.grid.empty());
  check_costs(args, chosen);
  const Task task = load_task(args);
  if (args.prints_tables()) print_task(args, task);
  TraceFile trace(args.trace);
  std::vector<Group> groups =
      args.compare ? compare(task, args, chosen, trace) : combine(task, args, chosen, trace);
  std::fflush(stdout);
  const bool complete = is_complete(groups);

  if (!args.json.empty()) write_results(args.json, task, groups);
  trace.close();
  if (!args.svg.empty()) {
    draw(args, task, std::move(groups));
    if (args.prints_tables()) std::printf("\npicture: %s\n", args.svg.c_str());
  }
  if (!complete && task.blocked_unknown > 0) {
    std::fprintf(stderr,
                 "tutavia-plan: %s: %zu unknown cells are blocked; --unknown free or cost:N lets "
                 "paths cross them\n",
                 args.grid.c_str(), task.blocked_unknown);
  }
  return complete ? 0 : 1;
}

}  // namespace plan_program
