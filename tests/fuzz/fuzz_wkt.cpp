// SPDX-License-Identifier: MIT
/// \file
/// Any text as WKT, and as CSV with a column of WKT: it is refused or read as by a second parser,
/// and its obstacles make a space or are refused by validation.

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/check_obstacles.hpp"
#include "support/reference_csv.hpp"
#include "support/reference_wkt.hpp"
#include "support/same_obstacles.hpp"
#include "tutavia/io/wkt.hpp"

namespace {

using namespace tutavia;

std::string without_mark(const std::string& text) {
  return text.rfind("\xEF\xBB\xBF", 0) == 0 ? text.substr(3) : text;
}

/// The obstacles of a CSV text by the second parsers.
std::optional<std::vector<Obstacle>> reference_of_column(const std::string& text) {
  const auto cells = test::reference_csv_column(text, "wkt");
  if (!cells) return std::nullopt;
  std::vector<Obstacle> all;
  for (const std::string& cell : *cells) {
    const auto obstacles = test::ReferenceWkt::read(cell, false);
    if (!obstacles) return std::nullopt;
    all.insert(all.end(), obstacles->begin(), obstacles->end());
  }
  return all;
}

void compare(Expected<WktObstacles, Failure> read,
             const std::optional<std::vector<Obstacle>>& expected) {
  if (read.has_value() != expected.has_value()) std::abort();
  if (!read) return;
  if (!test::same_obstacles(read->obstacles, *expected)) std::abort();
  test::check_obstacles(std::move(read->obstacles));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::string content = without_mark(text);
  compare(parse_wkt(text), test::ReferenceWkt::read(content));
  compare(parse_wkt(text, {.csv_column = "wkt"}), reference_of_column(content));
  return 0;
}
