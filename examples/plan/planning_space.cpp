// SPDX-License-Identifier: MIT
#include "planning_space.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <string_view>
#include <type_traits>

#include "registry.hpp"
#include "tutavia/core/assert.hpp"
#include "tutavia/metrics/path_metrics.hpp"
#include "tutavia/optimum.hpp"
#include "tutavia/smooth/delta_smoother.hpp"

namespace plan_program {

namespace {

const Algorithms<LatticeSpace>& algorithms_on(const LatticeSpace&) { return lattice_algorithms(); }
const Algorithms<CellSpace>& algorithms_on(const CellSpace&) { return cell_algorithms(); }

template <class S>
Names names_of(const Algorithms<S>& algorithms) {
  Names names;
  for (const auto& search : algorithms.searches) names.searches.emplace_back(search.name);
  for (const auto& smoother : algorithms.smoothers) names.smoothers.push_back(smoother.name);
  return names;
}

template <class Algorithm>
const Algorithm& find(const std::vector<Algorithm>& all, std::string_view name) {
  const auto found = std::find_if(
      all.begin(), all.end(), [&](const Algorithm& candidate) { return candidate.name == name; });
  TUTAVIA_ASSERT(found != all.end());
  return *found;
}

template <class S>
AnySmoother<S> find_pipeline(const std::vector<AnySmoother<S>>& all, const std::string& names) {
  const std::vector<std::string> stages = split(names, '+');
  AnySmoother<S> pipeline = find(all, stages.front());
  for (std::size_t i = 1; i < stages.size(); ++i) {
    pipeline = detail::chain(pipeline, find(all, stages[i]));
  }
  return pipeline;
}

}  // namespace

Names lattice_names() { return names_of(lattice_algorithms()); }
Names cell_names() { return names_of(cell_algorithms()); }

Names known_names(const PlanningSpace& space) {
  return std::visit([](const auto& known) { return names_of(algorithms_on(known)); }, space);
}

PlanQuery make_planner(const PlanningSpace& any_space, const std::string& search,
                       const std::string& smoother) {
  return std::visit(
      [&]<class S>(const S& space) -> PlanQuery {
        const Algorithms<S>& all = algorithms_on(space);
        // std::function copies its target, but scratch memory is not copyable.
        const auto planner = std::make_shared<Planner<AnySearch<S>, AnySmoother<S>>>(
            find(all.searches, search), find_pipeline(all.smoothers, smoother));
        return [&space, planner](const Query& query, SearchRecord* record) {
          return record != nullptr ? planner->plan(space, query, *record)
                                   : planner->plan(space, query);
        };
      },
      any_space);
}

double mean_clearance_of(const PlanningSpace& any_space, const Curve& curve) {
  return std::visit([&](const auto& space) { return detail::mean_clearance(space, curve); },
                    any_space);
}

std::optional<double> optimum_of(const PlanningSpace& any_space, const Query& query, double bound) {
  const auto* space = std::get_if<LatticeSpace>(&any_space);
  if (space == nullptr) return std::nullopt;
  const auto optimum = find_optimum(*space, query, bound);
  return optimum ? std::optional(*optimum) : std::nullopt;
}

double taut_length_of(const PlanningSpace& any_space, const Curve& route) {
  return std::visit(
      [&](const auto& space) {
        const auto taut =
            find(algorithms_on(space).smoothers, "taut_string").smooth(space, route, {});
        return taut ? taut->length() : std::numeric_limits<double>::quiet_NaN();
      },
      any_space);
}

std::vector<Point> critical_corners_of(const PlanningSpace& any_space, const Curve& route) {
  const DeltaSmoother delta;
  std::vector<Point> positions;
  std::visit(
      [&](const auto& space) {
        for (const Corner& corner : detail::critical_corners(
                 space, waypoints(route), delta.corner_threshold, delta.min_exterior_angle)) {
          positions.push_back(corner.position);
        }
      },
      any_space);
  return positions;
}

}  // namespace plan_program
