// SPDX-License-Identifier: MIT
#include "tutavia/search/grid/step_rule.hpp"

#include "support/catch.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/lattice_space.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;

static_assert(detail::EdgeStepSpace<LatticeSpace>);
static_assert(!detail::EdgeStepSpace<CellSpace>);

/// Whether the rule gives the steps that `expected(index)` gives, for every free node.
template <class S, class Expected>
bool gives(const S& space, const Expected& expected) {
  const detail::StepRule rule(space);
  const OccupancyGrid& grid = space.grid();
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const std::size_t index = grid.index({x, y});
      if (grid.is_free({x, y}) && rule(index) != expected(index)) return false;
    }
  }
  return true;
}

TEST_CASE("steps are those of the movement rule, or each node's own") {
  const Scene scene = maps::complex();
  for (const MovementRule movement : {MovementRule::no_cut, MovementRule::four_connected}) {
    const auto lattice =
        LatticeSpace::build(scene.workspace, {.resolution = 0.2, .movement = movement}).value();
    const auto by_rule = [&](std::size_t index) -> unsigned {
      return detail::all_successors(movement)[lattice.grid().view().neighbourhood(index)];
    };
    CHECK(gives(lattice, by_rule));
    const auto cells = CellSpace::build(lattice.grid(), {.movement = movement}).value();
    CHECK(gives(cells, by_rule));
  }
  const auto strict =
      LatticeSpace::build(scene.workspace, {.resolution = 0.2, .edges = EdgeRule::paper_strict})
          .value();
  CHECK(gives(strict, [&](std::size_t index) -> unsigned { return strict.edge_steps()[index]; }));
}

}  // namespace
