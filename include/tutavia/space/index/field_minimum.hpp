// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "tutavia/geometry/arc.hpp"
#include "tutavia/geometry/segment.hpp"

/// \file
/// Lower bounds of the clearance along segments and arcs, from its values at single points.

namespace tutavia::detail {

/// A lower bound of the clearance along a segment that is at most `length` long and whose ends have
/// the clearances `a` and `b` or more [m].
///
/// For an obstacle point o, Stewart's theorem gives the squared distance to the point at fraction
/// t: (1 - t) |a o|^2 + t |b o|^2 - t (1 - t) L^2, which is at least q(t) = (1 - t) a^2 + t b^2 -
/// t (1 - t) L^2. The least q is at t = (L^2 + a^2 - b^2) / (2 L^2). If it is positive, its root is
/// the bound: every point of the segment is inside one of the open discs around the ends with
/// radius a and b, so none is in an obstacle. If it is not, the clearance is 1-Lipschitz, and the
/// bound is (a + b - L) / 2. For a single obstacle point the first bound is exact; beside a
/// straight wall it is L^2 / (8 a) too low. The results are rounded down.
inline double least_between(double a, double b, double length) {
  const double coarse = 0.5 * (a + b - length);
  if (!(a > 0 && b > 0)) return coarse;
  const double squared_a = a * a, squared_b = b * b, squared_length = length * length;
  if (!(squared_length > 0)) return std::min(a, b);
  const double t = (squared_length + squared_a - squared_b) / (2 * squared_length);
  if (t <= 0) return a;
  if (t >= 1) return b;
  const double rounding = 0x1p-49 * (squared_a + squared_b + squared_length);
  const double least = squared_a - squared_length * t * t - rounding;
  return least > 0 ? std::max(coarse, (1 - 0x1p-50) * std::sqrt(least)) : coarse;
}

/// The same for the fraction `share` of a segment or an arc.
inline double least_between(double a, double b, const Segment& segment, double share) {
  return least_between(a, b, share * segment.length());
}
/// An arc of at most half a circle deviates from its chord by R (1 - cos(angle / 2)) <=
/// R angle^2 / 8.
inline double least_between(double a, double b, const Arc& arc, double share) {
  const double length = share * arc.length(), angle = share * std::abs(arc.sweep);
  const double coarse = 0.5 * (a + b - length);
  if (angle > std::numbers::pi) return coarse;
  return std::max(coarse, least_between(a, b, length) - 0.125 * length * angle);
}

/// A part of a piece over the parameters [from, to], with the clearances at its ends.
struct FieldPart {
  double from = 0, to = 1;
  double at_from = 0, at_to = 0;
  int depth = 0;
};

/// The unfinished parts of a piece. Depth-first search holds one sibling per level.
class FieldParts {
 public:
  static constexpr int max_depth = 48;
  /// More evaluations for one piece are not worth it: what is undecided is then given up.
  static constexpr std::size_t max_evaluations = std::size_t{1} << 16;

  explicit FieldParts(const FieldPart& whole) { parts_[size_++] = whole; }

  bool empty() const { return size_ == 0; }
  FieldPart pop() { return parts_[--size_]; }
  /// Pushes both halves; the one whose end has less clearance comes first.
  void push_halves(const FieldPart& part, double middle, double at_middle) {
    const FieldPart left{part.from, middle, part.at_from, at_middle, part.depth + 1};
    const FieldPart right{middle, part.to, at_middle, part.at_to, part.depth + 1};
    const bool left_first = part.at_from < part.at_to;
    parts_[size_++] = left_first ? right : left;
    parts_[size_++] = left_first ? left : right;
  }

 private:
  std::array<FieldPart, max_depth + 2> parts_;
  std::size_t size_ = 0;
};

/// The least clearance along a piece.
struct FieldMinimum {
  double lower = std::numeric_limits<double>::infinity();  ///< a bound of it [m]
  double parameter = 0;                                    ///< where the least value was found
};

/// Bounds the least clearance along a segment or an arc from below, by halving. If it is below
/// `cap` the bound is within `tolerance` of a value at `parameter`, unless the search was given up.
/// `clearance(p)` is never NaN.
template <class P, class Clearance>
FieldMinimum least_along(const P& piece, double cap, double tolerance, const Clearance& clearance) {
  FieldMinimum result;
  const FieldPart whole{0, 1, clearance(piece.point(0)), clearance(piece.point(1))};
  double least = std::min(whole.at_from, whole.at_to);
  result.parameter = whole.at_to < whole.at_from ? 1 : 0;
  std::size_t evaluations = 2;
  FieldParts parts(whole);
  while (!parts.empty()) {
    const FieldPart part = parts.pop();
    const double lower = least_between(part.at_from, part.at_to, piece, part.to - part.from);
    if (lower >= cap || lower >= least - tolerance || part.depth == FieldParts::max_depth ||
        evaluations >= FieldParts::max_evaluations) {
      result.lower = std::min(result.lower, lower);
      continue;
    }
    const double middle = 0.5 * (part.from + part.to);
    const double at_middle = clearance(piece.point(middle));
    ++evaluations;
    if (at_middle < least) {
      least = at_middle;
      result.parameter = middle;
    }
    parts.push_halves(part, middle, at_middle);
  }
  return result;
}

/// Whether a segment is proved to have the clearance `radius`. Parts shorter than `shortest` [m]
/// are not divided any more, so that the answer for ties is no.
template <class Clearance>
bool keeps_clearance(const Segment& segment, double radius, double shortest,
                     const Clearance& clearance) {
  const FieldPart whole{0, 1, clearance(segment.a), clearance(segment.b)};
  if (!(whole.at_from >= radius && whole.at_to >= radius)) return false;
  const double length = segment.length();
  std::size_t evaluations = 2;
  FieldParts parts(whole);
  while (!parts.empty()) {
    const FieldPart part = parts.pop();
    if (least_between(part.at_from, part.at_to, segment, part.to - part.from) >= radius) continue;
    if (!((part.to - part.from) * length >= shortest) || part.depth == FieldParts::max_depth ||
        evaluations >= FieldParts::max_evaluations) {
      return false;
    }
    const double middle = 0.5 * (part.from + part.to);
    const double at_middle = clearance(segment.point(middle));
    ++evaluations;
    if (!(at_middle >= radius)) return false;
    parts.push_halves(part, middle, at_middle);
  }
  return true;
}

}  // namespace tutavia::detail
