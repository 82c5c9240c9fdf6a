// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The module space: free space over polygons, discs, lattices, distance fields and cells.

#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/clearance_costs.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/space/distance_field_space.hpp"
#include "tutavia/space/grid_builder.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/space/lattice_space.hpp"
#include "tutavia/space/links.hpp"
#include "tutavia/space/nearest_free.hpp"
#include "tutavia/space/overlay_space.hpp"
