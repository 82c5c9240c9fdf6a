// SPDX-License-Identifier: MIT
/// \file
/// Any text as a workspace file: it is refused or read as by a second walk over its values, and
/// then it is a valid workspace that survives the way to JSON and back.

#include <cstdint>
#include <cstdlib>
#include <string>

#include "support/reference_json.hpp"
#include "support/same_obstacles.hpp"
#include "tutavia/io/workspace_json.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/world/workspace_report.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tutavia;
  const std::string input(reinterpret_cast<const char*>(data), size);
  const auto file = parse_scene_json(input);
  const auto expected = test::reference_scene(input);
  if (file.has_value() != (expected.has_value() && validate(*expected).has_value())) std::abort();
  if (!file) return 0;
  if (!test::same_obstacles(file->scene.workspace.obstacles, expected->obstacles)) std::abort();
  if (!validate(file->scene.workspace)) std::abort();
  (void)inspect(file->scene.workspace);
  const auto space = InflatedSpace::build(file->scene.workspace);
  if (!space) std::abort();
  const Box& bounds = space->bounds();
  (void)space->clearance(0.5 * bounds.min + 0.5 * bounds.max);
  const std::string text =
      scene_to_json(file->scene).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  const auto again = parse_scene_json(text);
  if (!again || scene_to_json(again->scene) != scene_to_json(file->scene)) std::abort();
  return 0;
}
