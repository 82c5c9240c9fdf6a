// SPDX-License-Identifier: MIT
#include "tutavia/space/index/nearest_feature.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;
using detail::nearest_feature;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Feature {
  Segment core;
  double radius;
  std::uint32_t obstacle, edge;
};

/// Looks among features as an index does: those that meet the window, nearest or not.
struct Features {
  std::vector<Feature> all;

  Box extent() const {
    Box box;
    for (const Feature& f : all) {
      box.include(f.core.box().inflated(f.radius).min);
      box.include(f.core.box().inflated(f.radius).max);
    }
    return box;
  }
  template <class P>
  NearestObstacle nearest(const P& piece, double cap, double first_reach = 1) const {
    return nearest_feature(piece, cap, first_reach, extent(), [&](double reach, const auto& visit) {
      const Box window = piece.box().inflated(reach);
      for (const Feature& f : all) {
        const Box box = f.core.box().inflated(f.radius);
        if (box.max.x() < window.min.x() || box.min.x() > window.max.x() ||
            box.max.y() < window.min.y() || box.min.y() > window.max.y()) {
          continue;
        }
        visit(f.core, f.radius, f.obstacle, f.edge);
      }
    });
  }
};

const Segment at_origin{{0, 0}, {0, 0}};

TEST_CASE("the nearest feature is found beyond the first window, a disc nearer by its radius") {
  const Features features{{{{{0, 50}, {9, 50}}, 0, 3, 1}, {{{100, 0}, {100, 0}}, 60, 4, 0}}};
  const NearestObstacle found = features.nearest(at_origin, infinity);
  CHECK(found.distance == 40);
  CHECK(found.obstacle == 4);
  CHECK(features.nearest(at_origin, 41).obstacle == 4);
}

TEST_CASE("a feature that is no nearer than the cap is none") {
  const Features features{{{{{0, 5}, {9, 5}}, 0, 3, 1}}};
  for (const double cap : {4.0, 5.0, 0.0}) {
    CAPTURE(cap);
    const NearestObstacle found = features.nearest(at_origin, cap);
    CHECK(found.obstacle == NearestObstacle::none);
    CHECK(found.distance == cap);
  }
  const NearestObstacle nothing = Features{}.nearest(at_origin, infinity);
  CHECK(nothing.obstacle == NearestObstacle::none);
  CHECK(nothing.distance == infinity);
}

TEST_CASE("of equally near features the one with the lower numbers is given, in any order") {
  std::vector<Feature> all{
      {{{5, -1}, {5, 1}}, 0, 2, 7}, {{{-5, -1}, {-5, 1}}, 0, 1, 9}, {{{-1, 5}, {1, 5}}, 0, 1, 8}};
  for (int i = 0; i < 6; ++i) {
    std::next_permutation(all.begin(), all.end(), [](const Feature& a, const Feature& b) {
      return 10 * a.obstacle + a.edge < 10 * b.obstacle + b.edge;
    });
    const NearestObstacle found = Features{all}.nearest(at_origin, infinity);
    CHECK(found.distance == 5);
    CHECK(found.obstacle == 1);
    CHECK(found.edge == 8);
  }
}

TEST_CASE("the nearest of random features is that of looking at all, whatever the first window") {
  const std::uint64_t seed = 43;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(500); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto any = [&] { return Point(random.uniform(-50, 50), random.uniform(-50, 50)); };
    Features features;
    for (std::uint32_t i = 0; i < 1 + random.below(20); ++i) {
      const Point p = any();
      const bool disc = random.below(2) == 0;
      features.all.push_back({{p, disc ? p : any()}, disc ? random.uniform(0, 5) : 0, i, 0});
    }
    const Segment piece{any(), any()};
    NearestObstacle expected;
    for (const Feature& f : features.all) {
      const double gap = closest_approach(piece, f.core).distance - f.radius;
      if (gap < expected.distance) expected = {gap, 0, f.obstacle, 0};
    }
    const double reach = random.below(3) == 0 ? 0 : random.uniform(0.01, 100);
    const NearestObstacle found = features.nearest(piece, infinity, reach);
    CHECK(found.distance == Approx(expected.distance));
    CHECK(found.obstacle == expected.obstacle);
  }
}

TEST_CASE("the side test rules out only what lies beyond the limit to one side") {
  const detail::SideTest beside(Segment{{0, 0}, {10, 10}});
  CHECK(beside({{0, 5}, {5, 9}}, 2));  // all to the left
  CHECK_FALSE(beside({{0, 5}, {5, 9}}, 4));
  CHECK(beside({{5, 0}, {9, 5}}, 2));                                 // all to the right
  CHECK_FALSE(beside({{0, 5}, {5, 0}}, 2));                           // on both sides
  CHECK_FALSE(detail::SideTest(at_origin)({{99, 99}, {98, 99}}, 1));  // a point has no sides
}

}  // namespace
