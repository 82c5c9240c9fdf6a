// SPDX-License-Identifier: MIT
#include "tutavia/registry.hpp"

#include "registry.hpp"

namespace plan_program {

const Algorithms<tutavia::LatticeSpace>& lattice_algorithms() {
  using Space = tutavia::LatticeSpace;
  static const Algorithms<Space> all{
      tutavia::all_searches<Space>(),     tutavia::all_smoothers<Space>(),
      tutavia::vehicle_searches<Space>(), tutavia::vehicle_smoothers<Space>(),
      &tutavia::make_search<Space>,       &tutavia::make_smoother<Space>};
  return all;
}

}  // namespace plan_program
