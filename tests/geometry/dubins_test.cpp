// SPDX-License-Identifier: MIT
#include "tutavia/geometry/dubins.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/driven_word.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/geometry/reeds_shepp.hpp"

namespace {

using namespace tutavia;
using std::numbers::pi;

double dubins_length(const Pose& to) { return dubins_word({}, to, 1).length(); }

TEST_CASE("Dubins paths have their known lengths") {
  CHECK(dubins_length({{5, 0}, 0}) == 5);
  CHECK(dubins_length({{0, 0}, 0}) == 0);
  CHECK(dubins_length({{0, 2}, pi}) == Approx(pi));
  CHECK(dubins_length({{1, 1}, pi / 2}) == Approx(pi / 2));
  CHECK(dubins_length({{4, 4}, pi / 2}) == Approx(3 * std::sqrt(2) + pi / 2));
  CHECK(dubins_length({{0, 7}, pi}) == Approx(5 + pi));
  CHECK(dubins_length({{2, 2}, 0}) == Approx(pi));
  CHECK(dubins_length({{0, 0}, pi}) == Approx(7 * pi / 3));  // three circles in a triangle
  CHECK(dubins_length({{-1e-3, 0}, 0}) > 6);
  // Turning radii scale: twice the radius, twice the path.
  CHECK(dubins_word({}, {{8, 8}, pi / 2}, 2).length() == Approx(3 * std::sqrt(2) + pi / 2));
}

TEST_CASE("Dubins words lead to the goal, forwards only, and all six of them occur") {
  const std::uint64_t seed = 1;
  Random random(seed);
  std::set<std::string> shapes;
  for (std::size_t round = 0; round < test::scaled(5000); ++round) {
    INFO("seed " << seed << ", round " << round);
    const double radius = std::exp(random.uniform(-2, 2)), reach = std::exp(random.uniform(-4, 4));
    const Pose from = test::any_pose(random, reach), to = test::any_pose(random, reach);
    const SteeringWord word = dubins_word(from, to, radius);
    CHECK(test::relative_miss(word, from, to, radius) < 2e-15);
    const double heading = test::driven(word, from, radius).heading;
    CHECK(test::heading_difference(heading, to.heading) < 2e-14);
    for (std::size_t i = 0; i < word.size; ++i) CHECK(word.moves[i].length >= 0);
    shapes.insert(test::shape_of(word));
    CHECK(test::broken_promise(dubins_path(from, to, radius), word, from, to, radius) == "");
  }
  for (const char* shape : {"L+S+L+", "L+S+R+", "R+S+L+", "R+S+R+", "L+R+L+", "R+L+R+"}) {
    CHECK(shapes.count(shape) == 1);
  }
  CHECK(shapes.size() == 6);
}

TEST_CASE("Dubins paths lead to goals of every degenerate kind") {
  std::vector<double> offsets{0, 1e-16, 2, 4, std::sqrt(8.0)};
  for (double offset = 1e-9; offset < 2e6; offset *= 10) offsets.push_back(offset);
  const Pose frame{{-7, 3}, 2};
  for (const double offset : offsets) {
    for (int direction = 0; direction < 8; ++direction) {
      for (int turn = -8; turn <= 8; ++turn) {
        INFO("offset " << offset << ", direction " << direction << ", turn " << turn);
        const Point aside(std::round(std::cos(direction * pi / 4)) * offset,
                          std::round(std::sin(direction * pi / 4)) * offset);
        const Pose goal{aside, turn * pi / 4};
        for (const Pose& from : {Pose{}, frame}) {
          const Pose to = test::placed(goal, from);
          const SteeringWord word = dubins_word(from, to, 1);
          CHECK(test::relative_miss(word, from, to, 1) < 2e-14);
          CHECK(test::broken_promise(dubins_path(from, to, 1), word, from, to, 1) == "");
        }
      }
    }
  }
}

TEST_CASE("turns far below the rounding of coordinates are found at once") {
  const Pose from{{1e3, -2e3}, 0.3};
  for (const double radius : {1e-20, 1e-100, 1e-300, 5e-324}) {
    for (const Pose& to : {Pose{{1e3, -2e3}, 2}, Pose{{1e3, 7}, -3}}) {
      CAPTURE(radius, to.position.y());
      CHECK(dubins_word(from, to, radius).size <= 3);
      CHECK(reeds_shepp_word(from, to, radius).size <= 5);
    }
  }
}

/// Any drive forwards with full lock or straight ahead; some moves are quarters and halves.
SteeringWord any_drive_forwards(Random& random) {
  SteeringWord word;
  const std::size_t size = 1 + random.below(5);
  for (std::size_t i = 0; i < size; ++i) {
    const auto steering = static_cast<Steering>(static_cast<int>(random.below(3)) - 1);
    const double quarter = pi / 2 * static_cast<double>(random.below(3));
    word.push_back({steering, random.below(3) == 0 ? quarter : random.uniform(0, 4)});
  }
  return word;
}

TEST_CASE("no drive forwards is shorter than the Dubins word between its ends") {
  const std::uint64_t seed = 2;
  Random random(seed);
  std::size_t shortest = 0;
  for (std::size_t round = 0; round < test::scaled(100000); ++round) {
    const SteeringWord drive = any_drive_forwards(random);
    const Pose from = test::any_pose(random, 3), to = test::driven(drive, from, 1);
    const double length = dubins_word(from, to, 1).length();
    if (length > drive.length() + 1e-9) {
      FAIL("seed " << seed << ", round " << round << ": " << length << " > " << drive.length());
    }
    if (length > drive.length() - 1e-9) ++shortest;
  }
  CHECK(shortest > test::scaled(100000) / 10);
}

TEST_CASE("a Dubins path backwards through turned poses has the same length") {
  const std::uint64_t seed = 3;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(2000); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Pose a = test::any_pose(random, 4), b = test::any_pose(random, 4);
    const double length = dubins_word(a, b, 1).length();
    const auto turned = [](const Pose& p) { return Pose{p.position, p.heading + pi}; };
    const auto mirrored = [](const Pose& p) {
      return Pose{{p.position.x(), -p.position.y()}, -p.heading};
    };
    CHECK(dubins_word(turned(b), turned(a), 1).length() == Approx(length).epsilon(1e-12));
    CHECK(dubins_word(mirrored(a), mirrored(b), 1).length() == Approx(length).epsilon(1e-12));
  }
}

}  // namespace
