// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include "tutavia/core/budget.hpp"
#include "tutavia/grid/bitboard/successors.hpp"
#include "tutavia/grid/movement.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/plan/statistics.hpp"
#include "tutavia/search/grid/grid_labels.hpp"
#include "tutavia/search/grid/grid_query.hpp"
#include "tutavia/search/grid/wide_bucket_queue.hpp"

/// \file
/// FlowRuns: labels every cell of a grid with its least cost from a set of seeds.

namespace tutavia::detail {

/// Dijkstra's algorithm over whole runs of cells. Steps follow the canonical table, so nearly every
/// cell continues in the direction in which it was reached. Such a run is labelled at once, and
/// from every cell of a diagonal run both straight runs beside it (with four neighbours: from
/// every cell of a vertical run the horizontal ones). Steps in other directions, at the corners of
/// obstacles, wait in an open list in the order of their costs.
///
/// A run ends at a cell that is known at no greater cost. Cells of a run may be reached at less
/// cost later, and are labelled again: a cell has its final label once the open list is empty.
/// Which steps the canonical table leaves out depends on the label of the cell alone, so the result
/// does not depend on the order.
class FlowRuns {
 public:
  FlowRuns(const OccupancyGrid& grid, MovementRule rule, std::span<const CellLink> seeds,
           GridLabels& labels)
      : grid_(grid.view()),
        table_(canonical_table(rule)),
        is_four_connected_(rule == MovementRule::four_connected),
        labels_(labels.reset(grid.index_count())),
        open_(std::make_unique<WideBucketQueue>()) {
    for (std::size_t step = 0; step < steps.size(); ++step) {
      offsets_[step] = static_cast<std::uint32_t>(grid.index(steps[step]) - grid.index({0, 0}));
    }
    Cost least = std::numeric_limits<Cost>::max();
    for (const CellLink& seed : seeds) least = std::min(least, seed.cost);
    open_->reset(least);
    for (const auto& [cell, cost] : seeds) {
      reach(static_cast<std::uint32_t>(grid_.index(cell)), labels_.words().word(cost, no_step));
    }
  }

  /// Labels all cells that can be reached. Counts the cells that it labels, again or not, as
  /// expanded. Errors: those of the budget, which a run of cells may exceed.
  Expected<void, Failure> run(const Budget& budget, Statistics& statistics) {
    for (unsigned runs = 0; !open_->empty(); ++runs) {
      open_->seek_first();
      const auto entry = open_->pop();
      const std::uint64_t label = labels_[entry.node];
      if (LabelWords::tag(label) != entry.tag) continue;  // a cheaper path was found since
      if (statistics.expanded >= budget.max_expansions) return fail(PlanError::budget_exhausted);
      if (runs % 32 == 0) {
        if (const auto exceeded = budget.exceeded()) return fail(*exceeded);
      }
      run_from(entry.node, label);
      statistics.expanded += labelled_;
      statistics.generated += labelled_;
      labelled_ = 0;
    }
    return {};
  }

 private:
  static constexpr int longest_run = 32;  // cells

  /// Whether runs in this direction send out straight runs on their way.
  bool sends_runs(std::size_t step) const {
    return is_four_connected_ ? steps[step].x == 0 : is_diagonal(step);
  }

  /// Records a path to a cell and puts the cell into the open list, if the path is the first or
  /// cheaper.
  void reach(std::uint32_t index, std::uint64_t label) {
    if (!labels_.improve(index, label)) return;
    open_->push(labels_.words().g(label), index, LabelWords::tag(label));
  }

  std::uint64_t stepped(std::uint64_t label, std::size_t step) const {
    return labels_.words().word(labels_.words().g(label) + step_cost(step), step);
  }

  /// Labels the run from a cell on, with the straight runs that it sends out.
  void run_from(std::uint32_t index, std::uint64_t label) {
    const std::size_t arrival = LabelWords::arrival(label);
    if (arrival == no_step || !sends_runs(arrival)) return run_straight(index, label);
    for (int length = 1;; ++length) {
      ++labelled_;
      unsigned left = table_[arrival][grid_.neighbourhood(index)];
      const bool goes_on = ((left >> arrival) & 1u) != 0;
      left &= ~(1u << arrival);
      for (; left != 0; left &= left - 1) {
        const auto step = static_cast<std::size_t>(std::countr_zero(left));
        const std::uint32_t next = index + offsets_[step];
        if (sends_runs(step)) {
          reach(next, stepped(label, step));
        } else if (const std::uint64_t word = stepped(label, step); labels_.improve(next, word)) {
          run_straight(next, word);
        }
      }
      if (!goes_on) return;
      index += offsets_[arrival];
      label = stepped(label, arrival);
      if (length == longest_run) return reach(index, label);
      if (!labels_.improve(index, label)) return;
    }
  }

  /// Labels the run from a cell on; steps to other directions wait in the open list.
  void run_straight(std::uint32_t index, std::uint64_t label) {
    const std::size_t arrival = LabelWords::arrival(label);
    for (int length = 1;; ++length) {
      ++labelled_;
      unsigned left = table_[arrival][grid_.neighbourhood(index)];
      const bool goes_on = arrival != no_step && ((left >> arrival) & 1u) != 0;
      if (goes_on) left &= ~(1u << arrival);
      for (; left != 0; left &= left - 1) {
        const auto step = static_cast<std::size_t>(std::countr_zero(left));
        reach(index + offsets_[step], stepped(label, step));
      }
      if (!goes_on) return;
      index += offsets_[arrival];
      label = LabelWords::farther(label, straight_cost);
      if (length == longest_run) return reach(index, label);
      if (!labels_.improve(index, label)) return;
    }
  }

  OccupancyGrid::View grid_;
  const CanonicalTable& table_;
  bool is_four_connected_;
  GridLabels::View labels_;
  std::unique_ptr<WideBucketQueue> open_;  // 17 kB
  std::array<std::uint32_t, 8> offsets_{};
  std::uint64_t labelled_ = 0;
};

}  // namespace tutavia::detail
