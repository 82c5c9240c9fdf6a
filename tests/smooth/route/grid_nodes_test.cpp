// SPDX-License-Identifier: MIT
#include "tutavia/smooth/route/grid_nodes.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/lattice_space.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

CellSpace open_cells(double resolution, const Point& origin) {
  OccupancyGrid grid = OccupancyGrid::blocked(20, 15).value();
  for (int y = 0; y < 15; ++y) grid.set_run(y, 0, 19, true);
  return CellSpace::build(grid, {.resolution = resolution, .origin = origin}).value();
}

std::vector<Point> ends(const Curve& curve) {
  std::vector<Point> points{curve.start()};
  for (const Piece& piece : curve.pieces()) points.push_back(end_of(piece));
  return points;
}

template <class S>
std::vector<Point> split(const S& space, const std::vector<Point>& points) {
  return ends(split_at_nodes(space, Curve::polyline(points)));
}

TEST_CASE("a straight run between nodes is cut into its single steps") {
  const CellSpace space = open_cells(0.1, {-12.3, 4.7});
  const auto node = [&](int x, int y) { return space.frame().point({x, y}); };
  for (std::size_t step = 0; step < steps.size(); ++step) {
    CAPTURE(step);
    const Cell from{9, 7}, d = steps[step];
    std::vector<Point> expected;
    for (int i = 0; i <= 6; ++i) expected.push_back(node(from.x + i * d.x, from.y + i * d.y));
    CHECK(split(space, {expected.front(), expected.back()}) == expected);
  }
}

TEST_CASE("the joints of a path are kept, and what is off the nodes stays whole") {
  const CellSpace space = open_cells(1, {0, 0});  // nodes at the halves
  const std::vector<Point> path{{0.2, 0.4}, {0.5, 0.5}, {3.5, 3.5}, {5.5, 3.5}, {5.5, 2.5},
                                {8.5, 3.5}, {8.5, 6},   {8.5, 7.5}, {9.25, 7.5}};
  const std::vector<Point> expected{{0.2, 0.4}, {0.5, 0.5}, {1.5, 1.5}, {2.5, 2.5},
                                    {3.5, 3.5}, {4.5, 3.5}, {5.5, 3.5}, {5.5, 2.5},
                                    {8.5, 3.5}, {8.5, 6},   {8.5, 7.5}, {9.25, 7.5}};
  CHECK(split(space, path) == expected);
}

TEST_CASE("the ends of a run stay as they are, also next to their nodes") {
  const auto space =
      LatticeSpace::build({.bounds = {{0, 0}, {9, 9}}, .safety_radius = 0.1}, {.resolution = 0.5})
          .value();
  const Point start{1 + 1e-12, 2}, goal{3, 2 - 1e-12};
  const std::vector<Point> points = split(space, {start, goal});
  REQUIRE(points.size() == 5);
  CHECK(points.front() == start);
  CHECK(points.back() == goal);
  CHECK(points[1] == space.frame().point({3, 4}));
  CHECK(points[3] == space.frame().point({5, 4}));
}

TEST_CASE("pieces that are not straight, and single points, are kept") {
  const CellSpace space = open_cells(1, {0, 0});
  Curve curve;
  curve.push_back(Segment{{0.5, 0.5}, {0.5, 0.5}});
  curve.push_back(QuadraticBezier{{Point(0.5, 0.5), Point(2.5, 0.5), Point(2.5, 2.5)}});
  curve.push_back(Segment{{2.5, 2.5}, {2.5, 4.5}});
  const Curve result = split_at_nodes(space, curve);
  REQUIRE(result.pieces().size() == 4);
  CHECK(result.pieces()[0].holds<Segment>());
  CHECK(result.pieces()[1].holds<QuadraticBezier>());
  CHECK(end_of(result.pieces()[2]) == Point(2.5, 3.5));
  CHECK(result.length() == Approx(curve.length()));
  CHECK(split_at_nodes(space, Curve()).empty());
}

TEST_CASE("without a grid a curve stays whole") {
  const auto space =
      InflatedSpace::build({.bounds = {{0, 0}, {9, 9}}, .safety_radius = 0.1}).value();
  const std::vector<Point> path{{1, 1}, {5, 1}, {8, 4}};
  CHECK(split(space, path) == path);
}

TEST_CASE("the routes of a search are cut at every node they pass") {
  const std::uint64_t seed = 1;
  Random random(seed);
  Planner planner(AStar{}, NoSmoothing{});
  std::size_t cut = 0;
  for (std::size_t round = 0; round < test::scaled(100); ++round) {
    INFO("seed " << seed << ", round " << round);
    OccupancyGrid map = OccupancyGrid::blocked(25, 20).value();
    for (int y = 0; y < 20; ++y) {
      for (int x = 0; x < 25; ++x) map.set({x, y}, random.uniform() > 0.2);
    }
    const auto space = CellSpace::build(map, {.resolution = 0.05, .origin = {-12.3, 4.7}}).value();
    const Frame& frame = space.frame();
    const auto cell = [&] {
      const int x = static_cast<int>(random.below(25));
      return Cell{x, static_cast<int>(random.below(20))};
    };
    const auto plan =
        planner.plan(space, {.start = frame.point(cell()), .goal = frame.point(cell())});
    if (!plan) continue;
    const Curve result = split_at_nodes(space, plan->curve);
    CHECK(result.start() == plan->curve.start());
    CHECK(result.end() == plan->curve.end());
    CHECK(result.length() == Approx(plan->curve.length()));
    bool single = true;
    for (const Piece& piece : result.pieces()) {
      const Cell from = frame.nearest_cell(start_of(piece)), to = frame.nearest_cell(end_of(piece));
      single = single && std::abs(to.x - from.x) <= 1 && std::abs(to.y - from.y) <= 1 &&
               frame.point(from) == start_of(piece) && frame.point(to) == end_of(piece);
    }
    CHECK(single);
    if (result.pieces().size() > plan->curve.pieces().size()) ++cut;
  }
  CHECK(cut > test::scaled(30));
}

}  // namespace
