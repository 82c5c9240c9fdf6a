// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/cell_world.hpp"
#include "support/random_cells.hpp"
#include "support/random_grids.hpp"
#include "support/scale.hpp"
#include "support/visibility_oracle.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/optimum.hpp"
#include "tutavia/search/any_angle.hpp"
#include "tutavia/search/tangent_graph.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;
using tutavia::test::VisibilityOracle;

template <class S>
Expected<Route, Failure> shortest(const S& space, const Query& query) {
  TangentGraph::Scratch scratch;
  NoObserver no_observer;
  return TangentGraph{}.search(space, query, scratch, no_observer);
}

/// The same obstacles for the library and for the oracle, on a lattice of half metres.
class PointWorlds {
 public:
  static constexpr double size = 10;

  explicit PointWorlds(std::uint64_t seed) : random_(seed) {}

  void draw() {
    oracle_ = VisibilityOracle({{0, 0}, {size, size}});
    obstacles_.clear();
    const std::uint64_t count = 2 + random_.below(10);
    const double longest = count < 6 ? 5 : 3;
    for (std::uint64_t i = 0; i < count; ++i) add(longest);
  }
  const VisibilityOracle& oracle() const { return oracle_; }
  InflatedSpace space() const {
    return InflatedSpace::build({.bounds = {{0, 0}, {size, size}}, .obstacles = obstacles_})
        .value();
  }
  Point point() { return {step(size), step(size)}; }

 private:
  double step(double largest) {
    return 0.5 * static_cast<double>(random_.below(static_cast<std::uint64_t>(2 * largest) + 1));
  }
  double side(double longest) { return 0.5 + step(longest - 0.5); }
  static std::vector<Point> rectangle(double x, double y, double width, double height) {
    return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
  }

  void add(double longest) {
    const Point at{step(size) - 1, step(size) - 1};
    const double width = side(longest), height = side(longest);
    switch (random_.below(6)) {
      case 0:
        return add_triangle(at, width, height);
      case 1:
        return add_wall(at, longest);
      case 2:
        return add_angle(at, 1 + side(longest), 1 + side(longest));
      case 3:
        return add_octagon(at);
      default:
        return add_convex(rectangle(at.x(), at.y(), width, height));
    }
  }
  /// A vertex in the middle of a side now and then, so that three lie in a line.
  void add_convex(std::vector<Point> ring) {
    oracle_.add_piece(ring);
    if (random_.below(3) == 0) ring.insert(ring.begin() + 1, 0.5 * (ring[0] + ring[1]));
    if (random_.below(2) == 0) std::reverse(ring.begin(), ring.end());
    obstacles_.emplace_back(Polygon{std::move(ring)});
  }
  void add_triangle(const Point& at, double width, double height) {
    add_convex({at, at + Point(width, step(height)), at + Point(step(width / 2), height + 0.5)});
  }
  void add_octagon(const Point& at) {
    add_convex({at + Point(1, 0), at + Point(2, 0), at + Point(3, 1), at + Point(3, 2),
                at + Point(2, 3), at + Point(1, 3), at + Point(0, 2), at + Point(0, 1)});
  }
  /// An L of two bars of half a metre, which overlap where they meet.
  void add_angle(const Point& at, double width, double height) {
    const double x = at.x(), y = at.y();
    oracle_.add_piece(rectangle(x, y, width, 0.5));
    oracle_.add_piece(rectangle(x, y, 0.5, height));
    obstacles_.emplace_back(Polygon{{{x, y},
                                     {x + width, y},
                                     {x + width, y + 0.5},
                                     {x + 0.5, y + 0.5},
                                     {x + 0.5, y + height},
                                     {x, y + height}}});
  }
  void add_wall(const Point& at, double longest) {
    Ring points{at};
    for (std::uint64_t count = 1 + random_.below(3); count > 0; --count) {
      const Point next = points.back() + Point(step(longest) - 1, step(longest) - 1);
      if (next == points.back()) continue;
      oracle_.add_wall({points.back(), next});
      points.push_back(next);
    }
    if (points.size() > 1) obstacles_.emplace_back(polyline_obstacle(std::move(points)));
  }

  Random random_;
  VisibilityOracle oracle_{{{0, 0}, {size, size}}};
  std::vector<Obstacle> obstacles_;
};

TEST_CASE(
    "a point's shortest paths among touching obstacles are those of an exact visibility graph",
    "[soak]") {
  const std::uint64_t seed = 2101;
  PointWorlds worlds(seed);
  std::size_t paths = 0, bent = 0, none = 0;
  for (std::size_t round = 0; round < test::scaled(100); ++round) {
    INFO("seed " << seed << ", round " << round);
    worlds.draw();
    const InflatedSpace space = worlds.space();
    const Query query{.start = worlds.point(), .goal = worlds.point()};
    const bool is_free =
        worlds.oracle().is_free(query.start) && worlds.oracle().is_free(query.goal);
    CHECK((space.is_free(query.start) && space.is_free(query.goal)) == is_free);
    if (!is_free) continue;
    const double expected = worlds.oracle().shortest_length(query.start, query.goal);
    const auto route = shortest(space, query);
    if (!route) {
      ++none;
      CHECK(route.error().code == PlanError::unreachable);
      CHECK(expected == std::numeric_limits<double>::infinity());
      continue;
    }
    ++paths;
    bent += route->curve.pieces().size() > 1 ? 1 : 0;
    CHECK(std::abs(route->cost - expected) <= 1e-9 * (1 + expected));
    CHECK(certify(space, route->curve).status == ProofStatus::proved);
    const TangentGraph prepared{.tangents = TangentGraph::prepare(space).value()};
    CHECK(find_optimum(space, query).value() == Approx(route->cost).epsilon(1e-12));
    TangentGraph::Scratch scratch;
    NoObserver no_observer;
    CHECK(prepared.search(space, query, scratch, no_observer)->cost ==
          Approx(route->cost).epsilon(1e-12));
  }
  CAPTURE(paths, bent, none);
  CHECK(paths > test::scaled(100) / 4);
  CHECK(bent > test::scaled(100) / 10);
}

TEST_CASE("buildings that touch leave a gap for a point in a workspace, and none among cells") {
  const auto workspace =
      InflatedSpace::build({.bounds = {{0, 0}, {4, 4}},
                            .obstacles = {Polygon{{{1, -1}, {2, -1}, {2, 5}, {1, 5}}},
                                          Polygon{{{2, -1}, {3, -1}, {3, 2}, {2, 2}}},
                                          Polygon{{{2, 2}, {3, 2}, {3, 5}, {2, 5}}}}})
          .value();
  // Along the side that two of them share; the third closes the way.
  CHECK(shortest(workspace, {.start = {3.5, 2}, .goal = {2, 2}})->cost == 1.5);
  CHECK(shortest(workspace, {.start = {3.5, 1}, .goal = {2, 1}})->cost ==
        Approx(std::sqrt(0.25 + 1) + 2));
  CHECK(shortest(workspace, {.start = {3.5, 2}, .goal = {0.5, 2}}).error().code ==
        PlanError::unreachable);
  OccupancyGrid grid = test::free_grid(4, 4);
  for (int y = 0; y < 4; ++y) {
    grid.set({1, y}, false);
    grid.set({2, y}, false);
  }
  const auto cells = CellSpace::build(std::move(grid)).value();
  CHECK(cells.is_free({3, 2}));
  CHECK_FALSE(cells.is_free({2.5, 2}));
}

/// The blocked cells of a grid, as CellSpace has them: where two share a side, that side is inside,
/// and so is the side that a cell shares with the border.
VisibilityOracle oracle_of(const OccupancyGrid& grid) {
  VisibilityOracle oracle({{0, 0}, Point(grid.width(), grid.height())});
  const auto is_blocked = [&](int x, int y) {
    return grid.contains({x, y}) && !grid.is_free({x, y});
  };
  const auto add = [&](double x, double y, double width, double height) {
    oracle.add_piece({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}});
  };
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (!is_blocked(x, y)) continue;
      add(x, y, 1, 1);
      const bool right = is_blocked(x + 1, y) || x + 1 == grid.width();
      const bool above = is_blocked(x, y + 1) || y + 1 == grid.height();
      if (right) add(x, y, 2, 1);
      if (above) add(x, y, 1, 2);
      if (x == 0) add(-1, y, 2, 1);
      if (y == 0) add(x, -1, 1, 2);
      if (right && above && (is_blocked(x + 1, y + 1) || !grid.contains({x + 1, y + 1}))) {
        add(x, y, 2, 2);
      }
    }
  }
  return oracle;
}

TEST_CASE("a point's shortest paths among cells are those of an exact visibility graph", "[soak]") {
  const std::uint64_t seed = 2102;
  Random random(seed);
  std::size_t paths = 0, shorter = 0;
  for (std::size_t round = 0; round < test::scaled(60); ++round) {
    INFO("seed " << seed << ", round " << round);
    const OccupancyGrid grid = test::random_grid(random, 12);
    const VisibilityOracle oracle = oracle_of(grid);
    const auto space = CellSpace::build(grid).value();
    const auto point = [&] {
      return Point(0.5 * static_cast<double>(random.below(2 * std::uint64_t(grid.width()) + 1)),
                   0.5 * static_cast<double>(random.below(2 * std::uint64_t(grid.height()) + 1)));
    };
    const Query query{.start = point(), .goal = point()};
    if (!space.is_free(query.start) || !space.is_free(query.goal)) continue;
    const double expected = oracle.shortest_length(query.start, query.goal);
    const auto route = shortest(space, query);
    CHECK(route.has_value() == (expected < std::numeric_limits<double>::infinity()));
    if (!route) continue;
    ++paths;
    CHECK(std::abs(route->cost - expected) <= 1e-9 * (1 + expected));
    CHECK(certify(space, route->curve).status == ProofStatus::proved);
    AnyAngle::Scratch scratch;
    NoObserver no_observer;
    const auto any_angle = AnyAngle{}.search(space, query, scratch, no_observer);
    if (!any_angle) continue;
    CHECK(any_angle->cost >= route->cost * (1 - 1e-9));
    shorter += any_angle->cost > route->cost * (1 + 1e-9) ? 1 : 0;
  }
  INFO(paths << " paths, " << shorter << " through corners that AnyAngle does not pass");
  CHECK(paths > test::scaled(60) / 5);
}

TEST_CASE("a disc's shortest paths among cells are those among rectangles", "[soak]") {
  const std::uint64_t seed = 2103;
  Random random(seed);
  std::size_t paths = 0;
  for (std::size_t round = 0; round < test::scaled(40); ++round) {
    INFO("seed " << seed << ", round " << round);
    const OccupancyGrid grid = test::random_grid(random, 20);
    const double radius = random.uniform(0.05, 0.49);
    const auto cells = CellSpace::build(grid, {.safety_radius = radius}).value();
    const auto polygons = InflatedSpace::build(test::world_of_cells(cells)).value();
    const auto point = [&] { return cells.frame().point(test::random_cell(random, grid)); };
    const Query query{.start = point(), .goal = point()};
    const auto expected = shortest(polygons, query);
    const auto route = shortest(cells, query);
    REQUIRE(route.has_value() == expected.has_value());
    if (!route) continue;
    ++paths;
    CHECK(route->cost == Approx(expected->cost).epsilon(1e-9));
    CHECK(certify(cells, route->curve).status == ProofStatus::proved);
  }
  CHECK(paths > test::scaled(40) / 5);
}

}  // namespace
