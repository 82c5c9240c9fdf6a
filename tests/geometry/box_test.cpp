// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/geometry/box.hpp"

namespace {

using namespace tutavia;

TEST_CASE("the default box contains nothing", "[geometry]") {
  const Box empty;
  CHECK_FALSE(empty.contains(Point(0, 0)));
  CHECK_FALSE(empty.contains(Point(1e308, -1e308)));
  CHECK_FALSE(empty.inflated(1e300).contains(Point(0, 0)));
  CHECK_FALSE(Box::around({}).contains(Point(0, 0)));
}

TEST_CASE("a box that includes one point contains that point alone", "[geometry]") {
  Box box;
  box.include({1e9, -3});
  CHECK(box.contains(Point(1e9, -3)));
  CHECK_FALSE(box.contains(Point(std::nextafter(1e9, 2e9), -3)));
  CHECK_FALSE(box.contains(Point(1e9, std::nextafter(-3.0, 0.0))));
  CHECK(box.width() == 0);
  CHECK(box.height() == 0);
}

TEST_CASE("a box is closed: it contains its edges and corners", "[geometry]") {
  const Box box{{-1, 2}, {3, 5}};
  for (const double x : {-1.0, 1.0, 3.0}) {
    for (const double y : {2.0, 3.5, 5.0}) CHECK(box.contains(Point(x, y)));
  }
  CHECK_FALSE(box.contains(Point(std::nextafter(-1.0, -2.0), 3)));
  CHECK_FALSE(box.contains(Point(std::nextafter(3.0, 4.0), 3)));
  CHECK_FALSE(box.contains(Point(0, std::nextafter(2.0, 1.0))));
  CHECK_FALSE(box.contains(Point(0, std::nextafter(5.0, 6.0))));
  CHECK_FALSE(box.contains(Point(std::nan(""), 3)));
}

TEST_CASE("a box contains itself and every box within it, not one that overlaps", "[geometry]") {
  const Box box{{0, 0}, {4, 3}};
  CHECK(box.contains(box));
  CHECK(box.contains(Box{{1, 1}, {4, 2}}));
  CHECK_FALSE(box.contains(Box{{1, 1}, {4.5, 2}}));
  CHECK_FALSE(box.contains(Box{{-1, 1}, {2, 2}}));
  CHECK_FALSE(box.contains(Box{{5, 5}, {6, 6}}));
  CHECK_FALSE(Box{{1, 1}, {4, 2}}.contains(box));
}

TEST_CASE("around() is the least box that holds its points", "[geometry]") {
  const Box box = Box::around({{2, -7}, {-1, 4}, {1, 9}, {2, -7}});
  CHECK(box.min == Point(-1, -7));
  CHECK(box.max == Point(2, 9));
  CHECK(box.width() == 3);
  CHECK(box.height() == 16);
  CHECK(box.largest_coordinate() == 9);
  CHECK(Box::around({{-20, 1}, {3, 2}}).largest_coordinate() == 20);
}

TEST_CASE("inflated() moves every side out, or in where the margin is negative", "[geometry]") {
  const Box box{{0, 10}, {4, 20}};
  CHECK(box.inflated(0.5).min == Point(-0.5, 9.5));
  CHECK(box.inflated(0.5).max == Point(4.5, 20.5));
  CHECK(box.inflated(-2).width() == 0);
  CHECK(box.inflated(-2).contains(Point(2, 15)));
  CHECK_FALSE(box.inflated(-2.5).contains(Point(2, 15)));
}

TEST_CASE("inflating reaches exactly the points within the margin along both axes", "[geometry]") {
  const std::uint64_t seed = 1;
  CAPTURE(seed);
  Random random(seed);
  const auto whole = [&] { return static_cast<double>(random.below(11)); };
  for (std::size_t round = 0; round < test::scaled(500); ++round) {
    const Box box = Box::around({{whole(), whole()}, {whole(), whole()}});
    const Point p{whole(), whole()};
    const double margin = static_cast<double>(random.below(4));
    INFO("round " << round);
    const double dx = std::fmax(0, std::fmax(box.min.x() - p.x(), p.x() - box.max.x()));
    const double dy = std::fmax(0, std::fmax(box.min.y() - p.y(), p.y() - box.max.y()));
    CHECK(box.inflated(margin).contains(p) == (std::fmax(dx, dy) <= margin));
  }
}

TEST_CASE("boxes meet where they share a point") {
  const Box box{{0, 0}, {2, 1}};
  CHECK(box.meets({{1, 0.5}, {3, 3}}));
  CHECK(box.meets({{0.5, 0.2}, {0.6, 0.3}}));
  CHECK(box.meets({{2, 1}, {3, 3}}));
  CHECK_FALSE(box.meets({{2.1, 0}, {3, 1}}));
  CHECK_FALSE(box.meets({{0, -2}, {2, -0.1}}));
  CHECK_FALSE(box.meets(Box{}));
  CHECK(box.meets({{std::nan(""), 0}, {1, 1}}));
}

}  // namespace
