// SPDX-License-Identifier: MIT
#include "tutavia/certify/certify_vehicle.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

#include "support/catch.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "support/vehicle_checker.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;

constexpr double pi = std::numbers::pi;

InflatedSpace vehicle_space(std::vector<Obstacle> obstacles, double r = 0) {
  return InflatedSpace::build(
             {.bounds = {{-50, -50}, {50, 50}}, .safety_radius = r, .obstacles = obstacles})
      .value();
}

/// A segment east, an arc of radius 5 to the left and an arc backwards.
VehiclePath turning_path() {
  VehiclePath path;
  path.push_back(Segment{{0, 0}, {4, 0}}, Gear::forward);
  Arc left = Arc::around({4, 5}, 5, -pi / 2, pi / 2);
  left.a = {4, 0};
  path.push_back(left, Gear::forward);
  // Backwards from (9, 5), heading north: the direction of travel is south, and the circle lies to
  // the east.
  Arc back = Arc::around({14, 5}, 5, pi, pi / 3);
  back.a = left.b;
  path.push_back(back, Gear::reverse);
  return path;
}

TEST_CASE("the clearance of a footprint is that of the disc that comes nearest") {
  // The front left disc passes the point (4, 3) as the vehicle drives by below it.
  const auto space = vehicle_space({Disc{{4, 3}, 0.5}});
  const Vehicle vehicle{5, true, {{{0, 0}, 0.5}, {{2, 1}, 0.25}}};
  VehiclePath path;
  path.push_back(Segment{{0, 0}, {10, 0}}, Gear::forward);
  const VehicleCertificate c = certify(space, vehicle, path);
  CHECK(c.status == ProofStatus::proved);
  CHECK(c.is_drivable);
  CHECK(c.disc == 1);
  CHECK(c.clearance.lower <= 1.25);  // 3 - 1 - 0.5 - 0.25
  CHECK(c.clearance.upper >= 1.25);
  CHECK(c.clearance.upper - c.clearance.lower <= 1e-6);
  CHECK((c.clearance.point - Point(4, 1)).norm() <= 1e-6);
  CHECK(c.clearance.parameter == Approx(0.2));
}

TEST_CASE("only a footprint that swings out hits a pillar beside the path") {
  // The arc of the front right corner around (4, 5) has radius hypot(3, 6).
  const double swing = std::hypot(3, 6);
  const Vehicle car{5, true, {{{0, 0}, 0.5}, {{3, -1}, 0.1}}};
  const Point direction{std::cos(-pi / 4 + std::atan2(3, 6)), std::sin(-pi / 4 + std::atan2(3, 6))};
  for (const double gap : {1e-9, -1e-9}) {
    const double away = swing + 0.1 + 0.2 + gap;
    const auto space =
        vehicle_space({Disc{{4 + away * direction.x(), 5 + away * direction.y()}, 0.2}});
    CHECK(certify(space, Vehicle::disc(0.5, 5, true), turning_path()).status ==
          ProofStatus::proved);
    const VehicleCertificate c = certify(space, car, turning_path());
    CHECK(c.status == (gap > 0 ? ProofStatus::proved : ProofStatus::violated));
    CHECK(c.clearance.piece == 1);
    CHECK(c.disc == 1);
  }
}

TEST_CASE("what a vehicle cannot drive is not proved") {
  const auto space = vehicle_space({});
  const auto status = [&](const Vehicle& vehicle, const VehiclePath& path) {
    const VehicleCertificate c = certify(space, vehicle, path);
    CHECK(c.is_drivable == (c.status == ProofStatus::proved));
    return c.status;
  };
  const VehiclePath path = turning_path();
  CHECK(status(Vehicle::point(5, true), path) == ProofStatus::proved);
  CHECK(status(Vehicle::point(5.001, true), path) == ProofStatus::violated);
  CHECK(status(Vehicle::point(5, false), path) == ProofStatus::violated);

  VehiclePath corner;
  corner.push_back(Segment{{0, 0}, {4, 0}}, Gear::forward);
  corner.push_back(Segment{{4, 0}, {8, 0.001}}, Gear::forward);
  CHECK(status(Vehicle::point(5, true), corner) == ProofStatus::violated);
  corner.gears[1] = Gear::reverse;
  CHECK(status(Vehicle::point(5, true), corner) == ProofStatus::violated);

  VehiclePath bezier;
  bezier.push_back(CubicBezier{{Point(0, 0), Point(1, 0), Point(2, 0), Point(3, 0)}},
                   Gear::forward);
  CHECK(status(Vehicle::point(5, true), bezier) == ProofStatus::violated);
  VehiclePath spin;
  spin.push_back(Arc{{0, 0}, {0, 0}, {0, 0}, 0, 0, 1}, Gear::forward);
  CHECK(status(Vehicle::point(5, true), spin) == ProofStatus::violated);
  CHECK(status(Vehicle::point(), spin) == ProofStatus::proved);
  VehiclePath gears = path;
  gears.gears.pop_back();
  CHECK(status(Vehicle::point(5, true), gears) == ProofStatus::violated);
  CHECK(status(Vehicle::point(5, true), {}) == ProofStatus::violated);
  CHECK(certify(space, Vehicle{5, true, {}}, path).status == ProofStatus::undecided);
}

TEST_CASE("a piece whose ends lie off its own curve cannot be driven") {
  const auto space = vehicle_space({Polygon{{{-1, 4}, {1, 4}, {1, 6}, {-1, 6}}}});
  const auto status = [&](const Piece& piece, double radius) {
    VehiclePath path;
    path.push_back(piece, Gear::forward);
    return certify(space, Vehicle::point(radius, true), path).status;
  };
  CHECK(status(Clothoid{{0, 0}, {0, 3}, 0, 0, 0, 0}, 1) == ProofStatus::violated);
  Arc sideways = Arc::around({0, -2}, 2, pi / 2, 0);
  sideways.b = {-1, 3};
  CHECK(status(sideways, 1) == ProofStatus::violated);
  // A negative radius would lead through the obstacle.
  CHECK(status(Arc::around({0, 0}, -5, pi + 0.3, pi - 0.6), 1) != ProofStatus::proved);
}

TEST_CASE("a disc may pass exactly at its radius") {
  // A corridor as wide as the robot: half of its width is the safety radius, or the disc, or both.
  for (const double safety : {0.5, 0.25, 0.0}) {
    INFO("safety radius " << safety);
    const auto space = vehicle_space({Polygon{{{-9, 0.5}, {9, 0.5}, {9, 2}, {-9, 2}}},
                                      Polygon{{{-9, -0.5}, {9, -0.5}, {9, -2}, {-9, -2}}}},
                                     safety);
    VehiclePath path;
    path.push_back(Segment{{-20, 0}, {20, 0}}, Gear::forward);
    CHECK(certify(space, Vehicle::disc(0.5 - safety, 1), path).status == ProofStatus::proved);
    CHECK(certify(space, Vehicle::disc(0.5 - safety + 1e-15, 1), path).status !=
          ProofStatus::proved);
  }
}

/// A chain of random arcs, segments and clothoids with continuous headings.
VehiclePath random_vehicle_path(Random& random, const Point& from, double scale) {
  VehiclePath path;
  Point p = from;
  double direction = random.uniform(-pi, pi);
  Gear gear = Gear::forward;
  for (int i = 0; i < 4; ++i) {
    if (random.below(3) == 0) {
      gear = gear == Gear::forward ? Gear::reverse : Gear::forward;
      direction = detail::wrapped_angle(direction + pi);
    }
    const double radius = scale * random.uniform(1, 3), side = random.below(2) == 0 ? 1 : -1;
    if (random.below(3) == 0) {
      const double length = scale * random.uniform(0.1, 2);
      const Clothoid clothoid = Clothoid::from(p, direction, side / (2 * radius),
                                               random.uniform(-0.4, 0.4) / radius / length, length);
      path.push_back(clothoid, gear);
      direction += clothoid.turn_to(1);
      p = clothoid.b;
    } else {
      const double sweep = side * random.uniform(0.05, 1.5), at = direction - side * pi / 2;
      const Point centre{p.x() - radius * std::cos(at), p.y() - radius * std::sin(at)};
      Arc arc = Arc::around(centre, radius, at, sweep);
      arc.a = p;
      path.push_back(arc, gear);
      direction += sweep;
      p = arc.b;
    }
  }
  return path;
}

TEST_CASE("the verdict on random vehicles and motions is that of an independent judge") {
  const std::uint64_t seed = 24;
  test::WorldGenerator worlds(seed);
  Random random(seed);
  std::size_t proved = 0, violated = 0;
  for (std::size_t round = 0; round < test::scaled(400); ++round) {
    INFO("seed " << seed << ", round " << round);
    Workspace world = worlds.workspace();
    const double size = world.bounds.width();
    world.safety_radius = random.below(3) == 0 ? 0 : 0.01 * size;
    const auto space = InflatedSpace::build(world).value();
    Vehicle vehicle{0.04 * size, true, {}};
    for (int k = 0; k < 3; ++k) {
      vehicle.footprint.push_back(
          {{size * random.uniform(-0.05, 0.05), size * random.uniform(-0.05, 0.05)},
           size * random.uniform(0.005, 0.02)});
    }
    const VehiclePath path = random_vehicle_path(random, worlds.point(world), 0.04 * size);
    const VehicleCertificate c = certify(space, vehicle, path);
    CHECK(c.is_drivable);
    const test::Real deficit = test::clearance_deficit(world, vehicle, path);
    if (c.status == ProofStatus::proved) {
      ++proved;
      CHECK(deficit <= 1e-12L * (1 + world.bounds.largest_coordinate()));
      CHECK(c.clearance.lower <= c.clearance.upper);
    } else if (c.status == ProofStatus::violated) {
      ++violated;
      CHECK(deficit > -1e-9L);
    }
    CHECK(detail::FootprintTest(vehicle).is_free(space, path) == (c.status == ProofStatus::proved));
  }
  CHECK(proved > test::scaled(400) / 20);
  CHECK(violated > test::scaled(400) / 20);
}

}  // namespace
