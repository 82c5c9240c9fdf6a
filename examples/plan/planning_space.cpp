// SPDX-License-Identifier: MIT
#include "planning_space.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "chosen_algorithms.hpp"
#include "registry.hpp"
#include "tutavia/core/parts/number_text.hpp"
#include "tutavia/metrics/path_metrics.hpp"
#include "tutavia/optimum.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "tutavia/smooth/no_smoothing.hpp"
#include "usage_error.hpp"

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

template <class S>
Expected<SmoothedRoute, Failure> smooth_and_certify(const S& space, const AnySmoother<S>& smoother,
                                                    const Route& route, const Budget& budget) {
  if (route.vehicle) {
    auto path =
        smoother.smooth(space, *route.vehicle, VehiclePath{route.curve, route.gears}, budget);
    if (!path) return std::move(path).unexpected();
    const VehicleCertificate proof = certify(space, *route.vehicle, *path, {}, budget);
    Certificate certificate = proof.clearance;
    certificate.status = proof.status;
    return SmoothedRoute{std::move(path->curve), std::move(path->gears), certificate};
  }
  auto curve = smoother.smooth(space, route.curve, budget);
  if (!curve) return std::move(curve).unexpected();
  const Certificate certificate = certify(space, *curve, {}, budget);
  return SmoothedRoute{std::move(*curve), {}, certificate};
}

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// A name that is known on the other kind of space alone gets a message of its own.
void refuse_elsewhere(const std::string& option, const PipelineText& pipeline,
                      const std::vector<std::string>& here, const std::vector<std::string>& there,
                      bool on_grid_map) {
  for (const AlgorithmText& stage : pipeline.stages) {
    if (has(here, stage.name) || !has(there, stage.name)) continue;
    throw UsageError{
        option + ": " + stage.name + " works on " +
        (on_grid_map ? "workspaces alone (--map, --workspace)" : "grid maps alone (--grid)")};
  }
}

/// Algorithms with headings are for vehicles, and no others are.
void check_headings(const Choices& choices) {
  const Names vehicle = vehicle_names();
  if (choices.for_vehicle) {
    for (const PipelineText& search : choices.searches) {
      if (has(vehicle.searches, search.name())) continue;
      throw UsageError{"--search: " + search.name() + " plans no headings; for a vehicle give " +
                       vehicle.searches.front()};
    }
  }
  for (const PipelineText& smoother : choices.smoothers) {
    for (const AlgorithmText& stage : smoother.stages) {
      const bool keeps_headings = has(vehicle.smoothers, stage.name);
      if (choices.for_vehicle && !keeps_headings) {
        std::string known = vehicle.smoothers.front();
        for (std::size_t i = 1; i < vehicle.smoothers.size(); ++i) {
          known.append(i + 1 < vehicle.smoothers.size() ? ", " : " or ")
              .append(vehicle.smoothers[i]);
        }
        throw UsageError{"--smoother: " + stage.name + " keeps no headings; for a vehicle give " +
                         known};
      }
      if (choices.for_vehicle || !keeps_headings || stage.name == NoSmoothing::name) continue;
      throw UsageError{"--smoother: " + stage.name + " is for vehicles; give --search " +
                       vehicle.searches.front()};
    }
  }
}

template <class S>
void check_on(const Algorithms<S>& all, const Choices& choices, const VehicleArguments& vehicle) {
  for (const PipelineText& search : choices.searches) make_search_on(all, search, vehicle);
  for (const PipelineText& smoother : choices.smoothers) make_smoother_on(all, smoother);
}

}  // namespace

Names lattice_names() { return names_of(lattice_algorithms()); }
Names cell_names() { return names_of(cell_algorithms()); }

Names known_names(const PlanningSpace& space) {
  return std::visit([](const auto& known) { return names_of(algorithms_on(known)); }, space);
}

Names vehicle_names() {
  const Algorithms<LatticeSpace>& all = lattice_algorithms();
  Names names{.searches = {}, .smoothers = {std::string(NoSmoothing::name)}};
  for (const auto& search : all.vehicle_searches) names.searches.emplace_back(search.name);
  for (const auto& smoother : all.vehicle_smoothers) names.smoothers.push_back(smoother.name);
  return names;
}

void check_choices(const Choices& choices, const VehicleArguments& vehicle, bool on_grid_map) {
  const Names lattice = lattice_names(), cell = cell_names();
  const Names &here = on_grid_map ? cell : lattice, &there = on_grid_map ? lattice : cell;
  for (const PipelineText& search : choices.searches) {
    refuse_elsewhere("--search", search, here.searches, there.searches, on_grid_map);
  }
  for (const PipelineText& smoother : choices.smoothers) {
    refuse_elsewhere("--smoother", smoother, here.smoothers, there.smoothers, on_grid_map);
  }
  if (on_grid_map) {
    check_on(cell_algorithms(), choices, vehicle);
  } else {
    check_on(lattice_algorithms(), choices, vehicle);
  }
  check_headings(choices);
}

ChosenPlanner make_planner(const PlanningSpace& any_space,
                           const std::shared_ptr<const CellCosts>& costs,
                           const PipelineText& search, const PipelineText& smoother,
                           const VehicleArguments& vehicle) {
  return std::visit(
      [&]<class S>(const S& space) -> ChosenPlanner {
        const Algorithms<S>& all = algorithms_on(space);
        AnySearch<S> any_search = make_search_on(all, search, vehicle, costs);
        AnySmoother<S> any_smoother = make_smoother_on(all, smoother);
        UsedAlgorithms used{std::string(any_search.name), any_smoother.name, any_search.options,
                            any_smoother.options, static_cast<bool>(any_search.for_vehicle)};
        // std::function copies its target, but scratch memory is not copyable.
        const auto planner = std::make_shared<Planner<AnySearch<S>, AnySmoother<S>>>(
            std::move(any_search), std::move(any_smoother));
        return {[&space, planner](const Query& query, SearchRecord* record) {
                  return record != nullptr ? planner->plan(space, query, *record)
                                           : planner->plan(space, query);
                },
                std::move(used),
                [&space, planner](const Route& route, const Budget& budget) {
                  return smooth_and_certify(space, planner->smoother(), route, budget);
                }};
      },
      any_space);
}

double mean_clearance_of(const PlanningSpace& any_space, const Curve& curve) {
  return std::visit([&](const auto& space) { return detail::mean_clearance(space, curve); },
                    any_space);
}

std::optional<double> optimum_of(const PlanningSpace& any_space, const Query& query, double bound) {
  return std::visit(
      [&](const auto& space) -> std::optional<double> {
        Query limited = query;
        limited.budget = Budget::for_seconds(1);
        const auto optimum = find_optimum(space, limited, bound);
        return optimum ? std::optional(*optimum) : std::nullopt;
      },
      any_space);
}

std::string remedy_of(const PlanningSpace& any_space, const Query& query) {
  const bool has_time_limit = query.budget.deadline != Budget{}.deadline;
  const auto optimum = optimum_of(any_space, query, std::numeric_limits<double>::infinity());
  if (!optimum) return "";
  const auto* space = std::get_if<LatticeSpace>(&any_space);
  std::string remedy = space != nullptr ? "; --search auto" : "; --search tangent_graph";
  remedy.append(" finds a path of ").append(detail::number_text(*optimum)).append(" m");
  if (space == nullptr || has_time_limit) return remedy;
  constexpr std::int64_t most_nodes = 1 << 22;  // about a second
  LatticeOptions finer{.resolution = space->frame().resolution,
                       .movement = MovementRule::no_cut,
                       .max_nodes = most_nodes};
  for (int halvings = 0; halvings < 5; ++halvings) {
    finer.resolution = *finer.resolution / 2;
    const auto lattice = LatticeSpace::build(space->workspace(), finer);
    if (!lattice) break;
    if (!Planner(AStar{}).plan(*lattice, query)) continue;
    return remedy + ", --resolution " + detail::number_text(*finer.resolution) +
           " one on the lattice";
  }
  return remedy;
}

double taut_length_of(const PlanningSpace& any_space, const Curve& route) {
  return std::visit(
      [&](const auto& space) {
        const auto string = algorithms_on(space).make_smoother("taut_string", {});
        const auto taut = string.value().smooth(space, route, {});
        return taut ? taut->length() : std::numeric_limits<double>::quiet_NaN();
      },
      any_space);
}

std::vector<Point> critical_corners_of(const PlanningSpace& any_space, const Curve& route,
                                       const OptionSettings& delta) {
  std::vector<Point> positions;
  std::visit(
      [&](const auto& space) {
        for (const Corner& corner : detail::critical_corners(
                 space, waypoints(route), value_of<double>(delta, "corner_threshold"),
                 value_of<double>(delta, "min_exterior_angle"))) {
          positions.push_back(corner.position);
        }
      },
      any_space);
  return positions;
}

}  // namespace plan_program
