// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <utility>
#include <vector>

#include "tutavia/core/assert.hpp"
#include "tutavia/grid/cell.hpp"

/// \file
/// ConstrainedDelaunay: an exact constrained Delaunay triangulation of lattice points.

namespace tutavia::detail {

/// A constrained Delaunay triangulation of lattice points within a rectangle.
///
/// Half-edges 3k, 3k + 1, 3k + 2 go counterclockwise around triangle k. The twin of a half-edge
/// runs in the opposite direction along the neighbour. All decisions are exact.
///
/// Sources: Lawson 1977, "Software for C1 surface interpolation" (insertion and flips); Sloan 1993,
/// "A fast algorithm for generating constrained Delaunay triangulations" (edges).
class ConstrainedDelaunay {
 public:
  using Index = std::uint32_t;
  static constexpr Index none = std::numeric_limits<Index>::max();
  static constexpr int max_side = 1 << 15;  ///< so that products of four differences fit 64 bits

  /// The rectangle between two corners, as two triangles. \pre its sides are between 1 and
  /// `max_side`
  ConstrainedDelaunay(Cell low, Cell high)
      : points_{low, {high.x, low.y}, high, {low.x, high.y}},
        origin_{0, 1, 2, 0, 2, 3},
        twin_{none, none, 3, 2, none, none},
        fixed_(6, 0),
        outgoing_{0, 1, 2, 5} {
    TUTAVIA_ASSERT(low.x < high.x && high.x - low.x <= max_side);
    TUTAVIA_ASSERT(low.y < high.y && high.y - low.y <= max_side);
  }

  /// Adds a point and returns its number; a point added before keeps its number. Fast if successive
  /// points are near each other. \pre the point lies inside the rectangle, and no edge was fixed
  /// yet
  Index insert(Cell p);

  /// Adds the edge between two inserted points and fixes it. \pre no third point lies on it and no
  /// fixed edge crosses it
  void fix(Index a, Index b);

  /// Flips edges until all that are not fixed are Delaunay again.
  void restore() {
    for (Index e = 0; e < half_edge_count(); ++e) suspects_.push_back(e);
    legalize();
  }

  Index half_edge_count() const { return static_cast<Index>(origin_.size()); }
  static Index next(Index e) { return e % 3 == 2 ? e - 2 : e + 1; }
  static Index previous(Index e) { return e % 3 == 0 ? e + 2 : e - 1; }
  /// The half-edge on the other side; `none` on the rectangle's border.
  Index twin(Index e) const { return twin_[e]; }
  bool is_fixed(Index e) const { return fixed_[e] != 0; }
  Cell from(Index e) const { return points_[origin_[e]]; }
  Cell to(Index e) const { return from(next(e)); }

 private:
  Index apex(Index e) const { return origin_[previous(e)]; }
  std::int64_t turn(Index a, Index b, Index c) const {
    return tutavia::detail::turn(points_[a], points_[b], points_[c]);
  }
  void set(Index e, Index from, Index twin, char fixed = 0) {
    origin_[e] = from;
    twin_[e] = twin;
    fixed_[e] = fixed;
    outgoing_[from] = e;
    if (twin != none) twin_[twin] = e;
  }

  Index locate(Cell p) const;
  Index find(Index a, Index b) const;
  void flip(Index e);
  bool is_illegal(Index e) const;
  void legalize();

  std::vector<Cell> points_;
  std::vector<Index> origin_, twin_;  // per half-edge
  std::vector<char> fixed_;
  std::vector<Index> outgoing_;  // per point, a half-edge from it
  std::vector<Index> suspects_;  // half-edges to test for a flip
};

/// A side of a triangle that contains the point; the side on which it lies, if it lies on one.
inline ConstrainedDelaunay::Index ConstrainedDelaunay::locate(Cell p) const {
  Index e = outgoing_.back();  // from the previous point
  for (int sides = 0; sides < 3;) {
    if (tutavia::detail::turn(from(e), to(e), p) < 0) {
      e = twin_[e];
      sides = 0;
    }
    e = next(e);
    ++sides;
  }
  for (int sides = 0; sides < 3 && tutavia::detail::turn(from(e), to(e), p) != 0; ++sides)
    e = next(e);
  return e;
}

inline ConstrainedDelaunay::Index ConstrainedDelaunay::insert(Cell p) {
  const Index ab = locate(p), bc = next(ab), ca = previous(ab);
  for (const Index e : {ab, bc, ca}) {
    if (from(e) == p) return origin_[e];
  }
  const auto point = static_cast<Index>(points_.size());
  points_.push_back(p);
  outgoing_.push_back(none);
  const bool on_side = tutavia::detail::turn(from(ab), to(ab), p) == 0;

  // Replaces the triangle by three. If the point lies on a side, one of them is flat until that
  // side is flipped.
  const Index a = origin_[ab], b = origin_[bc], c = origin_[ca];
  const Index beyond_bc = twin_[bc], beyond_ca = twin_[ca];
  const Index first = half_edge_count();
  origin_.resize(first + 6);
  twin_.resize(first + 6, none);
  fixed_.resize(first + 6, 0);
  set(bc, b, none);
  set(ca, point, none);
  set(first, b, beyond_bc);
  set(first + 1, c, none);
  set(first + 2, point, bc);
  set(first + 3, c, beyond_ca);
  set(first + 4, a, ca);
  set(first + 5, point, first + 1);
  for (const Index e : {ab, first, first + 3}) suspects_.push_back(e);
  if (on_side) {
    const Index t = twin_[ab];
    flip(ab);
    for (const Index e : {next(ab), previous(ab), next(t), previous(t)}) suspects_.push_back(e);
  }
  legalize();
  return point;
}

/// The half-edge from one point to another; `none` if there is none.
inline ConstrainedDelaunay::Index ConstrainedDelaunay::find(Index a, Index b) const {
  const Index first = outgoing_[a];
  Index e = first;
  do {
    if (origin_[next(e)] == b) return e;
    e = twin_[previous(e)];
  } while (e != first && e != none);
  if (e == first) return none;
  // At a corner of the rectangle, search in the other direction, too.
  for (e = twin_[first]; e != none; e = twin_[e]) {
    e = next(e);
    if (origin_[next(e)] == b) return e;
  }
  return none;
}

/// Turns a half-edge and its twin into the other diagonal of their two triangles.
inline void ConstrainedDelaunay::flip(Index e) {
  const Index t = twin_[e];
  const Index p = origin_[e], q = origin_[t], r = apex(e), s = apex(t);
  const Index qr = next(e), rp = previous(e), ps = next(t), sq = previous(t);
  const Index beyond_qr = twin_[qr], beyond_rp = twin_[rp], beyond_ps = twin_[ps],
              beyond_sq = twin_[sq];
  const char fixed_qr = fixed_[qr], fixed_rp = fixed_[rp], fixed_ps = fixed_[ps],
             fixed_sq = fixed_[sq];
  set(e, s, t);
  set(next(e), r, beyond_rp, fixed_rp);
  set(previous(e), p, beyond_ps, fixed_ps);
  set(t, r, e);
  set(next(t), s, beyond_sq, fixed_sq);
  set(previous(t), q, beyond_qr, fixed_qr);
}

/// Whether the angles opposite an edge sum to more than pi. Then the circumcircle of either
/// triangle contains the other one's apex.
inline bool ConstrainedDelaunay::is_illegal(Index e) const {
  const Cell p = from(e), q = to(e), r = points_[apex(e)], s = points_[apex(twin_[e])];
  const auto dot = [](Cell o, Cell a, Cell b) {
    return (std::int64_t{a.x} - o.x) * (b.x - o.x) + (std::int64_t{a.y} - o.y) * (b.y - o.y);
  };
  return tutavia::detail::turn(r, p, q) * dot(s, p, q) +
             dot(r, p, q) * tutavia::detail::turn(s, q, p) <
         0;
}

inline void ConstrainedDelaunay::legalize() {
  while (!suspects_.empty()) {
    const Index e = suspects_.back(), t = twin_[e];
    suspects_.pop_back();
    if (t == none || is_fixed(e) || !is_illegal(e)) continue;
    flip(e);
    for (const Index outer : {next(e), previous(e), next(t), previous(t)}) {
      suspects_.push_back(outer);
    }
  }
}

inline void ConstrainedDelaunay::fix(Index a, Index b) {
  Index edge = find(a, b);
  if (edge == none) {
    // All edges that cross it, from a to b.
    std::deque<std::pair<Index, Index>> crossing;
    Index e = outgoing_[a];
    while (!(turn(a, b, origin_[next(e)]) < 0 && turn(a, b, apex(e)) > 0)) e = twin_[previous(e)];
    for (e = next(e);;) {
      crossing.emplace_back(origin_[e], origin_[next(e)]);
      e = twin_[e];
      if (apex(e) == b) break;
      TUTAVIA_ASSERT(turn(a, b, apex(e)) != 0);
      e = turn(a, b, apex(e)) < 0 ? previous(e) : next(e);
    }
    // Flips each edge when it can be flipped, until none crosses.
    while (!crossing.empty()) {
      const auto [p, q] = crossing.front();
      crossing.pop_front();
      const Index f = find(p, q), r = apex(f), s = apex(twin_[f]);
      if (turn(s, r, p) > 0 && turn(s, r, q) < 0) {
        flip(f);
        const bool crosses =
            r != a && r != b && s != a && s != b && (turn(a, b, r) > 0) != (turn(a, b, s) > 0);
        if (crosses) crossing.emplace_back(r, s);
      } else {
        crossing.emplace_back(p, q);
      }
    }
    edge = find(a, b);
  }
  fixed_[edge] = fixed_[twin_[edge]] = 1;
}

}  // namespace tutavia::detail
