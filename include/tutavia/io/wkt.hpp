// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/io/text/csv_column.hpp"
#include "tutavia/io/text/degrees.hpp"
#include "tutavia/io/text/parse_error.hpp"
#include "tutavia/io/text/source_text.hpp"
#include "tutavia/io/text/wkt_reader.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// parse_wkt: obstacles from WKT.

namespace tutavia {

/// Options of `parse_wkt`.
struct WktOptions {
  /// The column of a CSV text (RFC 4180, separated by commas, semicolons or tabs, with a header)
  /// whose cells are WKT; an empty cell is no obstacle. Empty: the text is not CSV.
  std::string csv_column{};
};

/// Parsed obstacles, and warnings about ignored parts.
struct WktObstacles {
  std::vector<Obstacle> obstacles;
  std::vector<std::string> warnings;  ///< one line each
};

/// Parses obstacles from WKT (OGC 06-103r4, section 7), coordinates in metres: any number of
/// POLYGON, MULTIPOLYGON, TRIANGLE, LINESTRING, MULTILINESTRING and LINEARRING (walls without
/// thickness), POINT, MULTIPOINT and GEOMETRYCOLLECTION, over any number of lines. Between them may
/// stand a `,` or `;`, and lines that start with #, which are comments. A geometry may be in double
/// quotes.
///
/// All vertices of a geometry have the same number of ordinates, two to four, or as many as its tag
/// Z, M or ZM says; those after x and y are dropped. A ring that does not end where it begins is
/// closed. `SRID=n;` before a geometry is ignored. Each of these gives a warning, and so do
/// coordinates that look like degrees. EMPTY, and `()` where several items may stand, is no
/// obstacle.
///
/// Errors: `invalid_input` with line and column, in bytes, for anything else. Obstacles are not
/// validated before a space is built.
inline Expected<WktObstacles, Failure> parse_wkt(std::string_view text,
                                                 const WktOptions& options = {}) {
  text = detail::without_byte_order_mark(text);
  return detail::parse_or_fail([&] {
    detail::WktReader reader(text);
    if (options.csv_column.empty()) {
      reader.read();
    } else {
      detail::for_each_in_csv_column(text, options.csv_column, [&](const detail::CsvCell& cell) {
        reader.read_cell(cell.begin, cell.end);
      });
    }
    detail::DegreeCheck degrees;
    degrees.add(reader.obstacles);
    detail::warn_of_degrees(degrees, reader.warnings);
    return WktObstacles{std::move(reader.obstacles), std::move(reader.warnings)};
  });
}

}  // namespace tutavia
