// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "tutavia/grid/movement.hpp"

/// \file
/// Successor tables: the steps that a neighbourhood allows, and those of them that a search needs.

namespace tutavia::detail {

/// The eight neighbours of a cell, a bit each (1: free), row by row from (x - 1, y - 1).
using Neighbourhood = std::uint8_t;

/// Stands for "no step": the step of arrival at the first cell of a search.
inline constexpr std::size_t no_step = 8;

constexpr std::size_t opposite(std::size_t step) { return (step + 4) % 8; }

/// The bit of the neighbour in direction `step` in a Neighbourhood.
inline constexpr std::array<unsigned, 8> neighbour_bit{4, 7, 6, 5, 3, 0, 1, 2};

constexpr bool is_free(Neighbourhood around, std::size_t step) {
  return ((around >> neighbour_bit[step]) & 1u) != 0;
}

constexpr bool can_step(Neighbourhood around, std::size_t step, MovementRule rule) {
  if (!is_free(around, step) || rule == MovementRule::by_edge) return false;
  if (!is_diagonal(step) || rule == MovementRule::allow) return true;
  const bool left = is_free(around, (step + 1) % 8), right = is_free(around, step - 1);
  return rule == MovementRule::no_cut ? left && right
                                      : rule == MovementRule::no_squeeze && (left || right);
}

/// The allowed steps for every neighbourhood.
using SuccessorTable = std::array<StepSet, 256>;

constexpr SuccessorTable successor_table(MovementRule rule) {
  SuccessorTable table{};
  for (std::size_t around = 0; around < table.size(); ++around) {
    for (std::size_t step = 0; step < steps.size(); ++step) {
      if (can_step(static_cast<Neighbourhood>(around), step, rule)) {
        table[around] = static_cast<StepSet>(table[around] | (1u << step));
      }
    }
  }
  return table;
}

/// For each step of arrival (`no_step`: none) and every neighbourhood, the steps that a search must
/// follow. Every other step leads to a cell that a path around the middle cell reaches at no
/// greater cost. Among paths of equal cost, the one with diagonal steps first is kept (with
/// vertical steps first if there are no diagonals). Source: Harabor and Grastien 2011, "Online
/// graph pruning for pathfinding on grid maps", section 3; Sturtevant and Rabin 2016, "Canonical
/// orderings on grids".
using CanonicalTable = std::array<SuccessorTable, 9>;

/// Cost of the step from one cell to another, given as offsets from the middle of a neighbourhood
/// whose middle is free; `no_way` if there is no such step.
constexpr Cost no_way = 1 << 30;
constexpr Cost cost_between(Neighbourhood around, Cell a, Cell b, MovementRule rule) {
  const auto free = [&](Cell c) {
    // Neighbours are numbered row by row; the middle has no bit.
    const int index = 3 * (c.y + 1) + c.x + 1;
    return index == 4 || ((around >> (index < 4 ? index : index - 1)) & 1) != 0;
  };
  const Cell d = b - a;
  if (d.x < -1 || d.x > 1 || d.y < -1 || d.y > 1 || d == Cell{0, 0}) return no_way;
  if (d.x == 0 || d.y == 0) return straight_cost;
  const bool left = free(a + Cell{d.x, 0}), right = free(a + Cell{0, d.y});
  const bool can = rule == MovementRule::allow || (rule == MovementRule::no_cut && left && right) ||
                   (rule == MovementRule::no_squeeze && (left || right));
  return can ? diagonal_cost : no_way;
}

/// Cost of the cheapest path from one neighbour of a cell to another that avoids the cell itself,
/// in at most two steps; longer paths are never better.
constexpr Cost cost_around(Neighbourhood around, std::size_t from, std::size_t to,
                           MovementRule rule) {
  Cost best = cost_between(around, steps[from], steps[to], rule);
  for (std::size_t middle = 0; middle < steps.size(); ++middle) {
    if (middle == from || !is_free(around, middle)) continue;
    best = std::min(best, cost_between(around, steps[from], steps[middle], rule) +
                              cost_between(around, steps[middle], steps[to], rule));
  }
  return best;
}

inline CanonicalTable make_canonical_table(MovementRule rule) {
  CanonicalTable table{};
  table[no_step] = successor_table(rule);
  for (std::size_t arrival = 0; arrival < no_step; ++arrival) {
    const std::size_t from = opposite(arrival);
    const bool keeps_equal =
        rule == MovementRule::four_connected ? steps[arrival].x == 0 : is_diagonal(arrival);
    for (std::size_t i = 0; i < 256; ++i) {
      const auto around = static_cast<Neighbourhood>(i | (1u << neighbour_bit[from]));
      for (std::size_t step = 0; step < steps.size(); ++step) {
        if (((table[no_step][i] >> step) & 1u) == 0 || step == from) continue;
        const Cost through = step_cost(arrival) + step_cost(step);
        const Cost past = cost_around(around, from, step, rule);
        if (past < through || (past == through && !keeps_equal)) continue;
        table[arrival][i] = static_cast<StepSet>(table[arrival][i] | (1u << step));
      }
    }
  }
  return table;
}

/// For each step of arrival (`no_step`: none) and every neighbourhood, the allowed steps but those
/// back to the parent and to cells to which the parent has a step of its own: its expansion has
/// reached those at no greater cost.
inline CanonicalTable make_onward_table(MovementRule rule) {
  CanonicalTable table{};
  table[no_step] = successor_table(rule);
  const auto can_step_to = [&](Neighbourhood around, std::size_t from, std::size_t to) {
    const bool is_allowed = rule != MovementRule::four_connected || steps[from].x == steps[to].x ||
                            steps[from].y == steps[to].y;
    return is_allowed && cost_between(around, steps[from], steps[to], rule) < no_way;
  };
  for (std::size_t arrival = 0; arrival < no_step; ++arrival) {
    const std::size_t from = opposite(arrival);
    for (std::size_t i = 0; i < 256; ++i) {
      const auto around = static_cast<Neighbourhood>(i | (1u << neighbour_bit[from]));
      for (std::size_t step = 0; step < steps.size(); ++step) {
        if (((table[no_step][i] >> step) & 1u) == 0 || step == from) continue;
        if (can_step_to(around, from, step)) continue;
        table[arrival][i] = static_cast<StepSet>(table[arrival][i] | (1u << step));
      }
    }
  }
  return table;
}

/// The successor table of a rule, built at its first use: as a constant expression it would add a
/// fifth of a second to the compilation of every file that includes this header.
inline const SuccessorTable& all_successors(MovementRule rule) {
  static const std::array<SuccessorTable, 5> tables{
      successor_table(MovementRule::no_cut), successor_table(MovementRule::no_squeeze),
      successor_table(MovementRule::allow), successor_table(MovementRule::four_connected),
      successor_table(MovementRule::by_edge)};
  return tables[static_cast<std::size_t>(rule)];
}

/// The tables by step of arrival of a rule, built at their first use.
struct ArrivalTables {
  CanonicalTable canonical, onward;
};
template <MovementRule Rule>
const ArrivalTables& arrival_tables() {
  static const ArrivalTables tables{make_canonical_table(Rule), make_onward_table(Rule)};
  return tables;
}
inline const ArrivalTables& arrival_tables(MovementRule rule) {
  switch (rule) {
    case MovementRule::no_squeeze:
      return arrival_tables<MovementRule::no_squeeze>();
    case MovementRule::allow:
      return arrival_tables<MovementRule::allow>();
    case MovementRule::four_connected:
      return arrival_tables<MovementRule::four_connected>();
    case MovementRule::by_edge:
      return arrival_tables<MovementRule::by_edge>();
    case MovementRule::no_cut:
      break;
  }
  return arrival_tables<MovementRule::no_cut>();
}
inline const CanonicalTable& canonical_table(MovementRule rule) {
  return arrival_tables(rule).canonical;
}
inline const CanonicalTable& onward_table(MovementRule rule) { return arrival_tables(rule).onward; }

}  // namespace tutavia::detail
