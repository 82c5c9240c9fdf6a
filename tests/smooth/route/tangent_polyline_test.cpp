// SPDX-License-Identifier: MIT
#include "tutavia/smooth/route/tangent_polyline.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "support/catch.hpp"
#include "tutavia/geometry/bezier.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/tangent_graph.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "tutavia/smooth/taut_string.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/space/lattice_space.hpp"

namespace {

using namespace tutavia;

InflatedSpace around_a_disc(std::vector<Obstacle> others = {}) {
  others.emplace_back(Disc{{5, 5}, 1});
  return InflatedSpace::build(
             {.bounds = {{0, 0}, {10, 10}}, .safety_radius = 1, .obstacles = std::move(others)})
      .value();
}

/// Half a circle below the disc, from left to right.
Curve half_circle(double radius) {
  Curve curve;
  curve.push_back(Arc::around({5, 5}, radius, std::numbers::pi, std::numbers::pi));
  return curve;
}

TEST_CASE("tangents stand outside an arc and join its ends") {
  const auto points = detail::tangent_polyline(around_a_disc(), half_circle(2.001));
  REQUIRE(points);
  CHECK(points->size() == 1 + 4 + 1);
  CHECK(points->front() == half_circle(2.001).start());
  CHECK(points->back() == half_circle(2.001).end());
  for (std::size_t i = 1; i < points->size(); ++i) {
    const Segment leg{(*points)[i - 1], (*points)[i]};
    CHECK(distance(Point(5, 5), leg) == Approx(2.001));
  }
}

TEST_CASE("where there is little room there are more tangents, and none where there is no room") {
  // A post beside the arc, in a direction in which the tangents meet.
  const auto with_post = [](double turn, double room) {
    const double angle = std::numbers::pi + turn, reach = 2.001 + 1 + room;
    return around_a_disc({Disc{{5 + reach * std::cos(angle), 5 + reach * std::sin(angle)}, 0}});
  };
  const double eighth = std::numbers::pi / 8;
  CHECK(detail::tangent_polyline(with_post(eighth, 0.2), half_circle(2.001))->size() == 1 + 4 + 1);
  CHECK(detail::tangent_polyline(with_post(eighth, 0.02), half_circle(2.001))->size() == 1 + 8 + 1);
  const double finest = 101 * std::numbers::pi / 512;
  CHECK_FALSE(detail::tangent_polyline(with_post(finest, 1e-9), half_circle(2.001)));
}

TEST_CASE("a curve with a Bezier piece has no tangents") {
  Curve curve;
  curve.push_back(QuadraticBezier{{Point(1, 1), Point(2, 1), Point(3, 1)}});
  CHECK_FALSE(detail::tangent_polyline(around_a_disc(), curve));
}

TEST_CASE("smoothers of polylines smooth the paths of the tangent graph") {
  const auto space = LatticeSpace::build(around_a_disc().workspace(), {.resolution = 0.25}).value();
  const Query query{.start = {1, 4.5}, .goal = {9, 5}};
  const auto taut = Planner(TangentGraph{}, TautString{}).plan(space, query).value();
  CHECK_FALSE(taut.fell_back);
  CHECK(taut.metrics.length == Approx(taut.route.cost).epsilon(1e-9));
  CHECK_FALSE(Planner(TangentGraph{}, DeltaSmoother{}).plan(space, query).value().fell_back);
}

}  // namespace
