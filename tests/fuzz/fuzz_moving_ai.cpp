// SPDX-License-Identifier: MIT
/// \file
/// Any text as a map and as a scenario of MovingAI: it is refused or read as by second readers.

#include <cstdint>
#include <cstdlib>
#include <string>

#include "support/reference_moving_ai.hpp"
#include "support/same_obstacles.hpp"
#include "tutavia/io/moving_ai.hpp"

namespace {

using namespace tutavia;
using DirectionalTerrain = MovingAiOptions::DirectionalTerrain;

void compare_map(const std::string& text, DirectionalTerrain directional, char meaning) {
  const auto grid = parse_moving_ai_map(text, {directional});
  const auto expected = test::reference_moving_ai_map(text, meaning);
  if (grid.has_value() != expected.has_value()) std::abort();
  if (!grid) return;
  if (static_cast<std::size_t>(grid->height()) != expected->size()) std::abort();
  for (int y = 0; y < grid->height(); ++y) {
    const std::string& row = (*expected)[static_cast<std::size_t>(y)];
    if (static_cast<std::size_t>(grid->width()) != row.size()) std::abort();
    for (int x = 0; x < grid->width(); ++x) {
      if (grid->is_free(Cell{x, y}) != (row[static_cast<std::size_t>(x)] == '.')) std::abort();
    }
  }
}

void compare_scenario(const std::string& text) {
  const auto rows = parse_moving_ai_scenario(text);
  const auto expected = test::reference_moving_ai_scenario(text);
  if (rows.has_value() != expected.has_value()) std::abort();
  if (!rows) return;
  if (rows->size() != expected->size()) std::abort();
  for (std::size_t i = 0; i < rows->size(); ++i) {
    const ScenarioRow& row = (*rows)[i];
    const auto& other = (*expected)[i];
    const std::vector<long long> numbers{row.bucket,  row.width,  row.height, row.start.x,
                                         row.start.y, row.goal.x, row.goal.y};
    if (numbers != other.numbers || row.map != other.map) std::abort();
    if (!test::same_bits(row.optimal_length, other.length)) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  compare_map(text, DirectionalTerrain::refused, '?');
  compare_map(text, DirectionalTerrain::blocked, '@');
  compare_map(text, DirectionalTerrain::free, '.');
  compare_scenario(text);
  return 0;
}
