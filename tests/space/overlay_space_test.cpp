// SPDX-License-Identifier: MIT
#include "tutavia/space/overlay_space.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/search/tangent_graph.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;

static_assert(FeatureSpace<OverlaySpace<InflatedSpace>>);
static_assert(FeatureSpace<OverlaySpace<CellSpace>>);

TEST_CASE("a space with an overlay answers as a space of all obstacles") {
  for (std::uint64_t seed = 0; seed < test::scaled(60); ++seed) {
    CAPTURE(seed);
    test::WorldGenerator generator(seed);
    Random random(seed);
    Workspace whole = generator.workspace();
    whole.safety_radius = random.uniform(0.05, 0.5);
    Workspace below = whole;
    std::vector<Obstacle> added;
    for (int i = 0; i < 3; ++i) added.push_back(generator.obstacle(whole.bounds));
    whole.obstacles.insert(whole.obstacles.end(), added.begin(), added.end());
    below.safety_radius = 0.01;
    const InflatedSpace base = InflatedSpace::build(below).value();
    const InflatedSpace expected = InflatedSpace::build(whole).value();
    const auto overlay =
        OverlaySpace<InflatedSpace>::build(base, whole.bounds, whole.safety_radius, added).value();
    const auto offset = static_cast<std::uint32_t>(below.obstacles.size());
    for (int i = 0; i < 40; ++i) {
      const Point p = generator.point(whole), q = generator.point(whole);
      const Segment segment{p, q};
      const double gap = expected.nearest(segment, 1e9).distance - whole.safety_radius;
      if (std::abs(gap) > 1e-6) {
        CHECK(overlay.segment_free(p, q) == expected.segment_free(p, q));
      }
      CHECK(overlay.clearance(p) == Approx(expected.clearance(p)).margin(1e-9));
      CHECK(overlay.is_inside(p) == expected.is_inside(p));
      const NearestObstacle a = overlay.nearest(segment, 3), b = expected.nearest(segment, 3);
      CHECK(a.distance == Approx(b.distance).margin(1e-9));
      if (a.obstacle == NearestObstacle::none || a.distance != b.distance) continue;
      const bool is_added = a.obstacle >= OverlaySpace<InflatedSpace>::first_added;
      const std::uint32_t index =
          is_added ? a.obstacle - OverlaySpace<InflatedSpace>::first_added + offset : a.obstacle;
      CHECK((index == b.obstacle || a.distance == 0));
    }
  }
}

TEST_CASE("the tangent graph goes around an overlay, among cells too") {
  OccupancyGrid grid = OccupancyGrid::blocked(20, 10).value();
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 20; ++x) grid.set({x, y}, x != 10 || y > 6);
  }
  const CellSpace cells = CellSpace::build(grid, {.safety_radius = 0.2}).value();
  const auto length = [&](std::vector<Obstacle> added) {
    const auto overlay =
        OverlaySpace<CellSpace>::build(cells, {{-5, -5}, {50, 50}}, 0.3, std::move(added)).value();
    CHECK(overlay.bounds().max == Point(20, 10));
    TangentGraph::Scratch scratch;
    NoObserver no_observer;
    const auto route =
        TangentGraph{}.search(overlay, {.start = {2, 5}, .goal = {18, 5}}, scratch, no_observer);
    return route ? route->curve.length() : -1.0;
  };
  const double free = length({}), around = length({Disc{{10, 8}, 0.4}});
  CHECK(free > 16);
  CHECK(around > free + 0.1);
  CHECK(length({Disc{{10, 8.5}, 1.4}}) == -1);
}

TEST_CASE("an overlay refuses what a workspace refuses") {
  const InflatedSpace base = InflatedSpace::build({.bounds = {{0, 0}, {9, 9}}}).value();
  using Overlay = OverlaySpace<InflatedSpace>;
  CHECK(Overlay::build(base, base.bounds(), -1, {}).error().code == PlanError::invalid_input);
  CHECK(Overlay::build(base, base.bounds(), 1, {Disc{{1, 1}, -2}}).error().code ==
        PlanError::invalid_input);
}

}  // namespace
