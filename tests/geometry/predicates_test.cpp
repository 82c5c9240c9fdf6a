// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/geometry/predicates.hpp"

namespace {

using namespace tutavia;

__extension__ typedef __int128 Wide;

int sign(Wide value) { return (value > 0) - (value < 0); }

int integer_orientation(Wide ax, Wide ay, Wide bx, Wide by, Wide cx, Wide cy) {
  return sign((bx - ax) * (cy - ay) - (by - ay) * (cx - ax));
}

/// The same for points that become integers when multiplied by `scale`.
int scaled_orientation(const Point& a, const Point& b, const Point& c, double scale) {
  const auto whole = [&](double x) { return Wide{static_cast<std::int64_t>(scale * x)}; };
  return integer_orientation(whole(a.x()), whole(a.y()), whole(b.x()), whole(b.y()), whole(c.x()),
                             whole(c.y()));
}

struct IntegerPoint {
  int x, y;
  Point point(double scale = 1) const { return {scale * x, scale * y}; }
};

bool lies_on(IntegerPoint p, IntegerPoint a, IntegerPoint b) {
  return (b.x - a.x) * (p.y - a.y) == (b.y - a.y) * (p.x - a.x) &&
         (p.x - a.x) * (p.x - b.x) + (p.y - a.y) * (p.y - b.y) <= 0;
}

/// By solving a + t (b - a) = c + u (d - c) in fractions.
bool meet(IntegerPoint a, IntegerPoint b, IntegerPoint c, IntegerPoint d) {
  const int ux = b.x - a.x, uy = b.y - a.y, vx = d.x - c.x, vy = d.y - c.y;
  int denominator = ux * vy - uy * vx;
  if (denominator == 0) {
    return lies_on(a, c, d) || lies_on(b, c, d) || lies_on(c, a, b) || lies_on(d, a, b);
  }
  int t = (c.x - a.x) * vy - (c.y - a.y) * vx, u = (c.x - a.x) * uy - (c.y - a.y) * ux;
  if (denominator < 0) denominator = -denominator, t = -t, u = -u;
  return 0 <= t && t <= denominator && 0 <= u && u <= denominator;
}

TEST_CASE("orientation is exact where rounding misplaces points near a line", "[geometry]") {
  // Kettner et al. 2008, "Classroom examples of robustness problems", section 3.
  const Point b(12, 12), c(24, 24);
  int misled = 0;
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) {
      const Point p(0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53);
      const int expected = scaled_orientation(p, b, c, 0x1p53);
      INFO("i " << i << " j " << j);
      REQUIRE(orientation(p, b, c) == expected);
      REQUIRE(orientation(b, c, p) == expected);
      REQUIRE(orientation(c, b, p) == -expected);
      const double rounded = cross(b - p, c - p);
      if ((rounded > 0) - (rounded < 0) != expected) ++misled;
    }
  }
  CHECK(misled > 100);  // else the test proves nothing
}

TEST_CASE("orientation is exact next to lines through large coordinates", "[geometry]") {
  const std::uint64_t seed = 1;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(2000); ++round) {
    const double reach = round % 2 == 0 ? 1e6 : 1e9;
    const auto whole = [&](double limit) { return std::round(random.uniform(-limit, limit)); };
    const Point a{whole(reach), whole(reach)}, d{whole(1000), whole(1000)};
    const Point b = a + whole(1e5) * d, on_line = a + whole(1e5) * d;
    const Point nudge{whole(1.4), whole(1.4)}, c = on_line + nudge;
    INFO("round " << round);
    const int expected = scaled_orientation(a, b, c, 1);
    CHECK(orientation(a, b, c) == expected);
    CHECK(orientation(c, a, b) == expected);
    CHECK(orientation(a, c, b) == -expected);
    CHECK(orientation(a / 1024, b / 1024, c / 1024) == expected);
  }
}

TEST_CASE("orientation is exact at the ends of the permitted range", "[geometry]") {
  const double huge = 0x1p400, tiny = 0x1p-400;
  CHECK(orientation({0, 0}, {huge, huge}, {tiny, tiny}) == 0);
  CHECK(orientation({0, 0}, {huge, huge}, {tiny, std::nextafter(tiny, 1)}) == 1);
  CHECK(orientation({0, 0}, {huge, huge}, {std::nextafter(tiny, 1), tiny}) == -1);
  CHECK(orientation({tiny, tiny}, {huge, huge}, {-huge, -huge}) == 0);
  CHECK(orientation({tiny, 0}, {huge, huge}, {-huge, -huge}) == 1);
  CHECK(orientation({tiny, tiny}, {std::nextafter(tiny, 1), tiny}, {tiny, -tiny}) == -1);
  CHECK(orientation({3, 4}, {3, 4}, {-huge, tiny}) == 0);
}

TEST_CASE("segments meet exactly when fractions say so, in every case on a 4 x 4 grid",
          "[geometry]") {
  const auto at = [](int i) { return IntegerPoint{i % 4, i / 4 % 4}; };
  for (const double scale : {1.0, 0x1p398, 0x1p-400}) {
    CAPTURE(scale);
    int meetings = 0;
    for (int i = 0; i < 16 * 16 * 16 * 16; ++i) {
      const IntegerPoint a = at(i), b = at(i / 16), c = at(i / 256), d = at(i / 4096);
      const bool expected = meet(a, b, c, d);
      meetings += expected;
      if (detail::segments_intersect(a.point(scale), b.point(scale), c.point(scale),
                                     d.point(scale)) != expected) {
        FAIL("case " << i << ": expected " << expected);
      }
    }
    CHECK((1000 < meetings && meetings < 60000));
  }
}

TEST_CASE("segments that miss each other by one unit in the last place do not meet", "[geometry]") {
  const Point a(0, 0), b(24, 24), c(0.5, 0.5), above(0.5, std::nextafter(0.5, 1.0));
  CHECK(detail::segments_intersect(a, b, c, {0, 12}));
  CHECK_FALSE(detail::segments_intersect(a, b, above, {0, 12}));
  CHECK(detail::segments_intersect(a, b, above, {12, 0}));
  CHECK_FALSE(detail::segments_intersect(a, b, above, above));
  CHECK(detail::segments_intersect({1e9, 0}, {1e9, 1}, {1e9, 1}, {2e9, 7}));
  CHECK_FALSE(
      detail::segments_intersect({1e9, 0}, {1e9, 1}, {std::nextafter(1e9, 2e9), 1}, {2e9, 7}));
}

TEST_CASE("compare_distance knows a tie from one unit in the last place", "[geometry]") {
  const auto check = [](const Point& p, const Point& a, const Point& b, double distance) {
    for (const bool flipped : {false, true}) {
      const Point &from = flipped ? b : a, &to = flipped ? a : b;
      CHECK(detail::compare_distance(p, from, to, distance, 0) == 0);
      CHECK(detail::compare_distance(p, from, to, 0, distance) == 0);
      CHECK(detail::compare_distance(p, from, to, 0.25 * distance, 0.75 * distance) == 0);
      CHECK(detail::compare_distance(p, from, to, std::nextafter(distance, 0), 0) == 1);
      CHECK(detail::compare_distance(p, from, to, std::nextafter(distance, 1e300), 0) == -1);
      CHECK(detail::compare_distance(p, from, to, distance, 0x1p-300) ==
            -1);  // the sum is not rounded
    }
  };
  check({3, 4}, {0, 0}, {0, 0}, 5);     // a point
  check({3, 4}, {0, 0}, {-3, -1}, 5);   // the end of a segment
  check({3, 4}, {0, 0}, {4, -3}, 5);    // its end, at a right angle
  check({-1, 5.5}, {0, 0}, {4, 3}, 5);  // its inside
  check({1, 1e9}, {-1e9, 0}, {1e9, 0}, 1e9);
  const double s = 0x1p390;
  check({3 * s, 4 * s}, {0, 0}, {-s, 0}, 5 * s);
}

TEST_CASE("a point on the segment lies at distance 0, next to it further", "[geometry]") {
  const Point a(0, 0), b(24, 24);
  CHECK(detail::compare_distance({0.5, 0.5}, a, b, 0, 0) == 0);
  CHECK(detail::compare_distance({0.5, std::nextafter(0.5, 1)}, a, b, 0, 0) == 1);
  CHECK(detail::compare_distance({0.5, std::nextafter(0.5, 1)}, a, b, 0x1p-54, 0) == 1);
  CHECK(detail::compare_distance({0.5, std::nextafter(0.5, 1)}, a, b, 0x1p-53, 0) == -1);
  CHECK(detail::compare_distance(a, a, a, 0, 0) == 0);
}

TEST_CASE("compare_distance agrees with integer arithmetic on a small grid", "[geometry]") {
  const std::uint64_t seed = 2;
  CAPTURE(seed);
  Random random(seed);
  int ties = 0;
  for (std::size_t round = 0; round < test::scaled(5000); ++round) {
    const auto whole = [&] { return static_cast<int>(random.below(15)); };
    const IntegerPoint p{whole(), whole()}, a{whole(), whole()}, b{whole(), whole()};
    const int r = static_cast<int>(random.below(8));
    const int ux = b.x - a.x, uy = b.y - a.y, vx = p.x - a.x, vy = p.y - a.y;
    const int along = ux * vx + uy * vy, square = ux * ux + uy * uy, area = ux * vy - uy * vx;
    const int wx = p.x - b.x, wy = p.y - b.y;
    const int expected = along <= 0        ? sign(vx * vx + vy * vy - r * r)
                         : along >= square ? sign(wx * wx + wy * wy - r * r)
                                           : sign(area * area - r * r * square);
    ties += expected == 0;
    INFO("round " << round);
    CHECK(detail::compare_distance(p.point(), a.point(), b.point(), r, 0) == expected);
    CHECK(detail::compare_distance(p.point(0.125), b.point(0.125), a.point(0.125), 0.125 * r, 0) ==
          expected);
  }
  CHECK(ties > 50);
}

}  // namespace
