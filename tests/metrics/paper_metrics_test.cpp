// SPDX-License-Identifier: MIT
#include "tutavia/metrics/paper_metrics.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "tutavia/metrics/path_metrics.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;
using std::numbers::pi;

Curve polyline(const std::vector<Point>& points) { return Curve::polyline(points); }

/// 5 x 3 cells, the middle one blocked: [2, 3] x [1, 2].
CellSpace one_blocked_cell() {
  OccupancyGrid grid = test::free_grid(5, 3);
  grid.set({2, 1}, false);
  return CellSpace::build(std::move(grid), {.movement = MovementRule::allow}).value();
}

TEST_CASE("distances of a path that passes below a blocked cell") {
  // At a step of 1: samples at x = 0.5, 1.5, 2.5, 3.5.
  const auto d = obstacle_distances(one_blocked_cell(), polyline({{0.5, 0.5}, {4.5, 0.5}}), 1);
  CHECK(d.min == Approx(0.5));
  CHECK(d.mean == Approx((std::hypot(1.5, 0.5) + 2 * std::sqrt(0.5) + 0.5) / 4));
}

TEST_CASE("distances are 0 where a path touches an obstacle, and inside") {
  const CellSpace space = one_blocked_cell();
  // Past the corner (2, 1), which is a sample at step 0.25 times sqrt(2).
  const double step = 0.25 * std::numbers::sqrt2;
  const auto touching = obstacle_distances(space, polyline({{1.5, 1.5}, {2.5, 0.5}}), step);
  CHECK(touching.min == Approx(0).margin(1e-12));
  CHECK(touching.mean == Approx((0.5 + 0.25 + 0 + 0.25) / 4));
  const auto through = obstacle_distances(space, polyline({{1.5, 1.5}, {3.5, 1.5}}), 0.5);
  CHECK(through.min == 0);
  CHECK(through.mean == Approx((0.5 + 0 + 0 + 0) / 4));
  // The end counts for the least distance.
  CHECK(obstacle_distances(space, polyline({{0.5, 1.5}, {2, 1.5}}), 10).min == 0);
  CHECK(obstacle_distances(space, polyline({{0.5, 1.5}, {2, 1.5}}), 10).mean == Approx(1.5));
}

TEST_CASE("distances of a point, and without obstacles") {
  CHECK(obstacle_distances(one_blocked_cell(), polyline({{1, 1.5}}), 1).mean == Approx(1));
  const auto empty = CellSpace::build(test::free_grid(4, 4)).value();
  const auto d = obstacle_distances(empty, polyline({{1, 1}, {3, 3}}), 0.05);
  CHECK(d.min == std::numeric_limits<double>::infinity());
  CHECK(d.mean == std::numeric_limits<double>::infinity());
}

TEST_CASE("the mean turn of points counts every point between the ends") {
  const std::vector<Point> stairs{{0, 0}, {1, 0}, {1, 1}, {1, 2}, {2, 3}};
  CHECK(mean_turn(stairs) == Approx((pi / 2 + 0 + pi / 4) / 3));
  const std::vector<Point> zigzag{{0, 0}, {1, 0}, {1, 0}, {0, 0}};  // turns back
  CHECK(mean_turn(zigzag) == Approx(pi));
  const std::vector<Point> line{{0, 0}, {1, 1}};
  CHECK(mean_turn(line) == 0);
  CHECK(mean_turn(std::vector<Point>{}) == 0);
}

TEST_CASE("the mean turn of an arc is its sweep over the steps") {
  Curve curve;
  curve.push_back(Arc::around({0, 0}, 2, 0, pi / 2));
  // 99 chords of equal length: each of 98 points turns by a 99th of the sweep.
  CHECK(mean_turn(curve) == Approx(pi / 2 / 99));
  CHECK(mean_turn(curve, 3) == Approx(pi / 4));
  CHECK(mean_turn(polyline({{3, 3}})) == 0);
}

TEST_CASE("the nodes of a route are a step apart") {
  const double side = 0.5;
  const auto nodes = grid_nodes(polyline({{0, 0}, {1.5, 0}, {1, 0.5}, {0.9, 0.6}}), side);
  const std::vector<Point> expected{{0, 0}, {0.5, 0}, {1, 0}, {1.5, 0}, {1, 0.5}, {0.9, 0.6}};
  REQUIRE(nodes.size() == expected.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    CHECK(distance(nodes[i], expected[i]) == Approx(0).margin(1e-12));
  }
  CHECK(grid_nodes(Curve{}, 1).empty());
  CHECK(grid_nodes(polyline({{2, 2}}), 1).size() == 1);
}

TEST_CASE("relative smoothness is a ratio of turnings") {
  const double stairs = measure(polyline({{0, 0}, {1, 0}, {2, 1}, {3, 1}})).turning_angle;
  CHECK(relative_smoothness(stairs, pi / 4) == Approx(2));
  CHECK(relative_smoothness(stairs, stairs) == 1);
  CHECK(relative_smoothness(stairs, 0) == std::numeric_limits<double>::infinity());
  CHECK(relative_smoothness(0, 0) == 1);
}

}  // namespace
