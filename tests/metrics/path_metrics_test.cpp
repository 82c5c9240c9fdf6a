// SPDX-License-Identifier: MIT
#include "tutavia/metrics/path_metrics.hpp"

#include <cmath>
#include <numbers>

#include "support/catch.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;
using std::numbers::pi;

TEST_CASE("a staircase turns at every vertex, half a degree does not count") {
  const Point stairs[] = {{0, 0}, {1, 0}, {1, 1}, {2, 1}, {3, 1.001}};
  const PathMetrics m = measure(Curve::polyline(stairs));
  CHECK(m.turning_points == 2);
  CHECK(m.turning_angle == Approx(pi + std::atan(0.001)));
  CHECK(m.interior_angle_sum == Approx(pi));
  CHECK(m.length == Approx(3 + std::hypot(1, 0.001)));
  CHECK(m.max_curvature == 0);
  CHECK(m.max_joint_deflection == Approx(pi / 2));
}

TEST_CASE("a straight line and a single point do not turn") {
  const Point line[] = {{0, 0}, {1, 1}, {2, 2}, {2, 2}, {3, 3}};
  CHECK(measure(Curve::polyline(line)).turning_points == 0);
  CHECK(measure(Curve::polyline(line)).turning_angle == 0);
  CHECK(measure(Curve::polyline(line)).max_joint_deflection == 0);
  const Point point[] = {{4, 5}};
  CHECK(measure(Curve::polyline(point)).length == 0);
  CHECK(measure(Curve{}).turning_angle == 0);
}

TEST_CASE("an arc between two lines is one turn, joints included") {
  Curve curve;
  curve.push_back(Segment{{0, 0}, {1, 0}});
  curve.push_back(QuadraticBezier{{Point(1, 0), Point(2, 0.2), Point(2, 1)}});
  curve.push_back(Segment{{2, 1}, {2, 3}});
  const PathMetrics m = measure(curve);
  CHECK(m.turning_points == 1);
  CHECK(m.turning_angle == Approx(pi / 2));
  CHECK(m.interior_angle_sum == Approx(pi / 2));
  CHECK(m.max_joint_deflection == Approx(std::atan(0.2)));
}

TEST_CASE("the largest turn at a joint counts neither side nor what happens within pieces") {
  Curve smooth;
  smooth.push_back(Segment{{0, 0}, {1, 0}});
  smooth.push_back(QuadraticBezier{{Point(1, 0), Point(2, 0), Point(2, 1)}});
  smooth.push_back(Segment{{2, 1}, {2, 3}});
  CHECK(measure(smooth).max_joint_deflection == 0);
  smooth.push_back(Segment{{2, 3}, {2, 3}});  // a single point has no direction
  smooth.push_back(Segment{{2, 3}, {3, 4}});
  CHECK(measure(smooth).max_joint_deflection == Approx(pi / 4));
  smooth.push_back(Segment{{3, 4}, {4, 4}});
  smooth.push_back(Segment{{4, 4}, {3, 4}});
  CHECK(measure(smooth).max_joint_deflection == pi);
  CHECK(measure(Curve{}).max_joint_deflection == 0);
}

TEST_CASE("the jump of the curvature at a joint is 0 where curvature is continuous") {
  const Clothoid in = Clothoid::from({0, 0}, 0, 0, 0.5, 2);
  Curve curve;
  curve.push_back(Segment{{-1, 0}, {0, 0}});
  curve.push_back(in);
  const Arc arc = Arc::around(in.b + Point(-std::sin(1), std::cos(1)), 1, 1 - pi / 2, 0.5);
  Arc joined = arc;
  joined.a = in.b;
  curve.push_back(joined);
  CHECK(measure(curve).max_curvature_jump < 1e-12);
  CHECK(measure(curve).max_joint_deflection < 1e-12);
  const Point ahead = joined.b + 0.3 * Point(std::cos(1.5), std::sin(1.5));
  curve.push_back(Segment{joined.b, ahead});
  CHECK(measure(curve).max_curvature_jump == Approx(1));
  CHECK(measure(curve).turning_points == 1);
  CHECK(measure(curve).turning_angle == Approx(1.5));
}

TEST_CASE("turns in opposite directions count apart") {
  Curve curve;
  curve.push_back(CubicBezier{{Point(0, 0), Point(1, 2), Point(2, -2), Point(3, 0)}});
  const PathMetrics m = measure(curve);
  // Out at 63.4 degrees, down to -45 at the inflection, back up to 63.4.
  CHECK(m.turning_points == 2);
  CHECK(m.turning_angle == Approx(2 * (std::atan(2.0) + pi / 4)).epsilon(1e-6));
}

TEST_CASE("a turn goes on over a joint that is smooth up to rounding") {
  const auto turning_points = [](double deflection) {
    const double heading = pi / 4 + deflection;
    const Point middle{1.5, 0.5}, ahead{std::cos(heading), std::sin(heading)};
    Curve curve;
    curve.push_back(QuadraticBezier{{Point(0, 0), Point(1, 0), middle}});
    curve.push_back(QuadraticBezier{{middle, middle + ahead, Point(1.5, 3)}});
    return measure(curve).turning_points;
  };
  CHECK(turning_points(1e-13) == 1);
  CHECK(turning_points(-1e-13) == 1);
  CHECK(turning_points(-1e-3) == 2);
}

TEST_CASE("turning and curvature agree with dense sampling, forwards and backwards") {
  const std::uint64_t seed = 6;
  Random random(seed);
  for (int round = 0; round < 200; ++round) {
    INFO("seed " << seed << ", round " << round);
    std::array<Point, 4> p;
    for (Point& q : p) q = {random.uniform(0, 4), random.uniform(0, 4)};
    Curve forwards, backwards;
    if (round % 3 == 0) {
      forwards.push_back(CubicBezier{p});
      backwards.push_back(CubicBezier{{p[3], p[2], p[1], p[0]}});
    } else if (round % 3 == 1) {
      const Clothoid clothoid =
          Clothoid::from(p[0], p[1].x(), p[1].y() - 2, p[2].x() - 2, p[2].y());
      forwards.push_back(clothoid);
      backwards.push_back(clothoid.reversed());
    } else {
      forwards.push_back(QuadraticBezier{{p[0], p[1], p[2]}});
      backwards.push_back(QuadraticBezier{{p[2], p[1], p[0]}});
    }
    double turning = 0, curvature = 0;
    const int samples = 200000;
    forwards.pieces()[0].visit([&](const auto& piece) {
      Point before = piece.derivative(0);
      curvature = std::abs(tutavia::curvature(piece, 0));
      for (int i = 1; i <= samples; ++i) {
        const double t = static_cast<double>(i) / samples;
        const Point after = piece.derivative(t);
        turning += std::abs(turn_angle(before, after));
        curvature = std::max(curvature, std::abs(tutavia::curvature(piece, t)));
        before = after;
      }
    });
    const PathMetrics m = measure(forwards), reversed = measure(backwards);
    CHECK(m.turning_angle == Approx(turning).epsilon(1e-6));
    CHECK(reversed.turning_angle == Approx(m.turning_angle).epsilon(1e-9));
    CHECK(reversed.length == Approx(m.length).epsilon(1e-10));
    CHECK(m.max_curvature >= curvature * (1 - 1e-9));
    CHECK(m.max_curvature == Approx(curvature).epsilon(1e-4));
    CHECK(reversed.max_curvature == Approx(m.max_curvature).epsilon(1e-6));
  }
}

TEST_CASE("the mean clearance is taken over arc length, the least from the certificate") {
  const auto space = InflatedSpace::build({.bounds = {{0, 0}, {10, 10}},
                                           .safety_radius = 0.5,
                                           .obstacles = {Polygon{{{0, 0}, {10, 0}}}}})
                         .value();
  const Point line[] = {{1, 1}, {9, 3}};
  const Curve curve = Curve::polyline(line);
  const PathMetrics m = measure(curve, certify(space, curve));
  CHECK(detail::mean_clearance(space, curve) == Approx(2));
  CHECK(m.min_clearance <= 1);
  CHECK(m.min_clearance >= 1 - 1e-6);
}

}  // namespace
