// SPDX-License-Identifier: MIT
#include "tutavia/search/auto_search.hpp"

#include <cstddef>
#include <cstdint>

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/space/lattice_space.hpp"

namespace {

using namespace tutavia;
using test::search_once;

TEST_CASE("the search depends on the space") {
  Workspace world{.bounds = {{0, 0}, {8, 8}}, .safety_radius = 0.5};
  world.obstacles.emplace_back(Disc{{4, 4}, 1});
  const Query query{.start = {1, 4}, .goal = {7, 4}};
  const auto lattice = LatticeSpace::build(world, {.resolution = 0.5}).value();
  CHECK(search_once(AutoSearch{}, lattice, query)->found_by == "astar");
  const auto plane = InflatedSpace::build(world).value();
  CHECK(search_once(AutoSearch{}, plane, query)->found_by == "tangent_graph");
  const auto cells = CellSpace::build(test::free_grid(9, 9)).value();
  CHECK(search_once(AutoSearch{}, cells, query)->found_by == "jps");
  const auto straight =
      CellSpace::build(test::free_grid(9, 9), {.movement = MovementRule::four_connected}).value();
  CHECK(search_once(AutoSearch{}, straight, query)->found_by == "astar");
}

TEST_CASE("a planner without a search uses it") {
  const auto space =
      LatticeSpace::build({.bounds = {{0, 0}, {8, 8}}, .safety_radius = 0.5}, {.resolution = 1})
          .value();
  const auto plan = Planner<>{}.plan(space, {.start = {1, 4}, .goal = {7, 4}});
  REQUIRE(plan);
  CHECK(plan->route.found_by == "astar");
}

TEST_CASE("AutoSearch keeps the searcher contract") {
  test::searcher_contract(AutoSearch{}, {.ties = test::Ties::not_proved});
}

/// Two walls across a world with slots that are wider than the robot by up to a twentieth.
void add_slots(Random& random, Workspace& world) {
  const Box& b = world.bounds;
  for (const double part : {0.3, 0.6}) {
    const double x = b.min.x() + part * b.width(), thickness = b.width() / 40;
    const double middle = random.uniform(b.min.y(), b.max.y());
    const double half = world.safety_radius * random.uniform(1.0, 1.05);
    const auto add = [&](double low, double high) {
      if (!(low < high)) return;
      world.obstacles.emplace_back(
          Polygon{{{x, low}, {x + thickness, low}, {x + thickness, high}, {x, high}}});
    };
    add(b.min.y() - 1, middle - half);
    add(middle + half, b.max.y() + 1);
  }
}

TEST_CASE("a plan is found through narrow passages wherever there is one", "[soak]") {
  const std::uint64_t seed = 2104;
  test::WorldGenerator worlds(seed);
  std::size_t found = 0, exact = 0;
  for (std::size_t round = 0; round < test::scaled(100); ++round) {
    INFO("seed " << seed << ", round " << round);
    Workspace world = worlds.workspace();
    if (world.obstacles.size() > 6) world.obstacles.resize(6);
    add_slots(worlds.random(), world);
    const Query query{.start = worlds.point(world), .goal = worlds.point(world)};
    const auto space =
        LatticeSpace::build(world, {.resolution = world.bounds.width() / 25}).value();
    const auto optimum = search_once(TangentGraph{}, space, query);
    const auto plan = Planner(AutoSearch{}, DeltaSmoother{}).plan(space, query);
    if (optimum) {
      REQUIRE(plan);
      ++found;
      CHECK(plan->certificate.status == ProofStatus::proved);
      CHECK(plan->route.cost >= optimum->cost * (1 - 1e-9));
      exact += plan->route.found_by == "tangent_graph" ? 1 : 0;
    } else if (!plan) {
      CHECK(plan.error().code == optimum.error().code);
    }
  }
  CAPTURE(found, exact);
  CHECK(found > test::scaled(100) / 4);
  CHECK(exact > test::scaled(100) / 50);
}

}  // namespace
