// SPDX-License-Identifier: MIT
#include "support/registry.hpp"

namespace tutavia {

template std::vector<AnySearch<LatticeSpace>> all_searches<LatticeSpace>();
template std::vector<AnySmoother<LatticeSpace>> all_smoothers<LatticeSpace>();
template Expected<AnySearch<LatticeSpace>, Failure> make_search<LatticeSpace>(
    std::string_view, std::span<const OptionText>);
template Expected<AnySmoother<LatticeSpace>, Failure> make_smoother<LatticeSpace>(
    std::string_view, std::span<const OptionText>);

}  // namespace tutavia
