// SPDX-License-Identifier: MIT
#include "tutavia/registry.hpp"

#include "registry.hpp"

namespace plan_program {

const Algorithms<tutavia::CellSpace>& cell_algorithms() {
  static const Algorithms<tutavia::CellSpace> all{tutavia::all_searches<tutavia::CellSpace>(),
                                                  tutavia::all_smoothers<tutavia::CellSpace>()};
  return all;
}

}  // namespace plan_program
