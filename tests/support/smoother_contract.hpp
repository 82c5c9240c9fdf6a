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
/// The contract of every smoother, on every kind of space; a test file needs one line.

namespace tutavia::test {

/// Whether a smoother respects a cancelled or exhausted budget; one that does nothing may ignore
/// it.
enum class BudgetUse { reported, ignored };

/// The promises of a smoother beyond the contract's clauses.
struct SmootherPromise {
  double longest = 1;  ///< bound of the result's length, as a multiple of the input's
  Robot robot = Robot::any;
  BudgetUse budget = BudgetUse::reported;
};

/// The clauses that a smoother breaks on spaces of type S: LatticeSpace, CellSpace, InflatedSpace,
/// FieldSpace.
template <class S>
Breaches broken_clauses(const AnySmoother<S>& smoother, const SmootherPromise& promise);

/// The contract on all kinds of spaces on which the algorithm runs.
template <class A>
void smoother_contract(const A& smoother, const SmootherPromise& promise = {}) {
  static_assert(Smoother<A, CellSpace>);  // as for every smoother of the library
  for_each_kind_of_space([&]<class S>(std::type_identity<S>, std::string_view space) {
    if constexpr (Smoother<A, S>) {
      report(broken_clauses(erase_smoother<S>(smoother), promise), A::name, space);
    }
  });
}

}  // namespace tutavia::test
