// SPDX-License-Identifier: MIT
#include "tutavia/motion/profile/trapezoidal.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The fastest drive over intervals from one speed to at most another.
TrapezoidalProfile fastest(const std::vector<SpeedInterval>& intervals, double start, double end,
                           double acceleration, double braking) {
  std::vector<double> squares = boundary_speed_limits(intervals);
  squares.back() = std::min(squares.back(), end * end);
  squares = backward_pass(intervals, squares, braking);
  squares[0] = std::min(squares[0], start * start);
  TrapezoidalProfile drive;
  drive.drive(intervals, squares, acceleration, braking);
  return drive;
}

TEST_CASE("where intervals meet the smaller limit holds") {
  const std::vector<SpeedInterval> intervals{{5, 4}, {5, 9}, {5, 1}};
  CHECK(boundary_speed_limits(intervals) == std::vector<double>{4, 4, 1, 1});
  CHECK(boundary_speed_limits({}) == std::vector<double>{infinity});
}

TEST_CASE("one can brake in time from squares that rise by twice braking times length") {
  const std::vector<SpeedInterval> intervals{{1, 100}, {2, 100}, {3, 100}};
  CHECK(backward_pass(intervals, {100, 100, 100, 0}, 2) == std::vector<double>{24, 20, 12, 0});
  CHECK(backward_pass(intervals, {100, 5, 100, 0}, 2) == std::vector<double>{9, 5, 12, 0});
}

TEST_CASE("a drive from rest to rest is a trapezium, or a triangle over a short distance") {
  // Up to 2 m/s in 2 s over 2 m, down in 4 s over 4 m; 4 m at 2 m/s take 2 s.
  const TrapezoidalProfile trapezium = fastest({{10, 4}}, 0, 0, 1, 0.5);
  CHECK(trapezium.end_time() == Approx(8));
  CHECK(trapezium.at(1).s == Approx(0.5));
  CHECK(trapezium.at(3).speed == Approx(2));
  CHECK(trapezium.at(3).acceleration == 0);
  CHECK(trapezium.at(6).acceleration == -0.5);
  CHECK(trapezium.at(99).s == Approx(10));
  CHECK(trapezium.at(99).speed == Approx(0).margin(1e-9));
  CHECK(trapezium.at(-1).s == 0);
  // 3 m: up over 1 m to sqrt(2) m/s, down over 2 m.
  const TrapezoidalProfile triangle = fastest({{3, 4}}, 0, 0, 1, 0.5);
  CHECK(triangle.end_time() == Approx(3 * std::sqrt(2)));
  CHECK(triangle.at(std::sqrt(2)).speed == Approx(std::sqrt(2)));
}

TEST_CASE("a slow interval is braked for in time and left as soon as it ends") {
  const TrapezoidalProfile drive = fastest({{10, 16}, {4, 1}, {10, 16}}, 1, 1, 2, 2);
  // Up to 16 takes 15 / 4 m of each 10 m, down as much.
  CHECK(drive.end_time() == Approx(2 * (2 * 1.5 + 2.5 / 4) + 4));
  CHECK(drive.at(3.625).s == Approx(10));
  CHECK(drive.at(5).speed == Approx(1));
  CHECK(drive.at(7.625).s == Approx(14));
}

TEST_CASE("a constant speed adds time and distance, a stop adds time alone") {
  TrapezoidalProfile drive(-1, 5);
  CHECK(drive.end_time() == -1);
  CHECK(drive.at(0).s == 5);
  drive.keep(2, 3);
  drive.keep(0, 4);
  drive.keep(7, 0);  // no time: nothing
  CHECK(drive.end_time() == 6);
  CHECK(drive.at(0).s == Approx(7));
  CHECK(drive.at(4).s == Approx(11));
  CHECK(drive.at(4).speed == 0);
  const ProfileState mean = drive.mean(0, 4);  // half of it at 2 m/s
  CHECK(mean.speed == Approx(1));
  CHECK(mean.s == Approx((2 * 9 + 2 * 11) / 4.0));
}

TEST_CASE("drives keep every limit, and their averages are those of many samples") {
  const std::uint64_t seed = 61;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    INFO("seed " << seed << ", round " << round);
    std::vector<SpeedInterval> intervals(1 + random.below(6));
    for (SpeedInterval& interval : intervals) {
      interval = {random.below(6) == 0 ? 0 : random.uniform(0.1, 4), random.uniform(0.01, 9)};
    }
    intervals.push_back({1, 4});
    const double a = random.uniform(0.1, 3), b = random.uniform(0.1, 3);
    const TrapezoidalProfile drive =
        fastest(intervals, random.uniform(0, 3), random.uniform(0, 3), a, b);
    double length = 0;
    for (const SpeedInterval& interval : intervals) length += interval.length;
    CHECK(drive.at(drive.end_time()).s == Approx(length));
    constexpr int samples = 1000;
    ProfileState sum;
    for (int i = 0; i < samples; ++i) {
      const ProfileState state = drive.at(drive.end_time() * (i + 0.5) / samples);
      sum.s += state.s / samples;
      sum.speed += state.speed / samples;
      double from = 0, limit = 0;  // the larger one where two intervals meet
      for (const SpeedInterval& interval : intervals) {
        const bool here = state.s >= from - 1e-9 && state.s <= from + interval.length + 1e-9;
        if (here) limit = std::max(limit, interval.limit);
        from += interval.length;
      }
      if (state.speed * state.speed > limit + 1e-9) FAIL_CHECK("at " << state.s);
      if (state.acceleration > a || state.acceleration < -b) FAIL_CHECK("at " << state.s);
    }
    const ProfileState mean = drive.mean(0, drive.end_time());
    CHECK(mean.s == Approx(sum.s).epsilon(1e-3));
    CHECK(mean.speed == Approx(sum.speed).epsilon(1e-3));
  }
}

}  // namespace
