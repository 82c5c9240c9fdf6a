// SPDX-License-Identifier: MIT
/// \file
/// Any text as GeoJSON: it is refused, or its obstacles make a space or are refused by validation.

#include <cstdint>
#include <string_view>
#include <utility>

#include "fuzz/check_obstacles.hpp"
#include "tutavia/io/geo_json.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tutavia;
  auto file = parse_geo_json({reinterpret_cast<const char*>(data), size});
  if (!file) return 0;
  test::check_obstacles(std::move(file->scene.workspace.obstacles));
  return 0;
}
