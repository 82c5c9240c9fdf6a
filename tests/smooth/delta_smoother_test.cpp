// SPDX-License-Identifier: MIT
#include "tutavia/smooth/delta_smoother.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "support/random_tasks.hpp"
#include "support/searcher_contract.hpp"
#include "support/smoother_contract.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/metrics/path_metrics.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;

const DeltaSmoother as_printed{.join = DeltaSmoother::Join::paper};

TEST_CASE("DeltaSmoother keeps the smoother contract") {
  test::smoother_contract(DeltaSmoother{});
  test::smoother_contract(as_printed);
}

/// A post at the origin; the safety zone reaches 0.5 from it.
InflatedSpace post() {
  return InflatedSpace::build(
             {.bounds = {{-9, -9}, {9, 9}}, .safety_radius = 0.5, .obstacles = {Disc{{0, 0}, 0}}})
      .value();
}

/// The only arc of a curve.
const QuadraticBezier& only_arc(const Curve& curve) {
  REQUIRE(curve.pieces().size() == 1);
  const auto* arc = curve.pieces()[0].get_if<QuadraticBezier>();
  REQUIRE(arc != nullptr);
  return *arc;
}

TEST_CASE("the two steps around a trigger become one arc, pushed out only as far as it must be") {
  const auto space = post();
  // The path turns at (0, 0.8), 0.3 from the zone: farther than the first offset, so that the
  // control point stays there.
  const Point wide[] = {{-1, 0.4}, {0, 0.8}, {1, 0.4}};
  const Curve free = as_printed.smooth(space, Curve::polyline(wide), Budget{}).value();
  CHECK(only_arc(free).points[1] == Point(0, 0.8));

  // Nearer, the first control point is 0.12 from the zone. The arc below it reaches into the zone
  // until the control point is at a third of a metre or more.
  const Point close[] = {{-1, 0.2}, {0, 0.6}, {1, 0.2}};
  const Curve pushed = as_printed.smooth(space, Curve::polyline(close), Budget{}).value();
  CHECK(only_arc(pushed).points[1].isApprox(Point(0, 0.5 + 0.36)));
}

TEST_CASE("where no push helps, the steps stay as they are") {
  const auto space = post();
  const Point close[] = {{-1, 0.2}, {0, 0.6}, {1, 0.2}};
  const DeltaSmoother timid{.arc_max_offset = 0.1, .join = DeltaSmoother::Join::paper};
  const auto kept = timid.smooth(space, Curve::polyline(close), Budget{}).value();
  CHECK(test::same_curve(kept, Curve::polyline(close)));
}

TEST_CASE("shortcuts stop one node before the last in sight, and before triggers") {
  const auto space =
      InflatedSpace::build(
          {.bounds = {{-9, -9}, {9, 9}}, .safety_radius = 0.5, .obstacles = {Disc{{0, 0}, 0.25}}})
          .value();
  const DeltaSmoother no_corners{.min_exterior_angle = 7,  // nothing turns that much
                                 .join = DeltaSmoother::Join::paper};
  std::vector<Point> nodes;
  for (int i = 0; i <= 8; ++i) nodes.emplace_back(-2 + 0.25 * i, 0.8);
  for (int i = 1; i <= 8; ++i) nodes.emplace_back(0.8, 0.8 - 0.25 * i);
  nodes[8] = {0.4, 0.8};
  const auto result = no_corners.smooth(space, Curve::polyline(nodes), Budget{}).value();
  std::size_t last = nodes.size() - 1;
  while (!space.segment_free(nodes[0], nodes[last])) --last;
  REQUIRE(last < nodes.size() - 1);
  CHECK(end_of(result.pieces()[0]) == nodes[last - 1]);

  const auto triggers = as_printed.smooth(space, Curve::polyline(nodes), Budget{}).value();
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
      // As in the paper, whose A* follows all steps from a node.
      const AStar search{.successors = AStar::Successors::all};
      const auto route = test::search_once(search, space, {.start = scene.start, .goal = goal});
      REQUIRE(route);
      check(space, route->curve);
    }
  }
}

/// What the DSP paper prints in its tables 1 to 3, in the order of the built-in maps.
constexpr double published_lengths[] = {9.6276,  16.1712, 19.1045, 21.9126, 10.8420, 13.0680,
                                        10.2972, 8.2404,  20.2123, 23.2800, 18.0898, 24.6513};
/// The sum over the published paths of 180 degrees per turning point less the interior angles.
constexpr double published_turning = 2801;

std::size_t count_arcs(const Curve& curve) {
  return static_cast<std::size_t>(
      std::count_if(curve.pieces().begin(), curve.pieces().end(),
                    [](const Piece& piece) { return piece.holds<QuadraticBezier>(); }));
}

TEST_CASE("the twelve published tasks: arcs as in the paper, lengths within one percent of it") {
  std::size_t arcs = 0, task = 0;
  double excess = 0;
  for_each_built_in_route([&](const LatticeSpace& space, const Curve& route) {
    const Curve curve = as_printed.smooth(space, route, {}).value();
    CHECK(curve.length() < 0.99 * route.length());
    CHECK(certify(space, curve).status == ProofStatus::proved);
    arcs += count_arcs(curve);
    excess += curve.length() / published_lengths[task++] - 1;
  });
  CHECK(arcs >= 30);
  CHECK(std::abs(excess / 12) < 0.01);
}

TEST_CASE("the twelve published tasks: the default is smooth, and shorter and gentler than they") {
  std::size_t arcs = 0, task = 0;
  double turning = 0;
  for_each_built_in_route([&](const LatticeSpace& space, const Curve& route) {
    const Curve curve = DeltaSmoother{}.smooth(space, route, {}).value();
    CHECK(curve.length() < published_lengths[task++]);
    CHECK(curve.length() < 0.99 * route.length());
    CHECK(test::largest_corner(curve) < 1e-6);
    CHECK(certify(space, curve).status == ProofStatus::proved);
    arcs += count_arcs(curve);
    turning += measure(curve).turning_angle * 180 / std::acos(-1);
  });
  CHECK(arcs >= 30);
  CHECK(turning < published_turning);
}

TEST_CASE("a path that passes a corner straight has no arc there") {
  const auto space = post();
  std::vector<Point> nodes;
  for (int i = 0; i <= 20; ++i) nodes.emplace_back(-2 + 0.2 * i, 0.6);
  const Curve straight = as_printed.smooth(space, Curve::polyline(nodes), {}).value();
  CHECK(straight.pieces().size() == 1);
  nodes.emplace_back(2.2, 0.4);  // a turn, far from the post
  CHECK(count_arcs(as_printed.smooth(space, Curve::polyline(nodes), {}).value()) == 0);
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
