// SPDX-License-Identifier: MIT
#include "tutavia/geometry/tangent/clothoid_pair.hpp"

#include <cmath>
#include <numbers>

#include "support/catch.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;
using std::numbers::pi;

TEST_CASE("a unit spiral leaves a line and ends on a circle of radius 1") {
  for (const double turn : {1e-4, 0.1, 0.7, pi / 2, 3.0}) {
    INFO(turn);
    const UnitClothoid spiral = UnitClothoid::turning(turn);
    const Clothoid clothoid = Clothoid::from({0, 0}, 0, 0, 0.5 / turn, 2 * turn);
    CHECK(clothoid.curvature_at(1) == Approx(1));
    CHECK(clothoid.turn_to(1) == Approx(turn));
    CHECK(spiral.end == clothoid.b);
    const Point centre = clothoid.b + Point(-std::sin(turn), std::cos(turn));
    CHECK(spiral.centre.x() == Approx(centre.x()));
    CHECK(spiral.centre.y() == Approx(centre.y() - 1).margin(1e-15));
    CHECK(spiral.centre.y() > 0);
  }
  // To first order: it begins half its length before the circle would, and moves it aside by the
  // square of its length over 24.
  const UnitClothoid small = UnitClothoid::turning(1e-3);
  CHECK(small.centre.x() == Approx(1e-3).epsilon(1e-6));
  CHECK(small.centre.y() == Approx(4e-6 / 24).epsilon(1e-5));
  CHECK(is_zero(UnitClothoid::turning(0).end));
}

TEST_CASE("two clothoids of a pair meet on the corner's bisector") {
  for (const double turn : {1e-3, 0.5, pi / 2, 2.8}) {
    INFO(turn);
    const ClothoidPair pair = ClothoidPair::of_clothoids(turn);
    const Clothoid in = Clothoid::from({-pair.leg, 0}, 0, 0, 1 / turn, turn);
    CHECK(in.b.norm() == Approx(pair.drop));
    CHECK(heading(in.b) == Approx(pi / 2 + turn / 2));
    CHECK(heading(in.end_direction()) == Approx(turn / 2));
  }
}

TEST_CASE("Bezier spirals are continuous in direction and curvature, which is monotone") {
  for (const double turn : {-2.5, -0.3, 0.01, 0.8, pi / 2, 3.0}) {
    INFO(turn);
    const Point corner{3, 4}, in{std::cos(0.7), std::sin(0.7)};
    const Point out{std::cos(0.7 + turn), std::sin(0.7 + turn)};
    const double leg = 2.5;
    const auto [first, second] = bezier_spirals(corner, in, out, leg);
    CHECK(first.start().isApprox(corner - leg * in));
    CHECK(second.end().isApprox(corner + leg * out));
    CHECK(first.end() == second.start());
    CHECK(turn_angle(in, first.start_direction()) == Approx(0).margin(1e-12));
    CHECK(turn_angle(out, second.end_direction()) == Approx(0).margin(1e-12));
    CHECK(turn_angle(first.end_direction(), second.start_direction()) == Approx(0).margin(1e-12));
    const double peak = curvature(first, 1);
    CHECK(curvature(second, 0) == Approx(peak));
    CHECK(std::abs(curvature(first, 0)) < 1e-9 * std::abs(peak));
    CHECK(std::abs(curvature(second, 1)) < 1e-9 * std::abs(peak));
    CHECK(peak * turn > 0);
    for (int i = 0; i < 100; ++i) {
      const double before = std::abs(curvature(first, i / 100.0));
      CHECK(std::abs(curvature(first, (i + 1) / 100.0)) >= before * (1 - 1e-6));
    }
    const ClothoidPair pair = ClothoidPair::of_beziers(std::abs(turn));
    CHECK(pair.leg == Approx(leg * std::abs(peak)));
    CHECK(pair.drop == Approx(distance(corner, first.end()) * std::abs(peak)));
    // The paper's formula for the peak.
    constexpr double c1 = 7.2364, c2 = 0.5797958971132712, c3 = (c2 + 4) / (c1 + 6);
    const double c4 = (c2 + 4) * (c2 + 4) / (54 * c3), half = std::abs(turn) / 2;
    CHECK(std::abs(peak) ==
          Approx(c4 * std::sin(half) / (leg * std::cos(half) * std::cos(half))).epsilon(1e-3));
  }
}

}  // namespace
