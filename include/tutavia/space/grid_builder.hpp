// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <string>
#include <utility>

#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/world/frame.hpp"

/// \file
/// GridBuilder: samples free space on a lattice on which every step between free nodes is safe.

namespace tutavia {

namespace detail {

/// A function that maps a point to a lower bound of its signed clearance [m]. It is 1-Lipschitz:
/// two values differ by at most the distance between the points, as exact clearances do.
template <class F>
concept ClearanceFunction = std::regular_invocable<const F&, const Point&> &&
    requires(const F& clearance, const Point& p) {
  { clearance(p) } -> std::same_as<double>;
};

}  // namespace detail

/// A grid and its frame in the plane.
struct SampledGrid {
  OccupancyGrid grid;
  Frame frame;
};

/// Options of the sampling. The resolution is required.
struct GridOptions {
  double resolution = 0;                           ///< lattice spacing delta [m]
  std::int64_t max_nodes = std::int64_t{1} << 28;  ///< more than these: limit_exceeded
};

/// Samples a clearance function on the lattice of the points (i delta, j delta) within the bounds.
///
/// A node is free iff its clearance is at least sqrt(r^2 + delta^2 / 2). A segment between two such
/// nodes at most sqrt(2) delta apart keeps a distance of r from every obstacle: if an obstacle
/// point is at least T away from both ends of a segment of length L, then by Stewart's theorem its
/// squared distance to the point at fraction x is at least T^2 - x (1 - x) L^2 >= T^2 - L^2 / 4. So
/// no edge needs a test. The threshold includes a margin of two rounding errors and of 1e-9 delta,
/// which covers paths that start within 1e-9 delta of a node.
///
/// The clearance is 1-Lipschitz, so the value at its centre decides a whole block of nodes unless
/// an obstacle boundary is near. The work grows with the length of the boundaries, not with the
/// area.
template <detail::ClearanceFunction F>
class GridBuilder {
 public:
  /// `error_bound` is the rounding error of one value of `clearance` [m].
  GridBuilder(F clearance, const Box& bounds, double safety_radius, double error_bound)
      : clearance_(std::move(clearance)),
        bounds_(bounds),
        safety_radius_(safety_radius),
        error_bound_(error_bound) {}

  /// Errors: `invalid_option` for a resolution that is not positive and finite, `limit_exceeded`
  /// for too many nodes.
  Expected<SampledGrid, Failure> build(const GridOptions& options) const {
    const double delta = options.resolution;
    if (!(delta > 0) || !std::isfinite(delta)) {
      return fail(PlanError::invalid_option, "resolution must be positive and finite");
    }
    const Point low{std::ceil(bounds_.min.x() / delta), std::ceil(bounds_.min.y() / delta)};
    const Point high{std::floor(bounds_.max.x() / delta), std::floor(bounds_.max.y() / delta)};
    constexpr double largest = 0x1p30;
    if (!(std::fmax(detail::max_magnitude(low), detail::max_magnitude(high)) < largest)) {
      return fail(PlanError::limit_exceeded,
                  "resolution " + std::to_string(delta) + " m needs more than 2^30 nodes per axis");
    }
    const Frame frame{{low.x() * delta, low.y() * delta}, delta};
    const auto count = [](double from, double to) {
      return static_cast<std::int64_t>(std::fmax(to - from + 1, 0));
    };
    auto grid = OccupancyGrid::blocked(count(low.x(), high.x()), count(low.y(), high.y()),
                                       options.max_nodes);
    if (!grid) return Unexpected{grid.error()};
    SampledGrid result{std::move(*grid), frame};
    const Sampler sampler{*this, result,
                          std::sqrt(safety_radius_ * safety_radius_ + delta * delta / 2) +
                              2 * error_bound_ + 1e-9 * delta};
    sampler.fill({0, 0}, {result.grid.width() - 1, result.grid.height() - 1});
    return result;
  }

 private:
  struct Sampler {
    const GridBuilder& builder;
    SampledGrid& out;
    double threshold;

    /// Marks the free nodes of the block from `low` to `high`, both included.
    void fill(Cell low, Cell high) const {
      if (low.x > high.x || low.y > high.y) return;
      const Point a = out.frame.point(low), b = out.frame.point(high);
      const double clearance = builder.clearance_(detail::lerp(a, b, 0.5));
      const double reach = 0.5 * distance(a, b);
      if (clearance + reach < threshold) return;
      if (low == high || clearance - reach >= threshold) return set_free(low, high);
      if (high.x - low.x >= high.y - low.y) {
        const int middle = low.x + (high.x - low.x) / 2;
        fill(low, {middle, high.y});
        fill({middle + 1, low.y}, high);
      } else {
        const int middle = low.y + (high.y - low.y) / 2;
        fill(low, {high.x, middle});
        fill({low.x, middle + 1}, high);
      }
    }

    void set_free(Cell low, Cell high) const {
      for (int y = low.y; y <= high.y; ++y) {
        for (int x = low.x; x <= high.x; ++x) {
          // Rounding may move the outermost nodes past the bounds.
          if (builder.bounds_.contains(out.frame.point({x, y}))) out.grid.set({x, y}, true);
        }
      }
    }
  };

  F clearance_;
  Box bounds_;
  double safety_radius_;
  double error_bound_;
};

/// A builder for any space with clearances. It keeps a reference to the space.
template <ClearanceSpace S>
auto grid_builder(const S& space) {
  return GridBuilder([&space](const Point& p) -> double { return space.clearance(p); },
                     space.bounds(), space.safety_radius(), space.distance_error_bound());
}

}  // namespace tutavia
