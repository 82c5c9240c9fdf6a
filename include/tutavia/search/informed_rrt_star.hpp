// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string_view>

#include "tutavia/core/random.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/neighbours.hpp"
#include "tutavia/search/tree/rewired_tree.hpp"

/// \file
/// InformedRrtStar: RRT* that samples only points that can shorten its path.

namespace tutavia {

/// `RrtStar` that, once it has a path, samples uniformly from the ellipse of points through which a
/// shorter path may run: the sum of their distances from start and goal is less than the path's
/// length.
///
/// All else is as for `RrtStar`.
///
/// Source: Gammell, Srinivasa and Barfoot 2014, "Informed RRT*: optimal sampling-based path
/// planning focused via direct sampling of an admissible ellipsoidal heuristic".
///
/// Example: examples/searches_among_polygons.cpp.
struct InformedRrtStar {
  static constexpr std::string_view name = "informed_rrt_star";
  using Scratch = detail::RewiredTreeScratch;

  /// Longest step [m], at most the diagonal of the bounds. Default: 1/25 of the bounds' longer
  /// side.
  std::optional<double> step{};
  double goal_bias = 0.05;  ///< share of iterations that grow towards the goal until it is reached
  std::uint32_t max_iterations = 3000;
  Neighbours neighbours = Neighbours::k_nearest;
  double rewire_factor = 1.1;  ///< asymptotic optimality needs more than 1

  template <FreeSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const;
};

namespace detail {

/// The points whose distances from two foci add up to at most `length`.
class Ellipse {
 public:
  Ellipse(const Point& a, const Point& b, double length)
      : a_(a), b_(b), length_(length), centre_(lerp(a, b, 0.5)) {
    const double gap = distance(a, b);
    along_ = {(b.x() - a.x()) / gap, (b.y() - a.y()) / gap};
    half_axis_ = length / 2;
    other_half_axis_ = std::sqrt(std::max(0.0, length - gap) * (length + gap)) / 2;
  }

  double area() const { return std::numbers::pi * half_axis_ * other_half_axis_; }
  bool contains(const Point& p) const { return distance(a_, p) + distance(p, b_) <= length_; }

  /// Uniform over the ellipse: a point of the unit disc, scaled to the axes.
  Point sample(Random& random) const {
    double u = 0, v = 0;
    do {
      u = random.uniform(-1, 1);
      v = random.uniform(-1, 1);
    } while (u * u + v * v > 1);
    return offset_along(offset_along(centre_, u * half_axis_, along_), v * other_half_axis_,
                        perpendicular(along_));
  }

 private:
  Point a_, b_;
  double length_;
  Point centre_, along_;
  double half_axis_, other_half_axis_;
};

/// Uniform over the intersection of the bounds with an ellipse whose foci lie in them. Draws from
/// the smaller of the two until the other contains the point.
template <FreeSpace S, Observer O>
Point sample_in(const Ellipse& ellipse, TreeGrowth<S, O>& growth) {
  const Box& bounds = growth.bounds();
  if (ellipse.area() < bounds.width() * bounds.height()) {
    while (true) {
      Point p = ellipse.sample(growth.random());
      if (bounds.contains(p)) return p;
    }
  }
  while (true) {
    Point p = growth.sample();
    if (ellipse.contains(p)) return p;
  }
}

}  // namespace detail

template <FreeSpace S, Observer O>
Expected<Route, Failure> InformedRrtStar::search(const S& space, const Query& query,
                                                 Scratch& scratch, O& observer) const {
  return detail::search_with_rewired_tree(
      *this, space, query, scratch, observer, [&](auto& growth, double cost) {
        return detail::sample_in(detail::Ellipse(query.start, query.goal, cost), growth);
      });
}

}  // namespace tutavia
