// SPDX-License-Identifier: MIT
#include "tutavia/geometry/numeric/closest_parameter.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/geometry/bezier.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;
using detail::ClosestParameter;

TEST_CASE("the vertex of a parabola is nearest to a point on its axis below it") {
  const QuadraticBezier parabola{{Point(-1, 2), Point(0, 0), Point(1, 2)}};  // vertex (0, 1)
  CHECK(ClosestParameter(parabola).parameter() == Approx(0.5));
}

TEST_CASE("beyond an end of a piece that end is nearest") {
  const QuadraticBezier right{{Point(1, 0), Point(2, 1), Point(3, 0)}};
  CHECK(ClosestParameter(right).parameter() == 0);
  CHECK(ClosestParameter(right.reversed()).parameter() == 1);
}

TEST_CASE("of two parameters that are equally near the first is given") {
  // Symmetric about the y axis, passing the origin at (-x, 0) and (x, 0), farther in between.
  const QuadraticBezier arch{{Point(-1, -1), Point(0, 8), Point(1, -1)}};
  const double t = ClosestParameter(arch).parameter();
  CHECK(t < 0.5);
  CHECK(arch.point(t).norm() == Approx(arch.point(1 - t).norm()));
  CHECK(arch.point(t).norm() < arch.point(0.5).norm());
}

TEST_CASE("a piece that is one point has its start for the closest parameter") {
  const CubicBezier point{{Point(1, 1), Point(1, 1), Point(1, 1), Point(1, 1)}};
  CHECK(ClosestParameter(point).parameter() == 0);
}

TEST_CASE("a piece that is nearly a circle around the point ends, near enough") {
  constexpr double k = 0.5522847498;  // the cubic that draws a quarter of a circle
  const CubicBezier quarter{{Point(1, 0), Point(1, k), Point(k, 1), Point(0, 1)}};
  CHECK(quarter.point(ClosestParameter(quarter).parameter()).norm() == Approx(1).margin(1e-6));
}

TEST_CASE("no sample of a cubic is nearer than the point found") {
  const std::uint64_t seed = 35;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(500); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto any = [&] { return Point(random.uniform(-5, 5), random.uniform(-5, 5)); };
    const CubicBezier piece{{any(), any(), any(), any()}};
    const double found = piece.point(ClosestParameter(piece).parameter()).norm();
    double least = found;
    for (int i = 0; i <= 1000; ++i) least = std::min(least, piece.point(i / 1000.0).norm());
    CHECK(found <= least + 1e-10);
  }
}

}  // namespace
