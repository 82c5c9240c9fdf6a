// SPDX-License-Identifier: MIT
#include "tutavia/registry.hpp"

#include "registry.hpp"

namespace plan_program {

const Algorithms<tutavia::LatticeSpace>& lattice_algorithms() {
  static const Algorithms<tutavia::LatticeSpace> all{
      tutavia::all_searches<tutavia::LatticeSpace>(),
      tutavia::all_smoothers<tutavia::LatticeSpace>()};
  return all;
}

}  // namespace plan_program
