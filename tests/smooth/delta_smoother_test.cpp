// SPDX-License-Identifier: MIT
#include "tutavia/smooth/delta_smoother.hpp"

#include <limits>

#include "support/random_tasks.hpp"
#include "support/searcher_contract.hpp"
#include "support/smoother_contract.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;

TEST_CASE("DeltaSmoother keeps the smoother contract") {
  test::smoother_contract(DeltaSmoother{});
  test::smoother_contract(DeltaSmoother{.join = DeltaSmoother::Join::tangent});
}

/// A post at the origin; the safety zone reaches 0.5 from it.
InflatedSpace post() {
  return InflatedSpace::build(
             {.bounds = {{-9, -9}, {9, 9}}, .safety_radius = 0.5, .obstacles = {Disc{{0, 0}, 0}}})
      .value();
}

TEST_CASE("the two steps around a trigger become one arc, pushed out only as far as it must be") {
  const auto space = post();
  // The node nearest to the post is (0, 0.8): the corner is critical, and the arc without a push is
  // free.
  const Point wide[] = {{-1, 0.4}, {0, 0.8}, {1, 0.4}};
  const auto free = DeltaSmoother{}.smooth(space, Curve::polyline(wide), Budget{}).value();
  REQUIRE(free.pieces().size() == 1);
  const auto* arc = free.pieces()[0].get_if<QuadraticBezier>();
  REQUIRE(arc != nullptr);
  CHECK(arc->points[1] == Point(0, 0.8));

  // Nearer, the arc at offset 0 has its apex at 0.4, within the zone; the control point has to go
  // up by 0.24 until it is at 0.52.
  const Point close[] = {{-1, 0.2}, {0, 0.6}, {1, 0.2}};
  const auto pushed = DeltaSmoother{}.smooth(space, Curve::polyline(close), Budget{}).value();
  REQUIRE(pushed.pieces().size() == 1);
  arc = pushed.pieces()[0].get_if<QuadraticBezier>();
  REQUIRE(arc != nullptr);
  CHECK(arc->points[1].isApprox(Point(0, 0.6 + 0.12 + 0.12)));
}

TEST_CASE("where no push helps, the steps stay as they are") {
  const auto space = post();
  const Point close[] = {{-1, 0.2}, {0, 0.6}, {1, 0.2}};
  const DeltaSmoother timid{.arc_max_offset = 0.1};
  const auto kept = timid.smooth(space, Curve::polyline(close), Budget{}).value();
  CHECK(test::same_curve(kept, Curve::polyline(close)));
}

TEST_CASE("shortcuts stop one node before the last in sight, and before triggers") {
  const auto space =
      InflatedSpace::build(
          {.bounds = {{-9, -9}, {9, 9}}, .safety_radius = 0.5, .obstacles = {Disc{{0, 0}, 0.25}}})
          .value();
  const DeltaSmoother no_corners{.min_exterior_angle = 7};  // nothing turns that much
  std::vector<Point> nodes;
  for (int i = 0; i <= 8; ++i) nodes.emplace_back(-2 + 0.25 * i, 0.8);
  for (int i = 1; i <= 8; ++i) nodes.emplace_back(0.8, 0.8 - 0.25 * i);
  nodes[8] = {0.4, 0.8};
  const auto result = no_corners.smooth(space, Curve::polyline(nodes), Budget{}).value();
  std::size_t last = nodes.size() - 1;
  while (!space.segment_free(nodes[0], nodes[last])) --last;
  REQUIRE(last < nodes.size() - 1);
  CHECK(end_of(result.pieces()[0]) == nodes[last - 1]);

  const auto triggers = DeltaSmoother{}.smooth(space, Curve::polyline(nodes), Budget{}).value();
  for (const Piece& piece : triggers.pieces()) {
    if (const auto* arc = piece.get_if<QuadraticBezier>()) {
      CHECK(arc->points[1].norm() < 1.7);  // near the post's trigger
    }
  }
}

/// Calls `check(space, route)` for the routes of A* on all built-in maps.
template <class Check>
void for_each_built_in_route(const Check& check) {
  for (const Scene& scene : {maps::array(), maps::complex(), maps::maze()}) {
    const auto space =
        LatticeSpace::build(scene.workspace, {.resolution = scene.resolution}).value();
    for (const Point& goal : scene.goals) {
      INFO(scene.name << " to " << goal.transpose());
      const auto route = test::search_once(AStar{}, space, {.start = scene.start, .goal = goal});
      REQUIRE(route);
      check(space, route->curve);
    }
  }
}

TEST_CASE("every path of the built-in maps becomes shorter") {
  for_each_built_in_route([](const LatticeSpace& space, const Curve& route) {
    const auto smooth = DeltaSmoother{}.smooth(space, route, Budget{}).value();
    CHECK(smooth.length() < 0.99 * route.length());
    CHECK(certify(space, smooth).status == ProofStatus::proved);
  });
}

TEST_CASE("with tangent joins lines and arcs meet in one direction, as the paper's do not") {
  for_each_built_in_route([](const LatticeSpace& space, const Curve& route) {
    const DeltaSmoother tangent{.join = DeltaSmoother::Join::tangent};
    const Curve paper = DeltaSmoother{}.smooth(space, route, {}).value();
    const Curve smooth = tangent.smooth(space, route, {}).value();
    CHECK(test::largest_corner(paper) > 0.1);
    CHECK(test::largest_corner(smooth) < 1e-6);
    CHECK(smooth.length() <= paper.length());
    CHECK(certify(space, smooth).status == ProofStatus::proved);
  });
}

TEST_CASE("facets of a round obstacle are not corners, unless one asks for them") {
  const Scene scene = maps::complex();
  const auto space = InflatedSpace::build(scene.workspace).value();
  const std::vector<Point> along_the_ellipse{{0.2, 2}, {3.8, 2}};
  const double degree = std::acos(-1) / 180;
  const auto count = [&](double angle) {
    return detail::critical_corners(space, along_the_ellipse, 0.3, angle).size();
  };
  CHECK(count(20 * degree) < count(1 * degree));
  CHECK(count(1 * degree) >= 10);
}

TEST_CASE("options without meaning are refused by name") {
  const auto space = post();
  const Point points[] = {{-1, 2}, {1, 2}};
  const Curve curve = Curve::polyline(points);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refusal = [&](const DeltaSmoother& smoother) {
    const auto result = smoother.smooth(space, curve, Budget{});
    REQUIRE_FALSE(result);
    CHECK(result.error().code == PlanError::invalid_option);
    return result.error().detail;
  };
  CHECK(refusal({.corner_threshold = -1}).find("corner_threshold") == 0);
  CHECK(refusal({.arc_initial_offset = nan}).find("arc_initial_offset") == 0);
  CHECK(
      refusal({.arc_max_offset = std::numeric_limits<double>::infinity()}).find("arc_max_offset") ==
      0);
  CHECK(refusal({.arc_growth_step = 0}).find("arc_growth_step") == 0);
  CHECK(refusal({.min_exterior_angle = nan}).find("min_exterior_angle") == 0);

  Curve curved;
  curved.push_back(QuadraticBezier{{Point(-1, 2), Point(0, 3), Point(1, 2)}});
  CHECK(DeltaSmoother{}.smooth(space, curved, Budget{}).error().code == PlanError::invalid_input);
}

}  // namespace
