// SPDX-License-Identifier: MIT
#include "tutavia/smooth/spline/corner_spline.hpp"

#include <cmath>
#include <vector>

#include "support/catch.hpp"
#include "support/random_tasks.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

InflatedSpace field_with(std::vector<Obstacle> obstacles) {
  return InflatedSpace::build({.bounds = {{-50, -50}, {50, 50}},
                               .safety_radius = 0.5,
                               .obstacles = std::move(obstacles)})
      .value();
}

/// Jumps of the curvature where two pieces meet.
double largest_jump(const Curve& curve) {
  double largest = 0;
  for (std::size_t i = 0; i + 1 < curve.pieces().size(); ++i) {
    const auto at = [&](std::size_t piece, double t) {
      return curve.pieces()[piece].visit([&](const auto& p) { return curvature(p, t); });
    };
    largest = std::fmax(largest, std::abs(at(i, 1) - at(i + 1, 0)));
  }
  return largest;
}

const std::vector<Point> hook{{0, 0}, {6, 0}, {8, 5}, {14, 5}, {14, 0}};

TEST_CASE("in the open the spline has continuous curvature, and helpers hold it to the legs") {
  const auto space = field_with({});
  double shortest = 0;
  for (const double reach : {2.0, 1.0, 0.5, 0.1}) {
    const Curve curve = CornerSpline(hook, reach).prove(space, {}).value();
    CHECK(curve.start() == hook.front());
    CHECK(curve.end() == hook.back());
    CHECK(test::largest_corner(curve) < 1e-9);
    CHECK(largest_jump(curve) < 1e-9 / reach);
    CHECK(curve.length() > shortest);  // the tighter, the longer
    shortest = curve.length();
    CHECK(curve.pieces().front().holds<Segment>());
    CHECK(curve.pieces().back().holds<Segment>());
  }
  CHECK(shortest < Curve::polyline(hook).length());
  const Curve free = CornerSpline(hook, CornerSpline::no_auxiliary_points).prove(space, {}).value();
  CHECK(free.length() < CornerSpline(hook, 2).prove(space, {}).value().length());
  CHECK(free.pieces().size() == 2);  // five control points
  CHECK(largest_jump(free) < 1e-9);
}

TEST_CASE("only corners that obstacles ask for are drawn tighter, down to the corner itself") {
  const std::vector<Point> path{{0, 0}, {10, 0}, {10, 10}, {20, 10}};
  // Close to the inner side of the first corner; the second has all the room it wants.
  const auto near = field_with({Disc{{9.35, 0.65}, 0.1}});
  const Curve tight = CornerSpline(path, 3).prove(near, {}).value();
  CHECK(certify(near, tight).status == ProofStatus::proved);
  CHECK(test::largest_corner(tight) < 1e-9);
  const Curve open = CornerSpline(path, 3).prove(field_with({}), {}).value();
  CHECK(tight.length() > open.length());
  CHECK(tight.nearest({10, 10}).distance == Approx(open.nearest({10, 10}).distance));
  CHECK(tight.nearest({10, 0}).distance < 0.5 * open.nearest({10, 0}).distance);

  // Nothing fits: the corner stays, and both legs meet in it.
  const auto touching = field_with({Disc{{9.5 - 1e-9, 0.5 + 1e-9}, 0}});
  const Curve corner = CornerSpline(path, 3).prove(touching, {}).value();
  CHECK(corner.nearest({10, 0}).distance == 0);
  CHECK(test::largest_corner(corner) > 1.5);
  CHECK(end_of(corner.pieces().front()) == Point(10, 0));
}

TEST_CASE("a spline that fits nowhere is the polyline") {
  const std::vector<Point> path{{0, 0}, {10, 0}, {10, 10}};
  const double side = 9.5 - 1e-9;
  const auto touching = field_with({Polygon{{{-5, 10 - side}, {side, 10 - side}, {side, 30}}}});
  for (const double reach : {1.0, CornerSpline::no_auxiliary_points}) {
    const Curve curve = CornerSpline(path, reach).prove(touching, {}).value();
    CHECK(waypoints(curve) == path);
  }
}

TEST_CASE("few, equal, collinear and returning waypoints do no harm") {
  const auto space = field_with({});
  for (const double reach : {1.0, CornerSpline::no_auxiliary_points}) {
    CHECK(CornerSpline({{1, 2}}, reach).prove(space, {}).value().length() == 0);
    CHECK(CornerSpline({{1, 2}, {1, 2}}, reach).prove(space, {}).value().length() == 0);
    CHECK(CornerSpline({{0, 0}, {3, 4}}, reach).prove(space, {}).value().length() == 5);
    const Curve three = CornerSpline({{0, 0}, {4, 0}, {4, 4}}, reach).prove(space, {}).value();
    CHECK(three.length() < 8);
    CHECK(test::largest_corner(three) < 1e-9);
    const Curve line =
        CornerSpline({{0, 0}, {1, 0}, {1, 0}, {5, 0}, {6, 0}}, reach).prove(space, {}).value();
    CHECK(line.length() == Approx(6));
    const Curve back = CornerSpline({{0, 0}, {4, 0}, {1, 0}}, reach).prove(space, {}).value();
    CHECK(back.end() == Point(1, 0));
    CHECK(back.length() <= 7);
    CHECK(certify(space, back).status == ProofStatus::proved);
  }
}

}  // namespace
