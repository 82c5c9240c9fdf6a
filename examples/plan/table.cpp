// SPDX-License-Identifier: MIT
#include "table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <iterator>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "tutavia/core/parts/number_text.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/metrics/path_metrics.hpp"
#include "tutavia/motion/speed_profile.hpp"
#include "tutavia/world/workspace_report.hpp"

namespace plan_program {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

constexpr double degrees(double radians) { return radians * 180 / std::numbers::pi; }

std::string to_text(double value, int decimals) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*f", decimals, value);
  return buffer.data();
}

/// The relative change as "-12.3 %"; "new" if only `before` is 0, "0.0 %" if both are.
std::string change(double before, double after) {
  if (before == 0 && after != 0) return "new";
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%+.1f %%",
                before == 0 ? 0.0 : 100 * (after - before) / before);
  return buffer.data();
}

std::string change(std::size_t before, std::size_t after) {
  return change(static_cast<double>(before), static_cast<double>(after));
}

double milliseconds(const Statistics& stats) {
  return (stats.search_us + stats.smooth_us + stats.certify_us) / 1000;
}

/// Sums, largest and least figures over the goals that have a plan.
struct Summary {
  bool for_vehicle = false;
  std::size_t planned = 0, goals = 0;
  double length = 0, turning_angle = 0, max_curvature = 0, max_joint_deflection = 0;
  double min_clearance = std::numeric_limits<double>::infinity();
  double mean_clearance = 0;  ///< mean over the goals
  double taut_length = 0;     ///< NaN if a route cannot be pulled taut
  double optimum = 0;         ///< sum over the plans with a known optimum
  double travel_s = 0;        ///< with default SpeedLimits; NaN if no speed can follow a path
  std::size_t turning_points = 0, evaluations = 0, fell_back = 0, with_optimum = 0;
  std::size_t cusps = 0;  ///< changes of gear
  Statistics stats{};

  std::string share_planned() const {
    return std::to_string(planned) + "/" + std::to_string(goals);
  }
  std::string travel() const { return std::isnan(travel_s) ? "-" : to_text(travel_s, 2); }
  /// The ratio to the shortest paths, if they are all known.
  std::string over_optimum() const {
    if (planned == 0 || with_optimum < planned) return "-";
    return to_text(optimum > 0 ? length / optimum : 1, 4);
  }
  std::string over_taut() const {
    if (std::isnan(taut_length) && for_vehicle) return "-";
    return to_text(length == taut_length ? 1 : length / taut_length, 4);
  }
  std::string mean() const { return for_vehicle ? "-" : to_text(mean_clearance, 4); }
};

std::size_t cusps_of(const Plan& plan) {
  return VehiclePath{plan.curve, plan.gears}.cusps().size();
}

void add(const Plan& plan, Summary& sum) {
  const PathMetrics& m = plan.metrics;
  ++sum.planned;
  sum.length += m.length;
  sum.turning_angle += m.turning_angle;
  sum.turning_points += m.turning_points;
  sum.cusps += cusps_of(plan);
  sum.max_curvature = std::max(sum.max_curvature, m.max_curvature);
  sum.max_joint_deflection = std::max(sum.max_joint_deflection, m.max_joint_deflection);
  sum.min_clearance = std::min(sum.min_clearance, m.min_clearance);
  sum.mean_clearance += m.mean_clearance.value_or(nan);
  const auto profile = SpeedProfile::build(plan.curve, {});
  sum.travel_s += profile ? profile->duration() : nan;
  sum.evaluations += plan.certificate.evaluations;
  sum.fell_back += plan.fell_back ? 1 : 0;
  sum.stats.expanded += plan.stats.expanded;
  sum.stats.search_us += plan.stats.search_us;
  sum.stats.smooth_us += plan.stats.smooth_us;
  sum.stats.certify_us += plan.stats.certify_us;
}

bool is_for_vehicle(const Group& group) { return group.front().algorithms.for_vehicle; }

Summary summary_of(const Group& group) {
  Summary sum{.for_vehicle = is_for_vehicle(group), .goals = group.size()};
  for (const Result& result : group) {
    if (!result.plan) continue;
    add(*result.plan, sum);
    sum.taut_length += result.taut_length.value_or(nan);
    if (!result.optimum) continue;
    ++sum.with_optimum;
    sum.optimum += *result.optimum;
  }
  if (sum.planned > 0) sum.mean_clearance /= static_cast<double>(sum.planned);
  return sum;
}

/// The width of a column of labels: that of the longest, and no less than `least`.
int width_of(std::span<const Group> groups, std::string Result::*label, std::size_t least) {
  for (const Group& group : groups) least = std::max(least, (group.front().*label).size());
  return static_cast<int>(least);
}

void print_failure(const std::string& goal, const Failure& failure) {
  std::printf("%-16s %s: %s\n", goal.c_str(), std::string(to_string(failure.code)).c_str(),
              failure.detail.c_str());
}

/// Which of several searches found the path, and whether it could not be smoothed.
std::string remarks_on(const Plan& plan) {
  std::string remarks;
  if (!plan.route.found_by.empty()) remarks.append("  by ").append(plan.route.found_by);
  if (plan.fell_back) remarks.append("  (fell back to the route)");
  return remarks;
}

/// The end of the head of a table.
const char* cusp_head(const Group& group) { return is_for_vehicle(group) ? "  cusps" : ""; }

void print_plan(const std::string& goal, const Plan& plan) {
  const PathMetrics &m = plan.metrics, before = measure(plan.route.curve, plan.route.gears);
  std::printf("%-16s %10.4f %9s %6zu %9s %9.2f %9s %10.4f  %-8s %9.3f", goal.c_str(), m.length,
              change(before.length, m.length).c_str(), m.turning_points,
              change(before.turning_points, m.turning_points).c_str(), degrees(m.turning_angle),
              change(before.turning_angle, m.turning_angle).c_str(), m.min_clearance,
              std::string(to_string(plan.certificate.status)).c_str(), milliseconds(plan.stats));
  if (!plan.gears.empty()) std::printf(" %6zu", cusps_of(plan));
  std::printf("%s\n", remarks_on(plan).c_str());
}

void print_grid(const Task& task, const CellSpace& space) {
  const Scene& scene = task.scene;
  std::printf("%s: %d x %d cells of %s m, safety radius %s m, start %s\n", scene.name.c_str(),
              space.cells().width(), space.cells().height(),
              detail::number_text(space.frame().resolution).c_str(),
              detail::number_text(space.safety_radius()).c_str(),
              detail::to_text(scene.start).c_str());
  if (!task.frame.is_turned()) return;
  std::printf("the map is turned by %s rad about its origin %s; points are in the map's frame\n",
              detail::number_text(task.frame.yaw()).c_str(),
              detail::to_text(task.ros_map->origin).c_str());
}

void print_workspace(const std::string& name, const Scene& scene) {
  std::printf("%s: safety radius %s m, lattice %s m, start %s\n", name.c_str(),
              detail::number_text(scene.workspace.safety_radius).c_str(),
              detail::number_text(*scene.resolution).c_str(), detail::to_text(scene.start).c_str());
  const WorkspaceReport report = inspect(scene.workspace);
  if (report.empty()) return;
  std::fflush(stdout);
  std::cout << "workspace: " << report << std::endl;
}

std::vector<std::string> names_without(const std::vector<std::string>& names,
                                       const std::vector<std::string>& others) {
  std::vector<std::string> rest;
  std::copy_if(names.begin(), names.end(), std::back_inserter(rest), [&](const auto& name) {
    return std::find(others.begin(), others.end(), name) == others.end();
  });
  return rest;
}

void print_names_of(const std::vector<std::string>& names) {
  for (const std::string& name : names) std::cout << ' ' << name;
}

/// Prints the names for both kinds of space, those for one kind alone, and those for vehicles.
void print_list(const char* kind, const std::vector<std::string>& lattice,
                const std::vector<std::string>& cell, const std::vector<std::string>& vehicle) {
  const auto lattice_only = names_without(lattice, cell);
  std::cout << kind << ':';
  print_names_of(names_without(lattice, lattice_only));
  std::cout << "\n  on workspaces alone:";
  print_names_of(lattice_only);
  std::cout << "\n  on grid maps alone:";
  print_names_of(names_without(cell, lattice));
  std::cout << "\n  for vehicles:";
  print_names_of(vehicle);
  std::cout << '\n';
}

}  // namespace

void print_names(const Names& lattice, const Names& cell, const Names& vehicle) {
  print_list("search", lattice.searches, cell.searches, vehicle.searches);
  print_list("smoother", lattice.smoothers, cell.smoothers, vehicle.smoothers);
  std::cout << "pipeline: A+B smooths with A, then with B\n"
               "options: NAME:OPTION=VALUE,OPTION=VALUE; --help-NAME prints those of NAME\n";
}

void print_task(const Arguments& args, const Task& task) {
  if (const auto* cells = std::get_if<CellSpace>(&task.space)) {
    print_grid(task, *cells);
  } else {
    print_workspace(task.scene.name.empty() ? args.workspace : task.scene.name, task.scene);
  }
}

void print_plans(const Group& group) {
  std::printf("\nsearch %s, smoother %s; changes against the route of the search\n",
              group.front().search.c_str(), group.front().smoother.c_str());
  std::printf("%-16s %10s %9s %6s %9s %9s %9s %10s  %-8s %9s%s\n", "goal", "length m", "change",
              "turns", "change", "angle deg", "change", "clear >= m", "proof", "ms",
              cusp_head(group));
  for (const Result& result : group) {
    const std::string goal = detail::to_text(result.goal);
    if (result.plan) {
      print_plan(goal, *result.plan);
    } else {
      print_failure(goal, result.plan.error());
    }
  }
}

void print_searches(std::span<const Group> groups) {
  std::printf("\nall searches, smoother %s; sums over %zu goals\n",
              groups.front().front().smoother.c_str(), groups.front().size());
  const int width = width_of(groups, &Result::search, 20);
  std::printf("%-*s %9s %10s %6s %9s %10s %10s %10s %9s %10s%s\n", width, "search", "planned",
              "length m", "turns", "angle deg", "max curv.", "clear >= m", "expanded", "ms",
              "/ optimum", cusp_head(groups.front()));
  for (const Group& group : groups) {
    const Summary s = summary_of(group);
    std::printf("%-*s %9s %10.4f %6zu %9.2f %10.4f %10.4f %10llu %9.3f %10s", width,
                group.front().search.c_str(), s.share_planned().c_str(), s.length, s.turning_points,
                degrees(s.turning_angle), s.max_curvature, s.min_clearance,
                static_cast<unsigned long long>(s.stats.expanded), milliseconds(s.stats),
                s.over_optimum().c_str());
    if (s.for_vehicle) std::printf(" %6zu", s.cusps);
    std::printf("\n");
  }
}

void print_smoothers(std::span<const Group> groups) {
  std::printf("\nall smoothers, search %s, on the same routes; sums over %zu goals\n",
              groups.front().front().search.c_str(), groups.front().size());
  const int width = width_of(groups, &Result::smoother, 22);
  std::printf("%-*s %7s %10s %8s %13s %9s %9s %10s %12s %8s %10s %8s %10s%s\n", width, "smoother",
              "planned", "length m", "/ taut", "max curv. 1/m", "angle deg", "joint deg",
              "clear >= m", "clear mean m", "travel s", "us", "proofs", "/ optimum",
              cusp_head(groups.front()));
  for (const Group& group : groups) {
    const Summary s = summary_of(group);
    std::printf("%-*s %7s", width, group.front().smoother.c_str(), s.share_planned().c_str());
    if (s.planned > 0) {
      std::printf(" %10.4f %8s %13.4f %9.2f %9.2f %10.4f %12s %8s %10.1f %8zu %10s", s.length,
                  s.over_taut().c_str(), s.max_curvature, degrees(s.turning_angle),
                  degrees(s.max_joint_deflection), s.min_clearance, s.mean().c_str(),
                  s.travel().c_str(), s.stats.smooth_us, s.evaluations, s.over_optimum().c_str());
      if (s.for_vehicle) std::printf(" %6zu", s.cusps);
    }
    if (s.fell_back > 0) std::printf("  (%zu fell back to the route)", s.fell_back);
    std::printf("\n");
  }
}

}  // namespace plan_program
