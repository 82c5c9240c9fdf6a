// SPDX-License-Identifier: MIT
#include "support/registry.hpp"

namespace tutavia {

template std::vector<AnySearch<LatticeSpace>> all_searches<LatticeSpace>();
template std::vector<AnySmoother<LatticeSpace>> all_smoothers<LatticeSpace>();

}  // namespace tutavia
