// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/polygon.hpp"
#include "tutavia/io/text/svg_writer.hpp"

/// \file
/// SvgPaths: curves in metres as path data in pixels.

namespace tutavia::detail {

/// Converts metres to pixels.
struct SvgPaths {
  Box bounds;    ///< of the drawing [m]
  double scale;  ///< pixels per metre
  Point offset;  ///< upper left corner of the bounds, in pixels
  bool y_down;   ///< y grows downwards in metric coordinates, too

  Point pixel(const Point& p) const {
    return {offset.x() + (p.x() - bounds.min.x()) * scale,
            offset.y() + (y_down ? p.y() - bounds.min.y() : bounds.max.y() - p.y()) * scale};
  }
  /// Whether a point lies within the bounds, up to rounding.
  bool shows(const Point& p) const { return bounds.inflated(1e-3 / scale).contains(p); }
  std::string at(const Point& p) const { return SvgWriter::pair(pixel(p)); }
  /// A heading [rad] as a unit vector in pixels.
  Point direction(double heading) const {
    return {std::cos(heading), y_down ? std::sin(heading) : -std::sin(heading)};
  }

  std::string of_ring(const Ring& ring) const {
    std::string d;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      d += i == 0 ? 'M' : 'L';
      d += at(ring[i]);
    }
    d += 'Z';
    return d;
  }

  std::string of_curve(const Curve& curve) const {
    if (curve.empty()) return {};
    std::string d = std::string("M") + at(curve.start());
    for (const Piece& any : curve.pieces()) {
      if (const auto* segment = any.get_if<Segment>()) {
        d += std::string("L") + at(segment->b);
      } else if (const auto* q = any.get_if<QuadraticBezier>()) {
        d += std::string("Q") + at(q->points[1]) + " " + at(q->points[2]);
      } else if (const auto* c = any.get_if<CubicBezier>()) {
        d += std::string("C") + at(c->points[1]) + " " + at(c->points[2]) + " " + at(c->points[3]);
      } else if (const auto* arc = any.get_if<Arc>()) {
        // Two halves, because SVG cannot tell a full circle from none; y points down there.
        const bool is_clockwise = (arc->sweep > 0) == y_down;
        const std::string radius = SvgWriter::number(arc->radius * scale);
        for (const double t : {0.5, 1.0}) {
          d.append("A").append(radius).append(" ").append(radius);
          d.append(is_clockwise ? " 0 0 1 " : " 0 0 0 ").append(at(arc->point(t)));
        }
      } else if (const auto* clothoid = any.get_if<Clothoid>()) {
        d += of_clothoid(*clothoid);
      }
    }
    return d;
  }

  /// Approximates a piece by cubic Bezier pieces with the same ends and directions, each with a
  /// small turn.
  std::string of_clothoid(const Clothoid& clothoid) const {
    const double turn = clothoid.largest_curvature() * clothoid.arc_length;
    const int parts = std::max(1, static_cast<int>(std::ceil(2 * turn)));
    std::string d;
    for (int i = 0; i < parts; ++i) {
      const double from = double(i) / parts, to = (i + 1.0) / parts, handle = (to - from) / 3;
      d.append("C").append(
          at(offset_along(clothoid.point(from), handle, clothoid.derivative(from))));
      d.append(" ").append(at(offset_along(clothoid.point(to), -handle, clothoid.derivative(to))));
      d.append(" ").append(at(clothoid.point(to)));
    }
    return d;
  }
};

}  // namespace tutavia::detail
