// SPDX-License-Identifier: MIT
#include "tutavia/geometry/tangent/tangent_line.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

using std::numbers::pi;

TEST_CASE("an outer tangent of equal circles runs beside their centres, an inner one between") {
  const auto outer = tangent_line({{0, 0}, 1, 1}, {{10, 0}, 1, 1}).value();
  CHECK(outer.length == 10);
  CHECK(outer.from == Point(0, -1));  // a circle to the left of the path
  CHECK(outer.to == Point(10, -1));
  // 6-8-10: radii of 3 on either side, centres 10 apart.
  const auto inner = tangent_line({{0, 0}, 3, 1}, {{10, 0}, 3, -1}).value();
  CHECK(inner.length == Approx(8));
  CHECK(inner.direction.x() == Approx(0.8));
  CHECK(std::abs(inner.direction.y()) == Approx(0.6));
  CHECK(cross(inner.direction, Point(0, 0) - inner.from) == Approx(3));  // on the left
  CHECK(cross(inner.direction, Point(10, 0) - inner.to) == Approx(-3));  // on the right
}

TEST_CASE("circles within one another have no tangent, touching ones have one of length 0") {
  CHECK_FALSE(tangent_line({{0, 0}, 5, 1}, {{1, 0}, 1, 1}));
  CHECK_FALSE(tangent_line({{0, 0}, 2, 1}, {{3, 0}, 2, -1}));  // overlapping, on different sides
  CHECK_FALSE(tangent_line({{1, 2}, 0, 1}, {{1, 2}, 0, 1}));   // one point
  CHECK(tangent_line({{0, 0}, 2, 1}, {{4, 0}, 2, -1})->length == 0);
  CHECK(tangent_line({{0, 0}, 2, 1}, {{3, 0}, 2, 1})->length == 3);  // overlapping, on one side
}

TEST_CASE("between points a tangent is the segment") {
  const auto tangent = tangent_line({{1, 1}, 0, 1}, {{4, 5}, 0, -1}).value();
  CHECK(tangent.from == Point(1, 1));
  CHECK(tangent.to == Point(4, 5));
  CHECK(tangent.length == 5);
}

TEST_CASE("a tangent touches both circles, each on its side, and is perpendicular to the radii") {
  const std::uint64_t seed = 31;
  Random random(seed);
  std::size_t found = 0, none = 0;
  for (std::size_t round = 0; round < test::scaled(1000); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto circle = [&] {
      return OrientedCircle{{random.uniform(-5, 5), random.uniform(-5, 5)},
                            random.below(4) == 0 ? 0 : random.uniform(0, 4),
                            random.below(2) == 0 ? 1 : -1};
    };
    const OrientedCircle a = circle(), b = circle();
    const auto tangent = tangent_line(a, b);
    const double needed = std::abs(b.side * b.radius - a.side * a.radius);
    CHECK(tangent.has_value() == (distance(a.center, b.center) >= needed));
    ++(tangent ? found : none);
    if (!tangent) continue;
    CHECK(tangent->direction.norm() == Approx(1));
    CHECK(distance(tangent->from, tangent->to) == Approx(tangent->length).margin(1e-6));
    CHECK(distance(offset_along(tangent->from, tangent->length, tangent->direction), tangent->to) <
          1e-12);
    for (const auto& [touch, c] : {std::pair{tangent->from, a}, {tangent->to, b}}) {
      CHECK(distance(touch, c.center) == Approx(c.radius).margin(1e-12));
      CHECK(std::abs((c.center - touch).dot(tangent->direction)) < 1e-12);
      CHECK(c.side * cross(tangent->direction, c.center - touch) >= -1e-12);
    }
  }
  CHECK(std::min(found, none) > test::scaled(50));
}

/// The arcs by which a path goes around the unit circle at the origin.
std::vector<Arc> arcs(double from, double to, double turn) {
  std::vector<Arc> result;
  const auto at = [](double angle) { return Point(std::cos(angle), std::sin(angle)); };
  for_each_arc({{0, 0}, 1, 1}, at(from), at(to), turn, 1e-9,
               [&](const Arc& arc) { result.push_back(arc); });
  return result;
}

double sweep_of(const std::vector<Arc>& parts) {
  double sum = 0;
  for (const Arc& arc : parts) sum += arc.sweep;
  return sum;
}

TEST_CASE("arcs turn as far as asked, to the nearest full turn, half a circle at a time") {
  CHECK(sweep_of(arcs(0, 1, 1)) == Approx(1));
  CHECK(sweep_of(arcs(0, 1, -5)) == Approx(1 - 2 * pi));
  CHECK(sweep_of(arcs(0, 1, 7)) == Approx(1 + 2 * pi));
  CHECK(sweep_of(arcs(0, 0, 2 * pi)) == Approx(2 * pi));
  CHECK(arcs(0, 1, 1).size() == 1);
  CHECK(arcs(0, pi, pi).size() == 1);
  CHECK(arcs(0, 0, 2 * pi).size() == 2);
  CHECK(arcs(0, 1, 1 + 2 * pi).size() == 3);
  CHECK(arcs(2, 2, 0).empty());
  const auto parts = arcs(0.5, 2.5, 2 + 4 * pi);
  CHECK(parts.front().a == Point(std::cos(0.5), std::sin(0.5)));
  CHECK(parts.back().b == Point(std::cos(2.5), std::sin(2.5)));
  for (std::size_t i = 1; i < parts.size(); ++i) CHECK(parts[i].a == parts[i - 1].b);
}

TEST_CASE("around a point there is no arc") {
  int visits = 0;
  for_each_arc({{0, 0}, 0, 1}, {0, 0}, {0, 0}, 2, 1e-9, [&](const Arc&) { ++visits; });
  CHECK(visits == 0);
}

}  // namespace
