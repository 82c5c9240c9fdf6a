// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/geometry/tangent/tangent_line.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// SightSectors: how far the tangents of a circle reach, by their direction.

namespace tutavia::detail {

/// For each sector of directions around a circle's centre, a distance beyond which obstacles block
/// every tangent of the circle. A fast filter: it hides no circle to which a tangent is free.
///
/// Why it hides none: let r be the safety radius, and rho at least both circles' radii. A tangent
/// stays within rho of the line of centres. If the centres are four times the sum of the radii
/// apart, its direction deviates from that line by an angle whose sine is at most 1/4. Let an edge
/// of an obstacle stick out by at least 2 (rho - r) on both sides of the line of centres. Then both
/// of its ends lie less than r beyond the tangent's line, one on each side of it. So one of them is
/// nearer to that line than r, or the edge crosses it. If the other circle is a little farther away
/// than the edge, this happens between the points of contact, and the tangent is blocked.
class SightSectors {
 public:
  /// Finds what the obstacles near a circle hide from it. `circles`: the number of circles in the
  /// space, from which follows how far obstacles are near.
  template <FeatureSpace S>
  void look_from(const S& space, const OrientedCircle& at, std::size_t circles);

  /// Whether every tangent to a circle of this radius is blocked. `between` is the vector from the
  /// centre of the circle of `look_from` to its centre; without a call of that, nothing is hidden.
  /// \pre the centres are at least four times the sum of the radii apart
  bool hides(const Point& between, double radius) const {
    const double norm = sum_norm(between);
    if (!(radius <= largest_radius_ && norm > 0)) return false;
    const auto sector = static_cast<std::size_t>(position(between, norm)) % sectors;
    // 2 % for the width of a sector, 1 % for the margins, 1 % for the tangent's deviation.
    return nearness_[sector] * norm > 1.04;
  }

 private:
  static constexpr std::size_t sectors = 512;
  static constexpr double quarter = static_cast<double>(sectors) / 4;

  static double sum_norm(const Point& p) { return std::abs(p.x()) + std::abs(p.y()); }
  /// The direction of a vector, counterclockwise from the x-axis, in sectors. They divide the
  /// square |x| + |y| = 1 evenly, so directions need no angles, whose last bits differ between
  /// libraries.
  static double position(const Point& p, double norm) {
    const double x = p.x() / norm * quarter;
    return p.y() >= 0 ? quarter - x : 3 * quarter + x;
  }
  /// The point on that square where a sector begins.
  static Point ray(std::size_t sector) {
    const double k = static_cast<double>(sector);
    const double x = (k <= 2 * quarter ? quarter - k : k - 3 * quarter) / quarter;
    return {x, k <= 2 * quarter ? 1 - std::abs(x) : std::abs(x) - 1};
  }

  /// Adds what an obstacle's edge hides; its ends are relative to the centre.
  void add_edge(const Point& a, const Point& b);

  std::array<double, sectors> nearness_{};  // 1 / distance in the sum norm; 0: nothing is hidden
  double largest_radius_ = 0;               // of circles that can be hidden
  double margin_ = 0;                       // by which an edge must stick out
};

inline void SightSectors::add_edge(const Point& a, const Point& b) {
  const double turn = cross(a, b);
  const Point first = turn > 0 ? a : b, last = turn > 0 ? b : a;
  const Point along = last - first;
  // Edges seen end-on, or so near that rounding matters, are left out.
  if (!(std::abs(turn) > 256 * margin_ * sum_norm(along))) return;
  const double first_norm = sum_norm(first), last_norm = sum_norm(last);
  // A quarter of the square spans at least one radian, and the sum norm is at most 1.42 times the
  // length.
  const double turned = 2 * 1.42 * margin_ * quarter;
  const double from = position(first, first_norm) + turned / first_norm;
  double to = position(last, last_norm) - turned / last_norm;
  if (to < from) to += sectors;
  const auto begin = static_cast<std::size_t>(std::ceil(from)), end = static_cast<std::size_t>(to);
  if (end > begin + sectors / 2) return;  // the margins leave nothing between them
  // On the ray through a point d of the square, the edge has the distance turn / cross(d, along).
  const Point slope = along / std::abs(turn);
  double before = cross(ray(begin % sectors), slope);
  for (std::size_t k = begin; k < end; ++k) {
    const double after = cross(ray((k + 1) % sectors), slope);
    double& nearness = nearness_[k % sectors];
    nearness = std::max(nearness, std::min(before, after));
    before = after;
  }
}

template <FeatureSpace S>
void SightSectors::look_from(const S& space, const OrientedCircle& at, std::size_t circles) {
  nearness_.fill(0);
  const double error = space.distance_error_bound();
  largest_radius_ = std::max(at.radius, space.safety_radius() + 4 * error);
  margin_ = 2 * (largest_radius_ - space.safety_radius()) + 64 * error;
  const Box& bounds = space.bounds();
  const double spacing = std::sqrt(bounds.width() * bounds.height() / static_cast<double>(circles));
  const Box window = Box{at.center, at.center}.inflated(8 * spacing);
  space.for_each_feature(window, [&](const Segment& core, double radius) {
    const Point a = core.a - at.center;
    if (radius == 0) return add_edge(a, core.b - at.center);
    // The diameter across the line of sight stands for a disc.
    const double distance = a.norm();
    if (distance > radius) {
      const Point half = perpendicular(a) * (radius / distance);
      add_edge(a - half, a + half);
    }
  });
}

}  // namespace tutavia::detail
