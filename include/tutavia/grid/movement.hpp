// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "tutavia/grid/cell.hpp"

/// \file
/// Movement rules, and the exact costs of steps.

namespace tutavia {

/// Which steps are allowed between neighbouring free cells.
enum class MovementRule {
  no_cut,          ///< a diagonal needs both of the cells beside it
  no_squeeze,      ///< a diagonal needs at least one of them
  allow,           ///< a diagonal needs neither
  four_connected,  ///< no diagonals
  by_edge,         ///< none by rule: the space lists the steps of each node (see EdgeRule)
};

/// Cost of a path in exact integers: 13860 for a straight step, 19601 for a diagonal one. Their
/// ratio is sqrt(2) to a relative 1.3e-9 (a convergent of its continued fraction, so no diagonal
/// ever costs less than sqrt(2) straight steps), and 64 bits hold 4.7e14 steps.
using Cost = std::int64_t;
inline constexpr Cost straight_cost = 13860;
inline constexpr Cost diagonal_cost = 19601;

/// The eight steps, counterclockwise from +x: even ones are straight, odd ones diagonal.
inline constexpr std::array<Cell, 8> steps{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

/// A set of steps: bit i stands for `steps[i]`.
using StepSet = std::uint8_t;

namespace detail {

constexpr bool is_diagonal(std::size_t step) { return step % 2 != 0; }
constexpr Cost step_cost(std::size_t step) {
  return is_diagonal(step) ? diagonal_cost : straight_cost;
}

}  // namespace detail

/// Cost of the cheapest path between two cells on a grid without obstacles.
constexpr Cost octile_cost(Cell a, Cell b) {
  const Cost dx = a.x < b.x ? Cost{b.x} - a.x : Cost{a.x} - b.x;
  const Cost dy = a.y < b.y ? Cost{b.y} - a.y : Cost{a.y} - b.y;
  return straight_cost * std::max(dx, dy) + (diagonal_cost - straight_cost) * std::min(dx, dy);
}

}  // namespace tutavia
