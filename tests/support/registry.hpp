// SPDX-License-Identifier: MIT
#pragma once

#include "tutavia/registry.hpp"
#include "tutavia/space/lattice_space.hpp"

/// \file
/// The registry on lattices, compiled once for all tests.

namespace tutavia {

extern template std::vector<AnySearch<LatticeSpace>> all_searches<LatticeSpace>();
extern template std::vector<AnySmoother<LatticeSpace>> all_smoothers<LatticeSpace>();
extern template Expected<AnySearch<LatticeSpace>, Failure> make_search<LatticeSpace>(
    std::string_view, std::span<const OptionText>);
extern template Expected<AnySmoother<LatticeSpace>, Failure> make_smoother<LatticeSpace>(
    std::string_view, std::span<const OptionText>);

}  // namespace tutavia
