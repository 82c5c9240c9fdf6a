// SPDX-License-Identifier: MIT
/// \file
/// Any text as WKT: it is refused, or its obstacles make a space or are refused by validation.

#include <cstdint>
#include <string_view>
#include <utility>

#include "fuzz/check_obstacles.hpp"
#include "tutavia/io/wkt.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tutavia;
  auto read = parse_wkt({reinterpret_cast<const char*>(data), size});
  if (!read) return 0;
  test::check_obstacles(std::move(read->obstacles));
  return 0;
}
