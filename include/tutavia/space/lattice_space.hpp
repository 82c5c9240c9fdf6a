// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/space/grid_builder.hpp"
#include "tutavia/space/index/grid_layer.hpp"
#include "tutavia/space/inflated_space.hpp"

/// \file
/// LatticeSpace: the free space of a workspace with a lattice of safe nodes.

namespace tutavia {

/// Options of the lattice.
struct LatticeOptions {
  /// Spacing delta of the nodes (i delta, j delta) [m]. Default: 1/200 of the larger side of the
  /// bounds.
  std::optional<double> resolution{};
  MovementRule movement = MovementRule::no_cut;    ///< every rule is safe on a lattice
  std::int64_t max_nodes = std::int64_t{1} << 28;  ///< more than these: limit_exceeded
};

/// The free space of a workspace with a lattice on which every step is safe (see GridBuilder), so a
/// path of steps needs no further test. Proved segments join points off the lattice to it. It
/// offers every operation of InflatedSpace. Immutable: one object serves any number of threads.
class LatticeSpace {
 public:
  /// Errors: `invalid_input` for a workspace that `validate` rejects, `invalid_option` for a
  /// resolution that is not positive and finite, `limit_exceeded` for more than `max_nodes` nodes.
  static Expected<LatticeSpace, Failure> build(const Workspace& workspace,
                                               const LatticeOptions& options) {
    auto space = InflatedSpace::build(workspace);
    if (!space) return Unexpected{space.error()};
    auto sampled = grid_builder(*space).build(
        {.resolution = options.resolution.value_or(default_resolution(workspace.bounds)),
         .max_nodes = options.max_nodes});
    if (!sampled) return Unexpected{sampled.error()};
    return LatticeSpace(std::move(*space), detail::GridLayer(std::move(sampled->grid),
                                                             sampled->frame, options.movement));
  }

  /// The free space without the lattice.
  const InflatedSpace& inflated() const { return inflated_; }
  const Workspace& workspace() const { return inflated_.workspace(); }
  const Box& bounds() const { return inflated_.bounds(); }
  double safety_radius() const { return inflated_.safety_radius(); }
  double largest_coordinate() const { return inflated_.largest_coordinate(); }
  double distance_error_bound() const { return inflated_.distance_error_bound(); }
  bool is_free(const Point& p) const { return inflated_.is_free(p); }
  bool segment_free(const Point& p, const Point& q) const { return inflated_.segment_free(p, q); }
  double clearance(const Point& p) const { return inflated_.clearance(p); }
  template <class P>
  NearestObstacle nearest(const P& piece, double cap) const {
    return inflated_.nearest(piece, cap);
  }
  bool is_inside(const Point& p) const { return inflated_.is_inside(p); }
  template <class Visit>
  void for_each_feature(const Box& box, Visit visit) const {
    inflated_.for_each_feature(box, visit);
  }
  template <class Visit>
  void for_each_corner(const Box& box, Visit visit) const {
    inflated_.for_each_corner(box, visit);
  }

  const OccupancyGrid& grid() const { return layer_.grid(); }
  const Frame& frame() const { return layer_.frame(); }
  MovementRule movement() const { return layer_.movement(); }
  const detail::StopPlanes& stop_planes() const { return layer_.stop_planes(); }
  const OccupancyGrid& columns() const { return layer_.columns(); }

  /// The free nodes within sqrt(2) delta of `p` to which the segment is free. If `p` lies within
  /// 1e-9 delta of a free node, that node alone. May be empty.
  EndpointLinks links(const Point& p) const {
    if (!bounds().contains(p)) return {};
    return layer_.links(p, 1e-9 * frame().resolution,
                        [this](const Point& a, const Point& b) { return segment_free(a, b); });
  }

  /// Whether the segment between two nodes is free.
  bool line_of_sight(Cell a, Cell b) const {
    return segment_free(frame().point(a), frame().point(b));
  }

 private:
  static double default_resolution(const Box& bounds) {
    return std::max(bounds.width(), bounds.height()) / 200;
  }

  LatticeSpace(InflatedSpace space, detail::GridLayer layer)
      : inflated_(std::move(space)), layer_(std::move(layer)) {}

  InflatedSpace inflated_;
  detail::GridLayer layer_;
};

}  // namespace tutavia
