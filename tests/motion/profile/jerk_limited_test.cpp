// SPDX-License-Identifier: MIT
#include "tutavia/motion/profile/jerk_limited.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

TEST_CASE("a long drive from rest to rest takes one window more than without a limit of jerk") {
  // A trapezium of 8 s (see trapezoidal_test.cpp); the window is (1 + 0.5) / 0.75 = 2 s.
  const std::vector<SpeedInterval> intervals{{10, 4}};
  const auto drive = JerkLimitedProfile::over(intervals, 3, {1, 0.5, 0.75, 0, 0}).value();
  CHECK(drive.duration() == Approx(10));
  CHECK(drive.at(0).s == Approx(3));
  CHECK(drive.at(0).acceleration == Approx(0).margin(1e-12));
  CHECK(drive.at(1).acceleration == Approx(0.5));
  CHECK(drive.at(2).acceleration == Approx(1));
  CHECK(drive.at(10).s == Approx(13));
  CHECK(drive.at(10).speed == Approx(0).margin(1e-12));
}

TEST_CASE("a short drive is gentle, near the least time that its jerk allows") {
  for (const double length : {1.0, 0.01, 1e-4}) {
    CAPTURE(length);
    const std::vector<SpeedInterval> intervals{{length, 100}};
    const auto drive = JerkLimitedProfile::over(intervals, 0, {5, 5, 2, 0, 0}).value();
    const double least = std::cbrt(32 * length / 2);  // four phases of full jerk
    CHECK(drive.duration() >= least * (1 - 1e-9));
    CHECK(drive.duration() <= 1.2 * least);
  }
}

TEST_CASE("a start that cannot be braked from is refused") {
  const std::vector<SpeedInterval> wall{{1, 100}, {1, 0.01}};
  CHECK_FALSE(JerkLimitedProfile::over(wall, 0, {1, 1, 1, 9, 0}));
  CHECK(JerkLimitedProfile::over(wall, 0, {1, 1, 1, 0, 0}));
}

TEST_CASE("widened limits reach beyond both ends of their interval, the least of them counts") {
  const std::vector<SpeedInterval> intervals{{10, 9}, {2, 1}, {10, 4}};
  const WidenedLimits limits(intervals, [](double) { return 1.0; });
  CHECK(limits.least(0, 22) == 1);
  CHECK(limits.least(0, 8.9) == 9);
  CHECK(limits.least(8, 9.5) == 1);
  CHECK(limits.least(13.5, 20) == 4);
  const auto parts = limits.between(0, 22);
  REQUIRE(parts.size() >= 3);
  double length = 0, slow = 0;
  for (const SpeedInterval& part : parts) {
    length += part.length;
    if (part.limit == 1) slow += part.length;
  }
  CHECK(length == Approx(22));
  CHECK(slow == Approx(4));  // 2 m and 1 m at either end
}

TEST_CASE("eased drives keep speed, acceleration and jerk on random intervals") {
  const std::uint64_t seed = 62;
  Random random(seed);
  std::size_t found = 0;
  for (std::size_t round = 0; round < test::scaled(100); ++round) {
    INFO("seed " << seed << ", round " << round);
    std::vector<SpeedInterval> intervals(1 + random.below(5));
    double length = 0;
    for (SpeedInterval& interval : intervals) {
      interval = {random.uniform(0.1, 4), random.uniform(0.01, 9)};
      length += interval.length;
    }
    const JerkLimitedProfile::Limits limits{random.uniform(0.1, 3), random.uniform(0.1, 3),
                                            random.uniform(0.1, 10), random.uniform(0, 0.5),
                                            random.uniform(0, 3)};
    const auto drive = JerkLimitedProfile::over(intervals, 0, limits);
    if (!drive) continue;
    ++found;
    CHECK(drive->at(0).speed == Approx(limits.start_speed).margin(1e-9));
    CHECK(drive->at(drive->duration()).s == Approx(length).epsilon(1e-9));
    CHECK(drive->at(drive->duration()).speed <= limits.end_speed + 1e-9);
    constexpr int samples = 1000;
    const double step = drive->duration() / samples;
    double before = drive->at(0).acceleration;
    for (int i = 1; i <= samples; ++i) {
      const ProfileState state = drive->at(i * step);
      double from = 0, limit = 0;
      for (const SpeedInterval& interval : intervals) {
        const bool here = state.s >= from - 1e-9 && state.s <= from + interval.length + 1e-9;
        if (here) limit = std::max(limit, interval.limit);
        from += interval.length;
      }
      if (state.speed * state.speed > limit + 1e-9) FAIL_CHECK("speed at " << state.s);
      if (state.acceleration > limits.max_acceleration + 1e-9 ||
          state.acceleration < -limits.max_deceleration - 1e-9) {
        FAIL_CHECK("acceleration at " << state.s);
      }
      if (std::abs(state.acceleration - before) > limits.max_jerk * step * (1 + 1e-6) + 1e-9) {
        FAIL_CHECK("jerk at " << state.s);
      }
      before = state.acceleration;
    }
  }
  CHECK(found > test::scaled(100) / 2);
}

}  // namespace
