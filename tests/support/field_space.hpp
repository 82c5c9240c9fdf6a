// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "tutavia/space/distance_field_space.hpp"
#include "tutavia/space/inflated_space.hpp"

/// \file
/// A distance field whose values are the exact clearances of a workspace.

namespace tutavia::test {

/// The signed distance to the nearest obstacle of a workspace.
struct ExactField {
  std::shared_ptr<const InflatedSpace> space;

  double operator()(const Point& p) const { return space->clearance(p); }
};

using FieldSpace = DistanceFieldSpace<ExactField>;

/// The free space of a workspace, known by its distances alone.
inline FieldSpace field_space(const Workspace& world, const DistanceFieldOptions& options) {
  return FieldSpace::build(
             {std::make_shared<const InflatedSpace>(InflatedSpace::build(world).value())},
             world.bounds, world.safety_radius, options)
      .value();
}

}  // namespace tutavia::test
