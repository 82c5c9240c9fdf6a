// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/geometry/polygon.hpp"

namespace {

using namespace tutavia;

const Ring square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

Ring reversed(Ring ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

std::size_t edge_count(const Ring& ring) {
  std::size_t count = 0;
  detail::for_each_edge(ring, [&](const Point&, const Point&) { ++count; });
  return count;
}

/// Turns of the ring around p, from the angles under which p sees the edges.
int turns(const Ring& ring, const Point& p) {
  double angle = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    angle += turn_angle(ring[i] - p, ring[(i + 1) % ring.size()] - p);
  }
  return static_cast<int>(std::lround(angle / (2 * std::acos(-1.0))));
}

TEST_CASE("the edges of a ring close it and leave out equal neighbours", "[geometry]") {
  std::vector<std::pair<Point, Point>> edges;
  detail::for_each_edge(Ring{{0, 0}, {1, 0}, {1, 0}, {0, 2}, {0, 0}},
                        [&](const Point& a, const Point& b) { edges.emplace_back(a, b); });
  REQUIRE(edges.size() == 3);
  CHECK(edges[0] == std::pair(Point(0, 0), Point(1, 0)));
  CHECK(edges[1] == std::pair(Point(1, 0), Point(0, 2)));
  CHECK(edges[2] == std::pair(Point(0, 2), Point(0, 0)));
  CHECK(edge_count(square) == 4);
  CHECK(edge_count({}) == 0);
  CHECK(edge_count({{0, 0}, {1, 0}}) == 2);  // there and back
}

TEST_CASE("a ring of one distinct point has one edge, from it to itself", "[geometry]") {
  for (const Ring& ring : {Ring{{3, 4}}, Ring{{3, 4}, {3, 4}, {3, 4}}}) {
    std::size_t count = 0;
    detail::for_each_edge(ring, [&](const Point& a, const Point& b) {
      CHECK((a == Point(3, 4) && b == Point(3, 4)));
      ++count;
    });
    CHECK(count == 1);
  }
}

TEST_CASE("the signed area is positive counterclockwise, also far from the origin", "[geometry]") {
  CHECK(detail::signed_area_twice(square) == 32);
  CHECK(detail::signed_area_twice(reversed(square)) == -32);
  CHECK(detail::signed_area_twice({{0, 0}, {3, 0}, {0, 2}, {0, 0}}) == 6);
  Ring far = square;
  for (Point& p : far) p += Point(1e9, -1e9);
  CHECK(detail::signed_area_twice(far) == 32);
  CHECK(detail::signed_area_twice({{0, 0}, {2, 2}, {2, 0}, {0, 2}}) == 0);  // a figure eight
  CHECK(detail::signed_area_twice({{5, 5}}) == 0);
  CHECK(detail::signed_area_twice({}) == 0);
}

TEST_CASE("a ring winds once around its inside, either way, and never outside", "[geometry]") {
  CHECK(detail::winding_number(square, {1, 2}) == 1);
  CHECK(detail::winding_number(reversed(square), {1, 2}) == -1);
  for (const Point& outside : {Point(-1, 2), Point(5, 2), Point(2, 5), Point(2, -1), Point(-1, 0),
                               Point(-1, 4), Point(5, 4), Point(5, 0)}) {
    CHECK(detail::winding_number(square, outside) == 0);
  }
  CHECK(detail::winding_number({}, {0, 0}) == 0);
  CHECK(detail::winding_number({{1, 1}}, {0, 1}) == 0);
  CHECK(detail::winding_number({{1, 1}, {3, 1}}, {0, 1}) == 0);
}

TEST_CASE("vertices and horizontal edges at the height of the point count once", "[geometry]") {
  const Ring steps{{0, 0}, {6, 0}, {6, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}};
  CHECK(contains({steps}, {3, 2}));
  CHECK_FALSE(contains({steps}, {-1, 2}));
  CHECK_FALSE(contains({steps}, {7, 2}));
  CHECK_FALSE(contains({steps}, {1, 4}));
  const Ring diamond{{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  CHECK(contains({diamond}, {0, 0}));
  CHECK(contains({diamond}, {-0.5, 0}));
  CHECK_FALSE(contains({diamond}, {-2, 0}));
  CHECK_FALSE(contains({diamond}, {-2, 1}));
  CHECK_FALSE(contains({diamond}, {-2, -1}));
}

TEST_CASE("one unit in the last place decides between inside and outside", "[geometry]") {
  const Polygon triangle{{{0, 0}, {24, 24}, {0, 24}}};
  CHECK(contains(triangle, {0.5, std::nextafter(0.5, 1)}));
  CHECK_FALSE(contains(triangle, {0.5, std::nextafter(0.5, 0)}));
  CHECK(contains(triangle, {12, std::nextafter(12.0, 13)}));
  CHECK_FALSE(contains(triangle, {12, std::nextafter(12.0, 11)}));
}

TEST_CASE("an obstacle that crosses itself is solid wherever its ring winds", "[geometry]") {
  const Ring pentagram{{0, 5}, {-3, -4}, {5, 2}, {-5, 2}, {3, -4}};
  CHECK(std::abs(detail::winding_number(pentagram, {0, 0})) == 2);
  CHECK(contains({pentagram}, {0, 0}));
  CHECK(contains({pentagram}, {0, 4}));         // a tip
  CHECK_FALSE(contains({pentagram}, {0, -4}));  // between two tips
  const Ring eight{{0, 0}, {4, 4}, {4, 0}, {0, 4}};
  CHECK(detail::winding_number(eight, {0.5, 2}) == -detail::winding_number(eight, {3.5, 2}));
  CHECK(contains({eight}, {0.5, 2}));
  CHECK(contains({eight}, {3.5, 2}));
  CHECK_FALSE(contains({eight}, {2, 3}));
}

TEST_CASE("a hole is free only where its ring has an odd count", "[geometry]") {
  const Ring around{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}};
  const Ring pentagram{{0, 5}, {-3, -4}, {5, 2}, {-5, 2}, {3, -4}};
  for (const Ring& hole : {pentagram, reversed(pentagram)}) {
    CHECK(contains({around, {hole}}, {0, 0}));  // twice around: still solid
    CHECK_FALSE(contains({around, {hole}}, {0, 4}));
    CHECK(contains({around, {hole}}, {0, -4}));
  }
  const Polygon two{around,
                    {{{1, 1}, {2, 1}, {2, 2}, {1, 2}}, {{-2, 1}, {-1, 1}, {-1, 2}, {-2, 2}}}};
  CHECK_FALSE(contains(two, {1.5, 1.5}));
  CHECK_FALSE(contains(two, {-1.5, 1.5}));
  CHECK(contains(two, {0, 1.5}));
  CHECK_FALSE(contains(two, {10, 0}));
  CHECK_FALSE(contains({square, {{{5, 5}, {6, 5}, {6, 6}}}}, {5.75, 5.5}));  // a hole outside
  CHECK(contains({square, {{{2, 2}}}}, {1, 2}));                             // a hole without area
}

TEST_CASE("winding agrees with the sum of angles, however the ring is written", "[geometry]") {
  const std::uint64_t seed = 1;
  CAPTURE(seed);
  Random random(seed);
  int tested = 0;
  for (std::size_t round = 0; round < test::scaled(1000); ++round) {
    const auto whole = [&] { return static_cast<double>(random.below(7)); };
    Ring ring(1 + random.below(8));
    for (Point& p : ring) p = Point{whole(), whole()};
    const Point p{whole(), whole()};
    bool on_ring = false;
    detail::for_each_edge(ring, [&](const Point& a, const Point& b) {
      on_ring = on_ring || detail::compare_distance(p, a, b, 0, 0) == 0;
    });
    if (on_ring) continue;
    ++tested;
    INFO("round " << round);
    const int expected = detail::winding_number(ring, p);
    CHECK(expected == turns(ring, p));
    CHECK(detail::winding_number(reversed(ring), p) == -expected);
    Ring rotated = ring;
    std::rotate(rotated.begin(), rotated.begin() + 1, rotated.end());
    CHECK(detail::winding_number(rotated, p) == expected);
    ring.insert(ring.begin(), ring.front());  // a duplicate at the start
    ring.push_back(ring.front());             // and the start repeated at the end
    CHECK(detail::winding_number(ring, p) == expected);
  }
  CHECK(tested > 300);
}

}  // namespace
