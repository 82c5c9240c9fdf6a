// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <span>

#include "tutavia/grid/bitboard/successors.hpp"
#include "tutavia/grid/movement.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// StepRule: the steps from the cells of a grid space.

namespace tutavia::detail {

/// A grid space whose nodes may have steps of their own: `edge_steps()` holds the steps of every
/// node by index; empty unless `movement()` is `by_edge`.
template <class S>
concept EdgeStepSpace = GridSpace<S> && requires(const S& s) {
  { s.edge_steps() } -> std::same_as<std::span<const StepSet>>;
};

/// The steps from a cell: those of the space's movement rule, or the node's own.
class StepRule {
 public:
  template <GridSpace S>
  explicit StepRule(const S& space)
      : grid_(space.grid().view()), table_(&all_successors(space.movement())) {
    if constexpr (EdgeStepSpace<S>) {
      if (!space.edge_steps().empty()) own_ = space.edge_steps().data();
    }
  }

  unsigned operator()(std::size_t index) const {
    return own_ != nullptr ? own_[index] : (*table_)[grid_.neighbourhood(index)];
  }

 private:
  OccupancyGrid::View grid_;
  const SuccessorTable* table_;
  const StepSet* own_ = nullptr;
};

}  // namespace tutavia::detail
