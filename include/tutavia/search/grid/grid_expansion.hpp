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
    if (is_held_) {
      is_held_ = false;
      if (open_.current() >= limit) return false;
      if (is_below(limit, held_)) {
        out = held_;
        return true;
      }
    }
    while (!open_.empty()) {
      const Cost bucket = open_.seek_first();
      if (bucket >= limit) return false;
      const BucketEntry entry = open_.pop();
      const std::uint64_t label = labels_[entry.node];
      if (LabelWords::tag(label) != entry.tag) continue;  // a cheaper path was found since
      out = {entry.node, grid_.cell(entry.node), labels_.words().g(label),
             LabelWords::arrival(label)};
      if (is_below(limit, out)) return true;
    }
    return false;
  }

  void expand(const Popped& from) {
    context_.count_expanded(from.cell);
    unsigned left = tables_[from.arrival][grid_.neighbourhood(from.index)];
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
  /// Indexed by the step of arrival.
  static const SuccessorTable* tables(MovementRule rule) {
    const bool is_canonical = Successors == SuccessorRule::canonical;
    return (is_canonical ? canonical_table(rule) : onward_table(rule)).data();
  }

  /// Whether f of a cell from the current bucket is below a limit.
  bool is_below(Cost limit, const Popped& cell) const {
    return open_.current() <= limit - open_.width || f(cell) < limit;
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
    const Cost key = g + heuristic_(cell);
    // The last cell of the current bucket comes next: it is held back, not pushed and popped.
    if (step != no_step && open_.is_current(key)) {
      if (is_held_) {
        const std::uint64_t before = labels_.words().word(held_.g, held_.arrival);
        open_.push(open_.current(), held_.index, LabelWords::tag(before));
      }
      held_ = {index, cell, g, step};
      is_held_ = true;
      return;
    }
    open_.push(key, index, LabelWords::tag(label));
  }

  SearchContext<S, O>& context_;
  OccupancyGrid::View grid_;
  const SuccessorTable* tables_;
  Heuristic heuristic_;
  GridLabels::View labels_;
  BucketQueue<Heuristic::bucket_shift> open_;
  std::array<std::uint32_t, 8> offsets_{};
  Popped held_{};
  bool is_held_ = false;
};

}  // namespace tutavia::detail
