// SPDX-License-Identifier: MIT
#include "run.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "input.hpp"
#include "json_output.hpp"
#include "names.hpp"
#include "pictures.hpp"
#include "plan_goals.hpp"
#include "planning_space.hpp"
#include "table.hpp"

namespace plan_program {

namespace {

void add_taut_lengths(const PlanningSpace& space, Group& group) {
  for (Result& result : group) {
    if (result.plan) result.taut_length = taut_length_of(space, result.plan->route.curve);
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
/// finds the same routes each time. A chosen pipeline and chosen options take part.
std::vector<Group> compare(const Task& task, const Arguments& args, const Choices& chosen,
                           TraceFile& trace) {
  const PipelineText &search = chosen.searches.front(), &smoother = chosen.smoothers.front();
  const Names all = known_names(task.space);
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

bool is_complete(const std::vector<Group>& groups) {
  return std::all_of(groups.begin(), groups.end(), [](const Group& group) {
    return std::all_of(group.begin(), group.end(),
                       [](const Result& result) { return result.plan.has_value(); });
  });
}

}  // namespace

int run(const Arguments& args) {
  if (args.list) {
    print_names(lattice_names(), cell_names());
    return 0;
  }
  // Unknown names and options are rejected before any file is loaded.
  const Choices chosen = parse_choices(args);
  check_choices(chosen, !args.grid.empty());
  const Task task = load_task(args);
  if (args.prints_tables()) print_task(args, task);
  TraceFile trace(args.trace);
  std::vector<Group> groups =
      args.compare ? compare(task, args, chosen, trace) : combine(task, args, chosen, trace);
  std::fflush(stdout);
  const bool complete = is_complete(groups);

  if (!args.json.empty()) write_results(args.json, task.scene, groups);
  trace.close();
  if (!args.svg.empty()) {
    draw(args, task, std::move(groups));
    if (args.prints_tables()) std::printf("\npicture: %s\n", args.svg.c_str());
  }
  return complete ? 0 : 1;
}

}  // namespace plan_program
