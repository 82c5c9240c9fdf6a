// SPDX-License-Identifier: MIT
#include "tutavia/space/index/field_minimum.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;

TEST_CASE("the bound between two clearances is that of the worst obstacle") {
  const std::uint64_t seed = 7110;
  INFO("seed " << seed);
  Random random(seed);
  std::size_t exact = 0;
  for (std::size_t round = 0; round < test::scaled(2000); ++round) {
    INFO("round " << round);
    const Point obstacle{random.uniform(-3, 3), random.uniform(0.01, 2)};
    const Segment s{{-1, 0}, {1, 0}};
    const double at_a = distance(obstacle, s.a), at_b = distance(obstacle, s.b);
    const double expected = distance(obstacle, s);
    const double bound = detail::least_between(at_a, at_b, 2);
    CHECK(bound <= expected);
    CHECK(bound >= expected - 1e-12);
    exact += bound > expected - 1e-12 ? 1 : 0;
    // Lower values at the ends give no higher bound.
    CHECK(detail::least_between(0.9 * at_a, 0.9 * at_b, 2) <= bound);
  }
  CHECK(exact > 1000);
  CHECK(detail::least_between(1, 1, 4) == -1);   // an obstacle may lie in the middle
  CHECK(detail::least_between(-1, 3, 4) == -1);  // inside
  CHECK(detail::least_between(2, 3, 0) == 2);
}

TEST_CASE("the bound of an arc holds for every obstacle point") {
  const std::uint64_t seed = 7111;
  INFO("seed " << seed);
  Random random(seed);
  std::size_t close = 0;
  for (std::size_t round = 0; round < test::scaled(2000); ++round) {
    INFO("round " << round);
    const Point obstacle{random.uniform(-3, 3), random.uniform(-3, 3)};
    const Arc arc =
        Arc::around({0, 0}, random.uniform(0.1, 2), random.uniform(-3, 3), random.uniform(-6, 6));
    const double expected = distance(obstacle, arc.point(arc.nearest_parameter(obstacle)));
    const double bound =
        detail::least_between(distance(obstacle, arc.a), distance(obstacle, arc.b), arc, 1);
    CHECK(bound <= expected + 1e-14);
    const auto found = detail::least_along(arc, 100.0, 1e-6,
                                           [&](const Point& p) { return distance(p, obstacle); });
    CHECK(found.lower <= expected + 1e-14);
    CHECK(found.lower >= expected - 1e-6);
    close += bound > expected - 0.1 ? 1 : 0;
  }
  CHECK(close > 200);
}

TEST_CASE("the search for the least value takes few evaluations, and stops at its cap") {
  std::size_t evaluations = 0;
  const auto wall = [&evaluations](const Point& p) {
    ++evaluations;
    return p.y();
  };
  const Segment along{{0, 1}, {10, 1}};
  const auto exact = detail::least_along(along, 5, 1e-6, wall);
  CHECK(exact.lower >= 1 - 1e-6);
  CHECK(exact.lower <= 1);
  CHECK(evaluations < 10'000);
  evaluations = 0;
  CHECK(detail::least_along(along, 0.5, 1e-6, wall).lower >= 0.5);
  CHECK(evaluations < 20);
  evaluations = 0;
  CHECK(detail::least_along(Segment{{0, 0}, {10, 0}}, 5, 1e-9, wall).lower <= 0);  // gives up
  CHECK(evaluations == detail::FieldParts::max_evaluations);
}

TEST_CASE("a segment keeps a clearance if all of its parts are proved") {
  const auto origin = [](const Point& p) { return p.norm(); };
  const Segment s{{-3, 0.5}, {4, 0.5}};
  CHECK(detail::keeps_clearance(s, 0.5 - 1e-12, 1e-3, origin));
  CHECK_FALSE(detail::keeps_clearance(s, 0.5 + 1e-12, 1e-3, origin));
  CHECK_FALSE(detail::keeps_clearance(s, 4, 1e-3, origin));
  const auto wall = [](const Point& p) { return p.y(); };
  CHECK(detail::keeps_clearance(s, 0.4, 1e-3, wall));
  CHECK_FALSE(detail::keeps_clearance(s, 0.5, 1e-3, wall));  // parts would have no length
}

}  // namespace
