// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "tutavia/geometry/polygon.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/space/index/box_tree.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// MitredZones: the tips by which safety zones with mitred corners exceed round ones.

namespace tutavia::detail {

/// The parts of mitred safety zones at the convex vertices of polygons. Offset outwards by the
/// safety radius r, the two edges at a vertex meet in a tip. The zone is the round zone united with
/// the kites between vertex and tip. A vertex whose tip is more than 5 r away (Boost.Geometry's
/// default limit of mitred joins) has a round zone. Discs have round zones.
class MitredZones {
 public:
  explicit MitredZones(const Workspace& workspace) {
    std::vector<BoxTree::Entry> entries;
    for (const Obstacle& obstacle : workspace.obstacles) {
      const auto* polygon = std::get_if<Polygon>(&obstacle);
      if (polygon == nullptr) continue;
      add_ring(polygon->outer, false, workspace.safety_radius);
      for (const Ring& hole : polygon->holes) add_ring(hole, true, workspace.safety_radius);
    }
    for (std::uint32_t i = 0; i < kites_.size(); ++i) {
      Box box;
      for (const Point& p : kites_[i]) box.include(p);
      entries.emplace_back(box, i);
    }
    tree_ = BoxTree(std::move(entries));
  }

  /// Whether a segment enters a kite by more than 1e-9 m.
  bool enters(const Point& p, const Point& q) const {
    bool found = false;
    tree_.for_each_in(Segment{p, q}.box(),
                      [&](std::uint32_t i) { found = found || enters(kites_[i], p, q); });
    return found;
  }

 private:
  /// Counterclockwise: the vertex, then the ends of its offset edges with the tip between them.
  using Kite = std::array<Point, 4>;

  void add_ring(const Ring& ring, bool is_hole, double r) {
    std::vector<Point> points;  // without repetitions, with the obstacle on the left
    for_each_edge(ring, [&](const Point& a, const Point& b) {
      if (a != b) points.push_back(a);
    });
    if ((signed_area_twice(ring) > 0) == is_hole) std::reverse(points.begin(), points.end());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point& v = points[i];
      const Point in = unit(v - points[(i + points.size() - 1) % points.size()]);
      const Point out = unit(points[(i + 1) % points.size()] - v);
      // |tip - v| = r sqrt(2 / (1 + in . out))
      const double cosine = in.dot(out);
      if (!(cross(in, out) > 0) || 2 > 25 * (1 + cosine)) continue;
      const Point a{in.y(), -in.x()}, b{out.y(), -out.x()};  // outward normals
      const double s = r / (1 + cosine);
      kites_.push_back({v, offset_along(v, r, a),
                        Point(v.x() + s * (a.x() + b.x()), v.y() + s * (a.y() + b.y())),
                        offset_along(v, r, b)});
    }
  }

  static Point unit(const Point& v) {
    const double length = v.norm();
    return {v.x() / length, v.y() / length};
  }

  /// Clips the segment to the kite's sides, moved inwards.
  static bool enters(const Kite& kite, const Point& p, const Point& q) {
    constexpr double margin = 1e-9;
    double from = 0, to = 1;
    for (std::size_t i = 0; i < kite.size(); ++i) {
      const Point side = unit(kite[(i + 1) % kite.size()] - kite[i]);
      const double at_p = cross(side, p - kite[i]) - margin;
      const double at_q = cross(side, q - kite[i]) - margin;
      if (at_p <= 0 && at_q <= 0) return false;
      if (at_p < 0) from = std::max(from, at_p / (at_p - at_q));
      if (at_q < 0) to = std::min(to, at_p / (at_p - at_q));
    }
    return from < to || (p == q && from == 0 && to == 1);
  }

  std::vector<Kite> kites_;
  BoxTree tree_;
};

}  // namespace tutavia::detail
