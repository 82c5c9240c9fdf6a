// SPDX-License-Identifier: MIT
#include "tutavia/geometry/steering_word.hpp"

#include <cmath>
#include <initializer_list>
#include <numbers>

#include "support/catch.hpp"
#include "support/driven_word.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using std::numbers::pi;

SteeringWord word_of(std::initializer_list<SteeringMove> moves) {
  SteeringWord word;
  for (const SteeringMove& move : moves) word.push_back(move);
  return word;
}

TEST_CASE("a word has the length of its moves and a cusp at every change of gear") {
  using enum Steering;
  const SteeringWord word = word_of({{left, 1}, {right, -0.5}, {straight, -2}, {left, 0.25}});
  CHECK(word.length() == 3.75);
  CHECK(word.cusps() == 2);
  CHECK(word_of({}).length() == 0);
  CHECK(word_of({}).cusps() == 0);
  CHECK(word_of({{left, 1}, {straight, 2}}).cusps() == 0);
  CHECK(SteeringMove{right, -0.5}.turn() == 0.5);
  CHECK(SteeringMove{straight, 3}.turn() == 0);
}

TEST_CASE("moves that are rounding count neither as moves nor as cusps") {
  using enum Steering;
  const SteeringWord word = word_of({{left, 1e-16}, {straight, 5}, {right, -1e-15}, {left, 1}});
  CHECK(word.without_rounding().size == 2);
  CHECK(word.cusps() == 0);
  CHECK(word_of({{left, 1e-13}, {straight, -1e-12}}).cusps() == 1);
  CHECK(word_of({{straight, 1e-20}}).without_rounding().size == 1);
  CHECK(word_of({{left, 1}, {straight, 1e-20}}).without_rounding().size == 1);
}

TEST_CASE("the path of a word has a piece and a gear for every move") {
  using enum Steering;
  const SteeringWord word = word_of({{left, pi / 2}, {right, -pi / 2}, {straight, -3}, {left, 0}});
  const Pose from{{1, 2}, 0};
  const Pose end = test::driven(word, from, 2);
  const VehiclePath path = vehicle_path(word, from, end, 2);
  REQUIRE(path.gears.size() == 3);
  CHECK((path.gears[0] == Gear::forward && path.gears[1] == Gear::reverse));
  CHECK(path.gears[2] == Gear::reverse);
  CHECK(path.curve.pieces()[2].get_if<Segment>() != nullptr);
  CHECK(path.length() == Approx(2 * word.length()));
  CHECK(test::broken_promise(path, word, from, end, 2).empty());
}

TEST_CASE("a path that stays where it is keeps the heading") {
  for (const double heading : {0.0, 0.3, pi, -2.5, 8.0}) {
    const Pose pose{{1e6, -3}, heading};
    const VehiclePath path = vehicle_path({}, pose, pose, 0.7);
    REQUIRE(path.gears.size() == 1);
    const Arc* arc = path.curve.pieces()[0].get_if<Arc>();
    REQUIRE(arc != nullptr);
    CHECK((arc->sweep == 0 && arc->a == pose.position && arc->b == pose.position));
    CHECK(path.length() == 0);
    CHECK(test::heading_difference(path.start().heading, heading) < 1e-14);
    CHECK(test::heading_difference(path.at(0).heading, heading) < 1e-14);
    CHECK(test::broken_promise(path, {}, pose, pose, 0.7).empty());
  }
}

TEST_CASE("a path of which only rounding is left is straight") {
  using enum Steering;
  const Pose from{{0, 0}, 0.5};
  for (const double length : {1e-20, -1e-20}) {
    const Pose to{{length * std::cos(0.5), length * std::sin(0.5)}, 0.5};
    const SteeringWord word = word_of({{left, length}});
    const VehiclePath path = vehicle_path(word, from, to, 1);
    CHECK(test::broken_promise(path, word, from, to, 1).empty());
    CHECK(path.gears[0] == (length < 0 ? Gear::reverse : Gear::forward));
    CHECK(path.length() == Approx(1e-20));
  }
}

SteeringWord any_word(Random& random) {
  using enum Steering;
  SteeringWord word;
  const std::size_t size = 1 + random.below(5), with_straight = random.below(7);
  for (std::size_t i = 0; i < size; ++i) {
    const Steering turn = random.below(2) == 0 ? left : right;
    const bool is_straight = i == with_straight;
    const double length = is_straight ? std::exp(random.uniform(-20, 10)) : random.uniform(0, pi);
    word.push_back({is_straight ? straight : turn, random.below(2) == 0 ? length : -length});
  }
  return word;
}

TEST_CASE("paths of words join both poses exactly and keep radius and headings") {
  const std::uint64_t seed = 1;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(2000); ++round) {
    INFO("seed " << seed << ", round " << round);
    const SteeringWord word = any_word(random);
    const double radius = std::exp(random.uniform(-5, 5));
    const Pose from = test::any_pose(random, std::exp(random.uniform(-5, 14)));
    const Pose to = test::driven(word, from, radius);
    const VehiclePath path = vehicle_path(word, from, to, radius);
    CHECK(test::broken_promise(path, word, from, to, radius) == "");
    const double s = random.uniform(0, path.length());
    const Pose middle = path.at(s), turned = path.reversed().at(path.length() - s);
    CHECK(test::heading_difference(middle.heading, turned.heading) < 1e-8);
  }
}

}  // namespace
