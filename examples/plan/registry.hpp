// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "tutavia/any_algorithm.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/lattice_space.hpp"

/// \file
/// Every algorithm of the library for both kinds of space.

namespace plan_program {

/// The searches and smoothers that work on spaces of type S, with default options.
template <class S>
struct Algorithms {
  std::vector<tutavia::AnySearch<S>> searches;
  std::vector<tutavia::AnySmoother<S>> smoothers;
};

/// Algorithms for workspaces. Each list has its own source file, because it takes longest to
/// compile.
const Algorithms<tutavia::LatticeSpace>& lattice_algorithms();

/// Algorithms for grid maps.
const Algorithms<tutavia::CellSpace>& cell_algorithms();

}  // namespace plan_program
