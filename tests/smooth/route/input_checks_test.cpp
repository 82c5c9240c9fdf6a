// SPDX-License-Identifier: MIT
#include "tutavia/smooth/route/input_checks.hpp"

#include <numbers>
#include <stop_token>
#include <vector>

#include "support/catch.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/space/lattice_space.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

const Workspace world{
    .bounds = {{0, 0}, {10, 10}}, .safety_radius = 0.5, .obstacles = {Disc{{5, 5}, 1}}};

TEST_CASE("a curve is free where every piece is proved, else its first bad piece is named") {
  const auto space = InflatedSpace::build(world).value();
  const Curve free = Curve::polyline(std::vector<Point>{{1, 1}, {9, 1}, {9, 9}});
  CHECK(check_free(space, free, {}));
  const Curve blocked = Curve::polyline(std::vector<Point>{{1, 1}, {1, 5}, {9, 5}, {1, 5}});
  const auto refused = check_free(space, blocked, {});
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == PlanError::invalid_input);
  CHECK(refused.error().detail.find("segment 1 of the route, from ") == 0);
  Curve curved;
  curved.push_back(QuadraticBezier{{Point(1, 5), Point(5, 0), Point(9, 5)}});  // 2.5 below
  CHECK(check_free(space, curved, {}));
}

TEST_CASE("a stopped budget stops the check") {
  const auto space = InflatedSpace::build(world).value();
  const Curve free = Curve::polyline(std::vector<Point>{{1, 1}, {9, 1}});
  std::stop_source source;
  source.request_stop();
  Budget budget;
  budget.stop = source.get_token();
  const auto stopped = check_free(space, free, budget);
  REQUIRE_FALSE(stopped);
  CHECK(stopped.error().code == PlanError::cancelled);
}

TEST_CASE("curves of segments and arcs are taken as polylines, others are refused") {
  const auto space = InflatedSpace::build(world).value();
  Curve curve = Curve::polyline(std::vector<Point>{{1, 1}, {9, 1}});
  CHECK(free_polyline(space, curve, {}, "shears").value() == std::vector<Point>{{1, 1}, {9, 1}});
  Curve bent = curve;
  bent.push_back(Arc{{9, 1}, {9, 2}, {9, 1.5}, 0.5, -std::numbers::pi / 2, std::numbers::pi});
  CHECK(free_polyline(space, bent, {}, "shears").value().size() == 2 + 4 + 1);
  CHECK(free_nodes(space, bent, {}, "shears").value().size() == 2 + 4 + 1);
  curve.push_back(QuadraticBezier{{Point(9, 1), Point(9, 5), Point(9, 9)}});
  const auto refused = free_polyline(space, curve, {}, "shears");
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == PlanError::invalid_input);
  CHECK(refused.error().detail == "shears takes curves of segments and arcs only");
  CHECK(free_nodes(space, curve, {}, "shears").error().detail == refused.error().detail);
}

TEST_CASE("a run has all its nodes as waypoints on a lattice, and its ends alone in the plane") {
  const auto space = LatticeSpace::build(world, {.resolution = 1}).value();
  const Point a = space.frame().point({1, 1}), b = space.frame().point({5, 1});
  const Curve run = Curve::polyline(std::vector<Point>{a, b});
  const auto nodes = free_nodes(space, run, {}, "shears").value();
  REQUIRE(nodes.size() == 5);
  CHECK(nodes[2] == space.frame().point({3, 1}));
  CHECK(free_steps(space, run, {})->pieces().size() == 4);
  const auto plane = InflatedSpace::build(world).value();
  CHECK(free_nodes(plane, run, {}, "shears").value() == std::vector<Point>{a, b});
}

TEST_CASE("a blocked run is refused by its own ends, not by those of a step") {
  const auto space = LatticeSpace::build(world, {.resolution = 1}).value();
  const Curve blocked = Curve::polyline(std::vector<Point>{{1, 5}, {9, 5}});
  const auto refused = free_nodes(space, blocked, {}, "shears");
  REQUIRE_FALSE(refused);
  CHECK(refused.error().detail.find("segment 0 of the route") == 0);
}

}  // namespace
