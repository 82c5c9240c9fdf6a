// SPDX-License-Identifier: MIT
/// \file
/// Any text as GeoJSON: it is refused, or its obstacles make a space or are refused by validation.

#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "tutavia/io/geo_json.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/world/workspace_report.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tutavia;
  auto file = parse_geo_json({reinterpret_cast<const char*>(data), size});
  if (!file) return 0;
  Workspace workspace{.bounds = {{-100, -100}, {100, 100}}, .safety_radius = 0.5};
  workspace.obstacles = std::move(file->scene.workspace.obstacles);
  if (!validate(workspace)) return 0;
  (void)inspect(workspace);
  const auto space = InflatedSpace::build(workspace);
  if (!space) std::abort();
  const double clearance = space->clearance({1, 2});
  if (space->is_free({1, 2}) && clearance < 0.5 - space->slack()) std::abort();
  return 0;
}
