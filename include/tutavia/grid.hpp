// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The module grid: cells, steps and occupancy grids.

#include "tutavia/grid/cell.hpp"
#include "tutavia/grid/cell_costs.hpp"
#include "tutavia/grid/dilate.hpp"
#include "tutavia/grid/line_of_sight.hpp"
#include "tutavia/grid/movement.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/grid/safety_buffer.hpp"
