// SPDX-License-Identifier: MIT
#include "tutavia/geometry/reeds_shepp.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/driven_word.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/geometry/dubins.hpp"

namespace {

using namespace tutavia;
using std::numbers::pi;

double length_to(const Pose& to) { return reeds_shepp_length({}, to, 1); }

TEST_CASE("Reeds-Shepp paths have their known lengths") {
  CHECK(length_to({{5, 0}, 0}) == 5);
  CHECK(length_to({{-5, 0}, 0}) == 5);
  CHECK(length_to({{0, 0}, 0}) == 0);
  CHECK(length_to({{0, 0}, pi}) == Approx(pi));
  CHECK(length_to({{0, 2}, pi}) == Approx(pi));
  CHECK(length_to({{1, 1}, pi / 2}) == Approx(pi / 2));
  CHECK(length_to({{-1, 1}, -pi / 2}) == Approx(pi / 2));
  CHECK(length_to({{4, 4}, pi / 2}) == Approx(3 * std::sqrt(2) + pi / 2));
  // Sideways: L+R-L-R+ or its like.
  for (const double aside : {1e-6, 0.01, 0.1, 0.5}) {
    INFO(aside);
    const double middle = 2 * std::asin(std::sqrt((aside * aside + 4 * aside) / 32));
    const double first = std::atan2(std::sin(middle), 2 - std::cos(middle));
    CHECK(length_to({{0, aside}, 0}) == Approx(2 * (first + middle)).epsilon(1e-12));
    CHECK(length_to({{0, -aside}, 0}) == Approx(length_to({{0, aside}, 0})).epsilon(1e-12));
  }
  // A turn on the spot: three turns with two cusps, together as long as the turn.
  for (const double turn : {0.1, 1.0, 2.0, 3.0}) CHECK(length_to({{0, 0}, turn}) == Approx(turn));
  CHECK(reeds_shepp_length({}, {{8, 8}, pi / 2}, 2) == Approx(6 * std::sqrt(2) + pi));
}

void check_words(const Pose& from, const Pose& to, double radius, std::set<std::string>& shapes) {
  double least = std::numeric_limits<double>::infinity(), miss = 0, turn_miss = 0;
  for_each_reeds_shepp_word(from, to, radius, [&](const SteeringWord& word) {
    least = std::min(least, word.length());
    miss = std::max(miss, test::relative_miss(word, from, to, radius));
    const double heading = test::driven(word, from, radius).heading;
    turn_miss = std::max(turn_miss, test::heading_difference(heading, to.heading));
    shapes.insert(test::shape_of(word));
  });
  CHECK(miss < 2e-14);
  CHECK(turn_miss < 2e-14);
  const SteeringWord best = reeds_shepp_word(from, to, radius);
  CHECK(reeds_shepp_length(from, to, radius) == Approx(radius * least).epsilon(1e-15));
  CHECK(best.length() <= least * (1 + 1.01e-10));
  CHECK(best.length() <= dubins_word(from, to, radius).length() * (1 + 1.01e-10));
  CHECK(test::broken_promise(reeds_shepp_path(from, to, radius), best, from, to, radius) == "");
}

TEST_CASE("all 48 Reeds-Shepp words lead to the goal") {
  const std::uint64_t seed = 1;
  Random random(seed);
  std::set<std::string> shapes;
  for (std::size_t round = 0; round < test::scaled(3000); ++round) {
    INFO("seed " << seed << ", round " << round);
    const double radius = std::exp(random.uniform(-2, 2)), reach = std::exp(random.uniform(-3, 3));
    const Pose from = test::any_pose(random, radius * reach);
    check_words(from, test::any_pose(random, radius * reach), radius, shapes);
  }
  CHECK(shapes.size() == 48);
}

TEST_CASE("Reeds-Shepp words lead to goals of every degenerate kind") {
  const std::uint64_t seed = 2;
  Random random(seed);
  std::vector<double> offsets{0, 1e-16};
  for (double offset = 1e-9; offset < 2e6; offset *= 10) offsets.push_back(offset);
  for (const double offset : {2.0, 4.0, std::sqrt(8.0), std::sqrt(20.0)}) offsets.push_back(offset);
  std::set<std::string> shapes;
  for (const double offset : offsets) {
    for (int direction = 0; direction < 8; ++direction) {
      for (int turn = -8; turn <= 8; ++turn) {
        INFO("seed " << seed << ", offset " << offset << ", " << direction << ", " << turn);
        const Point aside(std::round(std::cos(direction * pi / 4)) * offset,
                          std::round(std::sin(direction * pi / 4)) * offset);
        const Pose to{aside, turn * pi / 4};
        check_words({}, to, 1, shapes);
        const Pose frame = test::any_pose(random, 10);
        check_words(frame, test::placed(to, frame), 1, shapes);
      }
    }
  }
}

/// Any drive with full lock or straight ahead, in both gears.
SteeringWord any_drive(Random& random) {
  SteeringWord word;
  const std::size_t size = 1 + random.below(5);
  for (std::size_t i = 0; i < size; ++i) {
    const auto steering = static_cast<Steering>(static_cast<int>(random.below(3)) - 1);
    const double length = random.below(3) == 0 ? pi / 2 : random.uniform(0, 2);
    word.push_back({steering, random.below(2) == 0 ? length : -length});
  }
  return word;
}

/// A drive with the turns of a word of Reeds and Shepp in any gears and of any lengths: quarters
/// are q, and second and third turns of one length m.
SteeringWord any_drive_of_a_family(Random& random) {
  struct Family {
    std::string turns, lengths;
  };
  static const std::vector<Family> families{
      {"LSL", "tst"},   {"LSR", "tst"},   {"LRL", "tmt"},   {"LRLR", "tmmt"},   {"LRSL", "tqst"},
      {"LRSR", "tqst"}, {"LSRL", "tsqt"}, {"LSLR", "tsqt"}, {"LRSLR", "tqsqt"},
  };
  const Family& family = families[random.below(families.size())];
  const int mirror = random.below(2) == 0 ? 1 : -1;
  const double middle = random.uniform(0, pi / 2);
  SteeringWord word;
  for (std::size_t i = 0; i < family.turns.size(); ++i) {
    const char kind = family.lengths[i], turn = family.turns[i];
    const int steering = turn == 'L' ? mirror : turn == 'R' ? -mirror : 0;
    double length = random.uniform(0, kind == 's' ? 3 : 1.2);
    if (kind == 'q') length = pi / 2;
    if (kind == 'm') length = middle;
    word.push_back({static_cast<Steering>(steering), random.below(2) == 0 ? length : -length});
  }
  return word;
}

TEST_CASE("no drive is shorter than the Reeds-Shepp word between its ends") {
  const std::uint64_t seed = 3;
  Random random(seed);
  std::set<std::string> shortest;
  for (std::size_t round = 0; round < test::scaled(200000); ++round) {
    const SteeringWord drive = round % 2 == 0 ? any_drive(random) : any_drive_of_a_family(random);
    const Pose from = test::any_pose(random, 3), to = test::driven(drive, from, 1);
    const double length = reeds_shepp_length(from, to, 1);
    if (length > drive.length() + 1e-11) {
      FAIL("seed " << seed << ", round " << round << ": " << length << " > " << drive.length());
    }
    if (length > drive.length() - 1e-11) shortest.insert(test::shape_of(drive));
  }
  // Words of every family were themselves the shortest drive.
  for (const char* shape :
       {"L+S+L+", "L+S+R+", "L+R-L+", "L+R-L-", "L+R+L-", "L+R+L-R-", "L+R-L-R+", "L+R-S-L-",
        "L+R-S-R-", "L-S-R-L+", "L-S-L-R+", "L+R-S-L-R+"}) {
    INFO(shape);
    CHECK(shortest.count(shape) == 1);
  }
}

TEST_CASE("a way through a third pose is not shorter") {
  const std::uint64_t seed = 4;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(5000); ++round) {
    INFO("seed " << seed << ", round " << round);
    const double reach = std::exp(random.uniform(-2, 2));
    const Pose a = test::any_pose(random, reach), b = test::any_pose(random, reach);
    const Pose c = test::any_pose(random, reach);
    const double direct = reeds_shepp_length(a, c, 1);
    CHECK(direct <= reeds_shepp_length(a, b, 1) + reeds_shepp_length(b, c, 1) + 1e-12);
    CHECK(direct >= (a.position - c.position).norm() * (1 - 1e-14));
  }
}

TEST_CASE("Reeds-Shepp lengths are the same backwards, mirrored and in every frame") {
  const std::uint64_t seed = 5;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(3000); ++round) {
    INFO("seed " << seed << ", round " << round);
    const double reach = std::exp(random.uniform(-2, 3));
    const Pose to = test::any_pose(random, reach), frame = test::any_pose(random, reach);
    const double length = length_to(to);
    const Pose mirrored{{to.position.x(), -to.position.y()}, -to.heading};
    const Pose flipped{{-to.position.x(), to.position.y()}, -to.heading};
    CHECK(reeds_shepp_length(to, {}, 1) == Approx(length).epsilon(1e-11));
    CHECK(length_to(mirrored) == Approx(length).epsilon(1e-11));
    CHECK(length_to(flipped) == Approx(length).epsilon(1e-11));
    CHECK(reeds_shepp_length(frame, test::placed(to, frame), 1) == Approx(length).epsilon(1e-10));
    const Pose scaled{3 * to.position, to.heading};
    CHECK(reeds_shepp_length({}, scaled, 3) == Approx(3 * length).epsilon(1e-11));
  }
}

TEST_CASE("of equal words the same one is taken in every frame") {
  const std::uint64_t seed = 6;
  Random random(seed);
  for (int i = -6; i <= 6; ++i) {
    for (int j = -6; j <= 6; ++j) {
      for (int k = -3; k <= 4; ++k) {
        const Pose to{{0.5 * i, 0.5 * j}, k * pi / 4};
        const std::string shape = test::shape_of(reeds_shepp_word({}, to, 1));
        for (std::size_t round = 0; round < test::scaled(5); ++round) {
          INFO("seed " << seed << ", goal " << i << ", " << j << ", " << k);
          const Pose frame = test::any_pose(random, 3);
          const SteeringWord word = reeds_shepp_word(frame, test::placed(to, frame), 1);
          CHECK(test::shape_of(word) == shape);
        }
      }
    }
  }
}

}  // namespace
