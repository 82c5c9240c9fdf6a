// SPDX-License-Identifier: MIT
/// \file
/// Everything that planning on a grid needs, and proof that none of it includes Boost.

#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/pull/shortcut.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/dijkstra.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "tutavia/world/scene.hpp"

#if defined(BOOST_CONFIG_HPP) || defined(BOOST_VERSION) || defined(BOOST_VERSION_HPP)
#error "a header that planning on a grid needs includes Boost"
#endif
