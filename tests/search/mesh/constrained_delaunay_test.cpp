// SPDX-License-Identifier: MIT
#include "tutavia/search/mesh/constrained_delaunay.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;
using Index = ConstrainedDelaunay::Index;

struct Ordered {
  bool operator()(Cell a, Cell b) const { return std::pair{a.x, a.y} < std::pair{b.x, b.y}; }
};
using IndexOfPoint = std::map<Cell, Index, Ordered>;

/// Triangles turn left, fill the rectangle, agree on their sides, and have these points as corners.
void check_triangles(const ConstrainedDelaunay& triangles, const IndexOfPoint& points,
                     std::int64_t twice_area) {
  std::set<Cell, Ordered> corners;
  std::int64_t sum = 0;
  for (Index e = 0; e < triangles.half_edge_count(); ++e) {
    corners.insert(triangles.from(e));
    if (const Index t = triangles.twin(e); t != ConstrainedDelaunay::none) {
      REQUIRE(triangles.twin(t) == e);
      REQUIRE(triangles.from(t) == triangles.to(e));
      REQUIRE(triangles.to(t) == triangles.from(e));
      REQUIRE(triangles.is_fixed(t) == triangles.is_fixed(e));
    }
    if (e % 3 != 0) continue;
    const std::int64_t area =
        turn(triangles.from(e), triangles.to(e), triangles.to(ConstrainedDelaunay::next(e)));
    REQUIRE(area > 0);
    sum += area;
  }
  REQUIRE(sum == twice_area);
  REQUIRE(corners.size() == points.size() + 4);
  for (const auto& [point, index] : points) REQUIRE(corners.count(point) == 1);
}

/// Whether d lies inside the circle through a, b, c, by Pythagoras on the lifted points.
bool in_circle(Cell a, Cell b, Cell c, Cell d) {
  const auto row = [&](Cell p) {
    const std::int64_t x = p.x - d.x, y = p.y - d.y;
    return std::vector<std::int64_t>{x, y, x * x + y * y};
  };
  const auto u = row(a), v = row(b), w = row(c);
  return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
             u[2] * (v[0] * w[1] - v[1] * w[0]) >
         0;
}

/// No edge that is not fixed can be flipped for the better.
void check_delaunay(const ConstrainedDelaunay& triangles) {
  for (Index e = 0; e < triangles.half_edge_count(); ++e) {
    const Index t = triangles.twin(e);
    if (t == ConstrainedDelaunay::none || triangles.is_fixed(e)) continue;
    const Cell apex = triangles.from(ConstrainedDelaunay::previous(e));
    const Cell opposite = triangles.from(ConstrainedDelaunay::previous(t));
    REQUIRE(!in_circle(triangles.from(e), triangles.to(e), apex, opposite));
  }
}

TEST_CASE("triangles of random lattice points are Delaunay, with many points in rows") {
  const std::uint64_t seed = 640;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    INFO("seed " << seed << ", round " << round);
    const int side = 2 + static_cast<int>(random.below(12));
    ConstrainedDelaunay triangles({-1, -1}, {side, side});
    IndexOfPoint points;
    for (int i = 0; i < side * side; ++i) {
      const Cell p{static_cast<int>(random.below(static_cast<std::uint32_t>(side))),
                   static_cast<int>(random.below(static_cast<std::uint32_t>(side)))};
      const Index index = triangles.insert(p);
      const auto [known, added] = points.emplace(p, index);
      CHECK(known->second == index);
    }
    check_triangles(triangles, points, 2 * std::int64_t{side + 1} * (side + 1));
    check_delaunay(triangles);
  }
}

TEST_CASE("fixed edges are there, and all others are Delaunay") {
  const std::uint64_t seed = 641;
  Random random(seed);
  std::size_t fixed_in_all = 0;
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    INFO("seed " << seed << ", round " << round);
    const int side = 12;
    ConstrainedDelaunay triangles({-1, -1}, {side, side});
    IndexOfPoint points;
    const auto any = [&] {
      return Cell{static_cast<int>(random.below(side)), static_cast<int>(random.below(side))};
    };
    for (int i = 0; i < 40; ++i) {
      const Cell p = any();
      points.emplace(p, triangles.insert(p));
    }
    std::vector<std::pair<Cell, Cell>> fixed;
    for (int i = 0; i < 60; ++i) {
      const Cell a = any(), b = any();
      if (a == b || points.count(a) == 0 || points.count(b) == 0) continue;
      const auto side_of = [](Cell p, Cell q, Cell r) {
        const std::int64_t area = turn(p, q, r);
        return (area > 0) - (area < 0);
      };
      const bool passes_point = std::any_of(points.begin(), points.end(), [&](const auto& entry) {
        const Cell p = entry.first, u = p - a, v = b - a;
        const std::int64_t along = std::int64_t{u.x} * v.x + std::int64_t{u.y} * v.y;
        return turn(a, b, p) == 0 && along > 0 &&
               along < std::int64_t{v.x} * v.x + std::int64_t{v.y} * v.y;
      });
      const bool crosses = std::any_of(fixed.begin(), fixed.end(), [&](const auto& edge) {
        return side_of(a, b, edge.first) * side_of(a, b, edge.second) < 0 &&
               side_of(edge.first, edge.second, a) * side_of(edge.first, edge.second, b) < 0;
      });
      if (passes_point || crosses) continue;
      triangles.fix(points.at(a), points.at(b));
      fixed.emplace_back(a, b);
    }
    triangles.restore();
    check_triangles(triangles, points, 2 * std::int64_t{side + 1} * (side + 1));
    check_delaunay(triangles);
    for (const auto& [a, b] : fixed) {
      bool found = false;
      for (Index e = 0; e < triangles.half_edge_count(); ++e) {
        found = found || (triangles.is_fixed(e) && triangles.from(e) == a && triangles.to(e) == b);
      }
      CHECK(found);
    }
    fixed_in_all += fixed.size();
  }
  CHECK(fixed_in_all > test::scaled(200) * 2);
}

TEST_CASE("predicates hold at the corners of the largest rectangle") {
  const int side = ConstrainedDelaunay::max_side;
  ConstrainedDelaunay triangles({0, 0}, {side, side});
  IndexOfPoint points;
  for (const Cell p : {Cell{1, 1}, Cell{side - 1, 1}, Cell{side - 1, side - 1}, Cell{1, side - 1},
                       Cell{side / 2 + 1, side / 2}, Cell{1, 2}, Cell{side - 1, side - 2}}) {
    points.emplace(p, triangles.insert(p));
  }
  triangles.fix(points.at({1, 2}), points.at({side - 1, side - 2}));
  triangles.restore();
  check_triangles(triangles, points, 2 * std::int64_t{side} * side);
}

}  // namespace
