// SPDX-License-Identifier: MIT
#include "tutavia/motion/speed_profile.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/random_tasks.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "tutavia/geometry/continuous_drives.hpp"
#include "tutavia/geometry/dubins.hpp"
#include "tutavia/geometry/reeds_shepp.hpp"
#include "tutavia/smooth/b_spline_smoother.hpp"
#include "tutavia/smooth/bezier_smoother.hpp"
#include "tutavia/smooth/clothoid_smoother.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "tutavia/smooth/taut_string.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;
using std::numbers::pi;

Curve line(double length) {
  const Point points[] = {{1, 1}, {1 + length, 1}};
  return Curve::polyline(points);
}

TEST_CASE("a straight line is accelerating, cruising and braking, in closed form") {
  const SpeedLimits limits{.max_speed = 2, .max_acceleration = 1, .max_deceleration = 0.5};
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
  const auto roll = SpeedProfile::build(line(10), {.max_speed = 2,
                                                   .max_acceleration = 1,
                                                   .max_deceleration = 0.5,
                                                   .start_speed = 2,
                                                   .end_speed = 2});
  CHECK(roll->duration() == Approx(5));
  CHECK(SpeedProfile::build(line(0), limits)->duration() == 0);
}

TEST_CASE("bends are taken at the speed that the lateral limit allows, corners from a stop") {
  Curve curve;
  curve.push_back(Segment{{0, 0}, {9, 0}});
  curve.push_back(Arc::around({9, 2}, 2, -pi / 2, pi));
  curve.push_back(Segment{curve.end(), {0, 4}});
  const SpeedLimits limits{.max_speed = 3,
                           .max_acceleration = 1,
                           .max_deceleration = 1,
                           .max_lateral_acceleration = 0.5};
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
    const SpeedProfile::State p = profile.at(random.uniform(0, profile.duration()));
    CHECK(p.speed <= limits.max_speed * tolerance);
    CHECK(p.acceleration <= limits.max_acceleration);
    CHECK(p.acceleration >= -limits.max_deceleration);
    CHECK(p.speed * p.speed * std::abs(p.curvature) <= limits.max_lateral_acceleration * tolerance);
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
    const SpeedLimits limits{.max_speed = random.uniform(0.2, 3),
                             .max_acceleration = random.uniform(0.1, 2),
                             .max_deceleration = random.uniform(0.1, 2),
                             .max_lateral_acceleration = random.uniform(0.1, 2)};
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
  INFO(profiles << " profiles; routes with stops " << stopping << " s, taut strings " << tangent
                << " s, paths of continuous curvature " << continuous << " s, B-splines " << spline
                << " s");
  CHECK(profiles > test::scaled(60));
  CHECK(tangent < stopping);
  CHECK(spline < stopping);
}

/// What one profile uses of its limits at most, over many random times.
struct Use {
  double speed = 0, lateral = 0, along = 0, jerk = 0;  // of each limit
  double change_of_place = 0, change_of_speed = 0;     // of what their rates allow
};

Use use_of(const SpeedProfile& profile, const SpeedLimits& limits, Random& random, int times) {
  const double duration = profile.duration(), infinity = std::numeric_limits<double>::infinity();
  const double rate = limits.max_acceleration + limits.max_deceleration;
  const double rounding =
      1e-13 * (1 + profile.curve().length() + duration) + 1e-15 * profile.curve().start().norm();
  Use use;
  const auto raise = [](double& most, double value) { most = std::max(most, value); };
  for (int i = 0; i < times; ++i) {
    const SpeedProfile::State p = profile.at(random.uniform(0, duration));
    raise(use.speed, p.speed < 0 ? infinity : p.speed / limits.max_speed);
    raise(use.lateral, p.speed * p.speed * std::abs(p.curvature) / limits.max_lateral_acceleration);
    raise(use.along, p.acceleration / limits.max_acceleration);
    raise(use.along, -p.acceleration / limits.max_deceleration);
    // A while later, as long as a step of a simulation or much shorter.
    const double later =
        std::min(p.time + duration * std::pow(10, random.uniform(-7, -2)), duration);
    const SpeedProfile::State q = profile.at(later);
    const double t = q.time - p.time;
    if (!(t > 0)) continue;
    const double place_error = std::abs(q.s - p.s - 0.5 * t * (p.speed + q.speed));
    const double speed_error =
        std::abs(q.speed - p.speed - 0.5 * t * (p.acceleration + q.acceleration));
    if (std::isinf(limits.max_jerk)) {  // a trapezoid's error, by how fast what it sums up changes
      raise(use.change_of_place, place_error / (rate * t * t / 8 + rounding));
      raise(use.change_of_speed, std::abs(q.speed - p.speed) / (rate * t + rounding));
    } else {
      const double change = std::abs(q.acceleration - p.acceleration);
      raise(use.jerk, change / (limits.max_jerk * t + 1e-9 * rate));
      raise(use.change_of_place, place_error / (limits.max_jerk * t * t * t / 12 + rounding));
      raise(use.change_of_speed, speed_error / (limits.max_jerk * t * t / 4 + rounding));
    }
  }
  return use;
}

void check_profile(const SpeedProfile& profile, const SpeedLimits& limits, Random& random,
                   int times) {
  const double tolerance = 1 + 1e-9;
  REQUIRE(std::isfinite(profile.duration()));
  const Use use = use_of(profile, limits, random, times);
  CHECK(use.speed <= tolerance);
  CHECK(use.lateral <= tolerance);
  CHECK(use.along <= tolerance);
  CHECK(use.jerk <= tolerance);
  CHECK(use.change_of_place <= tolerance);
  CHECK(use.change_of_speed <= tolerance);

  const SpeedProfile::State first = profile.at(0), last = profile.at(profile.duration());
  CHECK(first.s == 0);
  CHECK(first.position == profile.curve().start());
  CHECK(first.speed == Approx(limits.start_speed).epsilon(1e-12).margin(1e-15));
  CHECK(last.s == profile.curve().length());
  CHECK(last.position == profile.curve().end());
  CHECK(last.speed <= limits.end_speed * tolerance + 1e-9);
  if (std::isfinite(limits.max_jerk)) {
    CHECK(first.acceleration == 0);
    CHECK(last.acceleration == Approx(0).margin(1e-9));
  }
  // What is left at the very end is no more than rounding.
  const SpeedProfile::State almost = profile.at(profile.duration() * (1 - 1e-12));
  CHECK(almost.s == Approx(last.s).epsilon(1e-9));
}

/// Six arcs that continue each other without a corner.
Curve chain_of_arcs(Random& random) {
  Curve arcs;
  for (int i = 0; i < 6; ++i) {
    const Point at = arcs.empty() ? Point(1, 1) : arcs.end();
    const double before = arcs.empty() ? 0 : arcs.heading(arcs.length());
    const double radius = random.uniform(0.1, 3), sweep = random.uniform(-3, 3);
    const double out = before + (sweep > 0 ? -pi / 2 : pi / 2);  // from the centre
    const Point centre = at - radius * Point(std::cos(out), std::sin(out));
    Arc arc = Arc::around(centre, radius, out, sweep);
    arc.a = at;
    arcs.push_back(arc);
  }
  return arcs;
}

/// A route, what smoothers make of it, and arcs.
std::vector<Curve> curves_of_all_kinds(const InflatedSpace& space, const Curve& route,
                                       Random& random) {
  const double size = space.bounds().width();
  return {route,
          TautString{}.smooth(space, route, {}).value(),
          BezierSmoother{}.smooth(space, route, {}).value(),
          DeltaSmoother{}.smooth(space, route, {}).value(),
          BSplineSmoother{.reach = size / 20}.smooth(space, route, {}).value(),
          chain_of_arcs(random)};
}

TEST_CASE("profiles of curves of every kind keep all limits at any time, with and without jerk",
          "[soak]") {
  const std::uint64_t seed = 620;
  test::WorldGenerator worlds(seed);
  Random& random = worlds.random();
  std::size_t profiles = 0, refused = 0;
  std::vector<double> with_jerk(6, 0.0), without(6, 0.0);
  for (std::size_t round = 0; round < test::scaled(20); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto task = test::random_task(worlds);
    if (!task) continue;
    const auto space = InflatedSpace::build(task->world).value();
    const Curve route = Curve::polyline(task->route);
    if (!(route.length() > 0)) continue;
    const std::vector<Curve> curves = curves_of_all_kinds(space, route, random);
    SpeedLimits limits{.max_speed = random.uniform(0.2, 3),
                       .max_acceleration = random.uniform(0.1, 2),
                       .max_deceleration = random.uniform(0.1, 2),
                       .max_lateral_acceleration = random.uniform(0.1, 2)};
    const double jerk = std::pow(10, random.uniform(-1, 2));
    for (std::size_t k = 0; k < std::size(curves); ++k) {
      INFO("curve " << k << ", jerk " << jerk);
      const auto plain = SpeedProfile::build(curves[k], limits);
      SpeedLimits gentle = limits;
      gentle.max_jerk = jerk;
      const auto eased = SpeedProfile::build(curves[k], gentle);
      REQUIRE(plain);
      REQUIRE(eased);
      check_profile(*plain, limits, random, 10000);
      check_profile(*eased, gentle, random, 10000);
      CHECK(eased->duration() >= plain->duration() * (1 - 1e-12));
      without[k] += plain->duration();
      with_jerk[k] += eased->duration();

      gentle.start_speed = random.uniform(0, limits.max_speed);
      gentle.end_speed = random.uniform(0, limits.max_speed);
      const auto rolling = SpeedProfile::build(curves[k], gentle);
      if (rolling) {
        check_profile(*rolling, gentle, random, 1000);
      } else {
        CHECK(rolling.error().code == PlanError::invalid_option);
        ++refused;
      }
      profiles += rolling ? 3 : 2;
    }
  }
  CAPTURE(profiles, refused, with_jerk, without);  // durations of each kind of curve
  CHECK(profiles > test::scaled(60));
  CHECK(refused < profiles / 4);
}

TEST_CASE("with jerk, a straight line from rest to rest takes longer by one window") {
  SpeedLimits limits{
      .max_speed = 2, .max_acceleration = 1, .max_deceleration = 0.5, .max_jerk = 0.75};
  // 8 s without a limit of jerk (see above); the window is 1.5 / 0.75 = 2 s.
  const auto profile = SpeedProfile::build(line(10), limits).value();
  CHECK(profile.duration() == Approx(8 + 2));
  CHECK(profile.at(1).acceleration == Approx(0.5));  // half of the window accelerates
  CHECK(profile.at(2).acceleration == Approx(1));
  CHECK(profile.at(5).speed == Approx(2 - 0.25 / 2));  // the second half brakes
  CHECK(profile.at(99).position == Point(11, 1));
  // The shorter the way, the gentler: not far from the least time for it, (32 L / j)^(1/3).
  for (const double length : {1.0, 0.1, 1e-3, 1e-6}) {
    limits.max_deceleration = limits.max_acceleration;
    const double least = std::cbrt(32 * length / limits.max_jerk);
    const double time = SpeedProfile::build(line(length), limits)->duration();
    CHECK(time >= least * (1 - 1e-9));
    CHECK(time <= 1.25 * least);
  }
  // The more jerk, the closer to none.
  limits.max_jerk = 1e9;
  CHECK(SpeedProfile::build(line(10), limits)->duration() == Approx(2 + 3 + 2).epsilon(1e-6));
}

TEST_CASE("with jerk, rolling in and out is kept, and no start that cannot be braked from") {
  SpeedLimits limits{.max_jerk = 1, .start_speed = 1, .end_speed = 1};
  const auto roll = SpeedProfile::build(line(10), limits).value();
  CHECK(roll.duration() == Approx(10));
  CHECK(roll.at(5).speed == Approx(1));
  limits.end_speed = 0;
  CHECK(SpeedProfile::build(line(10), limits));
  // Without a limit of jerk 1 m is enough to brake on.
  const auto refused = SpeedProfile::build(line(1), limits);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == PlanError::invalid_option);
  CHECK(refused.error().detail.find("start_speed ") == 0);
  // Nor from a start so close before a bend that the first change of speed would come behind it.
  const auto before_bend = [](double straight) {
    Curve curve;
    curve.push_back(Segment{{-straight, 0}, {0, 0}});
    Arc arc = Arc::around({0, 1.62}, 1.62, -pi / 2, 0.2);  // at 0.9 m/s
    arc.a = {0, 0};
    curve.push_back(arc);
    const Point end = curve.end();
    curve.push_back(Segment{end, {end.x() + 20 * std::cos(0.2), end.y() + 20 * std::sin(0.2)}});
    return curve;
  };
  limits = {.max_jerk = 0.1, .start_speed = 1};
  CHECK_FALSE(SpeedProfile::build(before_bend(1), limits));
  const auto bend = SpeedProfile::build(before_bend(8), limits);
  REQUIRE(bend);
  Random random(1);
  check_profile(*bend, limits, random, 1000);
  // Stops at corners, one after the other.
  limits = {.max_jerk = 1};
  const Point corner[] = {{0, 0}, {2, 0}, {2, 2}};
  const auto stops = SpeedProfile::build(Curve::polyline(corner), limits).value();
  const double once = SpeedProfile::build(line(2), limits)->duration();
  CHECK(stops.duration() == Approx(2 * once));
  CHECK(stops.at(once).speed == Approx(0).margin(1e-12));
  CHECK(stops.at(once).acceleration == Approx(0).margin(1e-9));
  CHECK(stops.at(once).position.isApprox(Point(2, 0)));
}

TEST_CASE("a vehicle stops where its gear changes, and nowhere else") {
  const VehiclePath path = reeds_shepp_path({{0, 0}, 0}, {{1, 3}, 0.5}, 2);
  std::vector<double> stops = path.cusps();
  REQUIRE(stops.size() == 2);
  stops.insert(stops.end(), {0, path.length()});
  for (const double jerk : {std::numeric_limits<double>::infinity(), 2.0}) {
    const auto profile = SpeedProfile::build(path.curve, {.max_jerk = jerk}).value();
    std::vector<double> least(stops.size(), 1);
    double between = 1;
    for (const SpeedProfile::State& state : profile.sample(0.001)) {
      double gap = path.length();
      for (std::size_t i = 0; i < stops.size(); ++i) {
        const double distance = std::abs(state.s - stops[i]);
        gap = std::min(gap, distance);
        if (distance < 0.01) least[i] = std::min(least[i], state.speed);
      }
      if (gap > 0.05) between = std::min(between, state.speed);
    }
    for (const double speed : least) CHECK(speed < 0.01);
    CHECK(between > 0.05);
  }
}

TEST_CASE("limits out of range are refused by name, and what cannot be followed") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refusal = [](const SpeedLimits& limits) {
    const auto result = SpeedProfile::build(line(1), limits);
    REQUIRE_FALSE(result);
    CHECK(result.error().code == PlanError::invalid_option);
    return result.error().detail;
  };
  CHECK(refusal({.max_speed = 0}).find("max_speed ") == 0);
  CHECK(refusal({.max_acceleration = nan}).find("max_acceleration ") == 0);
  CHECK(refusal({.max_deceleration = -1}).find("max_deceleration ") == 0);
  CHECK(refusal({.max_lateral_acceleration = std::numeric_limits<double>::infinity()})
            .find("max_lateral_acceleration ") == 0);
  CHECK(refusal({.max_jerk = 0}).find("max_jerk ") == 0);
  CHECK(refusal({.max_jerk = nan}).find("max_jerk ") == 0);
  CHECK(refusal({.start_speed = 2}).find("start_speed ") == 0);
  CHECK(refusal({.end_speed = nan}).find("end_speed ") == 0);
  // From 1 m/s it takes 1 m to stop at 0.5 m/s^2.
  CHECK(SpeedProfile::build(line(1), {.start_speed = 1}));
  CHECK(refusal({.max_deceleration = 0.4, .start_speed = 1}).find("start_speed ") == 0);
  CHECK(SpeedProfile::build(Curve{}, {}).error().code == PlanError::invalid_input);
  Curve cusp;
  cusp.push_back(CubicBezier{{Point(0, 0), Point(1, 1), Point(0, 1), Point(1, 0)}});
  CHECK(SpeedProfile::build(cusp, {}).error().code == PlanError::invalid_input);
}

TEST_CASE("with a limit on steering the robot slows down on clothoids and stops where arcs begin") {
  const double infinity = std::numeric_limits<double>::infinity();
  const Pose start{}, goal{{6, 5}, 1.5};
  const SpeedLimits limits{.max_curvature_rate = 0.4};
  const VehiclePath smooth = ContinuousDrives({2, 0.5}).path(start, goal);
  for (const double jerk : {infinity, 1.0}) {
    SpeedLimits with = limits;
    with.max_jerk = jerk;
    const auto profile = SpeedProfile::build(smooth.curve, with).value();
    SpeedProfile::State before = profile.at(0);
    const double step = 0.01;
    double slowest = infinity;
    for (const SpeedProfile::State& state : profile.sample(step)) {
      if (state.time == 0) continue;
      const double rate = std::abs(state.curvature - before.curvature) / (state.time - before.time);
      CHECK(rate <= with.max_curvature_rate * (1 + 1e-9));
      if (state.time > 2 && state.time < profile.duration() - 2) {
        slowest = std::min(slowest, state.speed);
      }
      before = state;
    }
    CHECK(slowest > 0.1);  // it never stops on the way
  }

  const VehiclePath jumping = dubins_path(start, goal, 2);
  const auto free = SpeedProfile::build(jumping.curve, {}).value();
  const auto stopped = SpeedProfile::build(jumping.curve, limits).value();
  REQUIRE(jumping.gears.size() == 3);
  double steered = 0.5 / 0.4 + 0.5 / 0.4;  // from the first arc to straight, and to the last one
  double standing = 0;
  for (const SpeedProfile::State& state : stopped.sample(0.001)) {
    if (state.speed == 0) standing += 0.001;
  }
  CHECK(standing == Approx(steered).margin(0.02));
  CHECK(stopped.duration() > free.duration() + steered);
  // The same with a limit of jerk.
  SpeedLimits with = limits;
  with.max_jerk = 1;
  CHECK(SpeedProfile::build(jumping.curve, with)->duration() > stopped.duration());
}

TEST_CASE("at a cusp the wheels turn while the vehicle stands") {
  // A left turn forwards, then one backwards with the same wheels, and one with the others.
  VehiclePath path;
  const Arc left = detail::turn_from({}, {Steering::left, 1}, 2);
  path.push_back(left, Gear::forward);
  const SpeedLimits limits{.max_curvature_rate = 0.25};
  const double alone = SpeedProfile::build(path.curve, limits)->duration();
  for (const auto& [steering, waiting] : {std::pair{Steering::left, 0.0}, {Steering::right, 4.0}}) {
    VehiclePath both = path;
    both.push_back(detail::turn_from(path.end(), {steering, -1}, 2), Gear::reverse);
    CHECK(SpeedProfile::build(both.curve, limits)->duration() == Approx(2 * alone + waiting));
  }
}

TEST_CASE("a limit on steering is refused for pieces whose curvature has no known change") {
  Curve curve;
  curve.push_back(QuadraticBezier{{Point(0, 0), Point(1, 0), Point(1, 1)}});
  const auto profile = SpeedProfile::build(curve, {.max_curvature_rate = 1});
  REQUIRE_FALSE(profile);
  CHECK(profile.error().code == PlanError::invalid_option);
  CHECK_FALSE(SpeedProfile::build(line(1), {.max_curvature_rate = 0}));
  CHECK(SpeedProfile::build(line(1), {.max_curvature_rate = 1e-3}));
}

}  // namespace
