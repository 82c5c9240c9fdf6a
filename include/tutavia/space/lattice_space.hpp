// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/space/index/grid_layer.hpp"
#include "tutavia/space/index/lattice_sampler.hpp"
#include "tutavia/space/index/strict_edges.hpp"
#include "tutavia/space/inflated_space.hpp"

/// \file
/// LatticeSpace: the free space of a workspace with a lattice of safe nodes.

namespace tutavia {

/// Which nodes of a lattice are free, and how they are joined.
enum class EdgeRule {
  /// Nodes have the clearance with which every step that the movement rule allows is safe (see
  /// GridBuilder). No step needs a test of its own.
  uniform,
  /// The rule of Abdulshaheed 2025, "A Delta-Smoothed Path Algorithm", section 3, to reproduce its
  /// tables: nodes lie outside safety zones with mitred corners; two nodes are joined if the
  /// segment between them does, and if their distance, computed in double precision, is at most
  /// sqrt(2) delta without any tolerance. About half of the diagonals fail that comparison by
  /// rounding errors alone, which makes the paper's A* paths longer than those of an 8-connected
  /// lattice. `movement` must be left alone; `movement()` is `by_edge`, and searches that need a
  /// movement rule answer `invalid_option`. The paper's paths may touch the zones. So that rounding
  /// does not part them, the space's safety radius is smaller than the workspace's by 1e-9 m. Every
  /// step is proved at that radius.
  paper_strict,
};

/// Options of the lattice.
struct LatticeOptions {
  /// Spacing delta of the nodes (i delta, j delta) [m]. Default: 1/200 of the larger side of the
  /// bounds.
  std::optional<double> resolution{};
  MovementRule movement = MovementRule::no_cut;    ///< every rule is safe on a lattice
  std::int64_t max_nodes = std::int64_t{1} << 28;  ///< more than these: limit_exceeded
  EdgeRule edges = EdgeRule::uniform;
};

/// The free space of a workspace with a lattice on which every step is safe (see GridBuilder), so a
/// path of steps needs no further test. Proved segments join points off the lattice to it. It
/// offers every operation of InflatedSpace. Immutable: one object serves any number of threads.
class LatticeSpace {
 public:
  /// Errors: `invalid_input` for a workspace that `validate` rejects, `invalid_option` for a
  /// resolution that is not positive and finite and for a movement rule that `edges` does not
  /// allow, `limit_exceeded` for more than `max_nodes` nodes.
  static Expected<LatticeSpace, Failure> build(const Workspace& workspace,
                                               const LatticeOptions& options) {
    const bool is_strict = options.edges == EdgeRule::paper_strict;
    if (options.movement == MovementRule::by_edge ||
        (is_strict && options.movement != MovementRule::no_cut)) {
      return fail(
          PlanError::invalid_option,
          "the edge rule paper_strict brings its own movement rule, by_edge, which cannot be "
          "chosen; leave movement at no_cut with it");
    }
    if (auto valid = validate(workspace); !valid) return std::move(valid).unexpected();
    Workspace obstacles = workspace;
    if (is_strict) obstacles.safety_radius = std::max(workspace.safety_radius - touching, 0.0);
    auto space = InflatedSpace::build(std::move(obstacles));
    if (!space) return Unexpected{space.error()};
    auto sampled = detail::sample_lattice(
        [&space](const Point& p) { return space->clearance(p); }, space->bounds(),
        space->safety_radius(), space->distance_error_bound(),
        options.resolution.value_or(detail::default_resolution(workspace.bounds)),
        options.max_nodes);
    if (!sampled) return Unexpected{sampled.error()};
    std::shared_ptr<const detail::StrictEdges> edges;
    if (is_strict) {
      edges = std::make_shared<const detail::StrictEdges>(
          detail::strict_edges(*space, sampled->frame, sampled->grid));
    }
    return LatticeSpace(std::move(*space),
                        detail::GridLayer(std::move(sampled->grid), sampled->frame,
                                          is_strict ? MovementRule::by_edge : options.movement),
                        std::move(edges));
  }

  /// The lattice of the same obstacles and nodes at another safety radius [m]. Errors: those of
  /// `build`.
  Expected<LatticeSpace, Failure> with_safety_radius(double radius) const {
    Workspace obstacles = workspace();
    obstacles.safety_radius = radius;
    LatticeOptions options{.resolution = frame().resolution, .movement = movement()};
    options.max_nodes = std::int64_t{grid().width()} * grid().height();
    if (edges_ != nullptr) {
      options.movement = MovementRule::no_cut;
      options.edges = EdgeRule::paper_strict;
      obstacles.safety_radius += touching;
    }
    return build(obstacles, options);
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
  /// The steps of every node by its index in `grid()`; empty unless `movement()` is `by_edge`.
  std::span<const StepSet> edge_steps() const {
    return edges_ != nullptr ? std::span<const StepSet>(edges_->steps) : std::span<const StepSet>();
  }
  const detail::StopPlanes& stop_planes() const { return layer_.stop_planes(); }
  const detail::TurnPlanes& turn_planes() const { return layer_.turn_planes(); }
  const OccupancyGrid& columns() const { return layer_.columns(); }

  /// The free nodes within sqrt(2) delta of `p` to which the segment is free. If `p` lies within
  /// 1e-9 delta of a free node, that node alone. If there is none, nodes up to 16 spacings away.
  /// May be empty.
  EndpointLinks links(const Point& p) const {
    if (!bounds().contains(p)) return {};
    return layer_.links(p, 1e-9 * frame().resolution,
                        [this](const Point& a, const Point& b) { return can_join(a, b); });
  }

  /// Whether the segment between two nodes is free.
  bool line_of_sight(Cell a, Cell b) const { return can_join(frame().point(a), frame().point(b)); }

 private:
  /// By how much the radius is smaller with EdgeRule::paper_strict [m].
  static constexpr double touching = 1e-9;

  /// Whether a segment is free, with EdgeRule::paper_strict also by the paper's zones.
  bool can_join(const Point& p, const Point& q) const {
    return segment_free(p, q) && (edges_ == nullptr || !edges_->zones.enters(p, q));
  }

  LatticeSpace(InflatedSpace space, detail::GridLayer layer,
               std::shared_ptr<const detail::StrictEdges> edges)
      : inflated_(std::move(space)), layer_(std::move(layer)), edges_(std::move(edges)) {}

  InflatedSpace inflated_;
  detail::GridLayer layer_;
  std::shared_ptr<const detail::StrictEdges> edges_;  // null: those of the movement rule
};

}  // namespace tutavia
