// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/lattice_space.hpp"

/// \file
/// The spaces of Python: those of the library with the options that built them, for pickles.

namespace tutavia_python {

using namespace tutavia;

/// tutavia.LatticeSpace.
struct LatticeHandle {
  using Space = LatticeSpace;
  LatticeSpace space;
  LatticeOptions options;
  double safety_radius;  ///< as given; EdgeRule::paper_strict makes that of the space smaller
};

/// tutavia.CellSpace.
struct CellHandle {
  using Space = CellSpace;
  CellSpace space;
  CellOptions options;
};

/// Builds a space without the GIL. Raises the exceptions of its failures.
std::shared_ptr<CellHandle> build_cells(OccupancyGrid cells, const CellOptions& options);

/// The movement rule of a name. Raises InvalidOption.
MovementRule to_movement(const std::string& name);

}  // namespace tutavia_python
