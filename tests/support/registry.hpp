// SPDX-License-Identifier: MIT
#pragma once

#include "tutavia/registry.hpp"
#include "tutavia/space/lattice_space.hpp"

/// \file
/// The registry on lattices, compiled once for all tests.

namespace tutavia {

extern template std::vector<AnySearch<LatticeSpace>> all_searches<LatticeSpace>();
extern template std::vector<AnySmoother<LatticeSpace>> all_smoothers<LatticeSpace>();

}  // namespace tutavia
