// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/grid/safety_buffer.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/space/cell_space.hpp"

/// \file
/// Substitute grids for papers that publish none.

namespace tutavia::test {

namespace data_files {

inline nlohmann::json read_data(const std::string& name) {
  std::ifstream file(std::string(TUTAVIA_TEST_DATA) + "/" + name);
  return nlohmann::json::parse(file);
}

/// A grid from rows of characters; # is blocked.
inline OccupancyGrid to_grid(const nlohmann::json& rows) {
  const auto text = rows.get<std::vector<std::string>>();
  const auto width = static_cast<int>(text.at(0).size());
  OccupancyGrid grid = OccupancyGrid::blocked(width, static_cast<int>(text.size())).value();
  for (std::size_t y = 0; y < text.size(); ++y) {
    for (std::size_t x = 0; x < text[y].size(); ++x) {
      grid.set({static_cast<int>(x), static_cast<int>(y)}, text[y][x] != '#');
    }
  }
  return grid;
}

}  // namespace data_files

/// A grid with a query.
struct PaperTask {
  CellSpace space;
  Query query;
};

/// The grids of one set of the SSA-A* paper ("cluster_20" ... "random_50"): from cell (0, 0) to the
/// last cell; corners may be cut.
inline std::vector<PaperTask> ssa_tasks(const std::string& set) {
  const auto sets = data_files::read_data("ssa_grids.json");
  std::vector<PaperTask> tasks;
  for (const auto& rows : sets.at(set)) {
    OccupancyGrid grid = data_files::to_grid(rows);
    const Cell last{grid.width() - 1, grid.height() - 1};
    auto space = CellSpace::build(std::move(grid), {.movement = MovementRule::allow}).value();
    const Query query{.start = space.frame().point({0, 0}), .goal = space.frame().point(last)};
    tasks.push_back({std::move(space), query});
  }
  return tasks;
}

/// A substitute for map A, B or C of the paper "Improved REA*", without its safety buffer.
struct ReaMap {
  std::string name;
  OccupancyGrid grid;
  Cell start, goal;

  BufferedGrid buffered() const {
    const std::array ends{start, goal};
    return with_safety_buffer(grid, ends).value();
  }
  /// The task with the buffer, as in the paper.
  PaperTask task() const {
    auto space = CellSpace::build(buffered().grid).value();
    const Query query{.start = space.frame().point(start), .goal = space.frame().point(goal)};
    return {std::move(space), query};
  }
};

inline std::vector<ReaMap> rea_maps() {
  const auto all = data_files::read_data("rea_maps.json");
  const auto cell = [](const nlohmann::json& xy) { return Cell{xy.at(0), xy.at(1)}; };
  std::vector<ReaMap> maps;
  for (const auto& [name, map] : all.items()) {
    maps.push_back(
        {name, data_files::to_grid(map.at("rows")), cell(map.at("start")), cell(map.at("goal"))});
  }
  return maps;
}

/// The substitute for the raster of the JPS_Theta* paper: 20 rows of 30 cells.
inline PaperTask jps_theta_task() {
  const auto map = data_files::read_data("jps_theta_map.json").at("jps_theta_20x30");
  const auto cell = [&](const char* key) { return Cell{map.at(key).at(0), map.at(key).at(1)}; };
  auto space = CellSpace::build(data_files::to_grid(map.at("rows"))).value();
  const Query query{.start = space.frame().point(cell("start")),
                    .goal = space.frame().point(cell("goal"))};
  return {std::move(space), query};
}

}  // namespace tutavia::test
