// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "tutavia/geometry/polygon.hpp"
#include "tutavia/io/text/source_text.hpp"
#include "tutavia/io/text/wkt_cursor.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// WktReader: the parser behind parse_wkt.

namespace tutavia::detail {

/// A strict parser: any text that it does not fully understand is an error, because a lenient one
/// would misplace obstacles.
class WktReader : private WktCursor {
 public:
  explicit WktReader(std::string_view text) : WktCursor(text) {}

  /// Reads all geometries of the text. Throws ParseError with line and column.
  void read() {
    for (skip_comments(); !is_end(); skip_comments()) {
      entry();
      skip_comments();
      if (accept(',')) {
        skip_comments();
        if (is_end()) expected(next_, "a geometry after ','");
      } else {
        accept(';');
      }
    }
  }

  /// The same for the bytes [begin, end) of the text, where no line is a comment.
  void read_cell(std::size_t begin, std::size_t end) {
    next_ = begin;
    end_ = end;
    has_comments_ = false;
    read();
  }

  std::vector<Obstacle> obstacles{};
  std::vector<std::string> warnings{};

 private:
  /// Ordinates per vertex of a geometry, from its tag or its first vertex; 0: not known yet.
  using Dimension = std::size_t;

  /// A geometry at top level, which may be in quotes and have an SRID.
  void entry() {
    first_ = next_;
    const bool in_quotes = accept('"');
    skip_space();
    read_srid();
    geometry(0, 0);
    if (in_quotes && !accept('"')) expected(next_, "'\"' at the end of the geometry");
  }

  void read_srid() {
    const std::size_t at = next_;
    if (!equal_in_any_case(word(), "SRID")) {
      next_ = at;
      return;
    }
    if (is_end() || text_[next_] != '=') expected(next_, "'=' after SRID");
    ++next_;
    int id = 0;
    const auto [last, status] = std::from_chars(text_.data() + next_, text_.data() + end_, id);
    if (status != std::errc{}) expected(next_, "a whole number after SRID=");
    next_ = static_cast<std::size_t>(last - text_.data());
    if (!accept(';')) expected(next_, "';' after the SRID");
    if (std::find(srids_.begin(), srids_.end(), id) != srids_.end()) return;
    srids_.push_back(id);
    warnings.push_back(position_text(text_, at) + "SRID=" + std::to_string(id) +
                       " is ignored; coordinates are taken as metres");
  }

  /// `inherited` is the dimension of the collection that contains the geometry.
  void geometry(Dimension inherited, int depth) {
    skip_space();
    const std::size_t at = next_;
    std::string_view type = word();
    dimension_ = tag(type);
    if (inherited != 0 && dimension_ != 0 && dimension_ != inherited) {
      error(at, "a geometry of " + std::to_string(dimension_) + " ordinates in a collection of " +
                    std::to_string(inherited));
    }
    if (dimension_ == 0) dimension_ = inherited;
    const auto is = [&](std::string_view name) { return equal_in_any_case(type, name); };
    if (is("POINT")) {
      add_point();
    } else if (is("MULTIPOINT")) {
      list([this] { add_point_of_many(); });
    } else if (is("LINESTRING")) {
      add_line(false);
    } else if (is("LINEARRING")) {
      add_line(true);
    } else if (is("MULTILINESTRING")) {
      list([this] { add_line(false); });
    } else if (is("POLYGON")) {
      add_polygon();
    } else if (is("TRIANGLE")) {
      add_triangle();
    } else if (is("MULTIPOLYGON")) {
      list([this] { add_polygon(); });
    } else if (is("GEOMETRYCOLLECTION")) {
      constexpr int deepest = 16;
      if (depth == deepest) error(at, "collections are nested more than 16 deep");
      list([this, depth, own = dimension_] { geometry(own, depth + 1); });
    } else if (type.empty()) {
      expected(at, "a geometry");
    } else {
      error(at, "unknown geometry " + shown_text(type));
    }
  }

  /// Reads Z, M or ZM behind a type, or takes it off its end ("POINTZ").
  Dimension tag(std::string_view& type) {
    constexpr std::array<std::pair<std::string_view, Dimension>, 3> tags{
        {{"ZM", 4}, {"Z", 3}, {"M", 3}}};
    for (const auto& [name, dimension] : tags) {
      const std::size_t size = type.size() - std::min(type.size(), name.size());
      if (size == 0 || !equal_in_any_case(type.substr(size), name)) continue;
      type = type.substr(0, size);
      return dimension;
    }
    const std::size_t at = next_;
    skip_space();
    const std::string_view next_word = word();
    for (const auto& [name, dimension] : tags) {
      if (equal_in_any_case(next_word, name)) return dimension;
    }
    next_ = at;
    return 0;
  }

  void add_vertex() { obstacles.emplace_back(Disc{vertex(), 0}); }
  void add_point() {
    list([this] { add_vertex(); }, 1);
  }
  void add_point_of_many() {
    skip_space();
    if (is_number_next()) {
      add_vertex();
    } else {
      add_point();
    }
  }
  void add_line(bool is_ring) {
    const std::size_t at = next_;
    Ring points = vertices();
    if (points.empty()) return;
    if (is_ring && points.front() != points.back()) {
      warn_of_open_ring(at);
      points.push_back(Point(points.front()));
    }
    obstacles.emplace_back(polyline_obstacle(std::move(points)));
  }
  void add_polygon() {
    Polygon polygon;
    bool is_outer = true;
    list([&] {
      skip_space();
      const std::size_t at = next_;
      Ring points = ring();
      if (is_outer) {
        polygon.outer = std::move(points);
      } else if (polygon.outer.empty()) {
        error(at, "a hole in a polygon without an outer ring");
      } else if (!points.empty()) {
        polygon.holes.push_back(std::move(points));
      }
      is_outer = false;
    });
    if (!polygon.outer.empty()) obstacles.emplace_back(std::move(polygon));
  }
  void add_triangle() {
    list(
        [this] {
          skip_space();
          const std::size_t at = next_;
          Ring points = ring();
          if (points.empty()) return;
          const std::size_t corners = points.size() - (points.front() == points.back() ? 1 : 0);
          if (corners != 3) error(at, "a TRIANGLE of " + std::to_string(corners) + " corners");
          obstacles.emplace_back(Polygon{std::move(points)});
        },
        1);
  }

  /// The vertices of a ring. An open one needs no vertex more: polygons close their rings.
  Ring ring() {
    const std::size_t at = next_;
    Ring points = vertices();
    if (!points.empty() && points.front() != points.back()) warn_of_open_ring(at);
    return points;
  }
  Ring vertices() {
    Ring points;
    list([&] { points.push_back(vertex()); });
    return points;
  }

  /// Reads `EMPTY`, or at most `at_most` items separated by commas in parentheses. `()` is EMPTY
  /// where several items may stand.
  template <class Item>
  void list(Item item, std::size_t at_most = std::string_view::npos) {
    if (!accept('(')) {
      const std::size_t at = next_;
      if (!equal_in_any_case(word(), "EMPTY")) expected(at, "'(' or EMPTY");
      return;
    }
    if (at_most > 1 && accept(')')) return;
    item();
    std::size_t count = 1;
    while (count++ < at_most && accept(',')) item();
    if (!accept(')')) expected(next_, at_most > 1 ? "',' or ')'" : "')'");
  }

  /// Reads x and y; a third and a fourth ordinate are dropped.
  Point vertex() {
    skip_space();
    const std::size_t at = next_;
    Point p;
    p.x() = number("a number");
    p.y() = number("the second ordinate of a vertex");
    Dimension count = 2;
    for (skip_space(); count < 4 && is_number_next(); skip_space(), ++count) number("a number");
    if (dimension_ == 0) dimension_ = count;
    if (count < dimension_ && !is_end() && text_[next_] != ',' && text_[next_] != ')') {
      expected(next_, "a number");
    }
    if (count != dimension_) {
      error(at, "a vertex of " + std::to_string(count) + " ordinates in a geometry of " +
                    std::to_string(dimension_));
    }
    if (count > 2) warn_once(dropped_, at, "ordinates beyond x and y are dropped");
    return p;
  }

  void warn_once(bool& is_said, std::size_t at, const char* what) {
    if (!is_said) warnings.push_back(position_text(text_, at) + what);
    is_said = true;
  }
  void warn_of_open_ring(std::size_t at) {
    while (at < end_ && is_blank(text_[at])) ++at;
    warn_once(open_, at, "a ring that does not end where it begins is closed");
  }

  Dimension dimension_ = 0;              // of the current geometry
  bool dropped_ = false, open_ = false;  // said already
  std::vector<int> srids_;
};

}  // namespace tutavia::detail
