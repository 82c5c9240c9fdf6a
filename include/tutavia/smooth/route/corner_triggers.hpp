// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "tutavia/geometry/point.hpp"
#include "tutavia/smooth/route/critical_corners.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// find_triggers: the nodes at which a path turns near a critical corner.

namespace tutavia::detail {

/// A node at which a path turns, and the critical corner that it passes there.
struct CornerTrigger {
  std::size_t node;
  Point corner;     ///< a vertex of an obstacle, or a disc's centre
  double distance;  ///< between the node and the corner's safety zone [m]
  std::uint32_t corner_id;
};

/// Whether the path a, b, c turns at b by more than the rounding errors of lattice nodes.
inline bool is_turn(const Point& a, const Point& b, const Point& c) {
  const Point u = b - a, v = c - b;
  return std::abs(cross(u, v)) > 1e-9 * (u.squaredNorm() + v.squaredNorm());
}

/// The node of `by_x` nearest to `p`, at most `reach` away; the first one of ties. Searches
/// outwards from p's x. \pre `by_x` holds indices of nodes, in order of x
inline std::optional<std::size_t> nearest_node(const Point& p, double reach,
                                               const std::vector<Point>& nodes,
                                               const std::vector<std::size_t>& by_x) {
  std::optional<std::size_t> best;
  double least = reach;
  const auto look_at = [&](std::size_t i) {
    if (std::abs(nodes[i].x() - p.x()) > least) return false;
    const double d = distance(nodes[i], p);
    if (d < least || (d == least && (!best || i < *best))) {
      best = i;
      least = d;
    }
    return true;
  };
  const auto from = std::lower_bound(by_x.begin(), by_x.end(), p.x(),
                                     [&](std::size_t i, double x) { return nodes[i].x() < x; });
  for (auto i = from; i != by_x.end() && look_at(*i);) ++i;
  for (auto i = from; i != by_x.begin() && look_at(*(i - 1));) --i;
  return best;
}

/// For each critical corner (see critical_corners) the nearest node within `threshold` [m] of its
/// safety zone at which the path turns. In path order; a node that several corners share has the
/// nearest of them.
template <CornerSpace S>
std::vector<CornerTrigger> find_triggers(const S& space, const std::vector<Point>& nodes,
                                         double threshold, double min_exterior_angle) {
  std::vector<std::size_t> turns;
  for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
    if (is_turn(nodes[i - 1], nodes[i], nodes[i + 1])) turns.push_back(i);
  }
  std::sort(turns.begin(), turns.end(), [&](std::size_t i, std::size_t j) {
    return nodes[i].x() != nodes[j].x() ? nodes[i].x() < nodes[j].x() : i < j;
  });
  std::vector<CornerTrigger> triggers;
  for (const Corner& corner : critical_corners(space, nodes, threshold, min_exterior_angle)) {
    const double zone = corner.radius + space.safety_radius();
    const auto node = nearest_node(corner.position, zone + threshold, nodes, turns);
    if (!node) continue;
    const double away = distance(nodes[*node], corner.position);
    triggers.push_back({*node, corner.position, away - zone, corner.id});
  }
  std::sort(triggers.begin(), triggers.end(), [](const CornerTrigger& a, const CornerTrigger& b) {
    if (a.node != b.node) return a.node < b.node;
    return a.distance != b.distance ? a.distance < b.distance : a.corner_id < b.corner_id;
  });
  const auto same = [](const CornerTrigger& a, const CornerTrigger& b) { return a.node == b.node; };
  triggers.erase(std::unique(triggers.begin(), triggers.end(), same), triggers.end());
  return triggers;
}

}  // namespace tutavia::detail
