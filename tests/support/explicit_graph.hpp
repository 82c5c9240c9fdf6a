// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "tutavia/grid/cell_costs.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// Cheapest paths on a grid by an explicit list of edges in doubles: slow, simple, and independent
/// of the library's searches and tables.

namespace tutavia::test {

/// Whether a step is allowed, by the definition of the movement rules.
inline bool may_step(const OccupancyGrid& grid, Cell from, int dx, int dy, MovementRule rule) {
  const auto free = [&](Cell c) { return grid.contains(c) && grid.is_free(c); };
  if (!free(from) || !free(from + Cell{dx, dy})) return false;
  if (dx == 0 || dy == 0) return true;
  const int open = free(from + Cell{dx, 0}) + free(from + Cell{0, dy});
  switch (rule) {
    case MovementRule::no_cut:
      return open == 2;
    case MovementRule::no_squeeze:
      return open >= 1;
    case MovementRule::allow:
      return true;
    case MovementRule::four_connected:
    case MovementRule::by_edge:
      break;
  }
  return false;
}

/// Length of a cheapest path by steps and links, in metres: the sum of the steps' lengths (times 1
/// + mean extra cost / 32), plus `turn_penalty` for every radian turned between steps. Empty if
/// there is no path.
template <class S>
std::optional<double> explicit_cost(const S& space, const Query& query,
                                    const CellCosts* costs = nullptr, double turn_penalty = 0) {
  const OccupancyGrid& grid = space.grid();
  const double side = space.frame().resolution;
  const auto cells =
      static_cast<std::size_t>(grid.width()) * static_cast<std::size_t>(grid.height());
  const auto at = [&](Cell c) {
    return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(grid.width()) +
           static_cast<std::size_t>(c.x);
  };
  const std::size_t headings = turn_penalty > 0 ? 9 : 1;  // the last one: no heading
  std::vector<double> best(headings * cells, std::numeric_limits<double>::infinity());
  std::vector<double> exit(cells, std::numeric_limits<double>::infinity());
  for (const EndpointLink& link : space.links(query.goal)) exit[at(link.cell)] = link.length;
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto reach = [&](std::size_t node, double g) {
    if (g < best[node]) open.push({best[node] = g, node});
  };
  for (const EndpointLink& link : space.links(query.start)) {
    reach((headings - 1) * cells + at(link.cell), link.length);
  }
  double answer = std::numeric_limits<double>::infinity();
  while (!open.empty()) {
    const auto [g, node] = open.top();
    open.pop();
    if (g > best[node]) continue;
    const std::size_t index = node % cells, heading = node / cells;
    const Cell cell{static_cast<int>(index % static_cast<std::size_t>(grid.width())),
                    static_cast<int>(index / static_cast<std::size_t>(grid.width()))};
    answer = std::min(answer, g + exit[index]);
    std::size_t direction = 0;  // counterclockwise from +x
    for (const auto& [dx, dy] :
         {std::pair{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}) {
      const std::size_t own = direction++;
      if (!may_step(grid, cell, dx, dy, space.movement())) continue;
      const Cell next = cell + Cell{dx, dy};
      double price = side * std::sqrt(static_cast<double>(dx * dx + dy * dy));
      if (costs != nullptr) price *= 1 + ((*costs)[cell] + (*costs)[next]) / 64.0;
      if (headings > 1 && heading != 8) {
        const std::size_t turn = (own + 8 - heading) % 8;
        price += turn_penalty * static_cast<double>(std::min(turn, 8 - turn)) * std::acos(-1.0) / 4;
      }
      reach((headings > 1 ? own : 0) * cells + at(next), g + price);
    }
  }
  if (!std::isfinite(answer)) return std::nullopt;
  return answer;
}

}  // namespace tutavia::test
