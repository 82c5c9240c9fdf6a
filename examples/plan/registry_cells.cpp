// SPDX-License-Identifier: MIT
#include "tutavia/registry.hpp"

#include "registry.hpp"

namespace plan_program {

const Algorithms<tutavia::CellSpace>& cell_algorithms() {
  using Space = tutavia::CellSpace;
  static const Algorithms<Space> all{tutavia::all_searches<Space>(),
                                     tutavia::all_smoothers<Space>(), &tutavia::make_search<Space>,
                                     &tutavia::make_smoother<Space>};
  return all;
}

}  // namespace plan_program
