// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/geometry/segment.hpp"

/// \file
/// ClosestParameter: the point of a curved piece nearest to the origin.

namespace tutavia::detail {

/// Branch and bound for the parameter of a piece P nearest to the origin. The distance of a part is
/// at least that of its chord less its deviation, and halving divides the deviation by four.
/// Parameters within `tolerance` of the minimum distance are ties. If the piece is nearly a circle
/// around the origin, halving excludes nothing, and the search ends after some thousand parts; its
/// result then exceeds the minimum by at most the deviation of a 1024th of the piece.
template <class P>
class ClosestParameter {
 public:
  explicit ClosestParameter(const P& piece) {
    const Box box = piece.box();
    tolerance_ = 1e-12 * (box.width() + box.height()) + 256 * 0x1p-53 * box.largest_coordinate();
    consider(0, piece.start().norm());
    consider(1, piece.end().norm());
    descend(piece, 0, 1, 0);
    polish(piece);
  }

  double parameter() const { return parameter_; }

 private:
  static constexpr int coarse_depth = 10;
  static constexpr int most_fine_parts = 4096;

  void descend(const P& part, double from, double to, int depth) {
    const Segment chord{part.start(), part.end()};
    const double deviation = part.deviation();
    if (!(distance(Point::Zero(), chord) - deviation <= least_ + tolerance_)) return;
    const double local = chord.nearest_parameter(Point::Zero());
    consider(from + local * (to - from), part.point(local).norm());
    if (!(deviation > tolerance_ / 2)) return;
    if (depth >= coarse_depth && ++fine_parts_ > most_fine_parts) return;
    const auto [left, right] = part.halves();
    const double middle = 0.5 * (from + to);
    if (local < 0.5) descend(left, from, middle, depth + 1);
    descend(right, middle, to, depth + 1);
    if (!(local < 0.5)) descend(left, from, middle, depth + 1);
  }

  void consider(double t, double distance) {
    least_ = std::min(least_, distance);
    if (distance > least_ + tolerance_) return;
    if (t < parameter_ || distance_ > least_ + tolerance_) {
      parameter_ = t;
      distance_ = distance;
    }
  }

  /// Newton's method for B . B' = 0: the distance is flat around its minimum, so the tolerance
  /// alone would determine only half the digits of the parameter.
  void polish(const P& piece) {
    for (int i = 0; i < 8; ++i) {
      const double t = parameter_;
      const Point at = piece.point(t), speed = piece.derivative(t);
      const double slope = speed.squaredNorm() + at.dot(piece.second_derivative(t));
      if (!(slope > 0)) return;
      const double next = std::clamp(t - at.dot(speed) / slope, 0.0, 1.0);
      const double distance = piece.point(next).norm();
      if (next == t || !(distance <= distance_ + tolerance_ / 16)) return;
      parameter_ = next, distance_ = distance;
    }
  }

  double tolerance_ = 0;
  double least_ = std::numeric_limits<double>::infinity();
  double distance_ = std::numeric_limits<double>::infinity();  // at parameter_
  double parameter_ = 0;
  int fine_parts_ = 0;
};

}  // namespace tutavia::detail
