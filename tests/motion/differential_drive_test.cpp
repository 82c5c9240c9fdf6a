// SPDX-License-Identifier: MIT
#include "tutavia/motion/differential_drive.hpp"

#include <cmath>
#include <numbers>

#include "support/catch.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using std::numbers::pi;

TEST_CASE("a twist moves a robot as many small steps do, and along its path") {
  Random random(5);
  for (int round = 0; round < 200; ++round) {
    const Pose from{{random.uniform(-9, 9), random.uniform(-9, 9)}, random.uniform(-7, 7)};
    const Twist twist{random.uniform(-1, 1), round % 4 == 0 ? 0 : random.uniform(-2, 2)};
    const double time = random.uniform(0.01, 2);
    Pose stepped = from;
    constexpr int steps = 4000;
    for (int i = 0; i < steps; ++i) {
      const double middle = stepped.heading + 0.5 * twist.omega * time / steps;
      stepped.position += twist.v * time / steps * Point(std::cos(middle), std::sin(middle));
      stepped.heading += twist.omega * time / steps;
    }
    const Pose to = moved(from, twist, time);
    CHECK(distance(to.position, stepped.position) <= 1e-6);
    CHECK(to.heading == Approx(stepped.heading));
    const Piece path = path_of(from, twist, time);
    CHECK(start_of(path) == from.position);
    CHECK(distance(end_of(path), to.position) <= 1e-12);
    path.visit([&](const auto& p) {
      CHECK(p.length() == Approx(std::abs(twist.v) * time));
      for (const double t : {0.25, 0.5, 0.9}) {
        CHECK(distance(p.point(t), moved(from, twist, t * time).position) <= 1e-12);
      }
    });
  }
}

TEST_CASE("turning on the spot is a point, and more than a full turn a circle") {
  const Pose from{{1, 2}, 0.3};
  CHECK(path_of(from, {0, 1}, 3).holds<Segment>());
  CHECK(end_of(path_of(from, {0, 1}, 3)) == from.position);
  CHECK(moved(from, {0, 1}, 3).heading == Approx(3.3));
  const Piece circle = path_of(from, {1, 2}, 10);
  REQUIRE(circle.holds<Arc>());
  CHECK(circle.get_if<Arc>()->sweep == Approx(2 * pi));
  CHECK(circle.get_if<Arc>()->radius == Approx(0.5));
}

TEST_CASE("slow turns lose no precision") {
  const Pose from{{0, 0}, 0};
  for (const double omega : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const Pose to = moved(from, {1, omega}, 1);
    CHECK(to.position.x() == Approx(1).epsilon(1e-6));
    CHECK(to.position.y() == Approx(0.5 * omega).epsilon(1e-4));
  }
}

TEST_CASE("limits out of range are refused by name") {
  CHECK(validate(DriveLimits{}));
  CHECK(validate(DriveLimits{.max_speed = std::nan("")}).error().detail.find("max_speed") == 0);
  CHECK(validate(DriveLimits{.max_angular_speed = 0}).error().detail.find("max_angular_speed") ==
        0);
}

}  // namespace
