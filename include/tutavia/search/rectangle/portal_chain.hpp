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
/// Rails: a path from one free rectangle to the next, whose nodes slide along what they share.

namespace tutavia::detail {

/// Cells that two successive free rectangles share, and the one of them where the path passes; the
/// interval's side is where the path goes.
struct Rail {
  CellInterval cells;
  int place = 0;

  Cell node() const { return cells.cell(place); }
};

/// Where along the line of a rail the shortest way from one cell by that line to another passes;
/// `place` where they both lie on it and it makes no difference.
inline double crossing(const CellInterval& line, Cell before, Cell after, int place) {
  const auto along = [&](Cell c) { return line.axis == 0 ? c.x : c.y; };
  const auto aside = [&](Cell c) { return std::abs((line.axis == 0 ? c.y : c.x) - line.line); };
  const int from = along(before), to = along(after), depth = aside(before) + aside(after);
  if (depth == 0) return std::clamp(place, std::min(from, to), std::max(from, to));
  return from + (static_cast<double>(to) - from) * aside(before) / depth;
}

/// The place of a rail nearest to one on its line.
inline int nearest_place(const CellInterval& rail, double place) {
  return static_cast<int>(std::lround(std::clamp<double>(place, rail.first, rail.last)));
}

inline double cell_distance(Cell a, Cell b) {
  const double x = static_cast<double>(b.x) - a.x, y = static_cast<double>(b.y) - a.y;
  return std::sqrt(x * x + y * y);
}

/// Moves every node but the first and the last along its rail to where the way from the node before
/// to the one after is shortest, to whole cells, from first to last and again until none moves or
/// `sweeps` are done. Never lengthens the path.
/// Source: Zhang, Li and Bi 2016 mention such a "slide-rail corner adjustment" without its steps.
inline void slide(std::vector<Rail>& rails, int sweeps = 50) {
  for (bool moved = true; moved && sweeps > 0; --sweeps) {
    moved = false;
    for (std::size_t i = 1; i + 1 < rails.size(); ++i) {
      const Cell before = rails[i - 1].node(), after = rails[i + 1].node();
      Rail& rail = rails[i];
      const auto way = [&](int place) {
        const Cell node = rail.cells.cell(place);
        return cell_distance(before, node) + cell_distance(node, after);
      };
      const double best = crossing(rail.cells, before, after, rail.place);
      int place = rail.place;
      for (const double whole : {std::floor(best), std::ceil(best)}) {
        const int candidate = nearest_place(rail.cells, whole);
        if (way(candidate) < way(place) - 1e-6) place = candidate;
      }
      moved = moved || place != rail.place;
      rail.place = place;
    }
  }
}

/// Whether the straight line between two cells crosses the line of a rail within the rail, or
/// touches the rail.
inline bool passes(const CellInterval& rail, Cell a, Cell b) {
  const Cell first = rail.cell(rail.first), last = rail.cell(rail.last);
  const auto sign = [](std::int64_t v) { return (v > 0) - (v < 0); };
  const auto side = [&](Cell c) {
    return sign(rail.axis == 0 ? std::int64_t{c.y} - rail.line : std::int64_t{c.x} - rail.line);
  };
  if (side(a) * side(b) > 0) return false;
  if (side(a) == 0 && side(b) == 0) {
    const auto [low, high] = rail.axis == 0 ? std::minmax({a.x, b.x}) : std::minmax({a.y, b.y});
    return low <= rail.last && rail.first <= high;
  }
  return sign(turn(a, b, first)) * sign(turn(a, b, last)) <= 0;
}

/// Appends the corners of a path along rails, from its last node to its first: nodes are left out
/// where a straight line leads through their rails, looked for in steps that double and then
/// halve. O(n log n). \pre there are rails
inline void append_corners(const std::vector<Rail>& rails, std::vector<Cell>& cells) {
  cells.push_back(rails.back().node());
  for (std::size_t from = rails.size() - 1; from > 0;) {
    const auto leads_to = [&](std::size_t end) {
      for (std::size_t i = end + 1; i < from; ++i) {
        if (!passes(rails[i].cells, rails[from].node(), rails[end].node())) return false;
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
    append_cell(cells, rails[from].node());
  }
}

}  // namespace tutavia::detail
