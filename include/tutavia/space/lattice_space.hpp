// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/space/grid_builder.hpp"
#include "tutavia/space/inflated_space.hpp"

/// \file
/// LatticeSpace: a workspace with a lattice of safe nodes laid over it.

namespace tutavia {

/// How to lay the lattice; every field but the resolution has a default.
struct LatticeOptions {
  double resolution = 0;  ///< spacing delta of the nodes (i delta, j delta) [m]
  MovementRule movement = MovementRule::no_cut;    ///< any rule is safe on a lattice
  std::int64_t max_nodes = std::int64_t{1} << 28;  ///< more than these: limit_exceeded
};

/// The free space of a workspace and a lattice in it on which every step is safe (see GridBuilder),
/// so that a path of steps needs no further test. Points off the lattice are joined to it by proved
/// segments. Immutable: one object serves any number of threads.
class LatticeSpace : public InflatedSpace {
 public:
  /// `invalid_input` for a broken workspace, `invalid_option` for a resolution that is not positive
  /// and finite, `limit_exceeded` for more than `max_nodes` nodes.
  static Expected<LatticeSpace, Failure> build(const Workspace& workspace,
                                               const LatticeOptions& options) {
    auto space = InflatedSpace::build(workspace);
    if (!space) return Unexpected{space.error()};
    auto sampled = grid_builder(*space).build(
        {.resolution = options.resolution, .max_nodes = options.max_nodes});
    if (!sampled) return Unexpected{sampled.error()};
    return LatticeSpace(std::move(*space), std::move(*sampled), options.movement);
  }

  const OccupancyGrid& grid() const { return sampled_.grid; }
  const Frame& frame() const { return sampled_.frame; }
  MovementRule movement() const { return movement_; }

  /// Joins `p` to the free nodes within sqrt(2) delta that it reaches by a free segment; to the
  /// node alone where it lies within 1e-9 delta of one. None where there is no such node.
  Links links(const Point& p) const {
    Links result;
    if (!bounds().contains(p)) return result;
    const double delta = frame().resolution;
    const Cell centre = frame().nearest_cell(p);
    const auto usable = [&](Cell cell) { return grid().contains(cell) && grid().is_free(cell); };
    if (usable(centre) && distance(frame().point(centre), p) <= 1e-9 * delta) {
      result.push_back({centre, 0});
      return result;
    }
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        const Cell cell = centre + Cell{x, y};
        if (!usable(cell)) continue;
        const Point node = frame().point(cell);
        const double length = distance(node, p);
        if (length <= std::numbers::sqrt2 * delta * (1 + 1e-9) && segment_free(p, node)) {
          result.push_back({cell, length});
        }
      }
    }
    return result;
  }

 private:
  LatticeSpace(InflatedSpace space, SampledGrid sampled, MovementRule movement)
      : InflatedSpace(std::move(space)), sampled_(std::move(sampled)), movement_(movement) {}

  SampledGrid sampled_;
  MovementRule movement_;
};

}  // namespace tutavia
