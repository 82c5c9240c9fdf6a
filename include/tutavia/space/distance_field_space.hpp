// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <optional>
#include <utility>

#include "tutavia/geometry/segment.hpp"
#include "tutavia/grid/movement.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/space/index/field_minimum.hpp"
#include "tutavia/space/index/grid_layer.hpp"
#include "tutavia/space/index/lattice_sampler.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// DistanceFieldSpace: the free space that a clearance function of your own describes.

namespace tutavia {

/// A function `double(Point)`: a lower bound of the signed distance from a point to the nearest
/// obstacle [m], negative inside, for instance a signed distance field. It is 1-Lipschitz: two
/// values differ by at most the distance between the points, as exact distances do.
///
/// Example: examples/obstacle_sources.cpp.
template <class F>
concept ClearanceFunction = std::copy_constructible<F> &&
    std::regular_invocable<const F&, const Point&> && requires(const F& clearance, const Point& p) {
  { clearance(p) } -> std::floating_point;
};

/// Options of the lattice and of the search for the least clearance.
struct DistanceFieldOptions {
  /// Spacing delta of the nodes (i delta, j delta) [m]. Default: 1/200 of the larger side of the
  /// bounds.
  std::optional<double> resolution{};
  /// How far a computed distance of a segment or an arc may be from the least value along it [m].
  /// Default: the smaller of delta / 100000 and r / 1000 (for r > 0). Halving it makes proofs
  /// beside straight walls take 1.4 times as long.
  std::optional<double> tolerance{};
  MovementRule movement = MovementRule::no_cut;    ///< every rule is safe on a lattice
  std::int64_t max_nodes = std::int64_t{1} << 28;  ///< more than these: limit_exceeded
};

/// The points of the bounds whose clearance is at least the safety radius, according to a function
/// of your own, with a lattice on which every step is safe (see GridBuilder).
///
/// **What proofs mean.** The space knows the function at single points only. A value c > 0 at p
/// states that no obstacle is within c of p, and proofs use nothing else: a proved path keeps the
/// safety radius from every obstacle for which all evaluated values were lower bounds of the
/// distance. A function that overestimates a distance makes proofs wrong. Values may be too low by
/// any amount (then free space is smaller). The rounding of a value is taken to be at most
/// 16 u M (M: largest coordinate, u = 2^-53); subtract larger errors in the function, for instance
/// those of interpolation between the samples of a stored field. A point with the value NaN is not
/// free, but NaN says nothing of the points around it: where nothing is known, return 0 or less,
/// and around it at most the distance to it. A function far below the distances may make the proof
/// of a route fail (`not_proved`) although each of its steps is safe.
///
/// **Ties.** A point or a segment within rounding of the safety radius is not free. A segment whose
/// clearance exceeds the radius by less than about `tolerance` may be refused. Distances of
/// segments and arcs are lower bounds, within `tolerance` of a value of the function, unless one
/// piece takes more than 65536 evaluations: then the bound is lower still. The certificate's
/// `lower` is proved; `upper` belongs to the function: it bounds the true clearance if the
/// function's values are exact distances. A straight piece that is refused within
/// `distance_error_bound()` of the radius is reported as violated.
///
/// The function must be callable from several threads at once if the space is used from them.
/// Immutable: one object serves any number of threads.
///
/// Source of the bounds: Stewart's theorem; branch and bound of Lipschitz functions after
/// Piyavskii 1972, "An algorithm for finding the absolute extremum of a function".
template <ClearanceFunction F>
class DistanceFieldSpace {
 public:
  /// Errors: `invalid_input` for bounds or a radius that `validate` rejects, `invalid_option` for a
  /// resolution or a tolerance that is not positive and finite and for the movement rule `by_edge`,
  /// `limit_exceeded` for more than `max_nodes` nodes.
  static Expected<DistanceFieldSpace, Failure> build(F field, const Box& bounds,
                                                     double safety_radius,
                                                     const DistanceFieldOptions& options = {});

  /// The space of the same function at another safety radius [m]. Errors: those of `build`.
  Expected<DistanceFieldSpace, Failure> with_safety_radius(double radius) const {
    return build(function_, bounds_, radius, options_);
  }

  const F& function() const { return function_; }
  const Box& bounds() const { return bounds_; }
  double safety_radius() const { return safety_radius_; }
  double largest_coordinate() const { return bounds_.largest_coordinate(); }
  /// The tolerance, and the rounding errors of the function's values.
  double distance_error_bound() const { return tolerance_ + 2 * rounding_; }

  bool is_free(const Point& p) const { return bounds_.contains(p) && value(p) >= safety_radius_; }
  bool segment_free(const Point& p, const Point& q) const {
    return bounds_.contains(p) && bounds_.contains(q) &&
           detail::keeps_clearance(Segment{p, q}, safety_radius_, shortest_part(),
                                   [this](const Point& x) { return value(x); });
  }
  /// The function's value.
  double clearance(const Point& p) const { return static_cast<double>(function_(p)); }
  /// See above. The only obstacle has the index 0.
  template <class P>
  NearestObstacle nearest(const P& piece, double cap) const {
    const auto found =
        detail::least_along(piece, cap, tolerance_, [this](const Point& x) { return value(x); });
    if (found.lower >= std::fmin(cap, 0x1p399))
      return {.distance = cap, .parameter = found.parameter};
    return {.distance = found.lower, .parameter = found.parameter, .obstacle = 0};
  }
  bool is_inside(const Point& p) const { return clearance(p) < 0; }

  const OccupancyGrid& grid() const { return layer_.grid(); }
  const Frame& frame() const { return layer_.frame(); }
  MovementRule movement() const { return layer_.movement(); }
  const detail::StopPlanes& stop_planes() const { return layer_.stop_planes(); }
  const detail::TurnPlanes& turn_planes() const { return layer_.turn_planes(); }
  const OccupancyGrid& columns() const { return layer_.columns(); }
  /// The free nodes within sqrt(2) delta of `p` to which the segment is free. If `p` lies within
  /// 1e-9 delta of a free node, that node alone. May be empty.
  EndpointLinks links(const Point& p) const {
    if (!bounds_.contains(p)) return {};
    return layer_.links(p, 1e-9 * frame().resolution,
                        [this](const Point& a, const Point& b) { return segment_free(a, b); });
  }
  /// Whether the segment between two nodes is free.
  bool line_of_sight(Cell a, Cell b) const {
    return segment_free(frame().point(a), frame().point(b));
  }

 private:
  DistanceFieldSpace(F field, const Box& bounds, double radius, double tolerance,
                     detail::SampledGrid sampled, const DistanceFieldOptions& options)
      : function_(std::move(field)),
        bounds_(bounds),
        safety_radius_(radius),
        rounding_(value_rounding(bounds)),
        tolerance_(std::max(tolerance, rounding_)),
        options_(options),
        layer_(std::move(sampled.grid), sampled.frame, options.movement) {}

  /// The rounding errors of one value and of the point at which it is taken [m].
  static double value_rounding(const Box& bounds) {
    return 2 * detail::distance_rounding_error(bounds.largest_coordinate());
  }

  /// The function's value less its rounding errors, within bounds that can be squared.
  double value(const Point& p) const {
    const double computed = clearance(p) - rounding_;
    return computed > -0x1p400 ? std::fmin(computed, 0x1p400) : -0x1p400;  // also for NaN
  }

  /// A part of this length beside a straight wall gives a bound that is at most about a quarter of
  /// the tolerance too low.
  double shortest_part() const {
    const double shortest = std::sqrt(2 * safety_radius_ * tolerance_) + tolerance_;
    return std::min(shortest, frame().resolution / 16);
  }

  F function_;
  Box bounds_;
  double safety_radius_;
  double rounding_;
  double tolerance_;
  DistanceFieldOptions options_;
  detail::GridLayer layer_;
};

template <ClearanceFunction F>
Expected<DistanceFieldSpace<F>, Failure> DistanceFieldSpace<F>::build(
    F field, const Box& bounds, double safety_radius, const DistanceFieldOptions& options) {
  const Workspace limits{.bounds = bounds, .safety_radius = safety_radius};
  if (const auto valid = validate(limits); !valid) return Unexpected{valid.error()};
  if (options.movement == MovementRule::by_edge) {
    return fail(PlanError::invalid_option, "movement by_edge is not defined for clearances");
  }
  const double resolution = options.resolution.value_or(detail::default_resolution(bounds));
  double tolerance = options.tolerance.value_or(1e-5 * resolution);
  if (!options.tolerance && safety_radius > 0)
    tolerance = std::min(tolerance, 1e-3 * safety_radius);
  if (auto valid = detail::check_resolution(bounds, resolution); !valid) {
    return Unexpected{valid.error()};
  }
  if (!(tolerance > 0) || !std::isfinite(tolerance)) {
    return fail(PlanError::invalid_option, "tolerance must be positive and finite");
  }
  auto sampled = detail::sample_lattice(field, bounds, safety_radius, value_rounding(bounds),
                                        resolution, options.max_nodes);
  if (!sampled) return Unexpected{sampled.error()};
  return DistanceFieldSpace(std::move(field), bounds, safety_radius, tolerance, std::move(*sampled),
                            options);
}

}  // namespace tutavia
