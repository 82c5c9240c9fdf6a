// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "support/catch.hpp"
#include "support/free_route.hpp"
#include "support/random_grids.hpp"
#include "support/scale.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/space/cell_space.hpp"

/// \file
/// Checks for the searches of the Theta* family.

namespace tutavia::test {

/// Whenever A* finds a path, so does `algorithm`: in free space, and hardly longer.
template <class A>
void check_any_angle_search(const A& algorithm, std::uint64_t seed, double largest_ratio) {
  Random random(seed);
  typename A::Scratch scratch;
  AStar::Scratch grid_scratch;
  NoObserver no_observer;
  double length = 0, grid_length = 0;
  std::size_t found = 0;
  for (std::size_t round = 0; round < scaled(300); ++round) {
    INFO(A::name << ", seed " << seed << ", round " << round);
    const auto rule = static_cast<MovementRule>(random.below(2) == 0 ? 0 : random.below(4));
    const double radius = random.below(3) == 0 ? random.uniform(0, 1.5) : 0;
    const auto space =
        CellSpace::build(random_grid(random, 50), {.safety_radius = radius, .movement = rule})
            .value();
    // Half of the ends lie off the centres of their cells.
    const auto near_a_centre = [&] {
      const Point p = space.frame().point(random_cell(random, space.grid()));
      return random.below(2) == 0 ? p : Point(p.x() + random.uniform(-0.4, 0.4), p.y() + 0.25);
    };
    const Query query{.start = near_a_centre(), .goal = near_a_centre()};
    const auto expected = AStar{}.search(space, query, grid_scratch, no_observer);
    const auto route = algorithm.search(space, query, scratch, no_observer);
    REQUIRE(route.has_value() == expected.has_value());
    if (!route) {
      CHECK(route.error().code == expected.error().code);
      continue;
    }
    ++found;
    REQUIRE(is_free(space, *route));
    CHECK(route->curve.start() == query.start);
    CHECK(route->curve.end() == query.goal);
    CHECK(route->cost == Approx(route->curve.length()));
    CHECK(route->cost <= largest_ratio * expected->cost);
    CHECK(route->cost >= distance(query.start, query.goal) * (1 - 1e-12));
    length += route->cost;
    grid_length += expected->cost;
  }
  CHECK(found > scaled(300) / 4);
  CHECK(length < 0.99 * grid_length);
}

/// On an empty grid the path is one segment, whatever its direction.
template <class A>
void check_straight_paths(const A& algorithm) {
  const auto space = CellSpace::build(free_grid(80, 30)).value();
  NoObserver no_observer;
  typename A::Scratch scratch;
  for (const Cell goal : {Cell{79, 29}, Cell{1, 28}, Cell{79, 0}, Cell{0, 1}, Cell{0, 0}}) {
    const Query query{.start = space.frame().point(Cell{0, 0}), .goal = space.frame().point(goal)};
    CHECK(algorithm.search(space, query, scratch, no_observer).value().curve.pieces().size() == 1);
  }
}

}  // namespace tutavia::test
