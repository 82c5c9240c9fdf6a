// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "../plan/input.hpp"
#include "drive_result.hpp"
#include "encounters.hpp"
#include "global_planner.hpp"
#include "options.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/lattice_space.hpp"

/// \file
/// drive: one drive, from the global path to the end.

namespace drive_program {

/// A drive, in the frame of the grid.
struct Drive {
  GlobalPath path{};
  DriveResult result{};
  std::vector<Encounter> encounters{};
};

/// Plans a path and drives along it. Errors: those of the planner. Each space has its own source
/// file, because it takes long to compile.
Expected<Drive, Failure> drive(const LatticeSpace& space, const plan_program::Task& task,
                               const Arguments& args, const Progress& progress);
Expected<Drive, Failure> drive(const CellSpace& space, const plan_program::Task& task,
                               const Arguments& args, const Progress& progress);

}  // namespace drive_program
