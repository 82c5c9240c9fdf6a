// SPDX-License-Identifier: MIT
#include "tutavia/space/lattice_space.hpp"

#include <cmath>
#include <limits>

#include "support/catch.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"

namespace {

using namespace tutavia;

static_assert(GridSpace<LatticeSpace>);
static_assert(CornerSpace<LatticeSpace>);

TEST_CASE("a lattice without a resolution has 200 steps along the larger side") {
  const Workspace workspace{.bounds = {{0, 0}, {40, 10}}, .safety_radius = 0.3};
  const auto space = LatticeSpace::build(workspace, {}).value();
  CHECK(space.frame().resolution == 0.2);
  CHECK(space.grid().width() == 201);
}

TEST_CASE("every step between free nodes is a free segment") {
  const std::uint64_t seed = 3;
  test::WorldGenerator worlds(seed);
  std::size_t checked = 0;
  for (std::size_t round = 0; round < test::scaled(40); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Workspace world = worlds.workspace();
    const auto space = LatticeSpace::build(world, {.resolution = world.bounds.width() / 25,
                                                   .movement = MovementRule::allow})
                           .value();
    const OccupancyGrid& grid = space.grid();
    bool all_free = true;
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        if (!grid.is_free({x, y})) continue;
        for (std::size_t step = 0; step < 4; ++step) {
          if (!grid.can_step({x, y}, step, MovementRule::allow)) continue;
          const Point p = space.frame().point({x, y});
          all_free =
              all_free && space.segment_free(p, space.frame().point(Cell{x, y} + steps[step]));
          ++checked;
        }
      }
    }
    CHECK(all_free);
  }
  CHECK(checked > 1000);
}

TEST_CASE("the lattice is aligned to multiples of its resolution, wherever the bounds begin") {
  const auto space =
      LatticeSpace::build({.bounds = {{-0.95, 0.31}, {1.05, 1.69}}, .safety_radius = 0},
                          {.resolution = 0.2})
          .value();
  CHECK(space.frame().point({0, 0}).isApprox(Point(-0.8, 0.4)));
  CHECK(space.grid().width() == 10);
  CHECK(space.grid().height() == 7);
  CHECK(space.grid().count_free() == 70);
}

TEST_CASE("a point on a node has that node as its only link, one beside it has free ones around") {
  const auto space =
      LatticeSpace::build({.bounds = {{0, 0}, {4, 4}}, .safety_radius = 0.2}, {.resolution = 0.5})
          .value();
  const EndpointLinks on = space.links({1.5, 2});
  REQUIRE(on.size() == 1);
  CHECK(on[0].cell == Cell{3, 4});
  CHECK(on[0].length == 0);
  const EndpointLinks near = space.links({1.5 + 1e-12, 2});
  REQUIRE(near.size() == 1);
  CHECK(near[0].length == 0);

  const EndpointLinks between = space.links({1.6, 2.1});
  CHECK(between.size() == 6);
  for (const EndpointLink& link : between) {
    const Point node = space.frame().point(link.cell);
    CHECK(link.length == Approx((node - Point(1.6, 2.1)).norm()));
    CHECK(link.length <= std::sqrt(2) * 0.5);
  }
  CHECK(space.links({-1, 2}).empty());
  CHECK(space.links({std::numeric_limits<double>::quiet_NaN(), 2}).empty());
}

TEST_CASE("links keep clear of obstacles between the point and a node") {
  const auto space = LatticeSpace::build({.bounds = {{0, 0}, {4, 4}},
                                          .safety_radius = 0.05,
                                          .obstacles = {Polygon{{{2.2, 0}, {2.21, 4}}}}},
                                         {.resolution = 0.5})
                         .value();
  for (const EndpointLink& link : space.links({2.1, 2}))
    CHECK(space.frame().point(link.cell).x() < 2.1);
}

TEST_CASE("bad resolutions are refused before anything is allocated") {
  const Workspace world{.bounds = {{0, 0}, {10, 10}}, .safety_radius = 0.1};
  const auto code = [&](double resolution) {
    const auto space = LatticeSpace::build(world, {.resolution = resolution});
    REQUIRE_FALSE(space);
    return space.error().code;
  };
  CHECK(code(0) == PlanError::invalid_option);
  CHECK(code(-0.1) == PlanError::invalid_option);
  CHECK(code(std::numeric_limits<double>::quiet_NaN()) == PlanError::invalid_option);
  CHECK(code(std::numeric_limits<double>::infinity()) == PlanError::invalid_option);
  CHECK(code(1e-12) == PlanError::limit_exceeded);
  CHECK(code(1e-5) == PlanError::limit_exceeded);
  const auto detail = LatticeSpace::build(world, {.resolution = 0.01, .max_nodes = 1000}).error();
  CHECK(detail.code == PlanError::limit_exceeded);
  CHECK(detail.detail.find("1001 x 1001") != std::string::npos);
  CHECK(detail.detail.find("1000 cells") != std::string::npos);
}

TEST_CASE("a resolution larger than the world leaves few nodes, or none") {
  const auto space = LatticeSpace::build({.bounds = {{0.1, 0.1}, {0.9, 0.9}}, .safety_radius = 0.1},
                                         {.resolution = 1})
                         .value();
  CHECK(space.grid().count_free() == 0);
  CHECK(space.links({0.5, 0.5}).empty());
}

}  // namespace
