// SPDX-License-Identifier: MIT
#pragma once

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

/// Jump point search with precomputed jumps. Paths are the same as those of Jps, which needs an
/// eighth of the memory and is the better choice: the table saves a tenth to a fifth of the time
/// while the caches hold it, and nothing otherwise (docs/performance.md). Errors:
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
    return detail::jump_search(space, query, TableScanner{*table, detail::Places(space.grid())},
                               scratch, observer);
  }

 private:
  struct TableScanner {
    const JumpTable& table;
    detail::Places places;

    void prefetch(std::uint32_t index) const { detail::prefetch_for_reading(&table.row(index)); }

    detail::Jump straight(std::size_t step, std::size_t from) const {
      const int jump = table.jump(from, step), length = std::abs(jump);
      const std::size_t end = from + static_cast<std::size_t>(length) * places.per_step(step);
      return {static_cast<std::uint32_t>(end), length, jump > 0};
    }
    detail::Jump straight(std::size_t step, const detail::Place& from) const {
      return straight(step, from.in_rows());
    }

    template <class Visit>
    detail::Jump diagonal(std::size_t step, Cell, const detail::Place& from, Visit visit) const {
      std::size_t at = from.in_rows();
      for (int k = 0;;) {
        const int next = table.row(at)[step];
        if (next <= 0) return {0, k - next, false};
        const int leg = next == JumpTable::far ? JumpTable::leg : next;
        k += leg;
        at += static_cast<std::size_t>(leg) * places.per_step(step);
        if (next == JumpTable::far) continue;
        visit(k, straight(detail::horizontal_of(step), at),
              straight(detail::vertical_of(step), at));
      }
    }
  };
};

}  // namespace tutavia
