// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "tutavia/core/error.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/search/row_runs.hpp"

/// \file
/// RectangleMesh: the free cells of a grid as few rectangles, prepared.

namespace tutavia {

/// A decomposition of a grid's free cells into rectangles, with the sides they share: what RowRuns
/// finds anew for every query, in fewer and larger pieces. Four bytes per cell and some 60 per
/// rectangle; made in O(cells).
class RectangleMesh {
 public:
  /// Row by row: the run that begins at the first free cell not yet taken, and as many rows of it
  /// downwards as are free and not taken.
  static RectangleMesh build(const OccupancyGrid& grid);

  /// The rectangles as bytes, to be kept in a file.
  std::string to_bytes() const;
  /// What `to_bytes` gave. `invalid_input` for anything else, and for rectangles that are not a
  /// decomposition of this grid's free cells.
  static Expected<RectangleMesh, Failure> from_bytes(std::string_view bytes,
                                                     const OccupancyGrid& grid);

  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t size() const { return boxes_.size(); }
  std::size_t memory() const {
    return owners_.size() * sizeof(std::uint32_t) + boxes_.size() * sizeof(CellBox) +
           first_exit_.size() * sizeof(std::uint32_t) + exits_.size() * sizeof(Exit);
  }

  /// The rectangle that holds a free cell.
  const CellBox& box(Cell cell) const { return boxes_[owner(cell)]; }

  /// Calls `visit(right, left, cell)` for every side that a rectangle shares with a neighbour: its
  /// ends as seen from within, and a cell of the neighbour.
  template <class Visit>
  void for_each_exit(const CellBox& box, const Visit& visit) const {
    const std::uint32_t id = owner({box.x0, box.y0});
    for (std::uint32_t i = first_exit_[id]; i < first_exit_[id + 1]; ++i) {
      visit(exits_[i].right, exits_[i].left, exits_[i].beyond);
    }
  }

 private:
  struct Exit {
    Cell right, left, beyond;
  };
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  explicit RectangleMesh(const OccupancyGrid& grid)
      : width_(grid.width()),
        height_(grid.height()),
        owners_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), none) {}

  std::uint32_t owner(Cell cell) const { return owners_[place(cell)]; }
  std::size_t place(Cell cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(cell.x);
  }

  /// Takes cells for a new rectangle; false, and nothing is changed but owners, if one is taken.
  bool add(const CellBox& box) {
    const auto id = static_cast<std::uint32_t>(boxes_.size());
    for (int y = box.y0; y < box.y1; ++y) {
      for (int x = box.x0; x < box.x1; ++x) {
        std::uint32_t& owner = owners_[place({x, y})];
        if (owner != none) return false;
        owner = id;
      }
    }
    boxes_.push_back(box);
    return true;
  }

  /// Finds the sides that rectangles share.
  void join() {
    for (const CellBox& box : boxes_) {
      first_exit_.push_back(static_cast<std::uint32_t>(exits_.size()));
      // Counterclockwise: from `at` on in direction `d`, with the outside at `out`.
      walk({box.x0, box.y0}, {1, 0}, box.x1 - box.x0, {0, -1});
      walk({box.x1, box.y0}, {0, 1}, box.y1 - box.y0, {0, 0});
      walk({box.x1, box.y1}, {-1, 0}, box.x1 - box.x0, {-1, 0});
      walk({box.x0, box.y1}, {0, -1}, box.y1 - box.y0, {-1, -1});
    }
    first_exit_.push_back(static_cast<std::uint32_t>(exits_.size()));
  }
  void walk(Cell corner, Cell d, int count, Cell out) {
    std::uint32_t before = none;
    for (int i = 0; i < count; ++i) {
      const Cell from{corner.x + i * d.x, corner.y + i * d.y}, beyond = from + out;
      const bool inside = 0 <= beyond.x && beyond.x < width_ && 0 <= beyond.y && beyond.y < height_;
      const std::uint32_t id = inside ? owner(beyond) : none;
      if (id != none && id == before) {
        exits_.back().left = from + d;
      } else if (id != none) {
        exits_.push_back({from, from + d, beyond});
      }
      before = id;
    }
  }

  int width_, height_;
  std::vector<std::uint32_t> owners_;  // by cell; none: blocked
  std::vector<CellBox> boxes_;
  std::vector<std::uint32_t> first_exit_;  // by rectangle, and the end
  std::vector<Exit> exits_;
};

inline RectangleMesh RectangleMesh::build(const OccupancyGrid& grid) {
  RectangleMesh mesh(grid);
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const auto is_open = [&](int column, int row) {
        return grid.is_free(Cell{column, row}) && mesh.owner({column, row}) == none;
      };
      if (!is_open(x, y)) continue;
      CellBox box{x, y, x + 1, y + 1};
      while (box.x1 < grid.width() && is_open(box.x1, y)) ++box.x1;
      const auto row_is_open = [&](int row) {
        if (grid.run_end(row, box.x0, true) < box.x1) return false;
        for (int column = box.x0; column < box.x1; ++column) {
          if (mesh.owner({column, row}) != none) return false;
        }
        return true;
      };
      while (box.y1 < grid.height() && row_is_open(box.y1)) ++box.y1;
      mesh.add(box);
      x = box.x1 - 1;
    }
  }
  mesh.join();
  return mesh;
}

namespace detail {

inline constexpr std::string_view rectangle_mesh_magic = "tutavia rectangle mesh 1\n";

}  // namespace detail

inline std::string RectangleMesh::to_bytes() const {
  std::string bytes(detail::rectangle_mesh_magic);
  bytes.reserve(bytes.size() + 16 * boxes_.size());
  for (const CellBox& box : boxes_) {
    for (const int value : {box.x0, box.y0, box.x1, box.y1}) {
      for (int i = 0; i < 4; ++i) {
        bytes += static_cast<char>(static_cast<std::uint32_t>(value) >> (8 * i) & 0xFF);
      }
    }
  }
  return bytes;
}

inline Expected<RectangleMesh, Failure> RectangleMesh::from_bytes(std::string_view bytes,
                                                                  const OccupancyGrid& grid) {
  const std::string_view magic = detail::rectangle_mesh_magic;
  if (bytes.substr(0, magic.size()) != magic || (bytes.size() - magic.size()) % 16 != 0) {
    return fail(PlanError::invalid_input, "not a rectangle mesh of this version");
  }
  RectangleMesh mesh(grid);
  const auto number = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
    }
    return static_cast<int>(std::min<std::uint32_t>(value, std::numeric_limits<int>::max()));
  };
  std::size_t cells = 0;
  for (std::size_t at = magic.size(); at < bytes.size(); at += 16) {
    const CellBox box{number(at), number(at + 4), number(at + 8), number(at + 12)};
    bool fits =
        box.x0 < box.x1 && box.x1 <= grid.width() && box.y0 < box.y1 && box.y1 <= grid.height();
    for (int y = box.y0; fits && y < box.y1; ++y) {
      fits = grid.run_end(y, box.x0, true) >= box.x1;
    }
    if (!fits || !mesh.add(box)) {
      return fail(PlanError::invalid_input, "the rectangle mesh was made for another grid");
    }
    cells += static_cast<std::size_t>(box.x1 - box.x0) * static_cast<std::size_t>(box.y1 - box.y0);
  }
  if (cells != grid.count_free()) {
    return fail(PlanError::invalid_input, "the rectangle mesh was made for another grid");
  }
  mesh.join();
  return mesh;
}

}  // namespace tutavia
