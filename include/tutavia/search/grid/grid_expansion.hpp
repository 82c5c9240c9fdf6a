// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "tutavia/grid/bitboard/successors.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/grid/bucket_queue.hpp"
#include "tutavia/search/grid/grid_labels.hpp"
#include "tutavia/search/grid/grid_query.hpp"
#include "tutavia/search/grid/search_context.hpp"
#include "tutavia/search/heuristic.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// GridExpansion: best-first search over the cells of a grid (speed: docs/performance.md).

namespace tutavia::detail {

/// Memory of one expansion, kept from query to query.
struct GridExpansionScratch {
  GridLabels labels;
  Buckets buckets;
};

/// A heuristic for searches ordered in buckets: a function of cells, and the logarithm of the width
/// of buckets (see BucketQueue).
template <class H>
concept BucketHeuristic = requires(const H& heuristic, Cell cell) {
  { heuristic(cell) } -> std::same_as<Cost>;
  { H::bucket_shift } -> std::convertible_to<int>;
};

/// Which steps a search follows from a cell.
enum class SuccessorRule {
  all,
  canonical,  ///< those of the canonical table, which reach every cell at the same cost
};

/// Expansion from a set of seed cells in the order of least f = g + h. A* and Dijkstra's algorithm
/// use one, bidirectional search two. Counts expanded and generated cells in its context.
template <SuccessorRule Successors, BucketHeuristic Heuristic, GridSpace S, Observer O>
class GridExpansion {
 public:
  /// A cell popped from the open list, with its current label.
  struct Popped {
    std::uint32_t index;
    Cell cell;
    Cost g;
    std::size_t arrival;
  };

  /// Starts from cells that are reached from outside the grid, each at a cost.
  GridExpansion(SearchContext<S, O>& context, const Heuristic& heuristic,
                std::span<const CellLink> seeds, GridExpansionScratch& scratch)
      : context_(context),
        grid_(context.space.grid().view()),
        tables_(tables(context.space.movement())),
        heuristic_(heuristic),
        labels_(scratch.labels.reset(context.space.grid().index_count())),
        open_(scratch.buckets, least_f(heuristic, seeds)) {
    const OccupancyGrid& grid = context.space.grid();
    for (std::size_t step = 0; step < steps.size(); ++step) {
      offsets_[step] = static_cast<std::uint32_t>(grid.index(steps[step]) - grid.index({0, 0}));
    }
    for (const auto& [cell, cost] : seeds) {
      relax(static_cast<std::uint32_t>(grid_.index(cell)), cell, cost, no_step);
    }
  }

  /// Pops the next cell with f < limit into `out`; false if there is none.
  bool pop(Cost limit, Popped& out) {
    while (!open_.empty()) {
      const Cost bucket = open_.seek_first();
      if (bucket >= limit) return false;
      const BucketEntry entry = open_.pop();
      const std::uint64_t label = labels_[entry.node];
      if (LabelWords::tag(label) != entry.tag) continue;  // a cheaper path was found since
      const Cell cell = grid_.cell(entry.node);
      const Cost g = labels_.words().g(label);
      if (bucket > limit - open_.width && g + heuristic_(cell) >= limit) continue;
      out = {entry.node, cell, g, LabelWords::arrival(label)};
      return true;
    }
    return false;
  }

  void expand(const Popped& from) {
    context_.count_expanded(from.cell);
    unsigned left = tables_[is_canonical ? from.arrival : 0][grid_.neighbourhood(from.index)];
    const bool has_parent = !is_canonical && from.arrival != no_step;
    if (has_parent) left &= ~(1u << opposite(from.arrival));
    while (left != 0) {
      const auto step = static_cast<unsigned>(std::countr_zero(left));
      left &= left - 1;
      relax(from.index + offsets_[step], from.cell + steps[step], from.g + step_cost(step), step);
    }
  }

  /// f of a popped cell.
  Cost f(const Popped& popped) const { return popped.g + heuristic_(popped.cell); }

  const GridLabels::View& labels() const { return labels_; }

 private:
  static constexpr bool is_canonical = Successors == SuccessorRule::canonical;

  /// Indexed by the step of arrival; a single table if the search is not canonical.
  static const SuccessorTable* tables(MovementRule rule) {
    return is_canonical ? canonical_table(rule).data() : &all_successors(rule);
  }

  static Cost least_f(const Heuristic& heuristic, std::span<const CellLink> seeds) {
    Cost least = std::numeric_limits<Cost>::max();
    for (const auto& [cell, cost] : seeds) least = std::min(least, cost + heuristic(cell));
    return least;
  }

  void relax(std::uint32_t index, Cell cell, Cost g, std::size_t step) {
    const std::uint64_t label = labels_.words().word(g, step);
    if (!labels_.improve(index, label)) return;
    context_.count_generated(cell);
    if (step != no_step) labels_.prefetch(index + offsets_[step]);  // likely to be next
    open_.push(g + heuristic_(cell), index, LabelWords::tag(label));
  }

  SearchContext<S, O>& context_;
  OccupancyGrid::View grid_;
  const SuccessorTable* tables_;
  Heuristic heuristic_;
  GridLabels::View labels_;
  BucketQueue<Heuristic::bucket_shift> open_;
  std::array<std::uint32_t, 8> offsets_{};
};

}  // namespace tutavia::detail
