// SPDX-License-Identifier: MIT
#include "tutavia/motion/speed_profile.hpp"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <numbers>
#include <vector>

#include "support/catch.hpp"
#include "support/random_tasks.hpp"
#include "support/scale.hpp"
#include "tutavia/pull/taut_string.hpp"
#include "tutavia/smooth/b_spline_smoother.hpp"
#include "tutavia/smooth/clothoid_smoother.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;
using std::numbers::pi;

Curve line(double length) {
  const Point points[] = {{1, 1}, {1 + length, 1}};
  return Curve::polyline(points);
}

TEST_CASE("a straight line is accelerating, cruising and braking, in closed form") {
  const SpeedLimits limits{.speed = 2, .acceleration = 1, .braking = 0.5};
  // 2 m and 2 s up to speed, 4 m and 4 s down.
  const auto profile = SpeedProfile::build(line(10), limits).value();
  CHECK(profile.duration() == Approx(2 + 2 + 4));
  CHECK(profile.at(1).speed == Approx(1));
  CHECK(profile.at(1).s == Approx(0.5));
  CHECK(profile.at(3).speed == Approx(2));
  CHECK(profile.at(6).speed == Approx(1));
  CHECK(profile.at(6).acceleration == Approx(-0.5));
  CHECK(profile.at(99).position.isApprox(Point(11, 1)));
  CHECK(profile.at(99).speed == Approx(0).margin(1e-12));
  CHECK(profile.at(-1).position == Point(1, 1));

  // Too short for full speed: a third of the way up, two thirds down.
  const auto dash = SpeedProfile::build(line(1.5), limits).value();
  CHECK(dash.duration() == Approx(3));
  CHECK(dash.at(1).s == Approx(0.5));

  // Rolling through.
  const auto roll = SpeedProfile::build(
      line(10), {.speed = 2, .acceleration = 1, .braking = 0.5, .start_speed = 2, .end_speed = 2});
  CHECK(roll->duration() == Approx(5));
  CHECK(SpeedProfile::build(line(0), limits)->duration() == 0);
}

TEST_CASE("bends are taken at the speed that the lateral limit allows, corners from a stop") {
  Curve curve;
  curve.push_back(Segment{{0, 0}, {9, 0}});
  curve.push_back(Arc::around({9, 2}, 2, -pi / 2, pi));
  curve.push_back(Segment{curve.end(), {0, 4}});
  const SpeedLimits limits{.speed = 3, .acceleration = 1, .braking = 1, .lateral = 0.5};
  const auto profile = SpeedProfile::build(curve, limits).value();
  const double middle = profile.duration() / 2;
  CHECK(profile.at(middle).speed == Approx(1));  // 1^2 / 2 = 0.5
  CHECK(profile.at(middle).curvature == Approx(0.5));

  const Point corner[] = {{0, 0}, {2, 0}, {2, 2}};
  const auto stops = SpeedProfile::build(Curve::polyline(corner), limits).value();
  CHECK(stops.duration() == Approx(2 * SpeedProfile::build(line(2), limits)->duration()));
  CHECK(stops.at(stops.duration() / 2).speed == Approx(0).margin(1e-9));
}

/// Checks all limits at many times, and that they are made use of.
void check_limits(const SpeedProfile& profile, const SpeedLimits& limits, Random& random) {
  const double tolerance = 1 + 1e-9;
  for (int i = 0; i < 300; ++i) {
    const TimedPoint p = profile.at(random.uniform(0, profile.duration()));
    CHECK(p.speed <= limits.speed * tolerance);
    CHECK(p.acceleration <= limits.acceleration);
    CHECK(p.acceleration >= -limits.braking);
    CHECK(p.speed * p.speed * std::abs(p.curvature) <= limits.lateral * tolerance);
  }
  // Places and speeds belong together: what is driven is the length of the curve.
  double driven = 0;
  const auto states = profile.sample(profile.duration() / 2000);
  for (std::size_t i = 1; i < states.size(); ++i) {
    driven += 0.5 * (states[i].speed + states[i - 1].speed) * (states[i].time - states[i - 1].time);
    CHECK(states[i].s >= states[i - 1].s);
  }
  CHECK(driven == Approx(profile.curve().length()).epsilon(1e-3));
  CHECK(states.back().s == Approx(profile.curve().length()));
  CHECK(states.back().speed <= limits.end_speed + 1e-6);
}

TEST_CASE("the limits hold everywhere on curves of all kinds; smooth curves are faster", "[soak]") {
  const std::uint64_t seed = 600;
  test::WorldGenerator worlds(seed);
  Random& random = worlds.random();
  std::size_t profiles = 0;
  double stopping = 0, tangent = 0, continuous = 0, spline = 0;
  for (std::size_t round = 0; round < test::scaled(60); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto task = test::random_task(worlds);
    if (!task) continue;
    const auto space = InflatedSpace::build(task->world).value();
    const Curve route = Curve::polyline(task->route);
    const SpeedLimits limits{.speed = random.uniform(0.2, 3),
                             .acceleration = random.uniform(0.1, 2),
                             .braking = random.uniform(0.1, 2),
                             .lateral = random.uniform(0.1, 2)};
    const Curve string = TautString{}.smooth(space, route, {}).value();
    const Curve rounded =
        BSplineSmoother{.reach = task->world.bounds.width() / 20}.smooth(space, route, {}).value();
    const Curve spirals = ClothoidSmoother{}.smooth(space, string, {}).value();
    double* const sums[] = {&stopping, &tangent, &continuous, &spline};
    const Curve* const curves[] = {&route, &string, &spirals, &rounded};
    for (int k = 0; k < 4; ++k) {
      const auto profile = SpeedProfile::build(*curves[k], limits);
      REQUIRE(profile);
      if (profile->duration() == 0) continue;
      ++profiles;
      *sums[k] += profile->duration();
      check_limits(*profile, limits, random);
    }
  }
  std::printf(
      "%zu profiles; routes with stops %.1f s, taut strings %.1f s, paths of continuous curvature "
      "%.1f s, B-splines %.1f s\n",
      profiles, stopping, tangent, continuous, spline);
  CHECK(profiles > test::scaled(60));
  CHECK(tangent < stopping);
  CHECK(spline < stopping);
}

TEST_CASE("limits out of range are refused by name, and what cannot be followed") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refusal = [](const SpeedLimits& limits) {
    const auto result = SpeedProfile::build(line(1), limits);
    REQUIRE_FALSE(result);
    CHECK(result.error().code == PlanError::invalid_option);
    return result.error().detail;
  };
  CHECK(refusal({.speed = 0}).find("speed ") == 0);
  CHECK(refusal({.acceleration = nan}).find("acceleration ") == 0);
  CHECK(refusal({.braking = -1}).find("braking ") == 0);
  CHECK(refusal({.lateral = std::numeric_limits<double>::infinity()}).find("lateral ") == 0);
  CHECK(refusal({.start_speed = 2}).find("start_speed ") == 0);
  CHECK(refusal({.end_speed = nan}).find("end_speed ") == 0);
  // From 1 m/s it takes 1 m to stop at 0.5 m/s^2.
  CHECK(SpeedProfile::build(line(1), {.start_speed = 1}));
  CHECK(refusal({.braking = 0.4, .start_speed = 1}).find("start_speed ") == 0);
  CHECK(SpeedProfile::build(Curve{}, {}).error().code == PlanError::invalid_input);
  Curve cusp;
  cusp.push_back(CubicBezier{{Point(0, 0), Point(1, 1), Point(0, 1), Point(1, 0)}});
  CHECK(SpeedProfile::build(cusp, {}).error().code == PlanError::invalid_input);
}

}  // namespace
