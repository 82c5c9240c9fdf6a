// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "tutavia/search/grid/grid_query.hpp"
#include "tutavia/search/rectangle/free_rectangle.hpp"

/// \file
/// CellPortal: a path through free rectangles, whose nodes slide along the cells that these share.

namespace tutavia::detail {

/// A portal: the cells that two successive free rectangles share, and the one that the path
/// crosses. The interval's side points along the path.
struct CellPortal {
  CellInterval cells;
  int u = 0;

  Cell node() const { return cells.cell(u); }
};

/// The coordinate on a line where the shortest path from one cell via the line to another crosses
/// it. If both cells lie on the line, every coordinate between them will do: it is `u`, clamped to
/// that range.
inline double crossing(const CellInterval& line, Cell before, Cell after, int u) {
  const auto along = [&](Cell c) { return line.axis == 0 ? c.x : c.y; };
  const auto distance_to_line = [&](Cell c) {
    return std::abs((line.axis == 0 ? c.y : c.x) - line.line);
  };
  const int from = along(before), to = along(after),
            depth = distance_to_line(before) + distance_to_line(after);
  if (depth == 0) return std::clamp(u, std::min(from, to), std::max(from, to));
  return from + (static_cast<double>(to) - from) * distance_to_line(before) / depth;
}

/// The coordinate within a portal nearest to a coordinate on its line.
inline int nearest_column(const CellInterval& portal, double u) {
  return static_cast<int>(std::lround(std::clamp<double>(u, portal.first, portal.last)));
}

inline double cell_distance(Cell a, Cell b) {
  const double x = static_cast<double>(b.x) - a.x, y = static_cast<double>(b.y) - a.y;
  return std::sqrt(x * x + y * y);
}

/// Moves every node but the first and the last along its portal to the cell that minimises the
/// length from the previous to the next node. Sweeps from first to last until no node moves or
/// `sweeps` are done. Never lengthens the path.
///
/// Source: the paper on improved REA* mentions a slide rail for the corners of SBREA*, without its
/// steps.
inline void slide(std::vector<CellPortal>& portals, int sweeps = 50) {
  for (bool moved = true; moved && sweeps > 0; --sweeps) {
    moved = false;
    for (std::size_t i = 1; i + 1 < portals.size(); ++i) {
      const Cell before = portals[i - 1].node(), after = portals[i + 1].node();
      CellPortal& portal = portals[i];
      const auto length_via = [&](int u) {
        const Cell node = portal.cells.cell(u);
        return cell_distance(before, node) + cell_distance(node, after);
      };
      const double best = crossing(portal.cells, before, after, portal.u);
      int u = portal.u;
      for (const double whole : {std::floor(best), std::ceil(best)}) {
        const int candidate = nearest_column(portal.cells, whole);
        if (length_via(candidate) < length_via(u) - 1e-6) u = candidate;
      }
      moved = moved || u != portal.u;
      portal.u = u;
    }
  }
}

/// Whether the straight line between two cells crosses a portal or touches it.
inline bool crosses_portal(const CellInterval& portal, Cell a, Cell b) {
  const Cell first = portal.cell(portal.first), last = portal.cell(portal.last);
  const auto sign = [](std::int64_t v) { return (v > 0) - (v < 0); };
  const auto side = [&](Cell c) {
    return sign(portal.axis == 0 ? std::int64_t{c.y} - portal.line
                                 : std::int64_t{c.x} - portal.line);
  };
  if (side(a) * side(b) > 0) return false;
  if (side(a) == 0 && side(b) == 0) {
    const auto [low, high] = portal.axis == 0 ? std::minmax({a.x, b.x}) : std::minmax({a.y, b.y});
    return low <= portal.last && portal.first <= high;
  }
  return sign(turn(a, b, first)) * sign(turn(a, b, last)) <= 0;
}

/// Appends the vertices of a path through portals, from last to first. Removes nodes if a straight
/// line crosses the portals in between, found by doubling and halving steps. O(n log n).
/// \pre there are portals
inline void append_corners(const std::vector<CellPortal>& portals, std::vector<Cell>& cells) {
  cells.push_back(portals.back().node());
  for (std::size_t from = portals.size() - 1; from > 0;) {
    const auto leads_to = [&](std::size_t end) {
      for (std::size_t i = end + 1; i < from; ++i) {
        if (!crosses_portal(portals[i].cells, portals[from].node(), portals[end].node()))
          return false;
      }
      return true;
    };
    std::size_t to = from - 1, step = 1;
    while (step <= to && leads_to(to - step)) {
      to -= step;
      step *= 2;
    }
    for (; step > 0; step /= 2) {
      if (step <= to && leads_to(to - step)) to -= step;
    }
    from = to;
    append_cell(cells, portals[from].node());
  }
}

}  // namespace tutavia::detail
