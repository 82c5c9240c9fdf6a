// SPDX-License-Identifier: MIT
#include "map_input.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "tutavia/world/maps.hpp"
#include "usage_error.hpp"

namespace plan_program {

using namespace tutavia;

std::optional<Scene> builtin_map(std::string_view name) {
  if (name == "maze") return maps::maze();
  if (name == "array") return maps::array();
  if (name == "complex") return maps::complex();
  if (name == "rrt_scene_1") return maps::rrt_scene_1();
  if (name == "rrt_scene_2") return maps::rrt_scene_2();
  return std::nullopt;
}

Box bounds_around(const Scene& scene) {
  Box box = scene.workspace.extent();
  if (detail::is_finite(scene.start)) box.include(scene.start);
  for (const Point& goal : scene.goals) box.include(goal);
  const double margin =
      std::max(0.1 * std::max(box.width(), box.height()), 4 * scene.workspace.safety_radius);
  return box.inflated(margin > 0 ? margin : 1);
}

MovingAiOptions moving_ai_options(std::string_view terrain) {
  using DirectionalTerrain = MovingAiOptions::DirectionalTerrain;
  return {terrain == "free"      ? DirectionalTerrain::free
          : terrain == "blocked" ? DirectionalTerrain::blocked
                                 : DirectionalTerrain::refused};
}

OccupancyGrid cells_or_throw(Expected<OccupancyGrid, Failure> cells,
                             std::string_view terrain_option) {
  if (!cells) {
    std::string& text = cells.error().detail;
    const std::size_t at = text.find(detail::directional_option);
    if (at != std::string::npos) {
      text.replace(at, detail::directional_option.size(), terrain_option);
    }
    throw UsageError{std::move(text)};
  }
  return std::move(*cells);
}

}  // namespace plan_program
