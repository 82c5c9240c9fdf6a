// SPDX-License-Identifier: MIT
// The clearance, the nearest edge and the inside of blocked cells.
#include "tutavia/space/cell_space.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "support/catch.hpp"
#include "support/cell_oracle.hpp"
#include "support/random_cells.hpp"
#include "support/reference_distance.hpp"
#include "support/scale.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::test;

TEST_CASE("clearance of cells is the signed distance that brute force finds") {
  std::size_t outside = 0, inside = 0, touching = 0;
  on_random_cells({.seed = 3, .rounds = scaled(400), .large_every = 16}, [&](const CellTrial& t) {
    const double unit = t.space.frame().resolution / 4;
    for (int i = 0; i < 20; ++i) {
      const Place at = t.squares.random_place(t.random);
      const Point p = point_at(t.space, at);
      INFO("quarter (" << at.x << ", " << at.y << "), cells of " << 4 * unit);
      const double clearance = t.space.clearance(p);
      if (t.squares.cells.empty()) {
        CHECK(clearance == infinity);
      } else if (!t.squares.contains(at)) {
        const double expected = unit * std::sqrt(t.squares.squared_clearance(at, at).value());
        if (!(std::abs(clearance - expected) <= t.space.distance_error_bound()))
          CHECK(clearance == expected);
        ++outside;
      } else if (t.squares.squared_distance_to_edges(at, at).n > 0) {
        const double depth = unit * std::sqrt(t.squares.squared_distance_to_edges(at, at).value());
        if (!(std::abs(clearance + depth) <= t.space.distance_error_bound()))
          CHECK(clearance == -depth);
        ++inside;
      } else {
        if (clearance != 0) CHECK(clearance == 0);
        ++touching;
      }
    }
  });
  CHECK(std::min({outside, inside, touching}) > scaled(200));
}

TEST_CASE("the clearance of a point with NaN to cells is NaN, and it is not free") {
  OccupancyGrid cells = OccupancyGrid::blocked(4, 4).value();
  cells.set_run(2, 0, 3, true);
  const CellSpace space = CellSpace::build(std::move(cells)).value();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Point& p : {Point(nan, 2.5), Point(2.5, nan), Point(nan, nan)}) {
    CHECK(std::isnan(space.clearance(p)));
    CHECK_FALSE(space.is_free(p));
  }
}

TEST_CASE("the nearest edge of a segment is the one that brute force finds") {
  std::size_t found_edges = 0, beyond = 0;
  on_random_cells({.seed = 4, .rounds = scaled(400), .large_every = 8}, [&](const CellTrial& t) {
    const double unit = t.space.frame().resolution / 4;
    const auto name = [](const CellEdge& e) { return std::pair(e.cell, e.side); };
    for (int i = 0; i < 20; ++i) {
      const auto [a, b] = t.squares.random_segment(t.random);
      const Segment segment{point_at(t.space, a), point_at(t.space, b)};
      const double expected =
          t.squares.edges.empty()
              ? infinity
              : unit * std::sqrt(t.squares.squared_distance_to_edges(a, b).value());
      const double caps[] = {infinity, 0.5 * expected, 1.5 * expected, t.space.safety_radius(),
                             expected + 2 * t.space.distance_error_bound()};
      const double cap = caps[t.random.below(std::size(caps))];
      INFO("from quarter (" << a.x << ", " << a.y << ") to (" << b.x << ", " << b.y
                            << "), cells of " << 4 * unit << ", cap " << cap << ", expected "
                            << expected);
      const NearestObstacle found = t.space.nearest(segment, cap);
      if (expected > cap + t.space.distance_error_bound() || expected == infinity) {
        if (found.distance != cap) CHECK(found.distance == cap);
        if (found.obstacle != NearestObstacle::none) CHECK(found.obstacle == NearestObstacle::none);
        ++beyond;
      } else if (expected < cap - t.space.distance_error_bound()) {
        if (!(std::abs(found.distance - expected) <= t.space.distance_error_bound())) {
          CHECK(found.distance == expected);
        }
        const auto edge = std::find_if(
            t.squares.edges.begin(), t.squares.edges.end(),
            [&](const CellEdge& e) { return name(e) == std::pair(found.obstacle, found.edge); });
        REQUIRE(edge != t.squares.edges.end());
        const Rectangle& line = edge->line;
        const auto gap = static_cast<double>(reference_distance(
            segment.point(found.parameter), point_at(t.space, {line.x0, line.y0}),
            point_at(t.space, {line.x1, line.y1})));
        if (!(std::abs(gap - expected) <= 4 * t.space.distance_error_bound()))
          CHECK(gap == expected);
        ++found_edges;
      }
    }
  });
  CHECK(found_edges > scaled(1000));
  CHECK(beyond > scaled(1000));
}

TEST_CASE("the nearest edge of an arc is no farther than any of its points finds, and attained") {
  std::size_t found_edges = 0;
  on_random_cells({.seed = 5, .rounds = scaled(250)}, [&](const CellTrial& t) {
    const double side = t.space.frame().resolution;
    const Point centre = point_at(t.space, t.squares.random_place(t.random));
    const Arc arc = Arc::around(centre, side * t.random.uniform(0.1, 4), t.random.uniform(-4, 4),
                                t.random.uniform(-6, 6));
    std::map<std::pair<std::uint32_t, std::uint32_t>, Segment> edges;
    for (const CellEdge& e : t.squares.edges) {
      edges[{e.cell, e.side}] = {point_at(t.space, {e.line.x0, e.line.y0}),
                                 point_at(t.space, {e.line.x1, e.line.y1})};
    }
    constexpr int samples = 200;
    double least = infinity;
    for (int i = 0; i <= samples; ++i) {
      const Point p = arc.point(static_cast<double>(i) / samples);
      for (const auto& [name, edge] : edges) {
        least = std::min(least, static_cast<double>(reference_distance(p, edge.a, edge.b)));
      }
    }
    const double step = arc.length() / samples,
                 error = t.space.distance_error_bound() + arc.evaluation_error();
    for (const double cap : {infinity, 0.8 * (least - step), least + step}) {
      CAPTURE(cap, least);
      if (cap < 0) continue;
      const NearestObstacle found = t.space.nearest(arc, cap);
      if (edges.empty() || least - step > cap) {
        CHECK(found.distance == cap);
        CHECK(found.obstacle == NearestObstacle::none);
        continue;
      }
      const auto edge = edges.find({found.obstacle, found.edge});
      REQUIRE(edge != edges.end());
      CHECK(found.distance <= least + error);
      CHECK(found.distance >= least - step / 2 - error);
      const double gap = static_cast<double>(
          reference_distance(arc.point(found.parameter), edge->second.a, edge->second.b));
      CHECK(std::abs(gap - found.distance) <= 4 * error);
      ++found_edges;
    }
  });
  CHECK(found_edges > scaled(200));
}

TEST_CASE("the nearest edge is named by its blocked cell and its side") {
  const auto space = CellSpace::build(draw({".....", ".....", "..#..", ".....", "....."})).value();
  const auto index = static_cast<std::uint32_t>(space.cells().index({2, 2}));
  const Point beside[] = {{4, 2.5}, {2.5, 4}, {1, 2.5}, {2.5, 1}};
  for (std::uint32_t side = 0; side < 4; ++side) {
    CAPTURE(side);
    const Point& p = beside[side];
    const NearestObstacle found = space.nearest(Segment{p, p}, 1.5);
    CHECK(found.distance == 1);
    CHECK(found.obstacle == index);
    CHECK(found.edge == side);
    CHECK(space.nearest(Segment{p, p}, 0.5).distance == 0.5);
    CHECK(space.nearest(Segment{p, p}, 0.5).obstacle == NearestObstacle::none);
  }
  const NearestObstacle slanted = space.nearest(Segment{{4, 5}, {5, 4}}, infinity);
  CHECK(slanted.distance == Approx(std::sqrt(4.5)));
  CHECK(slanted.parameter == Approx(0.5));
}

TEST_CASE("an edge that is no nearer than the cap is not named") {
  const auto space = CellSpace::build(draw({".....", ".....", "..#..", ".....", "....."})).value();
  const NearestObstacle found = space.nearest(Segment{{4, 2}, {4, 3}}, 1);
  CHECK(found.distance == 1);
  CHECK(found.obstacle == NearestObstacle::none);
}

TEST_CASE("a point is inside where it is off every edge and the cells around it are blocked") {
  std::size_t inside = 0, outside = 0;
  on_random_cells({.seed = 6, .rounds = scaled(300), .large_every = 16}, [&](const CellTrial& t) {
    for (int i = 0; i < 30; ++i) {
      const Place at = t.squares.random_place(t.random);
      const bool expected = t.squares.inside_meets(at, at);
      if (t.space.is_inside(point_at(t.space, at)) != expected) {
        FAIL_CHECK("quarter (" << at.x << ", " << at.y << "): expected " << expected);
      }
      ++(expected ? inside : outside);
    }
  });
  CHECK(std::min(inside, outside) > scaled(500));
}

TEST_CASE("a point beyond the grid is inside nothing, and knows how far the blocked cells are") {
  std::size_t checked = 0;
  on_random_cells({.seed = 15, .rounds = scaled(100)}, [&](const CellTrial& t) {
    if (t.squares.cells.empty()) return;
    for (int i = 0; i < 20; ++i) {
      const auto coordinate = [&](int size) {
        return static_cast<std::int64_t>(
                   t.random.below(4 * static_cast<std::uint64_t>(size) + 25)) -
               12;
      };
      const Place at{coordinate(t.map.width()), coordinate(t.map.height())};
      const Point p = point_at(t.space, at);
      if (t.space.bounds().contains(p)) continue;
      INFO("quarter (" << at.x << ", " << at.y << ")");
      CHECK_FALSE(t.space.is_inside(p));
      CHECK_FALSE(t.space.is_free(p));
      const double expected =
          t.space.frame().resolution / 4 * std::sqrt(t.squares.squared_clearance(at, at).value());
      CHECK(std::abs(t.space.clearance(p) - expected) <= 2 * t.space.distance_error_bound());
      ++checked;
    }
  });
  CHECK(checked > scaled(200));
}

}  // namespace
