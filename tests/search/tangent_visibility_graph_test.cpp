// SPDX-License-Identifier: MIT
#include "tutavia/search/tangent_visibility_graph.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "support/catch.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "tutavia/search/tangent_graph.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/world/changed_boxes.hpp"
#include "tutavia/world/maps.hpp"
#include "tutavia/world/moving_obstacle.hpp"

namespace {

using namespace tutavia;

InflatedSpace space_of(const Workspace& workspace) {
  return InflatedSpace::build(workspace).value();
}

TangentVisibilityGraph prepared(const Workspace& workspace) {
  return TangentVisibilityGraph::prepare(space_of(workspace)).value();
}

TangentVisibilityGraph updated(const TangentVisibilityGraph& map, const Workspace& before,
                               const Workspace& after) {
  return map.updated(space_of(after), changed_boxes(before, after)).value();
}

std::size_t count_edges(const TangentVisibilityGraph& map) {
  std::size_t count = 0;
  for (TangentVisibilityGraph::Node node = 0; node < map.nodes(); ++node)
    count += map.edges(node).size();
  return count;
}

Polygon rectangle(const Box& box) {
  return {{box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}}};
}

/// Changes one thing about a world, in a way that its kind of change names.
const char* change(Workspace& world, test::WorldGenerator& worlds) {
  Random& random = worlds.random();
  std::vector<Obstacle>& obstacles = world.obstacles;
  const double size = world.bounds.width();
  const auto any = [&] {
    return obstacles.begin() + static_cast<std::ptrdiff_t>(random.below(obstacles.size()));
  };
  const std::uint64_t kind = obstacles.empty() ? 0 : random.below(16);
  switch (kind) {
    case 3:
    case 4:
    case 5:
    case 6:
      obstacles.erase(any());
      return "removed";
    case 7:
    case 8:
    case 9: {
      const Obstacle shifted = translated(
          *any(), worlds.snap({random.uniform(-size, size) / 4, random.uniform(-size, size) / 4}));
      obstacles.erase(any());
      obstacles.push_back(shifted);
      return "one removed, another there a second time and shifted";
    }
    case 10: {
      const auto which = any();
      *which = translated(*which, worlds.snap({random.uniform(-size, size), 0}));
      return "moved";
    }
    case 11: {
      const Obstacle twin = *any();
      obstacles.push_back(twin);
      return "there twice";
    }
    case 12: {  // where two obstacles have a vertex in common
      const Polygon* polygon = std::get_if<Polygon>(&*any());
      if (polygon == nullptr) break;
      const Point p = polygon->outer[random.below(polygon->outer.size())];
      obstacles.push_back(Polygon{{p, worlds.point(world), worlds.point(world)}});
      return "a triangle at a vertex";
    }
    case 13: {  // with an edge in common, or a hole that becomes an obstacle
      Polygon* polygon = std::get_if<Polygon>(&*any());
      if (polygon == nullptr) break;
      if (!polygon->holes.empty()) {
        const Polygon filling{polygon->holes[0]};
        polygon->holes.clear();
        obstacles.push_back(filling);
        return "a hole filled";
      }
      obstacles.push_back(
          Polygon{{polygon->outer.front(), polygon->outer.back(), worlds.point(world)}});
      return "a triangle at an edge";
    }
    case 14: {
      const Point low = worlds.point(world);
      const double grown = random.below(4) == 0 ? 3 * size : size / 3;
      obstacles.push_back(rectangle({low - Point(grown, grown) / 2, low + Point(grown, grown)}));
      return "a large rectangle";
    }
    case 15:
      if (random.below(4) == 0) {
        world.bounds.max.x() += 0.5;
        return "other bounds";
      }
      if (random.below(3) == 0) {
        world.safety_radius *= 1.5;
        return "another safety radius";
      }
      obstacles.push_back(rectangle(Box{world.bounds.max, world.bounds.max}.inflated(size / 8)));
      return "one beyond the bounds";
    default:
      break;
  }
  obstacles.push_back(worlds.obstacle(world.bounds));
  return "added";
}

TEST_CASE("updated tangents are those prepared anew, in random worlds that change", "[soak]") {
  const std::uint64_t seed = 610;
  test::WorldGenerator worlds(seed);
  std::size_t updates = 0, with_others = 0, same_edges = 0, routes = 0;
  for (std::size_t round = 0; round < test::scaled(60); ++round) {
    INFO("seed " << seed << ", round " << round);
    Workspace world = worlds.workspace();
    TangentVisibilityGraph map = prepared(world);
    for (int step = 0; step < 5; ++step) {  // each map from the one before it
      Workspace next = world;
      const char* kind = change(next, worlds);
      if (worlds.random().below(4) == 0) change(next, worlds);
      if (!validate(next)) continue;
      INFO("step " << step << ": " << kind);
      const InflatedSpace after = space_of(next);
      const TangentVisibilityGraph anew = TangentVisibilityGraph::prepare(after).value();
      map = updated(map, world, next);
      REQUIRE(map == anew);
      CHECK(map.matches(after));
      ++updates;
      with_others += world.obstacles.size() > 3;
      same_edges += count_edges(map) > 50;
      world = next;
    }
    if (!(world.safety_radius > 0)) continue;
    const InflatedSpace space = space_of(world);
    const Query query{.start = worlds.point(world), .goal = worlds.point(world)};
    detail::TangentScratch scratch;
    NoObserver no_observer;
    const auto route = TangentGraph{}.search(space, query, scratch, no_observer);
    const TangentGraph graph{.tangents =
                                 std::make_shared<const TangentVisibilityGraph>(std::move(map))};
    const auto again = graph.search(space, query, scratch, no_observer);
    REQUIRE(again.has_value() == route.has_value());
    if (route) {
      ++routes;
      CHECK(again->cost == Approx(route->cost).epsilon(1e-12));
    } else {
      CHECK(again.error().code == route.error().code);
    }
  }
  CAPTURE(updates, with_others, same_edges);
  CHECK(routes > test::scaled(60) / 3);
  CHECK(same_edges > updates / 4);
  CHECK(with_others > updates / 2);
}

Workspace with(std::vector<Obstacle> obstacles) {
  return {
      .bounds = {{-10, -10}, {10, 10}}, .safety_radius = 0.5, .obstacles = std::move(obstacles)};
}

const Disc west{{-6, 0}, 1}, east{{6, 0}, 1};

TEST_CASE("what stood between two circles opens their edges when it goes, and bars them again") {
  const Workspace open = with({west, east});
  const Workspace barred = with({west, rectangle({{-1, -8}, {1, 8}}), east});
  const TangentVisibilityGraph before = prepared(barred);
  const TangentVisibilityGraph after = updated(before, barred, open);
  CHECK(after.edges(0).size() == 2);  // to both sides of the other disc
  CHECK(after == prepared(open));
  CHECK(updated(after, open, barred) == before);
}

TEST_CASE("an obstacle that holds all the bounds bars every way, though no edge of it is near") {
  const Workspace open = with({west, east});
  const Workspace covered = with({west, east, rectangle({{-10.25, -90}, {90, 90}})});
  const TangentVisibilityGraph before = prepared(open);
  CHECK(count_edges(before) == 8);
  CHECK(count_edges(updated(before, open, covered)) == 0);
}

TEST_CASE("a hole that becomes an obstacle of its own bars the edges in it") {
  const Ring outer{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}, inner{{-8, -8}, {8, -8}, {8, 8}, {-8, 8}};
  const Workspace ring = with({Polygon{outer, {inner}}, west, east});
  const Workspace solid = with({Polygon{outer}, Polygon{inner}, west, east});
  const TangentVisibilityGraph before = prepared(ring);
  const TangentVisibilityGraph after = updated(before, ring, solid);
  CHECK(count_edges(after) < count_edges(before));
  CHECK(after == prepared(solid));
}

TEST_CASE("edges far from the changes are taken over without a proof") {
  // Boxes that leave out what changed show it: the way through the new wall is still there.
  const Workspace open = with({west, east});
  const Workspace barred = with({west, rectangle({{-1, -8}, {1, 8}}), east});
  const TangentVisibilityGraph before = prepared(open);
  const Box elsewhere[] = {{{-1, 8}, {1, 9}}};
  const TangentVisibilityGraph wrong = before.updated(space_of(barred), elsewhere).value();
  CHECK_FALSE(wrong == prepared(barred));
  // With more boxes than it pays to look at, everything is prepared.
  const std::vector<Box> many(TangentVisibilityGraph::most_boxes + 1, elsewhere[0]);
  CHECK(*before.updated(space_of(barred), many) == prepared(barred));
}

TEST_CASE("an update starts from nothing, keeps to its budget and works on cells") {
  const Workspace open = with({west, east});
  const InflatedSpace space = space_of(open);
  const TangentVisibilityGraph ready = TangentVisibilityGraph::prepare(space).value();
  CHECK(*TangentVisibilityGraph(space).updated(space, {}) == ready);
  CHECK(*ready.updated(space, {}) == ready);
  const auto late = ready.updated(space, {}, Budget::for_seconds(-1));
  REQUIRE_FALSE(late);
  CHECK(late.error().code == PlanError::budget_exhausted);

  OccupancyGrid cells = OccupancyGrid::blocked(20, 20).value();
  for (int y = 0; y < 20; ++y) cells.set_run(y, 0, 19, true);
  for (const Cell cell : {Cell{4, 4}, Cell{12, 5}, Cell{9, 14}}) cells.set(cell, false);
  const auto space_among = [&] { return CellSpace::build(cells, {.safety_radius = 0.4}).value(); };
  const TangentVisibilityGraph before = TangentVisibilityGraph::prepare(space_among()).value();
  cells.set({8, 8}, false);
  const Box changed[] = {{{8, 8}, {9, 9}}};
  CHECK(*before.updated(space_among(), changed) == *TangentVisibilityGraph::prepare(space_among()));
}

}  // namespace
