// SPDX-License-Identifier: MIT
#include "tutavia/certify/vehicle/carried_point.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "support/vehicle_checker.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

/// The largest distance between a carried point's path and that of the reference.
template <class P>
double largest_gap(const P& piece, const Point& offset) {
  const Piece any(piece);
  const test::ReferenceMotion motion(any, Gear::forward);
  const auto path = carried(piece, offset);
  double gap = 0;
  for (int i = 0; i <= 20; ++i) {
    gap =
        std::fmax(gap, distance(path.point(i / 20.0), motion.carried(i / test::Real(20), offset)));
  }
  return gap;
}

TEST_CASE("a carried point moves on the path that its motion has in long double") {
  const std::uint64_t seed = 5;
  Random random(seed);
  const double pi = std::numbers::pi;
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    INFO("seed " << seed << ", round " << round);
    const double far = std::pow(10, random.uniform(0, 5)),
                 size = std::pow(10, random.uniform(-1, 2));
    const Point p{random.uniform(-far, far), random.uniform(-far, far)};
    const Point offset{size * random.uniform(-1, 1), size * random.uniform(-1, 1)};
    const Segment segment{p, {p.x() + random.uniform(-1, 1), p.y() + random.uniform(-1, 1)}};
    const Arc arc = Arc::around(p, size * random.uniform(0.1, 2), random.uniform(-pi, pi),
                                random.uniform(-2 * pi, 2 * pi));
    const Clothoid clothoid =
        Clothoid::from(p, random.uniform(-pi, pi), random.uniform(-1, 1) / size,
                       random.uniform(-1, 1) / size / size, size * random.uniform(0.1, 2));
    const double magnitude = far + 4 * size;
    CHECK(largest_gap(segment, offset) <= carrying_error(segment, offset, magnitude));
    CHECK(largest_gap(arc, offset) <= carrying_error(arc, offset, magnitude));
    CHECK(largest_gap(clothoid, offset) <=
          carrying_error(clothoid, offset, magnitude) + clothoid.evaluation_error());
  }
}

TEST_CASE("chords of a point carried along a clothoid deviate by no more than they say") {
  const Clothoid clothoid = Clothoid::from({1, 2}, 0.3, -0.5, 0.4, 4);
  for (const Point& offset : {Point(3, 1), Point(-1, -2), Point(0, 0)}) {
    CarriedClothoid part{clothoid, offset};
    for (int depth = 0; depth < 6; ++depth) {
      const Segment chord{part.start(), part.end()};
      double gap = 0;
      for (int i = 0; i <= 50; ++i) {
        gap = std::fmax(gap, distance(part.point(i / 50.0), chord.point(i / 50.0)));
      }
      CHECK(gap <= part.deviation());
      CHECK(gap > 0);
      CHECK(part.box().inflated(1e-12).contains(part.point(0.3)));
      part = depth % 2 == 0 ? part.halves().first : part.halves().second;
    }
  }
}

}  // namespace
