// SPDX-License-Identifier: MIT
#include "tutavia/geometry/curvature.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST_CASE("segments have no curvature, arcs that of their circle, left turns positive") {
  CHECK(curvature(Segment{{0, 0}, {3, 4}}, 0.5) == 0);
  CHECK(curvature(Segment{{1, 1}, {1, 1}}, 0.5) == 0);  // one point
  CHECK(max_curvature(Segment{{0, 0}, {3, 4}}) == 0);
  const Arc left = Arc::around({0, 0}, 4, 0, 1), right = Arc::around({0, 0}, 4, 0, -1);
  CHECK(curvature(left, 0.3) == Approx(0.25));
  CHECK(curvature(right, 0.3) == Approx(-0.25));
  CHECK(max_curvature(left) == 0.25);
  CHECK(max_curvature(right) == 0.25);
  CHECK(max_curvature(Arc::around({0, 0}, 4, 1, 0)) == 0);  // one point
}

TEST_CASE("a clothoid is curved most at one of its ends") {
  const Clothoid growing = Clothoid::from({0, 0}, 0, 0.1, 0.2, 3);
  CHECK(max_curvature(growing) == Approx(0.7));
  CHECK(max_curvature(Clothoid::from({0, 0}, 0, 0.5, -0.3, 3)) == Approx(0.5));
  CHECK(max_curvature(Clothoid::from({0, 0}, 0, 0.5, -0.3, 0)) == 0);
}

TEST_CASE("a parabola is curved most at its vertex") {
  // (2t - 1, (2t - 1)^2): curvature 2 at (0, 0), 2 / 5^1.5 at the ends.
  const QuadraticBezier parabola{{Point(-1, 1), Point(0, -1), Point(1, 1)}};
  CHECK(curvature(parabola, 0.5) == Approx(2));
  CHECK(curvature(parabola, 0) == Approx(2 / std::pow(5, 1.5)));
  CHECK(max_curvature(parabola) == Approx(2));
  // The half beyond the vertex is curved most at its end.
  CHECK(max_curvature(parabola.halves().second) == Approx(2));
}

TEST_CASE("a cusp and coinciding ends are infinitely curved, a straight piece is not") {
  CHECK(max_curvature(CubicBezier{{Point(0, 0), Point(1, 1), Point(0, 1), Point(1, 0)}}) ==
        infinity);
  CHECK(max_curvature(QuadraticBezier{{Point(0, 0), Point(0, 0), Point(1, 1)}}) == 0);
  CHECK(max_curvature(CubicBezier{{Point(0, 0), Point(0, 0), Point(1, 1), Point(2, 0)}}) ==
        infinity);
  CHECK(max_curvature(CubicBezier{{Point(0, 0), Point(3, 3), Point(1, 1), Point(2, 2)}}) == 0);
  CHECK(max_curvature(CubicBezier{{Point(2, 1), Point(2, 1), Point(2, 1), Point(2, 1)}}) == 0);
}

TEST_CASE("no sample of a Bezier piece is curved more than its maximum, and one nearly as much") {
  const std::uint64_t seed = 34;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto any = [&] { return Point(random.uniform(-5, 5), random.uniform(-5, 5)); };
    const auto check = [](const auto& piece) {
      const double most = max_curvature(piece);
      constexpr int samples = 2000;
      double largest = 0;
      for (int i = 0; i <= samples; ++i) {
        largest = std::fmax(largest, std::abs(curvature(piece, double(i) / samples)));
      }
      CHECK(largest <= most * (1 + 1e-9));
      if (most < 20) CHECK(largest >= 0.98 * most);  // a sharper one may lie between the samples
    };
    check(QuadraticBezier{{any(), any(), any()}});
    check(CubicBezier{{any(), any(), any(), any()}});
  }
}

}  // namespace
