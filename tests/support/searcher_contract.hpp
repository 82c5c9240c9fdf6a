// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <type_traits>

#include "support/contract.hpp"
#include "tutavia/any_algorithm.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/space/lattice_space.hpp"
#include "tutavia/world/scene.hpp"

/// \file
/// The contract of every searcher, on every kind of space; a test file needs one line.

namespace tutavia::test {

/// A wall in the middle of a square, with room to pass on both sides.
const Scene& open_scene();

/// Runs one query with its own scratch memory.
template <class A, class S>
Expected<Route, Failure> search_once(const A& algorithm, const S& space, const Query& query) {
  typename A::Scratch scratch;
  NoObserver no_observer;
  return algorithm.search(space, query, scratch, no_observer);
}

/// Whether a search can prove that there is no path.
enum class Completeness { proves_that_there_is_none, gives_up };

/// Whether a search handles a start, a goal or a gap exactly at the safety radius.
enum class Ties { decided, not_proved };

/// The promises of a searcher beyond the contract's clauses.
struct SearcherPromise {
  Completeness completeness = Completeness::proves_that_there_is_none;
  Robot robot = Robot::any;
  Ties ties = Ties::decided;
  /// The minimum share of random queries solved by A* that the searcher must solve, too. It must
  /// also solve a third of all random queries.
  double found = 1;
};

/// The clauses that a searcher breaks on spaces of type S: LatticeSpace, CellSpace, InflatedSpace,
/// FieldSpace.
template <class S>
Breaches broken_clauses(const AnySearch<S>& search, const SearcherPromise& promise);

/// The contract on all kinds of spaces on which the algorithm runs.
template <class A>
void searcher_contract(const A& algorithm, const SearcherPromise& promise = {}) {
  static_assert(Searcher<A, CellSpace>);  // as for every search of the library
  for_each_kind_of_space([&]<class S>(std::type_identity<S>, std::string_view space) {
    if constexpr (Searcher<A, S>) {
      report(broken_clauses(erase_search<S>(algorithm), promise), A::name, space);
    }
  });
}

}  // namespace tutavia::test
