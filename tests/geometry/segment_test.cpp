// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/geometry/segment.hpp"

namespace {

using namespace tutavia;

Point any_point(Random& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

long double sampled_distance(const Point& p, const Segment& s, long double t) {
  const long double ux = static_cast<long double>(s.b.x()) - s.a.x();
  const long double uy = static_cast<long double>(s.b.y()) - s.a.y();
  return std::hypot(p.x() - (s.a.x() + t * ux), p.y() - (s.a.y() + t * uy));
}

/// By ternary search: the distance is a convex function of the parameter.
long double searched_distance(const Point& p, const Segment& s) {
  long double low = 0, high = 1;
  for (int i = 0; i < 160; ++i) {
    const long double left = (2 * low + high) / 3, right = (low + 2 * high) / 3;
    if (sampled_distance(p, s, left) < sampled_distance(p, s, right)) {
      high = right;
    } else {
      low = left;
    }
  }
  return std::min(
      {sampled_distance(p, s, low), sampled_distance(p, s, 0), sampled_distance(p, s, 1)});
}

TEST_CASE("a segment reaches both of its ends exactly", "[geometry]") {
  const std::uint64_t seed = 1;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    const Segment s{any_point(random, 1e9), any_point(random, round % 2 == 0 ? 1 : 1e9)};
    INFO("round " << round);
    CHECK(s.point(0) == s.a);
    CHECK(s.point(1) == s.b);
    CHECK((s.point(0.25) - (0.75 * s.a + 0.25 * s.b)).norm() < 1e-6);
    CHECK((s.point(0.75) - (0.25 * s.a + 0.75 * s.b)).norm() < 1e-6);
  }
}

TEST_CASE("a segment knows its length, box and directions", "[geometry]") {
  const Segment s{{1, 5}, {4, 1}};
  CHECK(s.length() == 5);
  CHECK(s.length_to(0.5) == 2.5);
  CHECK(s.derivative(0.3) == Point(3, -4));
  CHECK(s.second_derivative(0.3) == Point(0, 0));
  CHECK(s.start_direction() == s.end_direction());
  CHECK(s.box().min == Point(1, 1));
  CHECK(s.box().max == Point(4, 5));
  CHECK(s.is_finite());
  CHECK_FALSE(Segment{{1, 5}, {4, std::numeric_limits<double>::infinity()}}.is_finite());
}

TEST_CASE("the distance to a segment is that to its inside or the nearer end", "[geometry]") {
  const Segment s{{0, 0}, {10, 0}};
  CHECK(distance({4, 3}, s) == 3);
  CHECK(distance({4, -3}, s) == 3);
  CHECK(distance({-3, 4}, s) == 5);
  CHECK(distance({13, -4}, s) == 5);
  CHECK(distance({7, 0}, s) == 0);
  CHECK(distance({3, 4}, Segment{{0, 0}, {0, 0}}) == 5);
  CHECK(s.nearest_parameter({4, 3}) == 0.4);
  CHECK(s.nearest_parameter({-1, 3}) == 0);
  CHECK(s.nearest_parameter({11, 3}) == 1);
  CHECK((Segment{{2, 2}, {2, 2}}).nearest_parameter({5, 5}) == 0);
}

TEST_CASE("the distance to a segment errs by less than 12 u M", "[geometry]") {
  const std::uint64_t seed = 1;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(500); ++round) {
    const double reach = std::pow(10, static_cast<double>(round % 4) * 3);  // 1 to 1e9
    Segment s{any_point(random, reach), any_point(random, reach)};
    if (round % 5 == 0) s.b = s.a + any_point(random, 1e-9 * reach);  // far shorter than it is away
    Point p = any_point(random, reach);
    if (round % 3 == 0) p = s.point(random.uniform(-0.1, 1.1)) + any_point(random, 1e-9);
    const double magnitude = std::max(detail::max_magnitude(p), s.box().largest_coordinate());
    INFO("round " << round << " reach " << reach);
    const auto expected = static_cast<double>(searched_distance(p, s));
    CHECK(std::abs(distance(p, s) - expected) <= 12 * 0x1p-53 * magnitude);
    CHECK(std::abs((s.point(s.nearest_parameter(p)) - p).norm() - expected) <= 1e-14 * magnitude);
  }
}

TEST_CASE("an approach is no longer than any sampled gap, and its place attains it", "[geometry]") {
  const std::uint64_t seed = 2;
  CAPTURE(seed);
  Random random(seed);
  constexpr int samples = 1000;
  int meetings = 0;
  for (std::size_t round = 0; round < test::scaled(100); ++round) {
    const Segment s{any_point(random, 1), any_point(random, 1)};
    const Segment other{any_point(random, 1), any_point(random, 1)};
    const detail::ClosestApproach found = detail::closest_approach(s, other);
    meetings += found.distance == 0;
    double least = 10;
    for (int i = 0; i <= samples; ++i) {
      least = std::min(least, distance(s.point(static_cast<double>(i) / samples), other));
    }
    INFO("round " << round);
    CHECK(found.distance <= least + 1e-15);
    CHECK(least <= found.distance + 0.5 * s.length() / samples + 1e-15);
    CHECK((found.parameter >= 0 && found.parameter <= 1));
    CHECK(distance(s.point(found.parameter), other) == Approx(found.distance).margin(1e-13));
    CHECK(detail::closest_approach(other, s).distance == found.distance);
    CHECK((found.distance == 0) == detail::segments_intersect(s.a, s.b, other.a, other.b));
  }
  CHECK(meetings > 10);
}

TEST_CASE("segments that touch, overlap or are points approach to where they meet", "[geometry]") {
  const Segment s{{0, 0}, {8, 4}};
  const auto meets = [&](const Segment& other, double parameter) {
    const detail::ClosestApproach found = detail::closest_approach(s, other);
    CHECK(found.distance == 0);
    CHECK(found.parameter == parameter);
    CHECK(detail::closest_approach(other, s).distance == 0);
  };
  meets({{0, 3}, {5, -2}}, 0.25);  // crosses
  meets({{4, 2}, {4, 9}}, 0.5);    // touches with its start
  meets({{3, 9}, {6, 3}}, 0.75);   // touches with its end
  meets({{8, 4}, {9, 0}}, 1);      // shares an end
  meets({{4, 2}, {4, 2}}, 0.5);    // is a point of it
  const double late =
      detail::closest_approach(s, {{6, 3}, {16, 8}}).parameter;  // overlaps beyond the end
  CHECK((late >= 0.75 && late <= 1));
  const double early =
      detail::closest_approach(s, {{-2, -1}, {2, 1}}).parameter;  // overlaps before the start
  CHECK((early >= 0 && early <= 0.25));
  const double inside = detail::closest_approach(s, {{2, 1}, {6, 3}}).parameter;
  CHECK((inside >= 0.25 && inside <= 0.75));
  CHECK(detail::closest_approach(s, {{2, 1}, {6, 3}}).distance == 0);
  CHECK(detail::closest_approach(s, {{-8, -4}, {16, 8}}).distance == 0);  // lies within the other
}

TEST_CASE("the gap between parallel or single-point segments is their distance", "[geometry]") {
  const Segment s{{0, 0}, {10, 0}};
  CHECK(detail::closest_approach(s, {{3, 2}, {20, 2}}).distance == 2);
  CHECK(detail::closest_approach(s, {{13, 4}, {20, 4}}).distance == 5);
  CHECK(detail::closest_approach(s, {{13, 4}, {20, 4}}).parameter == 1);
  CHECK(detail::closest_approach(s, {{12, 0}, {20, 0}}).distance == 2);
  CHECK(detail::closest_approach(s, {{4, -3}, {4, -3}}).distance == 3);
  CHECK(detail::closest_approach(s, {{4, -3}, {4, -3}}).parameter == 0.4);
  CHECK(detail::closest_approach(Segment{{4, -3}, {4, -3}}, s).distance == 3);
  CHECK(detail::closest_approach(Segment{{1, 1}, {1, 1}}, {{4, 5}, {4, 5}}).distance == 5);
}

TEST_CASE("the place where nearly collinear segments meet lies on both") {
  const std::uint64_t seed = 7;
  CAPTURE(seed);
  Random random(seed);
  const auto hundredths = [&] { return static_cast<double>(random.below(1000)) / 100; };
  for (std::size_t round = 0; round < test::scaled(2000); ++round) {
    const Segment s{{hundredths(), hundredths()}, {hundredths(), hundredths()}};
    const Segment on{s.point(random.uniform(-0.5, 1)), s.point(random.uniform(0, 1.5))};
    const detail::ClosestApproach found = detail::closest_approach(s, on);
    INFO("round " << round);
    CHECK(distance(s.point(found.parameter), on) <= found.distance + 1e-13);
  }
}

TEST_CASE("parts of a segment and its reverse have exact ends", "[geometry]") {
  const std::uint64_t seed = 8;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Segment s{any_point(random, 1e6), any_point(random, round % 2 == 0 ? 1 : 1e6)};
    const double from = random.uniform(), to = random.uniform(from, 1), t = random.uniform();
    const Segment part = s.part(from, to);
    CHECK(part.a == s.point(from));
    CHECK(part.b == s.point(to));
    CHECK((part.point(t) - s.point(from + t * (to - from))).norm() < 1e-8);
    CHECK(s.part(0, to).a == s.a);
    CHECK(s.part(from, 1).b == s.b);
    CHECK(s.part(0, to).b == s.part(to, 1).a);
    CHECK(s.part(0, 0).b == s.a);
    CHECK(s.part(1, 1).a == s.b);
    CHECK(s.reversed().a == s.b);
    CHECK(s.reversed().b == s.a);
  }
}

}  // namespace
