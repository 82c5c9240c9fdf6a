// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <utility>

#include "tutavia/core/parts/compiler.hpp"
#include "tutavia/search/grid/jump_search.hpp"
#include "tutavia/search/jump_table.hpp"
#include "tutavia/search/query_checks.hpp"

/// \file
/// JPS+: jump point search with a precomputed jump table.

namespace tutavia {

/// Jump point search with precomputed jumps. Paths are the same as those of Jps. Errors:
/// `invalid_option` without the table of the space's grid (see `prepare`) and for any movement rule
/// but `no_cut`; others as for AStar. A table of another grid of the same size is not detected;
/// `JumpTable::matches` checks for it.
///
/// Source: Harabor and Grastien 2014, "Improving jump point search".
///
/// Example: examples/searches_on_cells.cpp.
struct JpsPlus {
  static constexpr std::string_view name = "jps_plus";
  using Scratch = detail::JumpScratch;
  using Prepared = JumpTable;

  std::shared_ptr<const JumpTable> table{};

  /// The jump table of a space's grid. `invalid_option` for any movement rule but `no_cut`.
  template <GridSpace S>
  static Expected<std::shared_ptr<const JumpTable>, Failure> prepare(
      const S& space, JumpTable::Threads threads = JumpTable::Threads::one) {
    if (auto valid = detail::check_no_cut(space, name); !valid)
      return std::move(valid).unexpected();
    return std::make_shared<const JumpTable>(JumpTable::build(space.grid(), threads));
  }

  template <GridSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    if (auto valid = detail::check_no_cut(space, name); !valid)
      return std::move(valid).unexpected();
    if (table == nullptr || table->width() != space.grid().width() ||
        table->height() != space.grid().height()) {
      return fail(PlanError::invalid_option, "jps_plus needs the table prepared for this grid");
    }
    return detail::jump_search(space, query, TableScanner{*table}, scratch, observer);
  }

 private:
  struct TableScanner {
    const JumpTable& table;

    void prefetch(Cell cell) const { tutavia::detail::prefetch(&table.row(cell)); }

    template <std::size_t Step>
    int straight(Cell from) const {
      return table.jump<Step>(from);
    }

    template <std::size_t Step, class Visit>
    void diagonal(Cell from, Cell goal, Visit visit) const {
      constexpr Cell d = steps[Step];
      constexpr std::size_t horizontal = d.x == 1 ? 0 : 4, vertical = d.y == 1 ? 2 : 6;
      const int at_row = (goal.y - from.y) * d.y, at_column = (goal.x - from.x) * d.x;
      const auto look = [&](int k) {
        const Cell at{from.x + k * d.x, from.y + k * d.y};
        visit(k, table.jump<horizontal>(at), table.jump<vertical>(at));
      };
      int k = 0;
      while (true) {
        const int next = table.row({from.x + k * d.x, from.y + k * d.y})[Step];
        const bool turns = 0 < next && next != JumpTable::far;  // jump point at the end
        const int end = k + (next == JumpTable::far ? JumpTable::leg : std::abs(next));
        // Cells next to `goal` may be goals too, and reachable from here although no jump point is.
        const int first = std::min(at_row, at_column) - 1, last = std::max(at_row, at_column) + 1;
        for (int near = std::max(k + 1, first); near <= std::min(end, last); ++near) {
          const bool meets = std::abs(at_row - near) <= 1 || std::abs(at_column - near) <= 1;
          if (!meets) {
            near = std::max(at_row, at_column) - 2;  // no goal lies between the two
          } else if (near < end || !turns) {
            look(near);
          }
        }
        if (next <= 0) return;
        k = end;
        if (turns) look(k);
      }
    }
  };
};

}  // namespace tutavia
