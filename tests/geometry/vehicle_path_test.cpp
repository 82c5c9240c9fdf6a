// SPDX-License-Identifier: MIT
#include "tutavia/geometry/vehicle_path.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "support/catch.hpp"
#include "support/driven_word.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/geometry/steering_word.hpp"

namespace {

using namespace tutavia;
using std::numbers::pi;

/// A quarter to the left forwards, a metre back, and half a circle to the left in reverse.
VehiclePath forwards_and_back() {
  VehiclePath path;
  path.push_back(Arc{{0, 0}, {2, 2}, {0, 2}, 2, -pi / 2, pi / 2}, Gear::forward);
  path.push_back(Segment{{2, 2}, {2, 1}}, Gear::reverse);
  path.push_back(Arc{{2, 1}, {-2, 1}, {0, 1}, 2, 0, -pi}, Gear::reverse);
  return path;
}

void check_pose(const Pose& pose, double x, double y, double heading) {
  CHECK(pose.position.x() == Approx(x).margin(1e-14));
  CHECK(pose.position.y() == Approx(y).margin(1e-14));
  CHECK(test::heading_difference(pose.heading, heading) < 1e-14);
  CHECK((-pi < pose.heading && pose.heading <= pi));
}

TEST_CASE("gears have names") {
  CHECK(to_string(Gear::forward) == "forward");
  CHECK(to_string(Gear::reverse) == "reverse");
}

TEST_CASE("an angle is wrapped into one circle, and half a circle to the left is pi") {
  CHECK(detail::wrapped_angle(0) == 0);
  CHECK(detail::wrapped_angle(pi) == pi);
  CHECK(detail::wrapped_angle(-pi) == pi);
  CHECK(detail::wrapped_angle(3 * pi) == Approx(pi));
  CHECK(detail::wrapped_angle(-1) == -1);
  CHECK(detail::wrapped_angle(7) == Approx(7 - 2 * pi));
}

TEST_CASE("a vehicle keeps its heading where it changes gear") {
  const VehiclePath path = forwards_and_back();
  check_pose(path.start(), 0, 0, 0);
  check_pose(path.pose(0, 1), 2, 2, pi / 2);
  check_pose(path.pose(1, 0), 2, 2, pi / 2);
  check_pose(path.pose(1, 0.5), 2, 1.5, pi / 2);
  check_pose(path.pose(2, 0), 2, 1, pi / 2);
  check_pose(path.pose(2, 0.5), 0, -1, 0);
  check_pose(path.end(), -2, 1, -pi / 2);
}

TEST_CASE("poses, cusps and lengths of a path are found by arc length") {
  const VehiclePath path = forwards_and_back();
  CHECK(path.length() == Approx(3 * pi + 1));
  CHECK(path.cusps() == std::vector<double>{pi});
  check_pose(path.at(-1), 0, 0, 0);
  check_pose(path.at(pi / 2), 2 * std::sin(pi / 4), 2 - 2 * std::cos(pi / 4), pi / 4);
  check_pose(path.at(pi + 0.25), 2, 1.75, pi / 2);
  check_pose(path.at(100), -2, 1, -pi / 2);
  CHECK_FALSE(path.empty());
  CHECK(VehiclePath{}.empty());
  CHECK(VehiclePath{}.cusps().empty());
}

TEST_CASE("a reversed path has the same poses and the other gears") {
  const std::uint64_t seed = 1;
  Random random(seed);
  const VehiclePath path = forwards_and_back(), back = path.reversed();
  CHECK(back.gears == std::vector<Gear>{Gear::forward, Gear::forward, Gear::reverse});
  CHECK(back.length() == Approx(path.length()));
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    INFO("seed " << seed << ", round " << round);
    const double s = random.uniform(0, path.length());
    const Pose there = path.at(s), again = back.at(path.length() - s);
    CHECK((there.position - again.position).norm() < 1e-13);
    CHECK(test::heading_difference(there.heading, again.heading) < 1e-13);
  }
}

TEST_CASE("an arc or a clothoid that is a single point has a direction of travel") {
  CHECK(detail::travel_direction(Arc{{1, 1}, {1, 1}, {0, 1}, 1, 0, 0}, 0) == pi / 2);
  CHECK(detail::travel_direction(Arc{{1, 1}, {1, 1}, {0, 1}, 1, 0, -1e-30}, 1) == -pi / 2);
  CHECK(detail::travel_direction(Clothoid{{1, 1}, {1, 1}, 0.3, 0, 0, 0}, 0.5) == 0.3);
  CHECK(detail::travel_direction(Segment{{0, 0}, {-1, 0}}, 0.5) == pi);
}

TEST_CASE("a straight piece keeps its direction, however short and far from the origin it is") {
  const std::uint64_t seed = 2;
  Random random(seed);
  std::size_t segments = 0, clothoids = 0;
  for (std::size_t round = 0; round < test::scaled(500); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Pose from = test::any_pose(random, std::exp(random.uniform(-5, 14)));
    const double length = std::exp(random.uniform(-20, 5)), direction = from.heading;
    const Point to = from.position + length * Point(std::cos(direction), std::sin(direction));
    const Piece piece = detail::straight_piece(from.position, to, direction);
    CHECK(start_of(piece) == from.position);
    CHECK(end_of(piece) == to);
    CHECK(max_curvature(piece) == 0);
    const double kept = piece.visit([](const auto& p) { return detail::travel_direction(p, 0.5); });
    CHECK(test::heading_difference(kept, direction) < 1e-12);
    ++(piece.get_if<Segment>() != nullptr ? segments : clothoids);
  }
  CHECK((segments > 0 && clothoids > 0));
}

TEST_CASE("a single point keeps its heading when a path is reversed") {
  for (const Steering side : {Steering::left, Steering::right}) {
    VehiclePath path;
    path.push_back(detail::turn_from({{1, 2}, 0.5}, {side, 0}, 2), Gear::forward);
    CHECK(path.start().heading == Approx(0.5));
    CHECK(path.reversed().start().heading == Approx(0.5));
    CHECK(path.reversed().reversed().end().heading == Approx(0.5));
  }
}

}  // namespace
