// SPDX-License-Identifier: MIT
#include "tutavia/search/jps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "support/against_astar.hpp"
#include "support/catch.hpp"
#include "support/check_route.hpp"
#include "support/explicit_graph.hpp"
#include "support/random_grids.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;

constexpr std::array corner_cutting{MovementRule::no_squeeze, MovementRule::allow};

TEST_CASE("Jps keeps the searcher contract") { test::searcher_contract(Jps{}); }

TEST_CASE("jump points are few among the nodes that A* expands") {
  const test::Effort effort = test::against_astar(Jps{}, 442, &Statistics::expanded);
  CHECK(effort.own < effort.of_astar / 2);
}

TEST_CASE("jump point search refuses the rule without diagonals") {
  for (const MovementRule rule : test::all_rules) {
    CAPTURE(static_cast<int>(rule));
    const auto space = CellSpace::build(test::free_grid(4, 4), {.movement = rule}).value();
    const auto route = test::search_once(Jps{}, space, {.start = {0.5, 0.5}, .goal = {3.5, 3.5}});
    REQUIRE(route.has_value() == (rule != MovementRule::four_connected));
    if (!route) CHECK(route.error().code == PlanError::invalid_option);
  }
}

/// Lengths of the shortest paths between all pairs of cells of a small grid, numbered row by row
/// (Floyd 1962); infinite where there is none.
class AllPairs {
 public:
  AllPairs(const OccupancyGrid& grid, MovementRule rule)
      : count_(static_cast<std::size_t>(grid.width() * grid.height())),
        lengths_(count_ * count_, std::numeric_limits<double>::infinity()) {
    const auto width = static_cast<std::size_t>(grid.width());
    for (std::size_t a = 0; a < count_; ++a) {
      const Cell from{static_cast<int>(a % width), static_cast<int>(a / width)};
      if (!grid.is_free(from)) continue;
      at(a, a) = 0;
      for (const Cell step : steps) {
        if (!test::may_step(grid, from, step.x, step.y, rule)) continue;
        const Cell to = from + step;
        at(a, static_cast<std::size_t>(to.y) * width + static_cast<std::size_t>(to.x)) =
            std::hypot(step.x, step.y);
      }
    }
    for (std::size_t via = 0; via < count_; ++via) {
      for (std::size_t a = 0; a < count_; ++a) {
        for (std::size_t b = 0; b < count_; ++b) {
          at(a, b) = std::min(at(a, b), at(a, via) + at(via, b));
        }
      }
    }
  }
  double& at(std::size_t a, std::size_t b) { return lengths_[a * count_ + b]; }

 private:
  std::size_t count_;
  std::vector<double> lengths_;
};

/// The number of pairs of free cells of a grid, given by its bits, between which jump point search
/// finds another length than the shortest.
std::size_t count_wrong(std::uint32_t free, int width, int height, MovementRule rule,
                        Jps::Scratch& scratch) {
  OccupancyGrid grid = OccupancyGrid::blocked(width, height).value();
  const int cells = width * height;
  for (int i = 0; i < cells; ++i) grid.set({i % width, i / width}, (free >> i & 1u) != 0);
  AllPairs lengths(grid, rule);
  const auto space = CellSpace::build(std::move(grid), {.movement = rule}).value();
  NoObserver no_observer;
  std::size_t wrong = 0;
  for (int a = 0; a < cells; ++a) {
    for (int b = 0; b < cells; ++b) {
      if ((free >> a & free >> b & 1u) == 0) continue;
      const Query query{.start = space.frame().point({a % width, a / width}),
                        .goal = space.frame().point({b % width, b / width})};
      const auto route = Jps{}.search(space, query, scratch, no_observer);
      const double length = route ? route->cost : std::numeric_limits<double>::infinity();
      const double least = lengths.at(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
      wrong += !(length == least || std::abs(length - least) < 1e-9);
    }
  }
  return wrong;
}

TEST_CASE("jump points that cut corners lead to shortest paths on every small grid", "[soak]") {
  Jps::Scratch scratch;
  for (const MovementRule rule : corner_cutting) {
    for (const auto& [width, height] : {std::pair{3, 3}, {3, 4}, {4, 3}, {2, 6}, {6, 2}, {4, 4}}) {
      CAPTURE(static_cast<int>(rule), width, height);
      const std::uint32_t grids = 1u << (width * height);
      // Scales of 64 and more try every grid of 4 x 4 cells.
      const auto stride = static_cast<std::uint32_t>(
          grids > 4096 ? 64 / std::min<std::size_t>(64, test::scaled(1)) : 1);
      std::size_t wrong = 0;
      for (std::uint32_t free = stride - 1; free < grids; free += stride) {
        wrong += count_wrong(free, width, height, rule, scratch);
      }
      CHECK(wrong == 0);
    }
  }
}

TEST_CASE("jump points that cut corners lead to shortest paths between any points", "[soak]") {
  const std::uint64_t seed = 443;
  Random random(seed);
  Jps::Scratch scratch;
  NoObserver no_observer;
  std::size_t found = 0, off_centre = 0;
  for (std::size_t round = 0; round < test::scaled(2000); ++round) {
    INFO("seed " << seed << ", round " << round);
    const MovementRule rule = corner_cutting[round % 2];
    const bool is_point = random.below(4) != 0;
    const auto space = CellSpace::build(test::random_grid(random, round % 10 == 0 ? 90 : 25),
                                        {.safety_radius = is_point ? 0 : 0.4, .movement = rule})
                           .value();
    const bool on_centres = random.below(3) == 0;
    const auto point = [&] {
      const Point centre = space.frame().point(test::random_cell(random, space.grid()));
      if (on_centres) return centre;
      return Point(centre + Point(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)));
    };
    const Point start = point(), goal = point();
    const Query query{.start = start, .goal = goal};
    if (!space.is_free(start) || !space.is_free(goal)) continue;
    const EndpointLinks starts = space.links(start), goals = space.links(goal);
    if (starts.empty() || goals.empty()) continue;
    const bool on_grid = starts[0].length == 0 && goals[0].length == 0;
    auto expected = test::explicit_cost(space, query);
    if (!on_grid && space.segment_free(start, goal)) expected = distance(start, goal);
    test::check_route(space, query, Jps{}.search(space, query, scratch, no_observer), expected,
                      2.1 / 13860);
    found += expected.has_value();
    off_centre += expected.has_value() && !on_grid;
  }
  CHECK(found > test::scaled(2000) / 3);
  CHECK(off_centre > test::scaled(2000) / 5);
}

TEST_CASE("jump points that cut corners are few among the nodes that A* expands") {
  const std::uint64_t seed = 444;
  Random random(seed);
  for (const MovementRule rule : corner_cutting) {
    std::uint64_t own = 0, of_astar = 0;
    for (std::size_t round = 0; round < test::scaled(100); ++round) {
      INFO("seed " << seed << ", round " << round);
      const auto space =
          CellSpace::build(test::random_grid(random, 60), {.movement = rule}).value();
      const Query query = test::random_query(random, space);
      const auto expected = test::search_once(AStar{}, space, query);
      const auto route = test::search_once(Jps{}, space, query);
      REQUIRE(route.has_value() == expected.has_value());
      if (!route) continue;
      own += route->stats.expanded;
      of_astar += expected->stats.expanded;
    }
    CHECK(own < of_astar / 2);
  }
}

}  // namespace
