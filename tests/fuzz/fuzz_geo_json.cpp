// SPDX-License-Identifier: MIT
/// \file
/// Any text as GeoJSON: it is refused or read as by a second walk over its values, and its
/// obstacles make a space or are refused by validation.

#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>

#include "fuzz/check_obstacles.hpp"
#include "support/reference_json.hpp"
#include "support/same_obstacles.hpp"
#include "tutavia/io/geo_json.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tutavia;
  const std::string text(reinterpret_cast<const char*>(data), size);
  auto file = parse_geo_json(text);
  const auto expected = test::ReferenceGeoJson::read(text);
  if (file.has_value() != expected.has_value()) std::abort();
  if (!file) return 0;
  if (!test::same_obstacles(file->scene.workspace.obstacles, *expected)) std::abort();
  test::check_obstacles(std::move(file->scene.workspace.obstacles));
  return 0;
}
