// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "tutavia/core/parts/bytes.hpp"
#include "tutavia/grid/bitboard/places.hpp"
#include "tutavia/grid/bitboard/successors.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// JumpTable: precomputed jump distances for JPS+.

namespace tutavia {

/// The length of the jump from every cell in every direction, under `no_cut`: n > 0 for n steps to
/// a jump point, -n for n free steps before an obstacle. A jump point is a cell with a forced
/// neighbour or, for diagonal jumps, a cell from which a straight jump reaches one. A jump takes
/// one byte, so the eight jumps of a cell fit one word; jumps of more than 126 steps are followed
/// in legs.
///
/// Source: the distances are those of Harabor and Grastien 2014, "Improving jump point search",
/// section "Preprocessing".
///
/// Example: examples/searches_on_cells.cpp.
class JumpTable {
 public:
  /// The jumps from one cell, by step.
  using Row = std::array<std::int8_t, 8>;

  /// Stands for `leg` free steps without a jump point; the jump continues from the cell at their
  /// end.
  static constexpr int far = 127;
  static constexpr int leg = 126;

  enum class Threads { one, two };

  /// Computes the table in O(cells); the result does not depend on the number of threads.
  static JumpTable build(const OccupancyGrid& grid, Threads threads = Threads::one);

  /// Serialises the table: 8 bytes per cell after a short header.
  std::string to_bytes() const;
  /// Restores the output of `to_bytes`. `invalid_input` for anything else, and for the table of
  /// another grid.
  static Expected<JumpTable, Failure> from_bytes(std::string_view bytes, const OccupancyGrid& grid);

  int width() const { return width_; }
  int height() const { return height_; }
  /// Whether this is the table of a grid, compared by a hash of its cells.
  bool matches(const OccupancyGrid& grid) const {
    return width_ == grid.width() && height_ == grid.height() && grid_hash_ == hash(grid);
  }

  /// The row of a cell by its index in the grid. \pre the cell lies in the grid
  const Row& row(std::size_t index) const { return rows_[index]; }
  /// The full jump from a cell in a direction, over all its legs. \pre the cell lies in the grid
  int jump(std::size_t from, std::size_t step) const {
    const int first = row(from)[step];
    return first != far ? first : jump_on(from, step);
  }

  std::size_t memory() const { return rows_.size() * sizeof(Row); }

 private:
  class Filler;

  explicit JumpTable(const OccupancyGrid& grid)
      : width_(grid.width()),
        height_(grid.height()),
        grid_hash_(hash(grid)),
        places_(grid),
        rows_(grid.index_count()) {}

  Row& row(Cell cell) { return rows_[places_.of(cell).in_rows()]; }

  int jump_on(std::size_t from, std::size_t step) const {
    for (int legs = leg;; legs += leg) {
      from += leg * places_.per_step(step);
      const int next = row(from)[step];
      if (next != far) return next > 0 ? legs + next : next - legs;
    }
  }

  /// Of all cells' rows, in a file.
  std::size_t byte_count() const {
    return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * sizeof(Row);
  }

  static std::uint64_t hash(const OccupancyGrid& grid) {  // FNV-1a over words
    std::uint64_t value = 0xCBF29CE484222325u;
    for (const std::uint64_t word : grid.words()) value = (value ^ word) * 0x100000001B3u;
    return value ^ static_cast<std::uint64_t>(grid.width());
  }

  int width_, height_;
  std::uint64_t grid_hash_;
  detail::Places places_;
  std::vector<Row> rows_;  // by index in the grid
};

namespace detail {

/// For every neighbourhood, the straight steps (as bits) whose jump stops at its centre cell.
inline const SuccessorTable& jump_stops() {
  static const SuccessorTable table = [] {
    const CanonicalTable& canonical = canonical_table(MovementRule::no_cut);
    SuccessorTable stops{};
    for (std::size_t around = 0; around < stops.size(); ++around) {
      for (std::size_t step = 0; step < steps.size(); step += 2) {
        const auto onwards = static_cast<StepSet>(1u << step);
        if ((canonical[step][around] & ~onwards) != 0) {
          stops[around] = static_cast<StepSet>(stops[around] | onwards);
        }
      }
    }
    return stops;
  }();
  return table;
}

inline constexpr std::string_view jump_table_magic = "tutavia jump table 2\n";

}  // namespace detail

/// Fills the jumps of a table that lead to the row above or below, row by row from the far end.
class JumpTable::Filler {
 public:
  /// `dy`: 1 for the jumps to the row above and along the rows; -1 for the jumps to the row below.
  Filler(JumpTable& table, const OccupancyGrid& grid, int dy)
      : table_(table),
        grid_(grid),
        dy_(dy),
        upright_(dy > 0 ? 2 : 6),
        right_(dy > 0 ? 1 : 7),
        left_(dy > 0 ? 3 : 5),
        columns_(static_cast<std::size_t>(grid.width())),
        before_(columns_ + 2),
        now_(columns_ + 2) {}

  void fill() {
    for (int i = 0; i < table_.height_; ++i) {
      const int y = dy_ > 0 ? table_.height_ - 1 - i : i;
      look_around(y);
      for (std::size_t x = columns_; x > 0; --x) jump_right(x);
      for (std::size_t x = 1; x <= columns_; ++x) {
        jump_on(x);
        write(table_.row({static_cast<int>(x - 1), y}), now_[x]);
      }
      std::swap(before_, now_);
    }
  }

 private:
  /// Full jumps from a cell, not cut into legs.
  struct Jumps {
    int right = 0, left = 0, upright = 0, diagonal_right = 0, diagonal_left = 0;
    StepSet successors = 0, stops = 0;
  };

  static int bit(StepSet set, std::size_t step) { return (set >> step) & 1; }
  /// A cell's jump, given that of the next cell: can_step ? (stop ? 1 : `next` extended by one) :
  /// 0. Unpredictable, so branch-free.
  static int jump_by(int can_step, int stop, int next) {
    const int further = next + (next > 0 ? 1 : -1);
    return -can_step & (((stop - 1) & further) | stop);
  }
  /// Whether a diagonal jump stops at a cell with these straight jumps.
  static int turns(int sideways, int ahead) {
    return static_cast<int>(sideways > 0) | static_cast<int>(ahead > 0);
  }
  static std::int8_t leg_of(int jump) {
    return static_cast<std::int8_t>(std::abs(jump) > leg ? far : jump);
  }

  void look_around(int y) {
    const std::size_t first = grid_.index({0, y});
    for (std::size_t x = 1; x <= columns_; ++x) {
      const detail::Neighbourhood around = grid_.view().neighbourhood(first + x - 1);
      now_[x].successors = successors_[around];
      now_[x].stops = stops_[around];
    }
  }

  void jump_right(std::size_t x) {
    const Jumps& next = now_[x + 1];
    now_[x].right = jump_by(bit(now_[x].successors, 0), bit(next.stops, 0), next.right);
  }

  /// The jumps to the left and to the next row.
  void jump_on(std::size_t x) {
    Jumps& jumps = now_[x];
    const StepSet can = jumps.successors;
    const Jumps &above = before_[x], &above_right = before_[x + 1], &above_left = before_[x - 1];
    jumps.left = jump_by(bit(can, 4), bit(now_[x - 1].stops, 4), now_[x - 1].left);
    jumps.upright = jump_by(bit(can, upright_), bit(above.stops, upright_), above.upright);
    jumps.diagonal_right = jump_by(bit(can, right_), turns(above_right.right, above_right.upright),
                                   above_right.diagonal_right);
    jumps.diagonal_left = jump_by(bit(can, left_), turns(above_left.left, above_left.upright),
                                  above_left.diagonal_left);
  }

  void write(Row& row, const Jumps& jumps) const {
    row[upright_] = leg_of(jumps.upright);
    row[right_] = leg_of(jumps.diagonal_right);
    row[left_] = leg_of(jumps.diagonal_left);
    if (dy_ < 0) return;
    row[0] = leg_of(jumps.right);
    row[4] = leg_of(jumps.left);
  }

  JumpTable& table_;
  const OccupancyGrid& grid_;
  const detail::SuccessorTable& successors_ = detail::all_successors(MovementRule::no_cut);
  const detail::SuccessorTable& stops_ = detail::jump_stops();
  int dy_;
  std::size_t upright_, right_, left_;  // steps
  std::size_t columns_;
  std::vector<Jumps> before_, now_;  // previous and current row, padded by a cell at each end
};

inline JumpTable JumpTable::build(const OccupancyGrid& grid, Threads threads) {
  JumpTable table(grid);
  const auto fill = [&](int dy) { Filler(table, grid, dy).fill(); };
  if (threads == Threads::two) {
    std::thread below(fill, -1);
    fill(1);
    below.join();
  } else {
    fill(1);
    fill(-1);
  }
  return table;
}

inline std::string JumpTable::to_bytes() const {
  std::string bytes(detail::jump_table_magic);
  bytes.reserve(bytes.size() + 16 + byte_count());
  detail::append_bytes(bytes, static_cast<std::uint64_t>(width_), 4);
  detail::append_bytes(bytes, static_cast<std::uint64_t>(height_), 4);
  detail::append_bytes(bytes, grid_hash_, 8);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      for (const std::int8_t jump : row(places_.of({x, y}).in_rows())) {
        bytes += static_cast<char>(jump);
      }
    }
  }
  return bytes;
}

inline Expected<JumpTable, Failure> JumpTable::from_bytes(std::string_view bytes,
                                                          const OccupancyGrid& grid) {
  const std::string_view magic = detail::jump_table_magic;
  const std::size_t head = magic.size() + 16;
  if (bytes.substr(0, magic.size()) != magic || bytes.size() < head) {
    return fail(PlanError::invalid_input, "not a jump table of this version");
  }
  JumpTable table(grid);
  if (detail::read_bytes(bytes, magic.size(), 4) != static_cast<std::uint64_t>(table.width_) ||
      detail::read_bytes(bytes, magic.size() + 4, 4) != static_cast<std::uint64_t>(table.height_) ||
      detail::read_bytes(bytes, magic.size() + 8, 8) != table.grid_hash_) {
    return fail(PlanError::invalid_input, "the jump table was made for another grid");
  }
  if (bytes.size() != head + table.byte_count()) {
    return fail(PlanError::invalid_input,
                "jump table of " + std::to_string(bytes.size()) + " bytes, " +
                    std::to_string(head + table.byte_count()) + " expected");
  }
  std::size_t from = head;
  for (int y = 0; y < table.height_; ++y) {
    for (int x = 0; x < table.width_; ++x) {
      for (std::size_t step = 0; step < steps.size(); ++step, ++from) {
        const auto jump = static_cast<std::int8_t>(static_cast<unsigned char>(bytes[from]));
        // A damaged table must not lead a search off the grid.
        const int length = jump == far ? leg : std::abs(int{jump});
        if (!grid.contains({x + length * steps[step].x, y + length * steps[step].y})) {
          return fail(PlanError::invalid_input, "the jump table is damaged");
        }
        table.row({x, y})[step] = jump;
      }
    }
  }
  return table;
}

}  // namespace tutavia
