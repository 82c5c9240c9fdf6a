// SPDX-License-Identifier: MIT
// Which points and segments CellSpace calls free.
#include "tutavia/space/cell_space.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

#include "support/catch.hpp"
#include "support/cell_oracle.hpp"
#include "support/cell_world.hpp"
#include "support/exact_checker.hpp"
#include "support/random_cells.hpp"
#include "support/scale.hpp"
#include "tutavia/certify/certify.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::test;

TEST_CASE("at radius 0 a point may touch blocked cells, slide along them and slip between two") {
  const auto space = CellSpace::build(draw({"......",  //
                                            "..#...",  //
                                            ".#..#.",  //
                                            "....#.",  //
                                            "......"}))
                         .value();
  for (const Point& p : {Point(1.5, 2), Point(1, 2), Point(2, 3), Point(4, 2), Point(0, 0)}) {
    INFO("touching at " << p.transpose());
    CHECK(space.is_free(p));
  }
  CHECK(space.segment_free({0, 2}, {4, 2}));    // along one cell and up to another
  CHECK(space.segment_free({4, 0}, {4, 5}));    // along two
  CHECK(space.segment_free({1, 4}, {3, 2}));    // between two that share a corner
  CHECK(space.segment_free({2, 0}, {2, 5}));    // the same along a line of the grid
  CHECK(space.segment_free({0, 3}, {6, 3}));    // and along the other
  CHECK(space.segment_free({0, 3}, {1, 2.5}));  // up to an edge

  CHECK_FALSE(space.is_free({1.5, 2.5}));
  CHECK_FALSE(space.is_free({4.5, 2}));                    // inside the edge that two share
  CHECK_FALSE(space.segment_free({0, 2}, {6, 2}));         // along that edge
  CHECK_FALSE(space.segment_free({0, 1}, {2, 3}));         // the diagonal of a cell
  CHECK_FALSE(space.segment_free({0, 3}, {1.25, 2.375}));  // beyond an edge

  CHECK(space.is_free({6, 5}));
  CHECK_FALSE(space.is_free({6, std::nextafter(5.0, 6.0)}));
  CHECK_FALSE(space.is_free({quiet_nan, 1}));
}

TEST_CASE("at radius 0 a corner is closed only where all of its four cells are blocked") {
  for (unsigned pattern = 0; pattern < 16; ++pattern) {
    CAPTURE(pattern);
    OccupancyGrid map = draw({"....", "....", "....", "...."});
    const auto blocked = [&](unsigned i) { return ((pattern >> i) & 1u) != 0; };
    for (unsigned i = 0; i < 4; ++i) {
      map.set({1 + static_cast<int>(i % 2), 1 + static_cast<int>(i / 2)}, !blocked(i));
    }
    const auto space = CellSpace::build(map).value();
    const Point corner{2, 2};
    CHECK(space.is_free(corner) == (pattern != 15));
    // From the corner along each of the four lines, and into each of the four cells.
    CHECK(space.segment_free(corner, {2.5, 2}) == !(blocked(1) && blocked(3)));
    CHECK(space.segment_free(corner, {1.5, 2}) == !(blocked(0) && blocked(2)));
    CHECK(space.segment_free(corner, {2, 2.5}) == !(blocked(2) && blocked(3)));
    CHECK(space.segment_free(corner, {2, 1.5}) == !(blocked(0) && blocked(1)));
    CHECK(space.segment_free(corner, {1.5, 1.5}) == !blocked(0));
    CHECK(space.segment_free(corner, {2.5, 1.5}) == !blocked(1));
    CHECK(space.segment_free(corner, {1.5, 2.5}) == !blocked(2));
    CHECK(space.segment_free(corner, {2.25, 2.5}) == !blocked(3));
    // Across it.
    CHECK(space.segment_free({1.5, 2.5}, {2.5, 1.5}) == !(blocked(1) || blocked(2)));
    CHECK(space.segment_free({1, 2}, {3, 2}) ==
          !((blocked(1) && blocked(3)) || (blocked(0) && blocked(2))));
  }
}

TEST_CASE("a segment is free exactly where integers say so") {
  std::size_t free_segments = 0, blocked_segments = 0, ties = 0;
  on_random_cells({.seed = 1, .rounds = scaled(700), .large_every = 16}, [&](const CellTrial& t) {
    const Rational limit = squared_radius(t.space);
    for (int i = 0; i < 40; ++i) {
      const auto [a, b] = t.squares.random_segment(t.random);
      const Point p = point_at(t.space, a), q = point_at(t.space, b);
      const bool expected = t.squares.is_free(a, b, limit);
      if (t.space.segment_free(p, q) != expected || t.space.segment_free(q, p) != expected) {
        FAIL_CHECK("from quarter (" << a.x << ", " << a.y << ") to (" << b.x << ", " << b.y
                                    << ") at radius " << t.space.safety_radius() << ", cells of "
                                    << t.space.frame().resolution << ": expected " << expected);
      }
      if (a.x == b.x && a.y == b.y && t.space.is_free(p) != expected) FAIL_CHECK("point");
      const Fraction clearance = t.squares.squared_clearance(a, b);
      if (Rational(clearance.n) == limit * clearance.d) ++ties;
      ++(expected ? free_segments : blocked_segments);
    }
  });
  CHECK(free_segments > scaled(700));
  CHECK(blocked_segments > scaled(700));
  CHECK(ties > scaled(100));
}

TEST_CASE("a segment is free exactly where the exact checker finds it free among squares") {
  std::size_t free_segments = 0, blocked_segments = 0;
  on_random_cells({.seed = 2, .rounds = scaled(120)}, [&](const CellTrial& t) {
    const Workspace world = world_of_cells(t.space);
    const ExactChecker checker(world);
    const Box& bounds = t.space.bounds();
    for (int i = 0; i < 10; ++i) {
      const auto [a, b] = t.squares.random_segment(t.random);
      Point p = point_at(t.space, a), q = point_at(t.space, b);
      if (i % 3 == 0) {
        p = {t.random.uniform(bounds.min.x(), bounds.max.x()),
             t.random.uniform(bounds.min.y(), bounds.max.y())};
      }
      if (i % 6 == 0) q = p + (q - p) * t.random.uniform(0, 0.3);
      if (!bounds.contains(p) || !bounds.contains(q)) continue;
      const bool expected = checker.check(Piece(Segment{p, q})) == ExactVerdict::free;
      if (t.space.segment_free(p, q) != expected) {
        FAIL_CHECK("from (" << p.transpose() << ") to (" << q.transpose() << ") at radius "
                            << t.space.safety_radius() << ": expected " << expected);
      }
      ++(expected ? free_segments : blocked_segments);
    }
  });
  CHECK(free_segments > scaled(100));
  CHECK(blocked_segments > scaled(100));
}

TEST_CASE("a corridor just as wide as the robot is free, one ulp more of the robot is not") {
  const OccupancyGrid map = draw({"########", "........", "########", "........", "........"});
  for (const double resolution : {1.0, 0.25, 0.05, 0.1, 1.0 / 3}) {
    for (const Point& origin : {Point(0, 0), Point(-12.3, 4.7)}) {
      CAPTURE(resolution, origin.x(), origin.y());
      CellOptions options{.resolution = resolution, .origin = origin};
      const double side = CellSpace::build(map, options).value().frame().resolution;
      options.safety_radius = side / 2;
      const auto space = CellSpace::build(map, options).value();
      const Point left = point_at(space, {0, 14}), right = point_at(space, {32, 14});
      CHECK(space.segment_free(left, right));
      CHECK_FALSE(space.segment_free(left, {right.x(), std::nextafter(right.y(), infinity)}));
      for (int x = 0; x < 8; ++x) CHECK(space.grid().is_free(Cell{x, 3}));
      options.safety_radius = std::nextafter(side / 2, infinity);
      const auto wider = CellSpace::build(map, options).value();
      CHECK_FALSE(wider.segment_free(left, right));
      for (int x = 0; x < 8; ++x) CHECK_FALSE(wider.grid().is_free(Cell{x, 3}));
    }
  }
}

TEST_CASE("a corridor of one cell is free for half a resolution, whatever the rounding") {
  const OccupancyGrid map = draw({"########", "........", "########"});
  for (const double resolution : {0.01, 0.02, 0.025, 0.05, 0.1, 0.2, 0.3}) {
    for (const Point& origin : {Point(0, 0), Point(-12.3, 4.7), Point(100.1, -50.7)}) {
      CAPTURE(resolution, origin.x(), origin.y());
      const auto space =
          CellSpace::build(
              map, {.resolution = resolution, .origin = origin, .safety_radius = resolution / 2})
              .value();
      CHECK(space.segment_free(space.frame().point({0, 1}), space.frame().point({7, 1})));
      CHECK(space.grid().count_free() == 8);
    }
  }
}

TEST_CASE("a corner keeps its distance to the last bit") {
  // The centre of a cell is sqrt(0.5) from its corners.
  const OccupancyGrid map = draw({"#..", "...", "..."});
  const double below = std::nextafter(std::sqrt(0.5), 0.0), above = std::sqrt(0.5);
  REQUIRE(Rational(below) * Rational(below) < Rational(0.5));
  REQUIRE(Rational(above) * Rational(above) > Rational(0.5));
  for (const double r : {below, above}) {
    const auto space = CellSpace::build(map, {.safety_radius = r}).value();
    CHECK(space.is_free({1.5, 1.5}) == (r == below));
    CHECK(space.grid().is_free(Cell{1, 1}) == (r == below));
    CHECK(space.segment_free({1, 1}, {2, 2}) == (r == below));
  }
  // 3-4-5: this line passes the corner (4, 4) at (7, 8), exactly 5 from it.
  const auto space = CellSpace::build(draw({".....", ".....", ".....", "#...."}),
                                      {.resolution = 4, .safety_radius = 5})
                         .value();
  CHECK(space.segment_free({11, 5}, {3, 11}));
  CHECK_FALSE(space.segment_free({11, 5}, {3, std::nextafter(11.0, 0.0)}));
}

TEST_CASE("a blocked cell at the border of the grid blocks the border too") {
  const OccupancyGrid map = draw({"......",  //
                                  "###...",  //
                                  "###...",  //
                                  "###..."});
  for (const double r : {0.0, 0.25}) {
    CAPTURE(r);
    const auto space = CellSpace::build(map, {.safety_radius = r}).value();
    for (const Point& p : {Point(0, 2.5), Point(0, 2), Point(0, 0), Point(2.5, 0)}) {
      INFO("at " << p.transpose());
      CHECK_FALSE(space.is_free(p));
      CHECK(space.clearance(p) == 0);
    }
    CHECK(space.is_free({0, 3}) == (r == 0));  // the corner of a blocked cell and a free one
    CHECK(space.is_free({0, 3.25}));
    CHECK_FALSE(space.segment_free({0, 1}, {0, 2}));
    CHECK_FALSE(space.segment_free({1, 0}, {2.5, 0}));
    CHECK_FALSE(space.segment_free({0, 4}, {0, 2.75}));
    for (const Segment& s : {Segment{{0, 1}, {1.5, 1.5}}, Segment{{1.5, 1.5}, {0, 1}},
                             Segment{{0, 1.25}, {1.25, 0}}, Segment{{0.5, 0}, {0.5, 1}}}) {
      INFO("from " << s.a.transpose() << " to " << s.b.transpose());
      CHECK_FALSE(space.segment_free(s.a, s.b));
      const Point ends[] = {s.a, s.b};
      CHECK(certify(space, Curve::polyline(ends)).status != ProofStatus::proved);
    }
    Curve curve;
    curve.push_back(QuadraticBezier{{Point(0, 1), Point(1, 1), Point(1.5, 0.5)}});
    CHECK(certify(space, curve).status != ProofStatus::proved);
  }
}

}  // namespace
