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
/// BidirectionalSearch: A* from the start and from the goal until they meet.

namespace tutavia::detail {

/// Memory of a bidirectional search.
struct BidirectionalScratch {
  GridExpansionScratch forward, backward;
  std::vector<Cell> cells, half;
};

/// Two expansions, one from the start and one from the goal.
template <GridSpace S, Observer O>
class BidirectionalExpansion {
 public:
  BidirectionalExpansion(SearchContext<S, O>& context, const GridQuery& linked,
                         BidirectionalScratch& scratch)
      : context_(context),
        forward_(context, linked, scratch.forward),
        backward_(context, linked.reversed(), scratch.backward) {}

  /// Expands cells until no meeting can be cheaper than the best one found.
  Expected<void, Failure> run() {
    auto within = expand_in_turn();
    const Statistics &forward = forward_.context.statistics,
                     &backward = backward_.context.statistics;
    context_.statistics.expanded = forward.expanded + backward.expanded;
    context_.statistics.generated = forward.generated + backward.generated;
    if (within && best_ == std::numeric_limits<Cost>::max()) return fail(PlanError::unreachable);
    return within;
  }

  /// The path found, from the goal's cell back to the start's. `half` is scratch memory.
  void trace(std::vector<Cell>& cells, std::vector<Cell>& half) const {
    const OccupancyGrid& grid = context_.space.grid();
    const Cell middle = grid.cell(meeting_);
    cells.clear();
    detail::trace(grid, backward_.expansion.labels(), middle, cells);
    std::reverse(cells.begin(), cells.end());
    half.clear();
    detail::trace(grid, forward_.expansion.labels(), middle, half);
    cells.insert(cells.end(), half.begin() + 1, half.end());
  }

 private:
  using Expansion = GridExpansion<SuccessorRule::all, OctileHeuristic, S, O>;

  /// One expansion with its own statistics.
  struct Side {
    Side(const SearchContext<S, O>& whole, const GridQuery& linked, GridExpansionScratch& scratch)
        : context{whole.space, whole.query, whole.observer},
          expansion(context, OctileHeuristic(linked), linked.starts, scratch) {}

    /// The approximate number of cells labelled and not yet expanded.
    std::uint64_t open_cells() const {
      return context.statistics.generated - context.statistics.expanded;
    }

    SearchContext<S, O> context;
    Expansion expansion;
  };

  Expected<void, Failure> expand_in_turn() {
    while (true) {
      const std::uint64_t expanded =
          forward_.context.statistics.expanded + backward_.context.statistics.expanded;
      if (auto within = check_budget(context_.query.budget, expanded, 256); !within) return within;
      const bool go_forward = forward_.open_cells() <= backward_.open_cells();
      if (!(go_forward ? expand_one(forward_, backward_) : expand_one(backward_, forward_)))
        return {};
    }
  }

  /// Expands one cell of a side. Returns false when it has no cell left.
  bool expand_one(Side& mine, const Side& other) {
    typename Expansion::Popped popped;
    if (!mine.expansion.pop(best_, popped)) return false;
    if (other.expansion.labels().reached(popped.index)) {
      const Cost total = popped.g + other.expansion.labels().g(popped.index);
      if (total < best_) {
        best_ = total;
        meeting_ = popped.index;
      }
    }
    mine.expansion.expand(popped);
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
    BidirectionalExpansion<S, O> search(context, linked, scratch);
    if (auto found = search.run(); !found) return std::move(found).unexpected();
    search.trace(scratch.cells, scratch.half);
    return GridPath{scratch.cells};
  }
};

}  // namespace tutavia::detail
