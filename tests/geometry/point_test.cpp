// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/geometry/point.hpp"

namespace {

using namespace tutavia;

using std::numbers::pi;
const double inf = std::numeric_limits<double>::infinity();
const double nan = std::numeric_limits<double>::quiet_NaN();

TEST_CASE("the cross product is positive to the left and changes sign with the order",
          "[geometry]") {
  CHECK(cross({1, 0}, {0, 1}) == 1);
  CHECK(cross({0, 1}, {1, 0}) == -1);
  CHECK(cross({2, 3}, {4, 6}) == 0);
  CHECK(cross({3, -2}, {5, 7}) == 31);
  CHECK(cross({1e9, 1}, {1, 1e9}) == 1e18 - 1);
}

TEST_CASE("perpendicular turns a vector left by a right angle", "[geometry]") {
  CHECK(detail::perpendicular({3, 4}) == Point(-4, 3));
  const Point v(-1.25, 7.5);
  CHECK(v.dot(detail::perpendicular(v)) == 0);
  CHECK(cross(v, detail::perpendicular(v)) == v.squaredNorm());
  CHECK(detail::perpendicular(detail::perpendicular(v)) == Point(-v));
}

TEST_CASE("heading measures from +x, left positive, and includes +pi", "[geometry]") {
  CHECK(heading({5, 0}) == 0);
  CHECK(heading({0, 1e-300}) == Approx(pi / 2));
  CHECK(heading({0, -1e9}) == Approx(-pi / 2));
  CHECK(heading({-2, 0}) == Approx(pi));
  CHECK(heading({-1, -1}) == Approx(-3 * pi / 4));
  CHECK(heading({0, 0}) == 0);
}

TEST_CASE("deflection is the signed angle from one vector to the other", "[geometry]") {
  CHECK(turn_angle({1, 0}, {1, 1}) == Approx(pi / 4));
  CHECK(turn_angle({0, 2}, {3, 0}) == Approx(-pi / 2));
  CHECK(turn_angle({1, 0}, {-3, 0}) == Approx(pi));
  CHECK(turn_angle({2, 5}, {4, 10}) == 0);
  // It stays small across the cut of the heading at pi.
  CHECK(turn_angle({-1, 0.125}, {-1, -0.125}) == Approx(2 * std::atan(0.125)));
}

TEST_CASE("deflection recovers the angle by which a vector was turned", "[geometry]") {
  const std::uint64_t seed = 1;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(1000); ++round) {
    const double from = random.uniform(-pi, pi), turn = random.uniform(-3.14, 3.14);
    const double size = std::exp(random.uniform(-20, 20)), other = random.uniform(0.1, 10);
    INFO("round " << round << " from " << from << " turn " << turn << " size " << size);
    const Point a = size * Point(std::cos(from), std::sin(from));
    const Point b = other * Point(std::cos(from + turn), std::sin(from + turn));
    CHECK(turn_angle(a, b) == Approx(turn).margin(1e-14));
    CHECK(turn_angle(b, a) == Approx(-turn).margin(1e-14));
  }
}

TEST_CASE("a point is finite when both of its coordinates are", "[geometry]") {
  CHECK(detail::is_finite({1e308, -1e-308}));
  for (const double bad : {inf, -inf, nan}) {
    CAPTURE(bad);
    CHECK_FALSE(detail::is_finite({bad, 0}));
    CHECK_FALSE(detail::is_finite({0, bad}));
  }
}

TEST_CASE("max_magnitude is the larger absolute coordinate", "[geometry]") {
  CHECK(detail::max_magnitude({3, -4}) == 4);
  CHECK(detail::max_magnitude({-5, 4}) == 5);
  CHECK(detail::max_magnitude({0, -0.0}) == 0);
  CHECK(detail::max_magnitude({1, -inf}) == inf);
}

TEST_CASE("angles never come out as -pi, whatever the signs of zeros") {
  CHECK(turn_angle({-1, 0}, {1, 0}) == Approx(std::acos(-1)));
  CHECK(heading({-1, -0.0}) == Approx(std::acos(-1)));
  CHECK(heading({-0.0, 0.0}) == 0);
}

}  // namespace
