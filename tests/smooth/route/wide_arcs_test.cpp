// SPDX-License-Identifier: MIT
#include "tutavia/smooth/route/wide_arcs.hpp"

#include <cmath>
#include <stop_token>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/random_tasks.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/metrics/path_metrics.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

/// Discs at safety radius 0.5.
InflatedSpace discs(const std::vector<Disc>& discs) {
  Workspace workspace{.bounds = {{-20, -20}, {20, 20}}, .safety_radius = 0.5, .obstacles = {}};
  for (const Disc& disc : discs) workspace.obstacles.emplace_back(disc);
  return InflatedSpace::build(workspace).value();
}

Curve wide_arcs(const InflatedSpace& space, std::vector<ArcVertex> path) {
  const Curve curve = WideArcs(space, std::move(path)).curve({}).value();
  CHECK(certify(space, curve).status == ProofStatus::proved);
  return curve;
}

std::vector<QuadraticBezier> arcs_of(const Curve& curve) {
  std::vector<QuadraticBezier> arcs;
  for (const Piece& piece : curve.pieces()) {
    if (const auto* arc = piece.get_if<QuadraticBezier>()) arcs.push_back(*arc);
  }
  return arcs;
}

/// A vertex that only goes where arcs stay as wide.
ArcVertex fixed(const Point& p) { return {p, {0, 1}, 0}; }

TEST_CASE("one arc takes as much of the shorter leg as there is") {
  const auto space = discs({{{0, -4}, 1}});
  const Curve curve = wide_arcs(space, {{{-4, -4}}, fixed({0, 0}), {{6, -6}}});
  const auto arcs = arcs_of(curve);
  REQUIRE(arcs.size() == 1);
  CHECK(distance(arcs[0].start(), arcs[0].points[1]) ==
        Approx(distance(arcs[0].end(), arcs[0].points[1])));
  CHECK(arcs[0].start() == Point(-4, -4));  // the whole leg
  CHECK(test::largest_corner(curve) < 1e-9);
}

TEST_CASE("an obstacle in the bend makes its arc smaller, one at the vertex stops it") {
  // The arc of reach t around (0, 0) has its apex at (0, -t / sqrt(8)).
  const auto space = discs({{{0, -2}, 0.5}, {{0, -4}, 0.5}});
  const auto arcs = arcs_of(wide_arcs(space, {{{-4, -4}}, fixed({0, 0}), {{4, -4}}}));
  REQUIRE(arcs.size() == 1);
  const double reach = distance(arcs[0].start(), arcs[0].points[1]);
  CHECK(reach < std::sqrt(8.0));
  CHECK(reach > 0.97 * std::sqrt(8.0));

  const auto wedge = InflatedSpace::build({.bounds = {{-5, -5}, {5, 5}},
                                           .safety_radius = 0,
                                           .obstacles = {Polygon{{{0, 0}, {-4, -4}, {4, -4}}}}})
                         .value();
  CHECK(arcs_of(wide_arcs(wedge, {{{-4, -4}}, fixed({0, 0}), {{4, -4}}})).empty());
}

TEST_CASE("neighbouring arcs share a leg, and one takes what the other leaves") {
  // The last disc keeps the second arc small, so that the first takes more than half of the leg.
  const auto space = discs({{{-3, 0}, 0.5}, {{0, -2.5}, 0.5}, {{0.8, -0.5}, 0.5}});
  const Curve curve = wide_arcs(space, {{{-8, 0}}, fixed({-2, 3}), fixed({2, 0}), {{2, -8}}});
  const auto arcs = arcs_of(curve);
  REQUIRE(arcs.size() == 2);
  const double leg = distance(arcs[0].points[1], arcs[1].points[1]);
  CHECK(distance(arcs[1].points[1], arcs[1].start()) < 0.45 * leg);
  CHECK(distance(arcs[0].points[1], arcs[0].end()) > 0.55 * leg);
  CHECK(test::largest_corner(curve) < 1e-9);
}

TEST_CASE("vertices move outward within their room where that makes the arc wider") {
  const auto space = discs({{{0, -1.2}, 0.4}, {{0, -3}, 0.4}});
  const std::vector<ArcVertex> held{{{-4, -3}}, {{0, 0}, {0, 1}, 0}, {{4, -3}}};
  const std::vector<ArcVertex> free{{{-4, -3}}, {{0, 0}, {0, 1}, 0.6}, {{4, -3}}};
  const Curve tight = wide_arcs(space, held), wide = wide_arcs(space, free);
  CHECK(measure(wide).max_curvature < 0.5 * measure(tight).max_curvature);
  const auto arcs = arcs_of(wide);
  REQUIRE(arcs.size() == 1);
  CHECK(arcs[0].points[1].y() > 0);
  CHECK(arcs[0].points[1].y() <= 0.6);
}

TEST_CASE("vertices that are not needed are dropped, those at corners unless arcs become sharper") {
  const auto space = discs({});
  const Curve line = wide_arcs(space, {{{0, 0}}, {{1, 1}}, {{2, 0}}});
  CHECK(test::same_curve(line, Curve::polyline(std::vector<Point>{{0, 0}, {2, 0}})));
  // Without either of the two vertices close together the other one's arc is wider.
  const Curve fewer = wide_arcs(space, {{{0, 0}}, fixed({4, 0}), fixed({4.1, 0.1}), {{4.1, 4}}});
  CHECK(arcs_of(fewer).size() <= 1);
}

TEST_CASE("degenerate polylines: one point, repeated points, straight on and straight back") {
  const auto space = discs({{{0, 0.6}, 0.1}});
  const auto is_line = [&](std::vector<ArcVertex> path, std::vector<Point> line) {
    CHECK(test::same_curve(wide_arcs(space, std::move(path)), Curve::polyline(line)));
  };
  is_line({{{1, -1}}}, {{1, -1}});
  is_line({{{1, -1}}, {{1, -1}}}, {{1, -1}});
  is_line({{{0, -1}}, fixed({1, -1}), fixed({1, -1}), {{3, -1}}}, {{0, -1}, {3, -1}});
  is_line({{{0, -1}}, fixed({3, -1}), {{0, -1}}}, {{0, -1}});
}

TEST_CASE("a cancelled budget stops the work") {
  const auto space = discs({});
  std::vector<ArcVertex> path{{{0, 0}}, fixed({4, 0}), {{4, 4}}};
  std::stop_source stop;
  stop.request_stop();
  const auto curve = WideArcs(space, path).curve({.stop = stop.get_token()});
  REQUIRE_FALSE(curve);
  CHECK(curve.error().code == PlanError::cancelled);
}

}  // namespace
