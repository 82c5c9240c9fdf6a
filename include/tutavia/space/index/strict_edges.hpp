// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "tutavia/grid/bitboard/successors.hpp"
#include "tutavia/grid/movement.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/space/index/mitred_zones.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/world/frame.hpp"

/// \file
/// The edges of a lattice by the rule of the DSP paper; see EdgeRule::paper_strict.

namespace tutavia::detail {

/// A value rounded to double, also where the compiler would fuse it with the next operation.
inline double rounded(double value) {
  const volatile double stored = value;
  return stored;
}

/// Whether the computed distance of two lattice nodes is at most the computed sqrt(2) delta. Every
/// operation is rounded on its own: for about half of all diagonal steps the coordinates' rounding
/// errors decide.
inline bool is_strictly_near(const Point& a, const Point& b, double delta) {
  const double dx = rounded(b.x() - a.x()), dy = rounded(b.y() - a.y());
  const double squared = rounded(rounded(dx * dx) + rounded(dy * dy));
  return rounded(std::sqrt(squared)) <= rounded(std::numbers::sqrt2 * delta);
}

/// The safety zones of a lattice by the paper's rule, and the steps of every node by its index.
struct StrictEdges {
  MitredZones zones;
  std::vector<StepSet> steps;
};

/// Nodes and edges in a grid and frame from `sample_lattice`. Marks the free nodes in `grid`.
inline StrictEdges strict_edges(const InflatedSpace& space, const Frame& frame,
                                OccupancyGrid& grid) {
  StrictEdges result{MitredZones(space.workspace()), std::vector<StepSet>(grid.index_count(), 0)};
  const auto free = [&](Cell a, Cell b) {
    const Point p = frame.point(a), q = frame.point(b);
    return space.segment_free(p, q) && !result.zones.enters(p, q);
  };
  const auto node = [&](Cell cell) {
    return Point(rounded(frame.origin.x() + rounded(frame.resolution * cell.x)),
                 rounded(frame.origin.y() + rounded(frame.resolution * cell.y)));
  };
  const auto for_each_cell = [&](auto visit) {
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) visit(Cell{x, y});
    }
  };
  for_each_cell([&](Cell cell) { grid.set(cell, free(cell, cell)); });
  for_each_cell([&](Cell cell) {
    if (!grid.is_free(cell)) return;
    for (std::size_t step = 0; step < 4; ++step) {  // and the opposite ones
      const Cell next = cell + steps[step];
      if (!grid.contains(next) || !grid.is_free(next)) continue;
      if (!is_strictly_near(node(cell), node(next), frame.resolution)) continue;
      if (!free(cell, next)) continue;
      StepSet& here = result.steps[grid.index(cell)];
      StepSet& there = result.steps[grid.index(next)];
      here = static_cast<StepSet>(here | (1u << step));
      there = static_cast<StepSet>(there | (1u << opposite(step)));
    }
  });
  return result;
}

}  // namespace tutavia::detail
