// SPDX-License-Identifier: MIT
// How CellSpace places its cells and which of them it keeps.
#include "tutavia/space/cell_space.hpp"

#include <cstddef>
#include <limits>
#include <set>

#include "support/catch.hpp"
#include "support/cell_oracle.hpp"
#include "support/random_cells.hpp"
#include "support/scale.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::test;

static_assert(GridSpace<CellSpace>);
static_assert(CornerSpace<CellSpace>);
static_assert(FeatureSpace<CellSpace>);

TEST_CASE("centres lie exactly halfway between corners, and neighbours share their corners") {
  OccupancyGrid chessboard = OccupancyGrid::blocked(61, 45).value();
  for (int y = 0; y < 45; ++y) {
    for (int x = 0; x < 61; ++x) chessboard.set({x, y}, (x + y) % 2 == 0);
  }
  for (const double resolution : {1.0, 0.5, 0.25, 0.05, 0.1, 1.0 / 3, 7.3, 1e-5, 1e5}) {
    for (const Point& origin :
         {Point(0, 0), Point(-12.3, 4.7), Point(1e-9, -1e-3), Point(7, 0.1)}) {
      CAPTURE(resolution, origin.x(), origin.y());
      const auto space =
          CellSpace::build(chessboard, {.resolution = resolution, .origin = origin}).value();
      const Rational side(space.frame().resolution), half = side / 2;
      const Rational left(space.bounds().min.x()), bottom(space.bounds().min.y());
      CHECK(Rational(space.bounds().max.x()) == left + 61 * side);
      CHECK(Rational(space.bounds().max.y()) == bottom + 45 * side);
      CHECK(space.frame().resolution == Approx(resolution).epsilon(1e-6));
      CHECK(space.bounds().min.x() == Approx(origin.x()).epsilon(0).margin(1e-6 * resolution));
      CHECK(space.bounds().min.y() == Approx(origin.y()).epsilon(0).margin(1e-6 * resolution));
      bool exact = true;
      for (const Cell cell : {Cell{0, 0}, Cell{60, 44}, Cell{31, 7}, Cell{1, 44}, Cell{59, 23}}) {
        const Point centre = space.frame().point(cell);
        exact = exact && Rational(centre.x()) == left + cell.x * side + half &&
                Rational(centre.y()) == bottom + cell.y * side + half;
      }
      CHECK(exact);
      std::set<double> columns, rows;  // the edges of all cells have no others
      space.for_each_feature(space.bounds(), [&](const Segment& edge, double) {
        for (const Point& p : {edge.a, edge.b}) {
          columns.insert(p.x());
          rows.insert(p.y());
        }
      });
      CHECK(columns.size() == 62);
      CHECK(rows.size() == 46);
      int k = 0;
      for (const double x : columns) exact = exact && Rational(x) == left + k++ * side;
      k = 0;
      for (const double y : rows) exact = exact && Rational(y) == bottom + k++ * side;
      CHECK(exact);
    }
  }
}

TEST_CASE("what is a binary fraction already is not moved") {
  for (const double resolution : {0.0625, 0.25, 1.0, 3.0, 40.0}) {
    const auto space = CellSpace::build(OccupancyGrid::blocked(300, 200).value(),
                                        {.resolution = resolution, .origin = {-37.25, 1024.5}})
                           .value();
    CHECK(space.frame().resolution == resolution);
    CHECK(space.bounds().min == Point(-37.25, 1024.5));
    CHECK(space.bounds().max == Point(-37.25 + 300 * resolution, 1024.5 + 200 * resolution));
  }
}

TEST_CASE("the origin and the size of a cell move by no more than the stated rounding") {
  for (const double resolution : {0.05, 0.1, 0.3}) {
    for (const Point& origin : {Point(0, 0), Point(-12.3, 4.7)}) {
      CAPTURE(resolution, origin.x(), origin.y());
      const auto space = CellSpace::build(OccupancyGrid::blocked(2000, 10).value(),
                                          {.resolution = resolution, .origin = origin})
                             .value();
      const Rational allowed = Rational(space.bounds().largest_coordinate()) / Rational(0x1p49);
      const Rational moved = Rational(space.bounds().min.x()) - Rational(origin.x());
      const Rational grown = Rational(space.frame().resolution) - Rational(resolution);
      CHECK(2 * abs(moved) <= allowed);
      CHECK(grown >= 0);
      CHECK(grown < allowed);
    }
  }
}

TEST_CASE("options that make no space are refused") {
  const OccupancyGrid map = draw({"...", ".#.", "..."});
  const auto refused = [&](const CellOptions& options) {
    const auto space = CellSpace::build(map, options);
    return !space && space.error().code == PlanError::invalid_option &&
           !space.error().detail.empty();
  };
  for (const double resolution : {0.0, -1.0, -0.0, quiet_nan, infinity, -infinity, 1e-100, 1e300}) {
    CAPTURE(resolution);
    CHECK(refused({.resolution = resolution}));
  }
  for (const double bad : {quiet_nan, infinity, -infinity}) {
    CAPTURE(bad);
    CHECK(refused({.origin = {bad, 0}}));
    CHECK(refused({.origin = {0, bad}}));
    CHECK(refused({.origin = {bad, bad}}));
    CHECK(refused({.safety_radius = bad}));
  }
  CHECK(refused({.safety_radius = -1e-300}));
  CHECK(refused({.safety_radius = 1e9}));
  CHECK(refused({.safety_radius = std::numeric_limits<double>::max()}));
  CHECK(refused({.resolution = 1e-3, .origin = {1e12, 0}}));
  CHECK(refused({.resolution = 1e-3, .origin = {0, -1e12}}));
  CHECK_FALSE(refused({.resolution = 1e-3, .origin = {1e5, -1e5}}));
  CHECK_FALSE(refused({.safety_radius = -0.0}));
  CHECK_FALSE(refused({.safety_radius = 1e-300}));
}

TEST_CASE("a radius far larger than the grid blocks all cells, or none where none is blocked") {
  for (const double r : {3.0, 100.0, 3000.0}) {
    CAPTURE(r);
    const auto blocked =
        CellSpace::build(draw({"...", ".#.", "..."}), {.safety_radius = r}).value();
    CHECK(blocked.grid().count_free() == 0);
    CHECK(blocked.cells().count_free() == 8);
    CHECK_FALSE(blocked.is_free({0, 0}));
    const auto open = CellSpace::build(draw({"...", "..."}), {.safety_radius = r}).value();
    CHECK(open.grid().count_free() == 6);
    CHECK(open.is_free({0, 0}));
    CHECK(open.segment_free({0, 0}, {3, 2}));
  }
}

TEST_CASE("maps without blocked cells, without free ones and without any have answers") {
  const auto open = CellSpace::build(draw({"...", "..."})).value();
  CHECK(open.clearance({1, 1}) == infinity);
  CHECK(open.nearest(Segment{{0, 0}, {1, 1}}, infinity).obstacle == NearestObstacle::none);
  CHECK(open.segment_free({0, 0}, {3, 2}));
  CHECK_FALSE(open.segment_free({0, 0}, {3.5, 2}));

  const auto full = CellSpace::build(draw({"###", "###"}), {.safety_radius = 0.5}).value();
  CHECK(full.clearance({1, 1}) < 0);
  CHECK_FALSE(full.is_free({1, 1}));
  CHECK_FALSE(full.is_free({1.5, 0.5}));
  CHECK_FALSE(full.segment_free({0.5, 0.5}, {2.5, 1.5}));
  CHECK(full.grid().count_free() == 0);

  const auto none = CellSpace::build(OccupancyGrid{}, {.safety_radius = 0.5}).value();
  CHECK(none.grid().width() == 0);
  CHECK(none.links({0, 0}).empty());
  CHECK_FALSE(none.is_free({0.5, 0.5}));
  none.for_each_corner({{-1, -1}, {1, 1}},
                       [](const Corner&) { FAIL_CHECK("a corner of nothing"); });
}

TEST_CASE("the grid holds exactly the cells whose centres keep what the movement rule asks for") {
  std::size_t lost = 0, kept = 0;
  on_random_cells({.seed = 10, .rounds = scaled(400), .large_every = 16}, [&](const CellTrial& t) {
    const bool cuts =
        t.space.movement() == MovementRule::no_squeeze || t.space.movement() == MovementRule::allow;
    // Half the square of a cell's side is eight squares of a quarter.
    const Rational limit = squared_radius(t.space) + (cuts && t.space.safety_radius() > 0 ? 8 : 0);
    CHECK(t.space.grid().width() == t.map.width());
    CHECK(t.space.grid().height() == t.map.height());
    for (int y = 0; y < t.map.height(); ++y) {
      for (int x = 0; x < t.map.width(); ++x) {
        const Place centre{4 * x + 2, 4 * y + 2};
        const Fraction clearance = t.squares.squared_clearance(centre, centre);
        const bool expected =
            !is_blocked(t.map, x, y) && Rational(clearance.n) >= limit * clearance.d;
        if (t.space.grid().is_free(Cell{x, y}) != expected ||
            t.space.cells().is_free(Cell{x, y}) == is_blocked(t.map, x, y)) {
          FAIL_CHECK("cell (" << x << ", " << y << "), radius "
                              << t.space.safety_radius() / t.space.frame().resolution << " cells");
        }
        if (!is_blocked(t.map, x, y)) ++(expected ? kept : lost);
      }
    }
  });
  CHECK(kept > scaled(2000));
  CHECK(lost > scaled(2000));
}

TEST_CASE("a map of too many columns is refused, instead of by the first search") {
  const auto space = CellSpace::build(OccupancyGrid::blocked(70'000'000, 1).value());
  REQUIRE_FALSE(space);
  CHECK(space.error().code == PlanError::limit_exceeded);
}

}  // namespace
