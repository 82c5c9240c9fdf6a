// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "tutavia/search/grid/expansion_search.hpp"
#include "tutavia/search/grid/goal_estimate.hpp"
#include "tutavia/search/grid/grid_expansion.hpp"
#include "tutavia/search/grid/search_context.hpp"
#include "tutavia/search/grid/search_grid.hpp"
#include "tutavia/search/query_checks.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// BidirectionalSearch: two waves of A* that meet.

namespace tutavia::detail {

/// Memory of a bidirectional search.
struct BidirectionalScratch {
  GridExpansionScratch forward, backward;
  std::vector<Cell> cells, half;
};

/// Two waves, from the start and from the goal, on their way to each other.
template <GridSpace S, Observer O>
class MeetingWaves {
 public:
  MeetingWaves(SearchContext<S, O>& context, const GridQuery& linked, BidirectionalScratch& scratch)
      : context_(context),
        forward_(context, linked, scratch.forward),
        backward_(context, linked.reversed(), scratch.backward) {}

  /// Expands cells until no meeting can be better than the best one found.
  Expected<void, Failure> run() {
    auto within = expand_in_turn();
    const Statistics &forward = forward_.context.statistics,
                     &backward = backward_.context.statistics;
    context_.statistics.expanded = forward.expanded + backward.expanded;
    context_.statistics.generated = forward.generated + backward.generated;
    if (within && best_ == std::numeric_limits<Cost>::max()) return fail(PlanError::unreachable);
    return within;
  }

  /// The path found, from the goal's cell back to the start's. `half` is memory.
  void trace(std::vector<Cell>& cells, std::vector<Cell>& half) const {
    const OccupancyGrid& grid = context_.space.grid();
    const Cell middle = grid.cell(meeting_);
    cells.clear();
    detail::trace(grid, backward_.wave.labels(), middle, cells);
    std::reverse(cells.begin(), cells.end());
    half.clear();
    detail::trace(grid, forward_.wave.labels(), middle, half);
    cells.insert(cells.end(), half.begin() + 1, half.end());
  }

 private:
  using Wave = GridExpansion<SuccessorRule::all, OctileHeuristic, S, O>;

  /// A wave with counts of its own.
  struct Side {
    Side(const SearchContext<S, O>& whole, const GridQuery& linked, GridExpansionScratch& scratch)
        : context{whole.space, whole.query, whole.observer},
          wave(context, OctileHeuristic(linked), linked.starts, scratch) {}

    /// Cells labelled and not yet expanded, about.
    std::uint64_t open_cells() const {
      return context.statistics.generated - context.statistics.expanded;
    }

    SearchContext<S, O> context;
    Wave wave;
  };

  Expected<void, Failure> expand_in_turn() {
    while (true) {
      const std::uint64_t expanded =
          forward_.context.statistics.expanded + backward_.context.statistics.expanded;
      if (auto within = check_budget(context_.query.budget, expanded, 256); !within) return within;
      const bool go_forward = forward_.open_cells() <= backward_.open_cells();
      if (!(go_forward ? offset_along(forward_, backward_) : offset_along(backward_, forward_)))
        return {};
    }
  }

  /// Expands one cell of a wave; false when the wave has come to its end.
  bool offset_along(Side& mine, const Side& other) {
    typename Wave::Popped popped;
    if (!mine.wave.pop(best_, popped)) return false;
    if (other.wave.labels().reached(popped.index)) {
      const Cost total = popped.g + other.wave.labels().g(popped.index);
      if (total < best_) {
        best_ = total;
        meeting_ = popped.index;
      }
    }
    mine.wave.expand(popped);
    return true;
  }

  SearchContext<S, O>& context_;
  Side forward_, backward_;
  Cost best_ = std::numeric_limits<Cost>::max();
  std::uint32_t meeting_ = 0;
};

/// The search of BidirectionalAStar.
struct BidirectionalSearch {
  BidirectionalScratch& scratch;

  template <GridSpace S, Observer O>
  Expected<GridPath, Failure> run(const GridQuery& linked, SearchContext<S, O>& context) const {
    MeetingWaves<S, O> waves(context, linked, scratch);
    if (auto found = waves.run(); !found) return std::move(found).unexpected();
    waves.trace(scratch.cells, scratch.half);
    return GridPath{scratch.cells};
  }
};

}  // namespace tutavia::detail
