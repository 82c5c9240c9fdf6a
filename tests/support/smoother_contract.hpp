// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <type_traits>

#include "support/contract.hpp"
#include "tutavia/any_algorithm.hpp"
#include "tutavia/smooth/concepts.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/space/lattice_space.hpp"

/// \file
/// What every smoother must do, on every kind of space; one line in a test file tries it.

namespace tutavia::test {

/// What a smoother does with a budget that is cancelled or exhausted: one that does nothing at all
/// may ignore it.
enum class BudgetUse { reported, ignored };

/// What a smoother promises beside the contract's clauses.
struct SmootherPromise {
  double longest = 1;  ///< bound of the result's length, as a multiple of the input's
  Robot robot = Robot::any;
  BudgetUse budget = BudgetUse::reported;
};

/// The clauses that a smoother breaks on spaces of type S: LatticeSpace, CellSpace, InflatedSpace.
template <class S>
Breaches broken_clauses(const AnySmoother<S>& smoother, const SmootherPromise& promise);

/// The contract on all kinds of spaces on which the algorithm runs.
template <class A>
void smoother_contract(const A& smoother, const SmootherPromise& promise = {}) {
  static_assert(Smoother<A, CellSpace>);  // as every smoother of the library
  for_each_kind_of_space([&]<class S>(std::type_identity<S>, std::string_view space) {
    if constexpr (Smoother<A, S>) {
      report(broken_clauses(erase_smoother<S>(smoother), promise), A::name, space);
    }
  });
}

}  // namespace tutavia::test
