// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "names.hpp"
#include "result.hpp"
#include "tutavia/grid/cell_costs.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/search_record.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/lattice_space.hpp"
#include "vehicle_arguments.hpp"

/// \file
/// PlanningSpace: a common interface to both kinds of space.

namespace plan_program {

using namespace tutavia;

/// The lattice of a workspace or the cells of a grid map.
using PlanningSpace = std::variant<LatticeSpace, CellSpace>;

/// Every search and smoother for workspaces.
Names lattice_names();
/// Every search and smoother for grid maps.
Names cell_names();
/// The names for the kind of a space.
Names known_names(const PlanningSpace& space);

/// Every search for vehicles, and the smoothers for its routes, the best one last.
Names vehicle_names();

/// Throws a UsageError for algorithms or options that are not known on workspaces, or on grid maps;
/// for those that keep no headings if a vehicle is planned for; and else for those of vehicles.
void check_choices(const Choices& choices, const VehicleArguments& vehicle, bool on_grid_map);

/// Plans one query. The record may be null.
using PlanQuery = std::function<Expected<Plan, Failure>(const Query&, SearchRecord*)>;

/// What a smoother makes of a route, and whether it is safe.
struct SmoothedRoute {
  Curve curve;
  std::vector<Gear> gears;  ///< of a vehicle; else empty
  Certificate certificate;
};

/// What plans with chosen algorithms.
struct ChosenPlanner {
  PlanQuery plan;
  UsedAlgorithms algorithms;
  /// The smoother alone, to see a curve that a plan refused.
  std::function<Expected<SmoothedRoute, Failure>(const Route&, const Budget&)> smooth;
};

/// A planner with its own scratch memory, for cells with these costs (null: they cost the same;
/// \pre null, or cells and a search that `takes_costs`), and for this vehicle if the search plans
/// headings. It keeps a reference to the space. Throws a UsageError for unknown names and options;
/// so does `plan` where an algorithm with options given by the user answers `invalid_option`.
ChosenPlanner make_planner(const PlanningSpace& space,
                           const std::shared_ptr<const CellCosts>& costs,
                           const PipelineText& search, const PipelineText& smoother,
                           const VehicleArguments& vehicle);

/// The mean clearance of a curve over its length [m].
double mean_clearance_of(const PlanningSpace& space, const Curve& curve);

/// The length of the shortest path [m], at most `bound`, if it is found within a second.
std::optional<double> optimum_of(const PlanningSpace& space, const Query& query, double bound);

/// What would find a path where the lattice of a workspace has none, as the end of a message: a
/// finer resolution (tried if the query has no time limit), or the exact search. Empty if there is
/// no path.
std::string remedy_of(const PlanningSpace& space, const Query& query);

/// The length of a route when pulled taut [m]; NaN if that fails.
double taut_length_of(const PlanningSpace& space, const Curve& route);

/// The obstacle corners that the delta smoother with these options treats as critical on a route.
std::vector<Point> critical_corners_of(const PlanningSpace& space, const Curve& route,
                                       const OptionSettings& delta);

}  // namespace plan_program
