// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "tutavia/grid/bitboard/free_runs.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/mesh/convex_pieces.hpp"
#include "tutavia/search/mesh/interval_scratch.hpp"
#include "tutavia/search/mesh/polyanya.hpp"
#include "tutavia/search/mesh_on_demand.hpp"
#include "tutavia/search/navigation_mesh.hpp"
#include "tutavia/search/query_checks.hpp"
#include "tutavia/space/cell_space.hpp"

/// \file
/// AnyAngle: the shortest any-angle path of a point among blocked cells.

namespace tutavia {

/// A shortest any-angle path of a point among blocked cells. It bends only at corners of cells.
///
/// The path may slide along blocked cells and touch their corners. It does not pass between two
/// blocked cells that share a side or only a corner. Optimal up to rounding (1e-12 relative);
/// visibility is decided by exact arithmetic. Start and goal may lie anywhere; a start or goal on a
/// corner where two blocked cells touch is reached from either side.
///
/// Searches the sides of convex pieces, split into the intervals visible from each bend of the
/// path. The pieces are the free runs of rows, found during the search, or the polygons of a mesh
/// prepared for the grid, which is many times faster; `prepare_after` makes one when it pays.
///
/// Errors: `invalid_option` for a safety radius other than 0 and for a mesh of another size (a mesh
/// of another grid of the same size is not detected); those of `check_query`; `unreachable`
/// (proved); those of the budget.
///
/// Source: Harabor, Grastien, Oz and Aksakalli 2016, "Optimal any-angle pathfinding in practice"
/// (Anya); Cui, Harabor and Grastien 2017, "Compromise-free pathfinding on a navigation mesh"
/// (Polyanya).
///
/// Example: examples/searches_on_cells.cpp.
struct AnyAngle {
  static constexpr std::string_view name = "any_angle";
  using Scratch = detail::IntervalScratch;
  using Prepared = NavigationMesh;

  std::shared_ptr<const NavigationMesh> mesh{};  ///< null: searches the free runs of rows
  /// Makes the mesh of one space after some queries; see `prepare_after`. Without effect with
  /// `mesh`.
  std::shared_ptr<MeshOnDemand> mesh_on_demand{};

  /// A search that makes a mesh at its n-th query in a space; its copies share the mesh. Which of
  /// several paths of equal length is found may depend on the number of earlier queries.
  static AnyAngle prepare_after(std::uint32_t queries) {
    return {.mesh_on_demand = std::make_shared<MeshOnDemand>(queries)};
  }

  /// The mesh of a space's cells. Errors: those of `NavigationMesh::build`.
  static Expected<std::shared_ptr<const NavigationMesh>, Failure> prepare(const CellSpace& space) {
    auto mesh = NavigationMesh::build(space.cells());
    if (!mesh) return Unexpected{std::move(mesh.error())};
    return std::make_shared<const NavigationMesh>(std::move(*mesh));
  }

  template <Observer O = NoObserver>
  Expected<Route, Failure> search(const CellSpace& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    if (space.safety_radius() != 0) {
      return fail(PlanError::invalid_option, "any_angle is defined for safety radius 0");
    }
    if (auto valid = check_query(space, query); !valid) return std::move(valid).unexpected();
    if (mesh == nullptr) {
      const NavigationMesh* made =
          mesh_on_demand != nullptr ? mesh_on_demand->next(space) : nullptr;
      if (made != nullptr) return search_in(*made, space, query, scratch, observer);
      const detail::FreeRuns runs(space.cells(), detail::FreeRuns::EqualRuns::joined);
      return search_in(runs, space, query, scratch, observer);
    }
    if (mesh->width() != space.cells().width() || mesh->height() != space.cells().height()) {
      return fail(PlanError::invalid_option, "any_angle needs the mesh prepared for this grid");
    }
    return search_in(*mesh, space, query, scratch, observer);
  }

 private:
  template <detail::ConvexPieces Pieces, Observer O>
  static Expected<Route, Failure> search_in(const Pieces& pieces, const CellSpace& space,
                                            const Query& query, Scratch& scratch, O& observer) {
    Route route;
    detail::Polyanya<Pieces, O> search(space, pieces, query, scratch, observer, route.stats);
    if (auto found = search.run(); !found) {
      Failure failure = std::move(found.error());
      if (failure.code == PlanError::unreachable) {
        failure.detail = "no path among the blocked cells";
      } else if (failure.code == PlanError::budget_exhausted) {
        failure.detail =
            "search stopped after " + std::to_string(route.stats.expanded) + " expansions";
      }
      failure.stats = route.stats;
      return Unexpected{std::move(failure)};
    }
    route.curve = search.curve();
    route.cost = route.curve.length();
    return route;
  }
};

}  // namespace tutavia
