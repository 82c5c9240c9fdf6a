// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "tutavia/geometry/areal.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// obstacles_from: the obstacles of a workspace from any area.

namespace tutavia {

/// The obstacles that fill an area: a polygon, a box, several polygons, or with
/// geometry/boost_adapt.hpp any areal type of Boost.Geometry.
template <Areal G>
std::vector<Obstacle> obstacles_from(const G& geometry) {
  std::vector<Obstacle> obstacles;
  for (const Polygon& polygon : to_polygons(geometry)) obstacles.emplace_back(polygon);
  return obstacles;
}

}  // namespace tutavia
