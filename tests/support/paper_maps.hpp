// SPDX-License-Identifier: MIT
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tutavia/grid/occupancy_grid.hpp"

/// \file
/// Grids that stand for those of papers which print none.

namespace tutavia::test {

/// The grids of one set of the SSA-A* paper ("cluster_20" ... "random_50"): the start is cell
/// (0, 0), the goal the last cell.
inline std::vector<OccupancyGrid> ssa_grids(const std::string& set) {
  std::ifstream file(std::string(TUTAVIA_TEST_DATA) + "/ssa_grids.json");
  std::vector<OccupancyGrid> grids;
  const auto sets = nlohmann::json::parse(file);
  for (const auto& rows : sets.at(set)) {
    const auto size = static_cast<int>(rows.size());
    OccupancyGrid grid = OccupancyGrid::blocked(size, size).value();
    for (int y = 0; y < size; ++y) {
      const auto row = rows[static_cast<std::size_t>(y)].get<std::string>();
      for (int x = 0; x < size; ++x) grid.set({x, y}, row[static_cast<std::size_t>(x)] != '#');
    }
    grids.push_back(std::move(grid));
  }
  return grids;
}

}  // namespace tutavia::test
