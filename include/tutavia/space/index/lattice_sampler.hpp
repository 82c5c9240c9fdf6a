// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "tutavia/core/parts/number_text.hpp"
#include "tutavia/geometry/box.hpp"
#include "tutavia/grid/bitboard/transposed.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/world/frame.hpp"

/// \file
/// sample_lattice: samples clearances on a lattice on which every step is safe.

namespace tutavia::detail {

/// A grid and its frame in the plane.
struct SampledGrid {
  OccupancyGrid grid;
  Frame frame;
};

/// The spacing of a lattice if none is given [m]: 1/200 of the larger side of the bounds.
inline double default_resolution(const Box& bounds) {
  return std::max(bounds.width(), bounds.height()) / 200;
}

/// Checks a resolution and the grid coordinates of the bounds in units of it.
inline Expected<void, Failure> check_resolution(const Box& bounds, double resolution) {
  if (!(resolution > 0) || !std::isfinite(resolution)) {
    return fail(PlanError::invalid_option, "resolution must be positive and finite");
  }
  if (!(bounds.largest_coordinate() / resolution < 0x1p30) ||
      !(bounds.width() / resolution < 0x1p30) || !(bounds.height() / resolution < 0x1p30)) {
    return fail(PlanError::limit_exceeded,
                "resolution " + number_text(resolution) + " m needs more than 2^30 nodes per axis");
  }
  return {};
}

/// Finds the free nodes of a lattice in blocks, from a lower bound of the clearance at each centre.
template <class Clearance>
struct LatticeSampler {
  const Clearance& clearance;
  const Box& bounds;
  SampledGrid& out;
  double threshold;

  /// Marks the free nodes of the block from `low` to `high`, both included.
  void fill(Cell low, Cell high) const {
    if (low.x > high.x || low.y > high.y) return;
    const Point a = out.frame.point(low), b = out.frame.point(high);
    const double at_centre = clearance(lerp(a, b, 0.5));
    const double reach = 0.5 * distance(a, b);
    if (at_centre + reach < threshold) return;
    if (at_centre - reach >= threshold) return set_free(low, high);
    if (low == high) return;  // NaN
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

 private:
  void set_free(Cell low, Cell high) const {
    for (int y = low.y; y <= high.y; ++y) {
      for (int x = low.x; x <= high.x; ++x) {
        // Rounding may move the outermost nodes past the bounds.
        if (bounds.contains(out.frame.point({x, y}))) out.grid.set({x, y}, true);
      }
    }
  }
};

/// Samples a clearance function on the lattice of the points (i delta, j delta) within the bounds.
/// `clearance(p)` is a lower bound of the signed distance from p to the nearest obstacle [m] and
/// 1-Lipschitz: two values differ by at most the distance between the points. `error_bound` is the
/// rounding error of one value [m]. A node is free iff its clearance is at least
/// sqrt(r^2 + delta^2 / 2).
///
/// A segment between two such nodes at most sqrt(2) delta apart keeps a distance of r from every
/// obstacle: if an obstacle point is at least T away from both ends of a segment of length L, then
/// by Stewart's theorem its squared distance to the point at fraction x is at least
/// T^2 - x (1 - x) L^2 >= T^2 - L^2 / 4. So no edge needs a test. The threshold includes a margin
/// of two rounding errors and of 1e-9 delta, which covers paths that start within 1e-9 delta of a
/// node.
///
/// The value at its centre decides a whole block of nodes unless an obstacle boundary is near. The
/// work grows with the length of the boundaries, not with the area.
///
/// Errors: `invalid_option` for a resolution that is not positive and finite, `limit_exceeded` for
/// more than `max_nodes` nodes or more columns than a transpose may have rows.
template <class Clearance>
Expected<SampledGrid, Failure> sample_lattice(const Clearance& clearance, const Box& bounds,
                                              double safety_radius, double error_bound,
                                              double resolution, std::int64_t max_nodes) {
  if (auto valid = check_resolution(bounds, resolution); !valid) return Unexpected{valid.error()};
  const Point low{std::ceil(bounds.min.x() / resolution), std::ceil(bounds.min.y() / resolution)};
  const Point high{std::floor(bounds.max.x() / resolution),
                   std::floor(bounds.max.y() / resolution)};
  const Frame frame{{low.x() * resolution, low.y() * resolution}, resolution};
  const auto count = [](double from, double to) {
    return static_cast<std::int64_t>(std::fmax(to - from + 1, 0));
  };
  auto grid = OccupancyGrid::blocked(count(low.x(), high.x()), count(low.y(), high.y()), max_nodes);
  if (!grid) return Unexpected{grid.error()};
  if (auto valid = check_transpose(*grid); !valid) return std::move(valid).unexpected();
  SampledGrid result{std::move(*grid), frame};
  const double threshold = std::sqrt(safety_radius * safety_radius + resolution * resolution / 2) +
                           2 * error_bound + 1e-9 * resolution;
  const LatticeSampler<Clearance> sampler{clearance, bounds, result, threshold};
  sampler.fill({0, 0}, {result.grid.width() - 1, result.grid.height() - 1});
  return result;
}

}  // namespace tutavia::detail
