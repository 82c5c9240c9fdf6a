// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <utility>

#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/first_of.hpp"
#include "tutavia/search/jps.hpp"
#include "tutavia/search/tangent_graph.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// AutoSearch: the search to use where nothing speaks for another.

namespace tutavia {

/// Finds a path wherever there is one, as fast as the space allows.
///
/// - Workspaces: A* on the lattice, and TangentGraph where the lattice has no path. A path is found
///   wherever one exists, except that an end between two safety zones may leave it `not_proved`;
///   `unreachable` is proved. Without a lattice, TangentGraph alone.
/// - Cells: jump point search, or A* where steps are not diagonal. A path from cell to cell is
///   found wherever one exists. A disc may find more between cells by TangentGraph, which takes
///   long on large maps.
///
/// `Route::found_by` names the search that found the path. Errors: those of these searches.
///
/// Example: examples/searches_among_polygons.cpp.
struct AutoSearch {
  static constexpr std::string_view name = "auto";
  struct Scratch {
    FirstOf<AStar, TangentGraph>::Scratch workspace;
    Jps::Scratch jps;
  };

  template <class S, Observer O = NoObserver>
  requires GridSpace<S> || WorkspaceSpace<S> Expected<Route, Failure> search(const S& space,
                                                                             const Query& query,
                                                                             Scratch& scratch,
                                                                             O& observer)
  const {
    if constexpr (GridSpace<S> && WorkspaceSpace<S>) {
      return FirstOf<AStar, TangentGraph>{}.search(space, query, scratch.workspace, observer);
    } else if constexpr (WorkspaceSpace<S>) {
      return named<TangentGraph>(
          TangentGraph{}.search(space, query, scratch.workspace.second, observer));
    } else {
      if constexpr (JumpSpace<S>) {
        if (space.movement() != MovementRule::four_connected) {
          return named<Jps>(Jps{}.search(space, query, scratch.jps, observer));
        }
      }
      return named<AStar>(AStar{}.search(space, query, scratch.workspace.first, observer));
    }
  }

 private:
  template <class A>
  static Expected<Route, Failure> named(Expected<Route, Failure> route) {
    if (route) route->found_by = A::name;
    return route;
  }
};

}  // namespace tutavia
