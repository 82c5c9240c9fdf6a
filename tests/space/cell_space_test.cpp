// SPDX-License-Identifier: MIT
#include "tutavia/space/cell_space.hpp"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "support/catch.hpp"
#include "support/exact_checker.hpp"
#include "support/random_grids.hpp"
#include "support/reference_distance.hpp"
#include "support/scale.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "tutavia/smooth/shortcut.hpp"
#include "tutavia/space/nearest_free.hpp"

namespace {

using namespace tutavia;
using test::ExactVerdict;
using Rational = boost::multiprecision::cpp_rational;

static_assert(GridSpace<CellSpace>);
static_assert(CornerSpace<CellSpace>);
static_assert(FeatureSpace<CellSpace>);

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A map from rows of text, the topmost first: '#' is blocked.
OccupancyGrid draw(const std::vector<std::string>& rows) {
  const int height = static_cast<int>(rows.size()), width = static_cast<int>(rows[0].size());
  OccupancyGrid grid = OccupancyGrid::blocked(width, height).value();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::string& row = rows[static_cast<std::size_t>(height - 1 - y)];
      grid.set({x, y}, row[static_cast<std::size_t>(x)] != '#');
    }
  }
  return grid;
}

bool is_blocked(const OccupancyGrid& grid, int x, int y) {
  return grid.contains({x, y}) && !grid.is_free(Cell{x, y});
}

/// Scattered cells and blocks of them; every now and then none, or all. Large maps are wider than a
/// word; they have few blocked cells, or few free ones.
OccupancyGrid random_map(Random& random, bool large = false) {
  const int width = 1 + static_cast<int>(random.below(9)) + (large ? 55 : 0);
  const int height = 1 + static_cast<int>(random.below(large ? 40 : 9));
  OccupancyGrid grid = OccupancyGrid::blocked(width, height).value();
  const double density = large                   ? 0.02 * random.uniform()
                         : random.below(12) == 0 ? 1
                                                 : random.uniform() * random.uniform();
  const auto count = static_cast<std::size_t>(random.below(large ? 7 : 4));
  const bool inverse = large && random.below(4) == 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) grid.set({x, y}, (random.uniform() < density) == inverse);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const int x = static_cast<int>(random.below(static_cast<std::uint64_t>(width)));
    const int y = static_cast<int>(random.below(static_cast<std::uint64_t>(height)));
    for (int dy = 0; dy < 1 + static_cast<int>(i); ++dy) {
      for (int dx = 0; dx < 3; ++dx) {
        if (grid.contains({x + dx, y + dy})) grid.set({x + dx, y + dy}, inverse);
      }
    }
  }
  return grid;
}

/// A point of the grid in quarters of a cell, counted from the grid's lower left corner.
struct Place {
  std::int64_t x, y;
};
/// A rectangle in the same units; an edge where it has no width or no height.
struct Rectangle {
  std::int64_t x0, y0, x1, y1;
  friend bool operator==(const Rectangle&, const Rectangle&) = default;
};
/// n / d, not negative.
struct Fraction {
  std::int64_t n, d;
  double value() const { return static_cast<double>(n) / static_cast<double>(d); }
  friend bool operator<(Fraction a, Fraction b) { return a.n * b.d < b.n * a.d; }
};

std::int64_t turn(Place a, Place b, Place c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether the closed segment a-b meets a rectangle, or its inside, by separating lines.
bool meets(const Rectangle& r, Place a, Place b, bool inside) {
  const auto apart = [&](std::int64_t p, std::int64_t q, std::int64_t low, std::int64_t high) {
    return inside ? std::max(p, q) <= low || std::min(p, q) >= high
                  : std::max(p, q) < low || std::min(p, q) > high;
  };
  if (apart(a.x, b.x, r.x0, r.x1) || apart(a.y, b.y, r.y0, r.y1)) return false;
  if (a.x == b.x && a.y == b.y) return true;
  const std::int64_t turns[] = {detail::turn(a, b, {r.x0, r.y0}), detail::turn(a, b, {r.x1, r.y0}),
                                detail::turn(a, b, {r.x0, r.y1}), detail::turn(a, b, {r.x1, r.y1})};
  const auto [least, most] = std::minmax_element(std::begin(turns), std::end(turns));
  return inside ? *least < 0 && *most > 0 : *least <= 0 && *most >= 0;
}

/// The squared distance of a point from a closed segment, and of that from a closed rectangle.
Fraction to_segment(Place p, Place a, Place b) {
  const std::int64_t ux = b.x - a.x, uy = b.y - a.y, vx = p.x - a.x, vy = p.y - a.y;
  const std::int64_t along = ux * vx + uy * vy, square = ux * ux + uy * uy;
  if (along <= 0) return {vx * vx + vy * vy, 1};
  if (along >= square) {
    return {(p.x - b.x) * (p.x - b.x) + (p.y - b.y) * (p.y - b.y), 1};
  }
  const std::int64_t area = ux * vy - uy * vx;
  return {area * area, square};
}

Fraction to_rectangle(const Rectangle& r, Place a, Place b) {
  if (meets(r, a, b, false)) return {0, 1};
  const auto from_end = [&](Place p) {
    const std::int64_t dx = std::max({r.x0 - p.x, p.x - r.x1, std::int64_t{0}});
    const std::int64_t dy = std::max({r.y0 - p.y, p.y - r.y1, std::int64_t{0}});
    return Fraction{dx * dx + dy * dy, 1};
  };
  return std::min({from_end(a), from_end(b), to_segment({r.x0, r.y0}, a, b),
                   to_segment({r.x1, r.y0}, a, b), to_segment({r.x0, r.y1}, a, b),
                   to_segment({r.x1, r.y1}, a, b)});
}

/// An edge of a blocked cell that no other one shares, with its names.
struct CellEdge {
  Rectangle line;
  std::uint32_t cell;
  std::uint32_t side;
};

/// What the blocked cells of a map block, in integers.
class Squares {
 public:
  explicit Squares(const OccupancyGrid& map) : width_(4 * map.width()), height_(4 * map.height()) {
    const auto solid = [&](int x, int y) { return !map.contains({x, y}) || !map.is_free({x, y}); };
    for (int y = -1; y < map.height(); ++y) {
      for (int x = -1; x < map.width(); ++x) {
        if (!solid(x, y)) continue;
        const auto add = [&](int columns, int rows) {
          const Cell far{x + columns - 1, y + rows - 1};
          if (is_blocked(map, x, y) || is_blocked(map, far.x, y) || is_blocked(map, x, far.y) ||
              is_blocked(map, far.x, far.y)) {
            insides.push_back({4 * x, 4 * y, 4 * (far.x + 1), 4 * (far.y + 1)});
          }
        };
        const bool right = solid(x + 1, y), above = solid(x, y + 1);
        add(1, 1);
        if (right) add(2, 1);
        if (above) add(1, 2);
        if (right && above && solid(x + 1, y + 1)) add(2, 2);
        if (!is_blocked(map, x, y)) continue;
        cells.push_back({4 * x, 4 * y, 4 * x + 4, 4 * y + 4});
        const auto edge = [&](int dx, int dy, const Rectangle& line) {
          if (is_blocked(map, x + dx, y + dy)) return;
          const std::uint32_t side = dx == 1 ? 0 : dy == 1 ? 1 : dx == -1 ? 2 : 3;
          edges.push_back({line, static_cast<std::uint32_t>(map.index({x, y})), side});
        };
        edge(1, 0, {4 * x + 4, 4 * y, 4 * x + 4, 4 * y + 4});
        edge(0, 1, {4 * x, 4 * y + 4, 4 * x + 4, 4 * y + 4});
        edge(-1, 0, {4 * x, 4 * y, 4 * x, 4 * y + 4});
        edge(0, -1, {4 * x, 4 * y, 4 * x + 4, 4 * y});
      }
    }
  }

  std::vector<Rectangle> cells;
  /// Rectangles whose open insides together are the inside of all that is blocked, what lies beyond
  /// the grid counted as blocked: cells, pairs that share an edge, and fours that share a corner.
  std::vector<Rectangle> insides;
  std::vector<CellEdge> edges;

  bool contains(Place p) const {
    return std::any_of(cells.begin(), cells.end(),
                       [&](const Rectangle& r) { return meets(r, p, p, false); });
  }
  bool inside_meets(Place a, Place b) const {
    return std::any_of(insides.begin(), insides.end(),
                       [&](const Rectangle& r) { return meets(r, a, b, true); });
  }
  /// From the segment to the nearest blocked cell; huge where there is none.
  Fraction squared_clearance(Place a, Place b) const {
    Fraction least{std::int64_t{1} << 40, 1};
    for (const Rectangle& r : cells) least = std::min(least, to_rectangle(r, a, b));
    return least;
  }
  Fraction squared_distance_to_edges(Place a, Place b) const {
    Fraction least{std::int64_t{1} << 40, 1};
    for (const CellEdge& e : edges) least = std::min(least, to_rectangle(e.line, a, b));
    return least;
  }
  /// Free space as it is documented.
  bool is_free(Place a, Place b, const Rational& squared_radius) const {
    if (squared_radius == 0) return !inside_meets(a, b);
    const Fraction clearance = squared_clearance(a, b);
    return Rational(clearance.n) >= squared_radius * clearance.d;
  }

  /// On lines of the grid, on centres, or anywhere among the quarters.
  Place random_place(Random& random) const {
    const auto coordinate = [&](std::int64_t size) {
      const auto any =
          static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(size) + 1));
      const std::uint64_t kind = random.below(4);
      return kind == 0 ? any / 4 * 4 : kind == 1 ? std::min(any / 4 * 4 + 2, size) : any;
    };
    const std::int64_t x = coordinate(width_);
    return {x, coordinate(height_)};
  }
  /// A single point, or along a line, or slanted by 45 degrees or by anything.
  std::pair<Place, Place> random_segment(Random& random) const {
    const Place a = random_place(random);
    Place b = random_place(random);
    switch (random.below(6)) {
      case 0:
        return {a, a};
      case 1:
        return {a, {b.x, a.y}};
      case 2:
        return {a, {a.x, b.y}};
      case 3: {
        const std::int64_t length = std::min({b.x, b.y, width_ - a.x, height_ - a.y});
        b = {a.x + length, a.y + length};
        return {a, b};
      }
      default:
        return {a, b};
    }
  }

 private:
  std::int64_t width_;
  std::int64_t height_;
};

/// A place's point, exactly.
Point point_at(const CellSpace& space, Place place) {
  const double unit = space.frame().resolution / 4;
  const Point corner = space.bounds().min;
  return {corner.x() + unit * static_cast<double>(place.x),
          corner.y() + unit * static_cast<double>(place.y)};
}

/// The square of the safety radius in quarters of a cell.
Rational squared_radius(const CellSpace& space) {
  const Rational ratio = Rational(space.safety_radius()) * 4 / Rational(space.frame().resolution);
  return ratio * ratio;
}

/// Somewhere: sizes and origins that are binary fractions, and such that are not.
CellOptions random_options(Random& random) {
  constexpr double sizes[] = {1, 0.5, 0.25, 0.05, 0.1, 3, 1e-3};
  const Point origins[] = {{0, 0}, {-12.3, 4.7}, {1000.5, -2000}, {-3, 1e4 / 3}};
  return {.resolution = sizes[random.below(std::size(sizes))],
          .origin = origins[random.below(std::size(origins))],
          .movement = test::all_rules[random.below(4)]};
}

/// A radius for cells of this size: none; a multiple of a quarter, or next to it; a distance of
/// corners; anything.
double random_radius(Random& random, double side) {
  const auto n = static_cast<double>(1 + random.below(8));
  switch (random.below(6)) {
    case 0:
      return 0;
    case 1:
      return side * n / 4;
    case 2:
      return std::nextafter(side * n / 4, random.below(2) == 0 ? 0 : infinity);
    case 3:
      return side * std::sqrt(n / 8);
    case 4:
      return std::nextafter(side * std::sqrt(n / 2), random.below(2) == 0 ? 0 : infinity);
    default:
      return side * random.uniform(0.01, 2);
  }
}

CellSpace random_space(Random& random, const OccupancyGrid& map, bool at_contact = false) {
  CellOptions options = random_options(random);
  const double side = CellSpace::build(map, options).value().frame().resolution;
  options.safety_radius = at_contact ? 0 : random_radius(random, side);
  return CellSpace::build(map, options).value();
}

/// The same free space with polygons: a square for every blocked cell; at radius 0 rectangles over
/// the edges and corners inside the union as well, where squares alone would leave a slit.
Workspace workspace_of(const CellSpace& space, const Squares& squares) {
  Workspace world{.bounds = space.bounds(), .safety_radius = space.safety_radius()};
  const auto& all = world.safety_radius == 0 ? squares.insides : squares.cells;
  for (const Rectangle& r : all) {
    const bool in_another = std::any_of(all.begin(), all.end(), [&](const Rectangle& other) {
      return other != r && other.x0 <= r.x0 && other.y0 <= r.y0 && other.x1 >= r.x1 &&
             other.y1 >= r.y1;
    });
    if (in_another) continue;
    world.obstacles.push_back(
        Polygon{{point_at(space, {r.x0, r.y0}), point_at(space, {r.x1, r.y0}),
                 point_at(space, {r.x1, r.y1}), point_at(space, {r.x0, r.y1})}});
  }
  return world;
}

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
  CHECK_FALSE(space.is_free({nan, 1}));
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
  const std::uint64_t seed = 1;
  Random random(seed);
  std::size_t free_segments = 0, blocked_segments = 0, ties = 0;
  for (std::size_t round = 0; round < test::scaled(700); ++round) {
    INFO("seed " << seed << ", round " << round);
    const OccupancyGrid map = random_map(random, round % 16 == 0);
    const CellSpace space = random_space(random, map);
    const Squares squares(map);
    const Rational limit = squared_radius(space);
    for (int i = 0; i < 40; ++i) {
      const auto [a, b] = squares.random_segment(random);
      const Point p = point_at(space, a), q = point_at(space, b);
      const bool expected = squares.is_free(a, b, limit);
      if (space.segment_free(p, q) != expected || space.segment_free(q, p) != expected) {
        FAIL_CHECK("from quarter (" << a.x << ", " << a.y << ") to (" << b.x << ", " << b.y
                                    << ") at radius " << space.safety_radius() << ", cells of "
                                    << space.frame().resolution << ": expected " << expected);
      }
      if (a.x == b.x && a.y == b.y && space.is_free(p) != expected) FAIL_CHECK("point");
      const Fraction clearance = squares.squared_clearance(a, b);
      if (Rational(clearance.n) == limit * clearance.d) ++ties;
      ++(expected ? free_segments : blocked_segments);
    }
  }
  CHECK(free_segments > test::scaled(700));
  CHECK(blocked_segments > test::scaled(700));
  CHECK(ties > test::scaled(100));
}

TEST_CASE("a segment is free exactly where the exact checker finds it free among squares") {
  const std::uint64_t seed = 2;
  Random random(seed);
  std::size_t free_segments = 0, blocked_segments = 0;
  for (std::size_t round = 0; round < test::scaled(120); ++round) {
    INFO("seed " << seed << ", round " << round);
    const OccupancyGrid map = random_map(random);
    const CellSpace space = random_space(random, map);
    const Squares squares(map);
    const Workspace world = workspace_of(space, squares);
    const test::ExactChecker checker(world);
    const Box& bounds = space.bounds();
    for (int i = 0; i < 10; ++i) {
      const auto [a, b] = squares.random_segment(random);
      Point p = point_at(space, a), q = point_at(space, b);
      if (i % 3 == 0) {
        p = {random.uniform(bounds.min.x(), bounds.max.x()),
             random.uniform(bounds.min.y(), bounds.max.y())};
      }
      if (i % 6 == 0) q = p + (q - p) * random.uniform(0, 0.3);
      if (!bounds.contains(p) || !bounds.contains(q)) continue;
      const bool expected = checker.check(Piece(Segment{p, q})) == ExactVerdict::free;
      if (space.segment_free(p, q) != expected) {
        FAIL_CHECK("from (" << p.transpose() << ") to (" << q.transpose() << ") at radius "
                            << space.safety_radius() << ": expected " << expected);
      }
      ++(expected ? free_segments : blocked_segments);
    }
  }
  CHECK(free_segments > test::scaled(100));
  CHECK(blocked_segments > test::scaled(100));
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

TEST_CASE("clearance of cells is the signed distance that brute force finds") {
  const std::uint64_t seed = 3;
  Random random(seed);
  std::size_t outside = 0, inside = 0, touching = 0;
  for (std::size_t round = 0; round < test::scaled(400); ++round) {
    INFO("seed " << seed << ", round " << round);
    const OccupancyGrid map = random_map(random, round % 16 == 0);
    const CellSpace space = random_space(random, map);
    const Squares squares(map);
    const double unit = space.frame().resolution / 4;
    for (int i = 0; i < 20; ++i) {
      const Place at = squares.random_place(random);
      const Point p = point_at(space, at);
      INFO("quarter (" << at.x << ", " << at.y << "), cells of " << 4 * unit);
      const double clearance = space.clearance(p);
      if (squares.cells.empty()) {
        CHECK(clearance == infinity);
      } else if (!squares.contains(at)) {
        const double expected = unit * std::sqrt(squares.squared_clearance(at, at).value());
        if (!(std::abs(clearance - expected) <= space.distance_error_bound()))
          CHECK(clearance == expected);
        ++outside;
      } else if (squares.squared_distance_to_edges(at, at).n > 0) {
        const double depth = unit * std::sqrt(squares.squared_distance_to_edges(at, at).value());
        if (!(std::abs(clearance + depth) <= space.distance_error_bound()))
          CHECK(clearance == -depth);
        ++inside;
      } else {
        if (clearance != 0) CHECK(clearance == 0);
        ++touching;
      }
    }
  }
  CHECK(std::min({outside, inside, touching}) > test::scaled(200));
}

TEST_CASE("the nearest edge of a segment is the one that brute force finds") {
  const std::uint64_t seed = 4;
  Random random(seed);
  std::size_t found_edges = 0, beyond = 0;
  for (std::size_t round = 0; round < test::scaled(400); ++round) {
    INFO("seed " << seed << ", round " << round);
    const OccupancyGrid map = random_map(random, round % 8 == 0);
    const CellSpace space = random_space(random, map);
    const Squares squares(map);
    const double unit = space.frame().resolution / 4;
    const auto name = [](const CellEdge& e) { return std::pair(e.cell, e.side); };
    for (int i = 0; i < 20; ++i) {
      const auto [a, b] = squares.random_segment(random);
      const Segment segment{point_at(space, a), point_at(space, b)};
      const double expected =
          squares.edges.empty() ? infinity
                                : unit * std::sqrt(squares.squared_distance_to_edges(a, b).value());
      const double caps[] = {infinity, 0.5 * expected, 1.5 * expected, space.safety_radius(),
                             expected + 2 * space.distance_error_bound()};
      const double cap = caps[random.below(std::size(caps))];
      INFO("from quarter (" << a.x << ", " << a.y << ") to (" << b.x << ", " << b.y
                            << "), cells of " << 4 * unit << ", cap " << cap << ", expected "
                            << expected);
      const NearestObstacle found = space.nearest(segment, cap);
      if (expected > cap + space.distance_error_bound() || expected == infinity) {
        if (found.distance != cap) CHECK(found.distance == cap);
        if (found.obstacle != NearestObstacle::none) CHECK(found.obstacle == NearestObstacle::none);
        ++beyond;
      } else if (expected < cap - space.distance_error_bound()) {
        if (!(std::abs(found.distance - expected) <= space.distance_error_bound())) {
          CHECK(found.distance == expected);
        }
        const auto edge = std::find_if(
            squares.edges.begin(), squares.edges.end(),
            [&](const CellEdge& e) { return name(e) == std::pair(found.obstacle, found.edge); });
        REQUIRE(edge != squares.edges.end());
        const Rectangle& line = edge->line;
        const auto gap = static_cast<double>(test::reference_distance(
            segment.point(found.parameter), point_at(space, {line.x0, line.y0}),
            point_at(space, {line.x1, line.y1})));
        if (!(std::abs(gap - expected) <= 4 * space.distance_error_bound())) CHECK(gap == expected);
        ++found_edges;
      }
    }
  }
  CHECK(found_edges > test::scaled(1000));
  CHECK(beyond > test::scaled(1000));
}

TEST_CASE("the nearest edge of an arc is no farther than any of its points finds, and attained") {
  const std::uint64_t seed = 5;
  Random random(seed);
  std::size_t found_edges = 0;
  for (std::size_t round = 0; round < test::scaled(250); ++round) {
    INFO("seed " << seed << ", round " << round);
    const OccupancyGrid map = random_map(random);
    const CellSpace space = random_space(random, map);
    const Squares squares(map);
    const double side = space.frame().resolution;
    const Point centre = point_at(space, squares.random_place(random));
    const Arc arc = Arc::around(centre, side * random.uniform(0.1, 4), random.uniform(-4, 4),
                                random.uniform(-6, 6));
    std::map<std::pair<std::uint32_t, std::uint32_t>, Segment> edges;
    for (const CellEdge& e : squares.edges) {
      edges[{e.cell, e.side}] = {point_at(space, {e.line.x0, e.line.y0}),
                                 point_at(space, {e.line.x1, e.line.y1})};
    }
    constexpr int samples = 200;
    double least = infinity;
    for (int i = 0; i <= samples; ++i) {
      const Point p = arc.point(static_cast<double>(i) / samples);
      for (const auto& [name, edge] : edges) {
        least = std::min(least, static_cast<double>(test::reference_distance(p, edge.a, edge.b)));
      }
    }
    const double step = arc.length() / samples,
                 error = space.distance_error_bound() + arc.evaluation_error();
    for (const double cap : {infinity, 0.8 * (least - step), least + step}) {
      CAPTURE(cap, least);
      if (cap < 0) continue;
      const NearestObstacle found = space.nearest(arc, cap);
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
          test::reference_distance(arc.point(found.parameter), edge->second.a, edge->second.b));
      CHECK(std::abs(gap - found.distance) <= 4 * error);
      ++found_edges;
    }
  }
  CHECK(found_edges > test::scaled(200));
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
  const std::uint64_t seed = 6;
  Random random(seed);
  std::size_t inside = 0, outside = 0;
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    INFO("seed " << seed << ", round " << round);
    const OccupancyGrid map = random_map(random, round % 16 == 0);
    const CellSpace space = random_space(random, map);
    const Squares squares(map);
    for (int i = 0; i < 30; ++i) {
      const Place at = squares.random_place(random);
      const bool expected = squares.inside_meets(at, at);
      if (space.is_inside(point_at(space, at)) != expected) {
        FAIL_CHECK("quarter (" << at.x << ", " << at.y << "): expected " << expected);
      }
      ++(expected ? inside : outside);
    }
  }
  CHECK(std::min(inside, outside) > test::scaled(500));
}

TEST_CASE("a point beyond the grid is inside nothing, and knows how far the blocked cells are") {
  const std::uint64_t seed = 15;
  Random random(seed);
  std::size_t checked = 0;
  for (std::size_t round = 0; round < test::scaled(100); ++round) {
    INFO("seed " << seed << ", round " << round);
    const OccupancyGrid map = random_map(random);
    const CellSpace space = random_space(random, map);
    const Squares squares(map);
    if (squares.cells.empty()) continue;
    for (int i = 0; i < 20; ++i) {
      const auto coordinate = [&](int size) {
        return static_cast<std::int64_t>(random.below(4 * static_cast<std::uint64_t>(size) + 25)) -
               12;
      };
      const Place at{coordinate(map.width()), coordinate(map.height())};
      const Point p = point_at(space, at);
      if (space.bounds().contains(p)) continue;
      INFO("quarter (" << at.x << ", " << at.y << ")");
      CHECK_FALSE(space.is_inside(p));
      CHECK_FALSE(space.is_free(p));
      const double expected =
          space.frame().resolution / 4 * std::sqrt(squares.squared_clearance(at, at).value());
      CHECK(std::abs(space.clearance(p) - expected) <= 2 * space.distance_error_bound());
      ++checked;
    }
  }
  CHECK(checked > test::scaled(200));
}

/// A point's place, for points on quarters.
std::pair<std::int64_t, std::int64_t> place_of(const CellSpace& space, const Point& p) {
  const double unit = space.frame().resolution / 4;
  const Point corner = space.bounds().min;
  return {std::llround((p.x() - corner.x()) / unit), std::llround((p.y() - corner.y()) / unit)};
}

/// A box with its corners on quarters, beyond the grid every now and then.
std::pair<Place, Place> random_box(Random& random, const Squares& squares) {
  const Place a = squares.random_place(random), b = squares.random_place(random);
  const std::int64_t more = random.below(5) == 0 ? 6 : 0;
  return {{std::min(a.x, b.x) - more, std::min(a.y, b.y) - more},
          {std::max(a.x, b.x) + more, std::max(a.y, b.y) + more}};
}

TEST_CASE("every edge of the blocked cells that they do not share is visited once in a box") {
  const std::uint64_t seed = 7;
  Random random(seed);
  std::size_t in_box = 0;
  for (std::size_t round = 0; round < test::scaled(400); ++round) {
    INFO("seed " << seed << ", round " << round);
    const OccupancyGrid map = random_map(random, round % 8 == 0);
    const CellSpace space = random_space(random, map);
    const Squares squares(map);
    const auto [low, high] = random_box(random, squares);
    using Line = std::tuple<std::int64_t, std::int64_t, std::int64_t, std::int64_t>;
    std::map<Line, int> visits;
    bool are_lines = true;
    space.for_each_feature({point_at(space, low), point_at(space, high)},
                           [&](const Segment& edge, double radius) {
                             const auto a = place_of(space, edge.a), b = place_of(space, edge.b);
                             const auto [first, last] = std::minmax(a, b);
                             ++visits[{first.first, first.second, last.first, last.second}];
                             are_lines = are_lines && radius == 0;
                           });
    CHECK(are_lines);
    std::set<Line> real;
    std::size_t missed = 0;
    for (const CellEdge& e : squares.edges) {
      const Rectangle& r = e.line;
      const Line line{r.x0, r.y0, r.x1, r.y1};
      real.insert(line);
      if (r.x0 > high.x || r.x1 < low.x || r.y0 > high.y || r.y1 < low.y) continue;
      ++in_box;
      if (visits[line] != 1) ++missed;
    }
    CHECK(missed == 0);
    const bool invented = std::any_of(visits.begin(), visits.end(), [&](const auto& visit) {
      return visit.second > 1 || real.count(visit.first) == 0;
    });
    CHECK_FALSE(invented);
  }
  CHECK(in_box > test::scaled(400));
}

TEST_CASE("the convex corners of the blocked cells in a box are visited, each by one number") {
  const std::uint64_t seed = 8;
  Random random(seed);
  std::size_t corners = 0;
  for (std::size_t round = 0; round < test::scaled(400); ++round) {
    INFO("seed " << seed << ", round " << round);
    const OccupancyGrid map = random_map(random, round % 8 == 0);
    const CellSpace space = random_space(random, map);
    const Squares squares(map);
    // Convex: some blocked cell has it as a corner at which neither of its two sides goes on.
    std::set<std::pair<std::int64_t, std::int64_t>> convex;
    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) {
        if (!is_blocked(map, x, y)) continue;
        for (const int dx : {0, 1}) {
          for (const int dy : {0, 1}) {
            const bool beside = is_blocked(map, x + (dx == 1 ? 1 : -1), y);
            const bool above = is_blocked(map, x, y + (dy == 1 ? 1 : -1));
            const bool across = is_blocked(map, x + (dx == 1 ? 1 : -1), y + (dy == 1 ? 1 : -1));
            const bool pinched = across && !beside && !above;
            if (!beside && !above && (!across || pinched)) {
              convex.insert({4 * (x + dx), 4 * (y + dy)});
            }
          }
        }
      }
    }
    std::map<std::uint32_t, std::pair<std::int64_t, std::int64_t>> numbers;
    for (int i = 0; i < 3; ++i) {
      const auto [low, high] = random_box(random, squares);
      auto expected = convex;
      std::erase_if(expected, [&, l = low, h = high](const auto& at) {
        return at.first < l.x || at.first > h.x || at.second < l.y || at.second > h.y;
      });
      std::set<std::pair<std::int64_t, std::int64_t>> visited;
      std::size_t visits = 0;
      bool as_documented = true;
      space.for_each_corner(
          {point_at(space, low), point_at(space, high)}, [&](const Corner& corner) {
            const auto at = place_of(space, corner.position);
            visited.insert(at);
            ++visits;
            as_documented = as_documented && corner.radius == 0 &&
                            corner.exterior_angle == Approx(std::numbers::pi / 2) &&
                            numbers.emplace(corner.id, at).first->second == at &&
                            corner.position == point_at(space, {at.first, at.second});
          });
      CHECK(visited == expected);
      CHECK(visits == expected.size());
      CHECK(as_documented);
      corners += visits;
    }
  }
  CHECK(corners > test::scaled(1000));
}

TEST_CASE("every step between free cells is a free segment, under every movement rule") {
  const std::uint64_t seed = 9;
  Random random(seed);
  std::size_t checked = 0;
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    INFO("seed " << seed << ", round " << round);
    const OccupancyGrid map = random_map(random);
    const CellSpace space = random_space(random, map);
    const Squares squares(map);
    const Rational limit = squared_radius(space);
    const OccupancyGrid& grid = space.grid();
    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) {
        if (!grid.is_free(Cell{x, y})) continue;
        for (std::size_t step = 0; step < steps.size(); ++step) {
          if (!grid.can_step({x, y}, step, space.movement())) continue;
          const Cell to = Cell{x, y} + steps[step];
          const Place a{4 * x + 2, 4 * y + 2}, b{4 * to.x + 2, 4 * to.y + 2};
          if (!squares.is_free(a, b, limit) ||
              !space.segment_free(space.frame().point({x, y}), space.frame().point(to))) {
            FAIL_CHECK("cell (" << x << ", " << y << "), step " << step << ", rule "
                                << static_cast<int>(space.movement()) << ", radius "
                                << space.safety_radius() / space.frame().resolution << " cells");
          }
          ++checked;
        }
      }
    }
  }
  CHECK(checked > test::scaled(2000));
}

TEST_CASE("the grid holds exactly the cells whose centres keep what the movement rule asks for") {
  const std::uint64_t seed = 10;
  Random random(seed);
  std::size_t lost = 0, kept = 0;
  for (std::size_t round = 0; round < test::scaled(400); ++round) {
    INFO("seed " << seed << ", round " << round);
    const OccupancyGrid map = random_map(random, round % 16 == 0);
    const CellSpace space = random_space(random, map);
    const Squares squares(map);
    const bool cuts =
        space.movement() == MovementRule::no_squeeze || space.movement() == MovementRule::allow;
    // Half the square of a cell's side is eight squares of a quarter.
    const Rational limit = squared_radius(space) + (cuts && space.safety_radius() > 0 ? 8 : 0);
    CHECK(space.grid().width() == map.width());
    CHECK(space.grid().height() == map.height());
    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) {
        const Place centre{4 * x + 2, 4 * y + 2};
        const Fraction clearance = squares.squared_clearance(centre, centre);
        const bool expected =
            !is_blocked(map, x, y) && Rational(clearance.n) >= limit * clearance.d;
        if (space.grid().is_free(Cell{x, y}) != expected ||
            space.cells().is_free(Cell{x, y}) == is_blocked(map, x, y)) {
          FAIL_CHECK("cell (" << x << ", " << y << "), radius "
                              << space.safety_radius() / space.frame().resolution << " cells");
        }
        if (!is_blocked(map, x, y)) ++(expected ? kept : lost);
      }
    }
  }
  CHECK(kept > test::scaled(2000));
  CHECK(lost > test::scaled(2000));
}

TEST_CASE("a point is joined to the cells around it that it reaches by free segments") {
  const std::uint64_t seed = 11;
  Random random(seed);
  std::size_t joined = 0, refused = 0;
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    INFO("seed " << seed << ", round " << round);
    const OccupancyGrid map = random_map(random);
    const CellSpace space = random_space(random, map);
    const Squares squares(map);
    const Rational limit = squared_radius(space);
    for (int i = 0; i < 10; ++i) {
      const Place at = squares.random_place(random);
      const EndpointLinks links = space.links(point_at(space, at));
      std::map<std::pair<int, int>, double> expected;
      for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
          const Place centre{4 * x + 2, 4 * y + 2};
          const std::int64_t dx = centre.x - at.x, dy = centre.y - at.y;
          const std::int64_t square = dx * dx + dy * dy;
          if (square > 32 || !space.grid().is_free(Cell{x, y})) continue;
          if (!squares.is_free(at, centre, limit)) {
            ++refused;
            continue;
          }
          expected[{x, y}] = std::sqrt(static_cast<double>(square)) * space.frame().resolution / 4;
        }
      }
      for (const auto& [cell, length] : expected) {  // a cell's own centre needs no other
        if (length != 0) continue;
        expected = {{cell, 0}};
        break;
      }
      bool right = links.size() == expected.size();
      for (const EndpointLink& link : links) {
        const auto entry = expected.find({link.cell.x, link.cell.y});
        right = right && entry != expected.end() &&
                std::abs(entry->second - link.length) <= space.distance_error_bound();
      }
      if (!right) FAIL_CHECK("quarter (" << at.x << ", " << at.y << ")");
      joined += links.size();
    }
  }
  CHECK(joined > test::scaled(1000));
  CHECK(refused > test::scaled(100));
}

TEST_CASE("a point outside the grid has no links") {
  const auto space = CellSpace::build(draw({"...", "...", "..."})).value();
  CHECK(space.links({-0.1, 1.5}).empty());
  CHECK(space.links({1.5, 3.1}).empty());
  CHECK(space.links({1e300, -1e300}).empty());
  CHECK(space.links({2147483647.5, 1.5}).empty());
  CHECK(space.links({nan, 1.5}).empty());
  CHECK(space.links({infinity, 1.5}).empty());
}

TEST_CASE("options that make no space are refused") {
  const OccupancyGrid map = draw({"...", ".#.", "..."});
  const auto refused = [&](const CellOptions& options) {
    const auto space = CellSpace::build(map, options);
    return !space && space.error().code == PlanError::invalid_option &&
           !space.error().detail.empty();
  };
  for (const double resolution : {0.0, -1.0, -0.0, nan, infinity, -infinity, 1e-100, 1e300}) {
    CAPTURE(resolution);
    CHECK(refused({.resolution = resolution}));
  }
  for (const double bad : {nan, infinity, -infinity}) {
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

/// The exact verdict on each piece among the obstacles near it; the others cannot matter.
ExactVerdict exact_verdict(const Workspace& world, const Curve& curve) {
  ExactVerdict verdict = ExactVerdict::free;
  for (const Piece& piece : curve.pieces()) {
    Box box = piece.visit([](const auto& any) { return any.box(); });
    box = box.inflated(1.001 * world.safety_radius + 1e-6 * world.bounds.width());
    Workspace near = world;
    std::erase_if(near.obstacles, [&](const Obstacle& obstacle) {
      const Ring& ring = std::get<Polygon>(obstacle).outer;  // a rectangle
      return ring[0].x() > box.max.x() || ring[2].x() < box.min.x() || ring[0].y() > box.max.y() ||
             ring[2].y() < box.min.y();
    });
    const ExactVerdict one = test::ExactChecker(near).check(piece);
    if (one == ExactVerdict::blocked) return one;
    if (one == ExactVerdict::unknown) verdict = one;
  }
  return verdict;
}

template <class Smooth>
void check_plans(const Smooth& smoother, std::uint64_t seed, std::size_t rounds) {
  Random random(seed);
  Planner planner(AStar{}, smoother);
  std::size_t plans = 0, at_contact = 0, unknown = 0;
  for (std::size_t round = 0; round < rounds; ++round) {
    INFO(Smooth::name << ", seed " << seed << ", round " << round);
    const OccupancyGrid map = random_map(random);
    const CellSpace space = random_space(random, map, round % 3 == 0);
    const Squares squares(map);
    const Workspace world = workspace_of(space, squares);
    const Rational limit = squared_radius(space);
    for (int i = 0; i < 4; ++i) {
      const Place from = squares.random_place(random), to = squares.random_place(random);
      if (!squares.is_free(from, from, limit) || !squares.is_free(to, to, limit)) continue;
      const Point start = point_at(space, from), goal = point_at(space, to);
      const auto plan = planner.plan(space, {.start = start, .goal = goal});
      if (!plan) {
        if (plan.error().code == PlanError::not_proved) FAIL_CHECK("a route that is not proved");
        continue;
      }
      INFO("from " << start.transpose() << " to " << goal.transpose());
      ++plans;
      if (space.safety_radius() == 0) ++at_contact;
      CHECK(plan->curve.start() == start);
      CHECK(plan->curve.end() == goal);
      CHECK(plan->certificate.status == ProofStatus::proved);
      CHECK(plan->certificate.lower >= space.safety_radius());
      const ExactVerdict verdict = exact_verdict(world, plan->curve);
      CHECK(verdict != ExactVerdict::blocked);
      if (verdict == ExactVerdict::unknown) ++unknown;
    }
  }
  CHECK(plans > rounds / 2);
  CHECK(at_contact > rounds / 8);
  CHECK(unknown == 0);
}

TEST_CASE("plans among cells are proved and free to the exact checker") {
  check_plans(NoSmoothing{}, 12, test::scaled(250));
}

TEST_CASE("plans among cells with shortcuts are proved and free to the exact checker") {
  check_plans(Shortcut{}, 13, test::scaled(250));
}

TEST_CASE("plans among cells with smooth corners are proved and free to the exact checker") {
  check_plans(DeltaSmoother{}, 14, test::scaled(250));
}

}  // namespace
