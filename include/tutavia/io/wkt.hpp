// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/multi_linestring.hpp>
#include <boost/geometry/geometries/multi_point.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/io/wkt/read.hpp>
#include <cctype>
#include <cstddef>
#include <exception>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/core/error.hpp"
#include "tutavia/space/boost_rtree.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// Obstacles in WKT.

namespace tutavia {

namespace detail {

/// Reads one WKT geometry with Boost.Geometry and turns it into obstacles.
class WktReader {
 public:
  /// Throws what Boost throws for malformed text, or a string.
  static void read(const std::string& text, std::vector<Obstacle>& out) {
    namespace bg = boost::geometry;
    const std::string type = keyword(text);
    if (type == "POINT") {
      out.emplace_back(Disc{to_point(parse<WktPoint>(text)), 0});
    } else if (type == "MULTIPOINT") {
      for (const auto& p : parse<bg::model::multi_point<WktPoint>>(text)) {
        out.emplace_back(Disc{to_point(p), 0});
      }
    } else if (type == "LINESTRING") {
      out.emplace_back(wall(to_ring(parse<Line>(text))));
    } else if (type == "MULTILINESTRING") {
      for (const auto& line : parse<bg::model::multi_linestring<Line>>(text)) {
        out.emplace_back(wall(to_ring(line)));
      }
    } else if (type == "POLYGON") {
      out.emplace_back(solid(parse<Area>(text)));
    } else if (type == "MULTIPOLYGON") {
      for (const auto& area : parse<bg::model::multi_polygon<Area>>(text)) {
        out.emplace_back(solid(area));
      }
    } else {
      throw "unknown geometry \"" + type + "\"";
    }
  }

 private:
  using WktPoint = boost::geometry::model::d2::point_xy<double>;
  using Line = boost::geometry::model::linestring<WktPoint>;
  using Area = boost::geometry::model::polygon<WktPoint>;

  static std::string keyword(const std::string& text) {
    std::string word;
    for (const char c : text) {
      if (std::isalpha(static_cast<unsigned char>(c)) == 0) break;
      word += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    return word;
  }
  template <class Geometry>
  static Geometry parse(const std::string& text) {
    Geometry geometry;
    boost::geometry::read_wkt(text, geometry);
    return geometry;
  }
  static Point to_point(const WktPoint& p) { return {p.x(), p.y()}; }
  template <class Points>
  static Ring to_ring(const Points& points) {
    Ring ring;
    for (const WktPoint& p : points) ring.push_back(to_point(p));
    return ring;
  }
  static Polygon solid(const Area& area) {
    Polygon polygon{to_ring(area.outer())};
    for (const auto& hole : area.inners()) polygon.holes.push_back(to_ring(hole));
    return polygon;
  }
};

}  // namespace detail

/// Parses obstacles from WKT, coordinates in metres: any number of POLYGON, MULTIPOLYGON,
/// LINESTRING, MULTILINESTRING (walls without thickness), POINT and MULTIPOINT geometries, one
/// after the other over any number of lines; lines that begin with # are comments. `invalid_input`
/// with the line at which the bad geometry begins; obstacles are not validated before a space is
/// built.
inline Expected<std::vector<Obstacle>, Failure> parse_wkt(std::string_view text) {
  std::vector<Obstacle> obstacles;
  std::string geometry;
  std::size_t line = 1, first_line = 1;
  int depth = 0;
  bool comment = false, line_start = true;
  const auto finish = [&]() -> std::string {
    const std::string complete = std::exchange(geometry, {});
    if (complete.empty()) return {};
    try {
      detail::WktReader::read(complete, obstacles);
    } catch (const std::string& complaint) {
      return complaint;
    } catch (const std::exception& error) {
      return error.what();
    }
    return {};
  };
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const char c = i < text.size() ? text[i] : '\n';
    if (line_start && c == '#' && depth == 0) comment = true;
    if (!comment && (!geometry.empty() || std::isspace(static_cast<unsigned char>(c)) == 0)) {
      if (geometry.empty()) first_line = line;
      geometry += c == '\n' || c == '\r' || c == '\0' ? ' ' : c;
      if (c == '(') ++depth;
      if (c == ')') --depth;
    }
    const bool empty_ends = c == '\n' && depth == 0 && geometry.size() >= 6 &&
                            geometry.find("EMPTY") != std::string::npos;
    if (!geometry.empty() && ((c == ')' && depth <= 0) || empty_ends || i == text.size())) {
      const std::string complaint = finish();
      if (!complaint.empty()) {
        return fail(PlanError::invalid_input,
                    "line " + std::to_string(first_line) + ": " + complaint);
      }
      depth = 0;
    }
    line_start = c == '\n';
    if (line_start) {
      comment = false;
      ++line;
    }
  }
  return obstacles;
}

}  // namespace tutavia
