// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/skip.hpp"
#include "tutavia/io/moving_ai.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/space/cell_space.hpp"

/// \file
/// The MovingAI maps, if they are installed.

namespace tutavia::test {

/// Rows of a MovingAI scenario as queries on its map.
struct MovingAiMap {
  std::string name;
  CellSpace space;
  std::vector<ScenarioRow> rows;

  Query query(const ScenarioRow& row) const {
    return {.start = space.frame().point(row.start), .goal = space.frame().point(row.goal)};
  }
};

/// Calls `visit(map)` for every map of the folder, by name, with `count` rows of its scenario,
/// evenly strided. Returns false without a folder; the test is then reported as skipped.
template <class Visit>
bool for_each_moving_ai_map(std::size_t count, Visit visit) {
  const char* folder = moving_ai_folder();
  if (folder == nullptr) return false;
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".map") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  REQUIRE_FALSE(paths.empty());
  for (const auto& path : paths) {
    MovingAiMap map{
        path.stem().string(), CellSpace::build(read_moving_ai_map(path).value()).value(), {}};
    const auto scenario = read_moving_ai_scenario(path.string() + ".scen").value();
    const std::size_t rows = std::min(count, scenario.size());
    for (std::size_t i = 0; i < rows; ++i) {
      map.rows.push_back(scenario[i * scenario.size() / rows]);
    }
    visit(map);
  }
  return true;
}

}  // namespace tutavia::test
