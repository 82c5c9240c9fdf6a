// SPDX-License-Identifier: MIT
#include "tutavia/search/tangent/sight_sectors.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>

#include "support/catch.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/geometry/tangent/tangent_line.hpp"
#include "tutavia/search/tangent_visibility_graph.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;
using detail::OrientedCircle;
using detail::SightSectors;

/// Pairs of circles so far apart that sectors may hide one from the other.
struct Pairs {
  std::size_t all = 0, hidden = 0, wrong = 0;
};

template <class S>
bool is_tangent_free(const S& space, const OrientedCircle& a, const OrientedCircle& b) {
  const auto tangent = detail::tangent_line(a, b);
  return tangent && space.segment_free(tangent->from, tangent->to);
}

template <class S>
void look_around(const S& space, OrientedCircle at, Pairs& pairs) {
  const TangentVisibilityGraph map(space);
  SightSectors sight;
  sight.look_from(space, at, map.nodes() / 2);
  for (TangentVisibilityGraph::Node node = 0; node < map.nodes(); ++node) {
    const OrientedCircle other = map.circle(node);
    const Point between = other.center - at.center;
    if (between.norm() < 4 * (other.radius + at.radius)) continue;
    ++pairs.all;
    if (!sight.hides(between, other.radius)) continue;
    ++pairs.hidden;
    for (const int side : {1, -1}) {
      at.side = side;
      if (is_tangent_free(space, at, other)) ++pairs.wrong;
    }
  }
}

TEST_CASE("no circle to which a tangent is free is hidden", "[tangent]") {
  Pairs pairs;
  for (std::uint64_t seed = 1; seed <= test::scaled(150); ++seed) {
    test::WorldGenerator worlds(seed);
    const Workspace world = worlds.workspace();
    const InflatedSpace space = InflatedSpace::build(world).value();
    const TangentVisibilityGraph map(space);
    for (TangentVisibilityGraph::Node node = 0; node < map.nodes(); node += 2) {
      look_around(space, map.circle(node), pairs);
    }
    for (int k = 0; k < 4; ++k) look_around(space, {worlds.point(world), 0, 1}, pairs);
  }
  CHECK(pairs.wrong == 0);
  CHECK(pairs.hidden > pairs.all / 8);
}

TEST_CASE("no circle to which a tangent is free is hidden among cells", "[tangent]") {
  Pairs pairs;
  for (std::uint64_t seed = 1; seed <= test::scaled(16); ++seed) {
    Random random(seed);
    OccupancyGrid grid = OccupancyGrid::blocked(24, 24).value();
    for (int y = 0; y < 24; ++y) {
      for (int x = 0; x < 24; ++x) grid.set({x, y}, random.below(5) > 0);
    }
    const double radius = seed % 2 == 0 ? 0 : random.uniform(0, 0.4);
    const CellSpace space = CellSpace::build(std::move(grid), {.safety_radius = radius}).value();
    const TangentVisibilityGraph map(space);
    for (TangentVisibilityGraph::Node node = 0; node < map.nodes(); node += 8) {
      look_around(space, map.circle(node), pairs);
    }
  }
  CHECK(pairs.wrong == 0);
  CHECK(pairs.hidden > pairs.all / 2);
}

TEST_CASE("a wall hides what is behind it and nothing else", "[tangent]") {
  const Workspace world{.bounds = {{0, 0}, {20, 20}},
                        .safety_radius = 0.5,
                        .obstacles = {Polygon{{{5, 8}, {15, 8}, {15, 9}, {5, 9}}}}};
  const InflatedSpace space = InflatedSpace::build(world).value();
  SightSectors sight;
  CHECK_FALSE(sight.hides({0, 10}, 0.5));  // it has not looked
  sight.look_from(space, {{10, 2}, 0, 1}, 4);
  CHECK(sight.hides({0, 10}, 0.5));
  CHECK(sight.hides({2, 7}, 0.5));
  CHECK_FALSE(sight.hides({0, 5.5}, 0.5));  // in front
  CHECK_FALSE(sight.hides({9, 7}, 0.5));    // beside
  CHECK_FALSE(sight.hides({0, -2}, 0.5));   // on the other side
  CHECK_FALSE(sight.hides({0, 10}, 0.6));   // a larger circle
  CHECK_FALSE(sight.hides({0, 0}, 0));
}

}  // namespace
