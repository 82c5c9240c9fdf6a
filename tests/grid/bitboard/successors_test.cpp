// SPDX-License-Identifier: MIT
#include "tutavia/grid/bitboard/successors.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

/// Whether a neighbour is free: bits count row by row from (-1, -1), without the middle.
bool is_free(std::size_t around, int dx, int dy) {
  const int place = 3 * (dy + 1) + (dx + 1);
  return (around >> (place < 4 ? place : place - 1) & 1u) != 0;
}

/// The movement rules by their words.
bool may_step(std::size_t around, Cell step, MovementRule rule) {
  if (!is_free(around, step.x, step.y)) return false;
  if (step.x == 0 || step.y == 0) return true;
  const int free_beside = is_free(around, step.x, 0) + is_free(around, 0, step.y);
  switch (rule) {
    case MovementRule::no_cut:
      return free_beside == 2;
    case MovementRule::no_squeeze:
      return free_beside >= 1;
    case MovementRule::allow:
      return true;
    case MovementRule::four_connected:
    case MovementRule::by_edge:
      break;
  }
  return false;
}

bool has(StepSet set, std::size_t step) { return ((set >> step) & 1u) != 0; }

/// A small map with a blocked frame.
struct Map {
  int width, height;
  std::vector<bool> free;

  bool is_free(int x, int y) const {
    return x >= 0 && y >= 0 && x < width && y < height && free[at({x, y})];
  }
  std::size_t at(Cell c) const { return static_cast<std::size_t>(c.y * width + c.x); }
  std::size_t around(Cell c) const {
    std::size_t bits = 0, place = 0;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (dx == 0 && dy == 0) continue;
        if (is_free(c.x + dx, c.y + dy)) bits |= std::size_t{1} << place;
        ++place;
      }
    }
    return bits;
  }
};

Map random_map(Random& random, int size, double density) {
  Map map{1 + static_cast<int>(random.below(static_cast<std::uint64_t>(size))),
          1 + static_cast<int>(random.below(static_cast<std::uint64_t>(size))),
          {}};
  for (int i = 0; i < map.width * map.height; ++i) map.free.push_back(random.uniform() >= density);
  return map;
}

constexpr Cost unreached = std::numeric_limits<Cost>::max();

struct Wave {
  std::vector<Cost> costs;
  std::size_t steps = 0;  // followed in all
};

/// Dijkstra's algorithm with a plain list; of equal costs any one is taken next. `next(cell,
/// arrival)` gives the steps to follow from a cell whose first best way arrives by `arrival`.
template <class Next>
Wave flood(Random& random, const Map& map, Cell start, Next next) {
  const auto cells = static_cast<std::size_t>(map.width * map.height);
  Wave wave{std::vector<Cost>(cells, unreached)};
  std::vector<std::size_t> arrivals(cells, no_step);
  std::vector<std::pair<Cost, Cell>> open{{0, start}};
  wave.costs[map.at(start)] = 0;
  while (!open.empty()) {
    std::size_t best = 0, ties = 0;
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (open[i].first < open[best].first) best = i, ties = 0;
      if (open[i].first == open[best].first && random.below(++ties) == 0) best = i;
    }
    const auto [cost, cell] = open[best];
    open.erase(open.begin() + static_cast<std::ptrdiff_t>(best));
    if (cost != wave.costs[map.at(cell)]) continue;
    const StepSet successors = next(cell, arrivals[map.at(cell)]);
    for (std::size_t step = 0; step < steps.size(); ++step) {
      if (!has(successors, step)) continue;
      ++wave.steps;
      const Cell to = cell + steps[step];
      const Cost reached = cost + (step % 2 == 0 ? straight_cost : diagonal_cost);
      if (reached >= wave.costs[map.at(to)]) continue;
      wave.costs[map.at(to)] = reached;
      arrivals[map.at(to)] = step;
      open.emplace_back(reached, to);
    }
  }
  return wave;
}

Wave flood_all(Random& random, const Map& map, Cell start, MovementRule rule) {
  return flood(random, map, start, [&](Cell cell, std::size_t) {
    StepSet set = 0;
    for (std::size_t step = 0; step < steps.size(); ++step) {
      if (may_step(map.around(cell), steps[step], rule)) {
        set = static_cast<StepSet>(set | (1u << step));
      }
    }
    return set;
  });
}

Wave flood_canonical(Random& random, const Map& map, Cell start, MovementRule rule) {
  return flood(random, map, start, [&](Cell cell, std::size_t arrival) {
    return canonical_table(rule)[arrival][map.around(cell)];
  });
}

TEST_CASE("the successor tables hold the movement rules for every neighbourhood", "[grid]") {
  for (const MovementRule rule : test::all_rules) {
    const SuccessorTable table = successor_table(rule);
    std::size_t wrong = 0;
    for (std::size_t around = 0; around < 256; ++around) {
      for (std::size_t step = 0; step < steps.size(); ++step) {
        if (has(table[around], step) != may_step(around, steps[step], rule)) ++wrong;
      }
    }
    CAPTURE(static_cast<int>(rule));
    CHECK(wrong == 0);
    CHECK(all_successors(rule) == table);
  }
}

TEST_CASE("the opposite of a step leads back", "[grid]") {
  for (std::size_t step = 0; step < steps.size(); ++step) {
    CHECK(steps[step] + steps[opposite(step)] == Cell{0, 0});
  }
}

TEST_CASE("canonical steps are allowed ones, and never lead back", "[grid]") {
  for (const MovementRule rule : test::all_rules) {
    CAPTURE(static_cast<int>(rule));
    const CanonicalTable& table = canonical_table(rule);
    CHECK(table[no_step] == successor_table(rule));
    std::size_t wrong = 0;
    for (std::size_t arrival = 0; arrival < no_step; ++arrival) {
      for (std::size_t around = 0; around < 256; ++around) {
        const StepSet set = table[arrival][around];
        if ((set & ~table[no_step][around]) != 0 || has(set, opposite(arrival))) ++wrong;
      }
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("onward steps are all but those to the parent and to cells that it steps to", "[grid]") {
  // The neighbourhood as a map of its own, whose other cells are blocked.
  for (const MovementRule rule : test::all_rules) {
    CAPTURE(static_cast<int>(rule));
    const CanonicalTable& table = onward_table(rule);
    CHECK(table[no_step] == successor_table(rule));
    std::size_t wrong = 0;
    for (std::size_t arrival = 0; arrival < no_step; ++arrival) {
      const Cell parent = steps[opposite(arrival)];
      for (std::size_t around = 0; around < 256; ++around) {
        if (!may_step(around, parent, MovementRule::allow)) continue;
        const auto is_free = [&](Cell c) {
          return c == Cell{0, 0} || (-1 <= c.x && c.x <= 1 && -1 <= c.y && c.y <= 1 &&
                                     may_step(around, c, MovementRule::allow));
        };
        std::size_t from_parent = 0;
        for (std::size_t step = 0; step < steps.size(); ++step) {
          if (is_free(parent + steps[step])) from_parent |= std::size_t{1} << neighbour_bit[step];
        }
        for (std::size_t step = 0; step < steps.size(); ++step) {
          const Cell to = steps[step], of_parent = to - parent;
          const bool is_next =
              -1 <= of_parent.x && of_parent.x <= 1 && -1 <= of_parent.y && of_parent.y <= 1;
          const bool known = to == parent || (is_next && may_step(from_parent, of_parent, rule));
          const bool expected = may_step(around, to, rule) && !known;
          if (has(table[arrival][around], step) != expected) ++wrong;
        }
      }
    }
    CHECK(wrong == 0);
  }
}

Wave flood_onwards(Random& random, const Map& map, Cell start, MovementRule rule) {
  return flood(random, map, start, [&](Cell cell, std::size_t arrival) {
    return onward_table(rule)[arrival][map.around(cell)];
  });
}

TEST_CASE("canonical and onward steps reach every cell as cheaply as all steps do in any order",
          "[grid]") {
  const std::uint64_t seed = 1;
  Random random(seed);
  std::size_t reached = 0, saved = 0;
  for (std::size_t round = 0; round < test::scaled(8000); ++round) {
    const Map map = random_map(random, round % 4 == 0 ? 12 : 7, 0.6 * random.uniform());
    const MovementRule rule = test::all_rules[random.below(4)];
    const Cell start{static_cast<int>(random.below(static_cast<std::uint64_t>(map.width))),
                     static_cast<int>(random.below(static_cast<std::uint64_t>(map.height)))};
    if (!map.is_free(start.x, start.y)) continue;
    const Wave all = flood_all(random, map, start, rule);
    const Wave canonical = flood_canonical(random, map, start, rule);
    const Wave onwards = flood_onwards(random, map, start, rule);
    INFO("seed " << seed << ", round " << round << ", rule " << static_cast<int>(rule));
    CHECK(canonical.costs == all.costs);
    CHECK(onwards.costs == all.costs);
    CHECK(canonical.steps <= all.steps);
    CHECK(onwards.steps <= all.steps);
    saved += all.steps - canonical.steps;
    for (const Cost cost : all.costs) reached += cost != unreached ? 1 : 0;
  }
  CHECK(reached > test::scaled(50000));
  CHECK(saved > test::scaled(50000));
}

TEST_CASE("in the open canonical steps come to every cell exactly once", "[grid]") {
  Random random(2);
  Map map{11, 8, std::vector<bool>(88, true)};
  for (const MovementRule rule : test::all_rules) {
    CAPTURE(static_cast<int>(rule));
    for (const Cell start : {Cell{0, 0}, Cell{5, 3}, Cell{10, 4}}) {
      const Wave wave = flood_canonical(random, map, start, rule);
      CHECK(wave.steps == 87);
      CHECK(wave.costs == flood_all(random, map, start, rule).costs);
    }
  }
}

TEST_CASE("a path turns around a corner where the movement rule lets it", "[grid]") {
  // Arriving by +x with the cell to the upper left, or the one above, blocked.
  constexpr std::size_t all_free = 255;
  const auto without = [&](Cell c) {
    std::size_t around = all_free;
    const int place = 3 * (c.y + 1) + (c.x + 1);
    around &= ~(std::size_t{1} << (place < 4 ? place : place - 1));
    return around;
  };
  const auto steps_for = [&](MovementRule rule, Cell blocked) {
    return static_cast<int>(canonical_table(rule)[0][without(blocked)]);
  };
  const auto set = [](auto... step) { return static_cast<int>(((1u << step) | ...)); };
  CHECK(steps_for(MovementRule::no_cut, {-1, 1}) == set(0, 1, 2));
  CHECK(steps_for(MovementRule::no_cut, {0, 1}) == set(0));
  CHECK(steps_for(MovementRule::no_squeeze, {0, 1}) == set(0, 1));
  CHECK(steps_for(MovementRule::allow, {0, 1}) == set(0, 1));
  CHECK(steps_for(MovementRule::allow, {-1, 1}) == set(0));
  CHECK(canonical_table(MovementRule::no_cut)[1][all_free] == set(0, 1, 2));
  CHECK(canonical_table(MovementRule::no_cut)[0][all_free] == set(0));
}

}  // namespace
