// SPDX-License-Identifier: MIT
#include "tutavia/geometry/continuous_drives.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <set>
#include <string>

#include "support/catch.hpp"
#include "support/driven_word.hpp"
#include "support/scale.hpp"
#include "support/steering_checker.hpp"
#include "support/vehicle_checker.hpp"
#include "tutavia/certify/certify_vehicle.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/geometry/dubins.hpp"
#include "tutavia/geometry/reeds_shepp.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;
using std::numbers::pi;

/// What a path breaks of the promises of ContinuousDrives; empty if nothing.
std::string broken_promise(const VehiclePath& path, const Pose& from, const Pose& to,
                           const SteeringLimits& limits, bool reverse) {
  if (path.curve.start() != from.position || path.curve.end() != to.position) return "ends";
  double magnitude = 1;
  for (std::size_t i = 0; i < path.gears.size(); ++i) {
    if (path.gears[i] == Gear::reverse && !reverse) return "gear";
    magnitude = std::max(magnitude, detail::max_magnitude(end_of(path.curve.pieces()[i])));
  }
  if (const std::string limit =
          test::broken_steering_limit(path, limits.min_turning_radius, limits.max_sharpness);
      !limit.empty()) {
    return limit;
  }
  const double unit = std::max(1.0, 1 / limits.min_turning_radius);
  if (test::largest_jump(path, from, to) > 1e-12L * unit * magnitude) {
    return "jump " + std::to_string(static_cast<double>(test::largest_jump(path, from, to)) * 1e12);
  }
  return "";
}

TEST_CASE("paths of continuous curvature keep steering limits, gears and both poses") {
  const std::uint64_t seed = 1;
  Random random(seed);
  std::set<std::string> shapes;
  for (std::size_t round = 0; round < test::scaled(3000); ++round) {
    INFO("seed " << seed << ", round " << round);
    const double radius = std::exp(random.uniform(-2, 2));
    const SteeringLimits limits{radius, std::exp(random.uniform(-3, 4)) / (radius * radius)};
    const double reach = radius * std::exp(random.uniform(-4, 4));
    const Pose from = test::any_pose(random, reach), to = test::any_pose(random, reach);
    const bool reverse = random.below(2) == 0;
    const ContinuousDrives drives(limits, reverse);
    const ContinuousWord word = drives.word(from, to);
    REQUIRE(std::isfinite(word.length));
    const VehiclePath path = drives.path(word, from, to);
    CHECK(broken_promise(path, from, to, limits, reverse) == "");
    CHECK(path.length() == Approx(word.length).epsilon(1e-9));
    const double least = reverse ? reeds_shepp_length(from, to, radius)
                                 : radius * dubins_word(from, to, radius).length();
    CHECK(word.length >= least * (1 - 1e-9));
    std::string shape;
    for (std::size_t i = 0; i < word.size; ++i) {
      shape += word.moves[i].steering == Steering::straight ? 'S' : 'T';
      shape += word.moves[i].length < 0 ? '-' : '+';
    }
    shapes.insert(shape);
  }
  for (const char* shape : {"T+S+T+", "T-S-T-", "T+T-T+", "T-T+T-", "T+T+T-", "T-T+T+", "T+T+T+"}) {
    CHECK(shapes.count(shape) == 1);
  }
}

TEST_CASE("paths of continuous curvature lead to goals of every degenerate kind") {
  const SteeringLimits limits{2, 0.25};
  const detail::ContinuousTurn turn(limits);
  VehiclePath one, two;
  Pose half = turn.append({}, {Steering::left, pi}, one);
  turn.append(half, {Steering::right, -1}, two);
  for (const Pose& frame : {Pose{}, Pose{{3, -7}, 0.3}, Pose{{1e6, 2e6}, -2}}) {
    for (const Pose& goal :
         {Pose{}, Pose{{0, 0}, 1e-9}, Pose{{1, 0}, 0}, Pose{{-1, 0}, 0}, Pose{{20, 0}, 0},
          Pose{{1e-9, 0}, 0}, Pose{{0, 1e-9}, 0}, Pose{{0, 0}, pi}, Pose{{0, 4}, pi},
          Pose{{0, -4}, pi}, Pose{{8, 8}, pi / 2}, Pose{{4, 4}, 0}, half, two.end(),
          Pose{{2 * turn.ahead(), 0}, 0}, Pose{{0, 2 * turn.beside()}, pi}}) {
      for (const bool reverse : {false, true}) {
        const Pose to = test::placed(goal, frame);
        INFO("to " << goal.position.x() << ", " << goal.position.y() << ", " << goal.heading
                   << " from " << frame.position.x() << ", reverse " << reverse);
        const ContinuousDrives drives(limits, reverse);
        const ContinuousWord word = drives.word(frame, to);
        REQUIRE(std::isfinite(word.length));
        CHECK(broken_promise(drives.path(word, frame, to), frame, to, limits, reverse) == "");
      }
    }
  }
}

TEST_CASE("simple goals take the moves that one expects") {
  const SteeringLimits limits{2, 0.25};
  const ContinuousDrives forwards(limits), drives(limits, true);
  CHECK(forwards.word({}, {{3, 0}, 0}).size == 1);
  CHECK(forwards.word({}, {{3, 0}, 0}).length == Approx(3));
  CHECK(drives.word({}, {{-0.1, 0}, 0}).length == Approx(0.1));
  CHECK(forwards.word({}, {}).length == 0);
  const detail::ContinuousTurn turn(limits);
  for (const double deflection : {0.1, 0.5, 1.0, 2.0, 3.0}) {
    INFO(deflection);
    VehiclePath path;
    const Pose end = turn.append({}, {Steering::left, deflection}, path);
    CHECK(drives.word({}, end).length <= path.length() * (1 + 1e-12));
    const ContinuousWord word = forwards.word({}, end);
    REQUIRE(word.size == 1);
    CHECK(word.moves[0].length == Approx(deflection));
    CHECK(word.length == Approx(path.length()));
  }
}

TEST_CASE("goals that one, two or three simple moves reach take no longer way") {
  const std::uint64_t seed = 5;
  Random random(seed);
  using Move = SteeringMove;
  for (std::size_t round = 0; round < test::scaled(2000); ++round) {
    INFO("seed " << seed << ", round " << round);
    const double radius = std::exp(random.uniform(-1, 1));
    const SteeringLimits limits{radius, std::exp(random.uniform(-2, 3)) / (radius * radius)};
    const detail::ContinuousTurn turn(limits);
    const bool reverse = random.below(2) == 0;
    const ContinuousDrives drives(limits, reverse);
    // Straight moves of a turn without deflection, or of any length.
    const auto straight = [&] {
      return Move{Steering::straight, random.below(2) == 0
                                          ? 2 * turn.ahead()
                                          : radius * std::exp(random.uniform(-4, 2))};
    };
    const Move curved{random.below(2) == 0 ? Steering::left : Steering::right,
                      random.uniform(0.1, 3)};
    ContinuousWord word;
    switch (random.below(4)) {
      case 0:
        word.push_back(straight(), 0);
        break;
      case 1:
        word.push_back(straight(), 0);
        word.push_back(curved, 0);
        break;
      case 2:
        word.push_back(curved, 0);
        word.push_back(straight(), 0);
        break;
      default:
        word.push_back(straight(), 0);
        word.push_back(curved, 0);
        word.push_back(straight(), 0);
    }
    double length = 0;
    Pose pose = test::any_pose(random, radius);
    const Pose from = pose;
    VehiclePath driven;
    for (std::size_t i = 0; i < word.size; ++i) {
      length += drives.length(word.moves[i]);
      if (word.moves[i].steering == Steering::straight) {
        pose.position +=
            word.moves[i].length * Point(std::cos(pose.heading), std::sin(pose.heading));
      } else {
        pose = turn.append(pose, word.moves[i], driven);
      }
    }
    const ContinuousWord found = drives.word(from, pose);
    CHECK(found.length <= length * (1 + 1e-9));
    const VehiclePath path = drives.path(found, from, pose);
    CHECK(broken_promise(path, from, pose, limits, reverse) == "");
    CHECK(path.length() == Approx(found.length).epsilon(1e-9));
  }
}

TEST_CASE("every drive can be driven by its vehicle, the shortest ones too") {
  const auto space = InflatedSpace::build({.bounds = {{-50, -50}, {50, 50}}}).value();
  const SteeringLimits limits{2, 0.25};
  for (const bool reverse : {false, true}) {
    const ContinuousDrives drives(limits, reverse);
    for (const double x : {0.0, 1e-15, 3e-14, 1e-12, 1e-9, 1e-6, 0.01, 0.5, 1.0, 1.9, 2.0}) {
      INFO("x " << x << ", reverse " << reverse);
      const Pose to{{x, 0}, 0};
      const ContinuousWord word = drives.word({}, to);
      CHECK(word.length <= x + 1e-12);
      CHECK(certify(space, Vehicle::point(2, reverse), drives.path(word, {}, to)).is_drivable);
      CHECK(certify(space, Vehicle::point(2, reverse), drives.path(to, {})).is_drivable);
    }
  }
  const Pose turned{{1, 1}, 1e3};
  CHECK(
      certify(space, Vehicle::point(2), ContinuousDrives(limits).path(turned, turned)).is_drivable);
}

TEST_CASE("very sharp clothoids give the lengths of Dubins") {
  Random random(3);
  for (int round = 0; round < 200; ++round) {
    const Pose to = test::any_pose(random, 5);
    const double dubins = dubins_word({}, to, 1).length();
    CHECK(ContinuousDrives({1, 1e7}).word({}, to).length == Approx(dubins).epsilon(1e-5));
  }
}

}  // namespace
