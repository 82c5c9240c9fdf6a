// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/natural_spline.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/smooth/concepts.hpp"
#include "tutavia/smooth/route/input_checks.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// SmoothingSpline: the least-squares cubic spline of the SSA-A* paper.

namespace tutavia {

/// Fits a cubic smoothing spline to the nodes of a polyline, including the grid nodes on a grid
/// path. Cubic Bezier pieces then join points of the spline at equal parameters, with the spline's
/// tangents.
///
/// The spline minimises the integral of the squared second derivative among those whose sum of
/// squared distances from the nodes is within a bound; see NaturalSpline. A route that close to a
/// straight line becomes straight. If a piece is not proved, or the spline is longer than the
/// polyline, the route is halved at its middle node. Each half gets its own spline, with its share
/// of the bound and of the pieces, down to single steps of the route. There may be corners at nodes
/// where the route was cut.
///
/// Guarantees: the ends are exact; every piece is proved at the space's safety radius; the result
/// is never longer than the input. O(n log n) for n nodes.
///
/// Source: Zhou, Shang, Wang, Zuo 2025, Appl. Sci. 15(10) 5583 (SSA). They take FITPACK's
/// parametric smoothing spline with s = 0.1 and 100 points; here Reinsch's criterion replaces it.
///
/// Example: examples/smoothers.cpp.
struct SmoothingSpline {
  static constexpr std::string_view name = "smoothing_spline";

  /// Bound s on the sum of squared distances from the nodes. In squared units of the grid's
  /// resolution, or in square metres if the space has no grid. With 0, or nearly 0, a spline is
  /// hardly ever shorter than the route, which is then returned.
  double smoothing = 0.1;
  /// Number of spline points on the whole route, joined by Bezier pieces.
  std::size_t output_points = 100;

  /// Errors: `invalid_option` for a smoothing that is negative or NaN and for less than 2 or more
  /// than a million output points; `invalid_input` for a curve that is not free or not of segments
  /// and arcs; those of the budget.
  template <ClearanceSpace S>
  Expected<Curve, Failure> smooth(const S& space, const Curve& input, const Budget& budget) const;
};

namespace detail {

/// Smooths a route section by section.
template <ClearanceSpace S>
class PiecewiseSplineFit {
 public:
  /// `bound` and `pieces` are those of the whole route. \pre no two successive nodes are equal, and
  /// the steps between them are proved
  PiecewiseSplineFit(const S& space, const Budget& budget, std::span<const Point> nodes,
                     double bound, std::size_t pieces)
      : space_(space),
        budget_(budget),
        nodes_(nodes),
        bound_per_node_(bound / static_cast<double>(nodes.size())),
        pieces_per_step_(static_cast<double>(pieces) / static_cast<double>(nodes.size() - 1)),
        rounding_(8 * 0x1p-53 * space.largest_coordinate()) {}

  /// Appends the pieces from node `first` to `last` to the result; an error if the budget has
  /// ended. \pre first < last
  Expected<void, Failure> smooth(std::size_t first, std::size_t last) {
    if (const auto exceeded = budget_.exceeded()) return fail(*exceeded, "while smoothing");
    if (last - first == 1) {
      append({nodes_[first], nodes_[last]});
    } else if (!fit(nodes_.subspan(first, last - first + 1))) {
      const std::size_t middle = first + (last - first) / 2;
      if (auto half = smooth(first, middle); !half) return half;
      return smooth(middle, last);
    }
    return {};
  }

  const std::vector<Piece>& result() const { return result_; }

 private:
  /// Appends the spline of a section, if it is proved and no longer than the section.
  bool fit(std::span<const Point> section) {
    const auto count = static_cast<double>(section.size());
    const double bound = count * std::max(bound_per_node_, rounding_ * rounding_);
    const NaturalSpline spline = NaturalSpline::within(section, bound);
    if (spline.is_straight()) {
      const Segment chord{section.front(), section.back()};
      const bool proved = is_proved_free(space_, chord);
      if (proved) append(chord);
      return proved;
    }
    const double share = std::max(std::round(pieces_per_step_ * (count - 1)), 1.0);
    Curve curve;
    if (!add_pieces(spline, section, static_cast<std::uint64_t>(share), curve)) return false;
    if (!(curve.length() <= length(section))) return false;
    result_.insert(result_.end(), curve.pieces().begin(), curve.pieces().end());
    return true;
  }

  /// Adds `count` pieces between points at equal parameters; false if one is not proved.
  bool add_pieces(const NaturalSpline& spline, std::span<const Point> section, std::uint64_t count,
                  Curve& curve) const {
    const double step = spline.end() / static_cast<double>(count);
    Point start = section.front(), tangent = spline.derivative(0);
    for (std::uint64_t i = 1; i <= count; ++i) {
      // Out of time; the halves of the section will report it.
      if (i % 256 == 0 && budget_.exceeded()) return false;
      const double t = i < count ? static_cast<double>(i) * step : spline.end();
      const Point end = i < count ? spline.point(t) : section.back();
      const Point end_tangent = spline.derivative(t);
      const CubicBezier piece{{start, offset_along(start, step / 3, tangent),
                               offset_along(end, -step / 3, end_tangent), end}};
      if (!is_proved_free(space_, piece)) return false;
      curve.push_back(piece);
      start = end;
      tangent = end_tangent;
    }
    return true;
  }

  /// Appends a proved segment, merged with the previous one if both lie on one line.
  void append(const Segment& segment) {
    const Segment* before = result_.empty() ? nullptr : result_.back().get_if<Segment>();
    if (before != nullptr) {
      const Segment both{before->a, segment.b};
      const bool on_line = (segment.b - segment.a).dot(before->b - before->a) > 0 &&
                           distance(segment.a, both) <= rounding_;
      if (on_line && is_proved_free(space_, both)) {
        result_.back() = both;
        return;
      }
    }
    result_.emplace_back(segment);
  }

  static double length(std::span<const Point> section) {
    double sum = 0;
    for (std::size_t i = 1; i < section.size(); ++i) sum += distance(section[i - 1], section[i]);
    return sum;
  }

  const S& space_;
  const Budget& budget_;
  std::span<const Point> nodes_;
  double bound_per_node_, pieces_per_step_;
  double rounding_;  // nodes this close to a line count as on it [m]
  std::vector<Piece> result_;
};

}  // namespace detail

template <ClearanceSpace S>
Expected<Curve, Failure> SmoothingSpline::smooth(const S& space, const Curve& input,
                                                 const Budget& budget) const {
  if (!(smoothing >= 0)) return fail(PlanError::invalid_option, "smoothing must not be negative");
  if (output_points < 2) {
    return fail(PlanError::invalid_option, "output_points must be at least 2");
  }
  if (output_points > 1'000'000) {
    return fail(PlanError::invalid_option, "output_points must be at most a million");
  }
  auto route = detail::free_nodes(space, input, budget, "the smoothing spline");
  if (!route) return Unexpected{route.error()};
  std::vector<Point>& nodes = *route;
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  if (nodes.size() < 2) return Curve::polyline(nodes);

  const double unit = detail::length_unit(space), bound = smoothing * (unit * unit);
  detail::PiecewiseSplineFit sections(space, budget, nodes, bound, output_points - 1);
  if (auto smoothed = sections.smooth(0, nodes.size() - 1); !smoothed) {
    return std::move(smoothed).unexpected();
  }
  Curve result;
  result.reserve(sections.result().size());
  for (const Piece& piece : sections.result()) result.push_back(piece);
  return result;
}

}  // namespace tutavia
