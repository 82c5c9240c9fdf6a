// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <variant>
#include <vector>

#include "tutavia/world/workspace.hpp"

/// \file
/// same_obstacles: whether two readers agree to the last bit.

namespace tutavia::test {

inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
inline bool same_bits(const Point& a, const Point& b) {
  return same_bits(a.x(), b.x()) && same_bits(a.y(), b.y());
}
inline bool same_bits(const Ring& a, const Ring& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Point& p, const Point& q) { return same_bits(p, q); });
}
inline bool same_bits(const Obstacle& a, const Obstacle& b) {
  if (a.index() != b.index()) return false;
  if (const Disc* disc = std::get_if<Disc>(&a)) {
    const Disc& other = std::get<Disc>(b);
    return same_bits(disc->center, other.center) && same_bits(disc->radius, other.radius);
  }
  const Polygon &p = std::get<Polygon>(a), &q = std::get<Polygon>(b);
  return same_bits(p.outer, q.outer) &&
         std::equal(p.holes.begin(), p.holes.end(), q.holes.begin(), q.holes.end(),
                    [](const Ring& r, const Ring& s) { return same_bits(r, s); });
}
inline bool same_obstacles(const std::vector<Obstacle>& a, const std::vector<Obstacle>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Obstacle& p, const Obstacle& q) { return same_bits(p, q); });
}

}  // namespace tutavia::test
