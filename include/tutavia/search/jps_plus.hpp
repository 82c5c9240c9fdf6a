// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "tutavia/search/jps.hpp"

/// \file
/// JPS+: jump point search on a precomputed table.

namespace tutavia {

/// For every cell and step how far a jump goes: n > 0 steps to a jump point (diagonally: to a cell
/// from which a straight jump reaches one), or -n, n free steps before a wall.
class JumpTable {
 public:
  using Row = std::array<std::int16_t, 8>;

  /// Computes the table of a grid under `no_cut` in O(cells), rows and columns by up to `threads`
  /// threads; the result does not depend on their number. `limit_exceeded` for grids of more than
  /// 32767 cells a side.
  static Expected<JumpTable, Failure> build(const OccupancyGrid& grid, const StopPlanes& planes,
                                            unsigned threads = 1);

  /// The table as bytes, to be kept in a file; 16 per cell and a short head.
  std::string to_bytes() const;
  /// What `to_bytes` gave. `invalid_input` for anything else, and for the table of another grid.
  static Expected<JumpTable, Failure> from_bytes(std::string_view bytes, const OccupancyGrid& grid);

  int width() const { return width_; }
  int height() const { return height_; }
  /// Whether this is the table of a grid (by a hash of its cells).
  bool matches(const OccupancyGrid& grid) const {
    return width_ == grid.width() && height_ == grid.height() && grid_hash_ == hash(grid);
  }
  /// \pre the cell lies in the grid
  const Row& operator[](Cell cell) const {
    return rows_[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(width_) +
                 static_cast<std::size_t>(cell.x)];
  }
  std::size_t memory() const { return rows_.size() * sizeof(Row); }

 private:
  JumpTable(const OccupancyGrid& grid)
      : width_(grid.width()),
        height_(grid.height()),
        grid_hash_(hash(grid)),
        rows_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}

  Row& at(Cell cell) { return const_cast<Row&>(std::as_const(*this)[cell]); }
  static std::uint64_t hash(const OccupancyGrid& grid) {  // FNV-1a over words
    std::uint64_t value = 0xCBF29CE484222325u;
    for (const std::uint64_t word : grid.words()) value = (value ^ word) * 0x100000001B3u;
    return value ^ static_cast<std::uint64_t>(grid.width());
  }

  int width_, height_;
  std::uint64_t grid_hash_;
  std::vector<Row> rows_;
};

/// Jump point search that looks its jumps up. Same answers as Jps; needs the table of the space's
/// grid (`prepare`), else `invalid_option`; a table of another grid of the same size is not noticed
/// (ask `JumpTable::matches`). Source: Harabor and Grastien 2014, "Improving jump point search".
struct JpsPlus {
  static constexpr std::string_view name = "jps_plus";
  using Scratch = JumpScratch;
  using Prepared = JumpTable;

  std::shared_ptr<const JumpTable> table{};

  /// The table of a space's grid. Errors: those of JumpTable::build; `invalid_option` for another
  /// movement rule than `no_cut`.
  template <JumpSpace S>
  static Expected<std::shared_ptr<const JumpTable>, Failure> prepare(const S& space,
                                                                     unsigned threads = 1) {
    if (space.movement() != MovementRule::no_cut) {
      return fail(PlanError::invalid_option, "jps_plus is defined for the movement rule no_cut");
    }
    auto table = JumpTable::build(space.grid(), space.stop_planes(), threads);
    if (!table) return Unexpected{table.error()};
    return std::shared_ptr<const JumpTable>(std::make_shared<JumpTable>(std::move(*table)));
  }

  template <GridSpace S, Observer O = NoObserver>
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  O& observer) const {
    if (space.movement() != MovementRule::no_cut) {
      return fail(PlanError::invalid_option, "jps_plus is defined for the movement rule no_cut");
    }
    if (table == nullptr || table->width() != space.grid().width() ||
        table->height() != space.grid().height()) {
      return fail(PlanError::invalid_option, "jps_plus needs the table prepared for this grid");
    }
    return jump_search(space, query, TableScanner{*table}, scratch, observer);
  }

 private:
  struct TableScanner {
    const JumpTable& table;

    void prefetch([[maybe_unused]] Cell cell) const {
#if defined(__GNUC__)
      __builtin_prefetch(&table[cell]);
#endif
    }

    template <std::size_t Step>
    int straight(Cell from) const {
      return table[from][Step];
    }

    template <std::size_t Step, class Visit>
    void diagonal(Cell from, Cell goal, Visit visit) const {
      constexpr Cell d = steps[Step];
      constexpr std::size_t horizontal = d.x == 1 ? 0 : 4, vertical = d.y == 1 ? 2 : 6;
      const int at_row = (goal.y - from.y) * d.y, at_column = (goal.x - from.x) * d.x;
      const auto look = [&](int k) {
        const JumpTable::Row& row = table[{from.x + k * d.x, from.y + k * d.y}];
        visit(k, int{row[horizontal]}, int{row[vertical]});
      };
      int k = 0;
      while (true) {
        const int next = table[{from.x + k * d.x, from.y + k * d.y}][Step];
        const int end = k + std::abs(next);
        // Goals next to the cell `goal` may be seen from here though no jump point is.
        const int first = std::min(at_row, at_column) - 1, last = std::max(at_row, at_column) + 1;
        for (int near = std::max(k + 1, first); near <= std::min(end, last); ++near) {
          const bool meets = std::abs(at_row - near) <= 1 || std::abs(at_column - near) <= 1;
          if (!meets) {
            near = std::max(at_row, at_column) - 2;  // between the two nothing is near
          } else if (near < end || next <= 0) {
            look(near);
          }
        }
        if (next <= 0) return;
        k = end;
        look(k);
      }
    }
  };
};

inline Expected<JumpTable, Failure> JumpTable::build(const OccupancyGrid& grid,
                                                     const StopPlanes& planes, unsigned threads) {
  constexpr int longest = std::numeric_limits<std::int16_t>::max();
  if (grid.width() > longest || grid.height() > longest) {
    return fail(PlanError::limit_exceeded, "grid of " + std::to_string(grid.width()) + " x " +
                                               std::to_string(grid.height()) +
                                               " cells, 32767 a side allowed by jps_plus");
  }
  JumpTable table(grid);
  const int width = grid.width(), height = grid.height();
  // Calls `work(first, last)` for ranges of 0 ... count - 1, each on a thread of its own.
  const auto in_parallel = [threads](int count, const auto& work) {
    const int parts = std::clamp(static_cast<int>(threads), 1, std::max(1, count / 64));
    std::vector<std::thread> workers;
    for (int i = 1; i < parts; ++i) {
      workers.emplace_back([&work, count, parts, i] {
        work(static_cast<int>(std::int64_t{count} * i / parts),
             static_cast<int>(std::int64_t{count} * (i + 1) / parts));
      });
    }
    work(0, count / parts);
    for (std::thread& worker : workers) worker.join();
  };
  const auto longer = [](int next) {
    return static_cast<std::int16_t>(next > 0 ? next + 1 : next - 1);
  };

  // A cell's jump from that of the next cell, which comes before it.
  const auto set_straight = [&](Cell cell, std::size_t step) {
    const Cell next = cell + steps[step];
    std::int16_t& value = table.at(cell)[step];
    if (!grid.is_free(next)) {
      value = 0;
    } else if (planes.is_stop(next, step)) {
      value = 1;
    } else {
      value = longer(table[next][step]);
    }
  };
  in_parallel(height, [&](int first, int last) {
    for (int y = first; y < last; ++y) {
      for (const std::size_t step : {std::size_t{0}, std::size_t{4}}) {
        const int dx = steps[step].x;
        for (int i = 0, x = dx > 0 ? width - 1 : 0; i < width; ++i, x -= dx) {
          set_straight({x, y}, step);
        }
      }
    }
  });
  in_parallel(width, [&](int first, int last) {
    for (const std::size_t step : {std::size_t{2}, std::size_t{6}}) {
      const int dy = steps[step].y;
      for (int i = 0, y = dy > 0 ? height - 1 : 0; i < height; ++i, y -= dy) {
        for (int x = first; x < last; ++x) {
          set_straight({x, y}, step);
        }
      }
    }
  });
  // A row of diagonal jumps needs the row next to it: the two pairs of directions go at once.
  const auto diagonals = [&](int dy) {
    for (int i = 0, y = dy > 0 ? height - 1 : 0; i < height; ++i, y -= dy) {
      for (int x = 0; x < width; ++x) {
        const Neighbourhood around = grid.view().neighbourhood(grid.index({x, y}));
        for (const int dx : {1, -1}) {
          const std::size_t step = dy > 0 ? (dx > 0 ? 1 : 3) : (dx > 0 ? 7 : 5);
          std::int16_t& value = table.at({x, y})[step];
          if (!detail::can_step(around, step, MovementRule::no_cut)) {
            value = 0;
            continue;
          }
          const Row& next = table[{x + dx, y + dy}];
          const bool turns = next[dx > 0 ? 0 : 4] > 0 || next[dy > 0 ? 2 : 6] > 0;
          value = turns ? std::int16_t{1} : longer(next[step]);
        }
      }
    }
  };
  if (threads > 1) {
    std::thread other([&] { diagonals(-1); });
    diagonals(1);
    other.join();
  } else {
    diagonals(1);
    diagonals(-1);
  }
  return table;
}

namespace detail {

inline constexpr std::string_view jump_table_magic = "tutavia jump table 1\n";

inline void append_bytes(std::string& bytes, std::uint64_t value, int count) {
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFF);
}
inline std::uint64_t read_bytes(std::string_view bytes, std::size_t from, int count) {
  std::uint64_t value = 0;
  for (int i = 0; i < count; ++i) {
    value |= std::uint64_t{static_cast<unsigned char>(bytes[from + static_cast<std::size_t>(i)])}
             << (8 * i);
  }
  return value;
}

}  // namespace detail

inline std::string JumpTable::to_bytes() const {
  std::string bytes(detail::jump_table_magic);
  detail::append_bytes(bytes, static_cast<std::uint64_t>(width_), 4);
  detail::append_bytes(bytes, static_cast<std::uint64_t>(height_), 4);
  detail::append_bytes(bytes, grid_hash_, 8);
  bytes.reserve(bytes.size() + memory());
  for (const Row& row : rows_) {
    for (const std::int16_t value : row) {
      detail::append_bytes(bytes, static_cast<std::uint16_t>(value), 2);
    }
  }
  return bytes;
}

inline Expected<JumpTable, Failure> JumpTable::from_bytes(std::string_view bytes,
                                                          const OccupancyGrid& grid) {
  const std::size_t head = detail::jump_table_magic.size() + 16;
  if (bytes.substr(0, detail::jump_table_magic.size()) != detail::jump_table_magic ||
      bytes.size() < head) {
    return fail(PlanError::invalid_input, "not a jump table of this version");
  }
  JumpTable table(grid);
  const std::size_t at = detail::jump_table_magic.size();
  const auto is = [&](std::size_t from, int count, std::uint64_t value) {
    return detail::read_bytes(bytes, at + from, count) == value;
  };
  if (!is(0, 4, static_cast<std::uint64_t>(table.width_)) ||
      !is(4, 4, static_cast<std::uint64_t>(table.height_)) || !is(8, 8, table.grid_hash_)) {
    return fail(PlanError::invalid_input, "the jump table was made for another grid");
  }
  if (bytes.size() != head + table.memory()) {
    return fail(PlanError::invalid_input, "jump table of " + std::to_string(bytes.size()) +
                                              " bytes, " + std::to_string(head + table.memory()) +
                                              " expected");
  }
  std::size_t from = head;
  for (int y = 0; y < table.height_; ++y) {
    for (int x = 0; x < table.width_; ++x) {
      for (std::size_t step = 0; step < steps.size(); ++step, from += 2) {
        const auto value = static_cast<std::int16_t>(
            static_cast<std::uint16_t>(detail::read_bytes(bytes, from, 2)));
        // A damaged table must not lead a search out of the grid.
        const Cell end{x + std::abs(value) * steps[step].x, y + std::abs(value) * steps[step].y};
        if (!grid.contains(end)) {
          return fail(PlanError::invalid_input, "the jump table is damaged");
        }
        table.at({x, y})[step] = value;
      }
    }
  }
  return table;
}

}  // namespace tutavia
