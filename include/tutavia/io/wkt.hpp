// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "tutavia/geometry/polygon.hpp"
#include "tutavia/io/text/parse_error.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// parse_wkt: obstacles from WKT.

namespace tutavia {

/// Parsed obstacles, and warnings about ignored parts.
struct WktObstacles {
  std::vector<Obstacle> obstacles;
  std::vector<std::string> warnings;  ///< one line each
};

namespace detail {

/// A strict parser: any text that it does not fully understand is an error, because a lenient one
/// would misplace obstacles.
class WktReader {
 public:
  explicit WktReader(std::string_view text) : text_(text) {}

  /// Throws ParseError with line and column.
  WktObstacles read() {
    for (skip_comments(); next_ < text_.size(); skip_comments()) geometry();
    return std::move(out_);
  }

 private:
  void geometry() {
    first_ = next_;
    ordinates_ = 0;
    const std::string_view type = word();
    if (is(type, "POINT")) {
      list([this] { add(vertex()); }, 1);
    } else if (is(type, "MULTIPOINT")) {
      list([this] {
        const auto point = [this] { add(vertex()); };
        skip_space();
        if (is_number_next()) {
          point();
        } else {
          list(point, 1);
        }
      });
    } else if (is(type, "LINESTRING")) {
      add_line();
    } else if (is(type, "MULTILINESTRING")) {
      list([this] { add_line(); });
    } else if (is(type, "POLYGON")) {
      add_polygon();
    } else if (is(type, "MULTIPOLYGON")) {
      list([this] { add_polygon(); });
    } else if (type.empty()) {
      expected(first_, "a geometry");
    } else {
      error(first_, "unknown geometry \"" + std::string(type) + "\"");
    }
  }

  void add(const Point& p) { out_.obstacles.emplace_back(Disc{p, 0}); }
  void add_line() {
    Ring points = ring();
    if (!points.empty()) out_.obstacles.emplace_back(polyline_obstacle(std::move(points)));
  }
  void add_polygon() {
    Polygon polygon;
    bool is_outer = true;
    list([&] {
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
    if (!polygon.outer.empty()) out_.obstacles.emplace_back(std::move(polygon));
  }

  Ring ring() {
    Ring points;
    list([&] { points.push_back(vertex()); });
    return points;
  }

  /// Reads `EMPTY`, or at most `at_most` items separated by commas in parentheses.
  template <class Item>
  void list(Item item, std::size_t at_most = std::string_view::npos) {
    skip_space();
    if (!accept('(')) {
      const std::size_t at = next_;
      if (!is(word(), "EMPTY")) expected(at, "'(' or EMPTY");
      return;
    }
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
    std::size_t count = 2;
    for (skip_space(); count < 4 && is_number_next(); skip_space(), ++count) number("a number");
    if (ordinates_ == 0) ordinates_ = count;
    if (count != ordinates_) {
      error(at, "a vertex of " + std::to_string(count) + " ordinates in a geometry of " +
                    std::to_string(ordinates_));
    }
    if (count > 2 && out_.warnings.empty()) {
      out_.warnings.push_back(position_text(at) + "ordinates beyond x and y are dropped");
    }
    return p;
  }

  /// Reads a decimal number, which must be followed by a blank, a comma, a parenthesis or the end.
  double number(const char* what) {
    skip_space();
    if (!is_number_next()) expected(next_, what);
    const std::size_t at = next_;
    double value = 0;
    const char* const first = text_.data() + at + (text_[at] == '+' ? 1 : 0);
    const auto [last, status] = std::from_chars(first, text_.data() + text_.size(), value);
    next_ = static_cast<std::size_t>(last - text_.data());
    if (status == std::errc::result_out_of_range) error(at, "a number beyond the range of double");
    if (status != std::errc{} || !(is_end() || is_space(text_[next_]) || is_one_of(",()"))) {
      expected(at, what);
    }
    return value;
  }

  /// Whether a number starts here; "nan" and "inf" are not numbers.
  bool is_number_next() const {
    std::size_t i = next_;
    if (i < text_.size() && (text_[i] == '-' || text_[i] == '+')) ++i;
    if (i < text_.size() && text_[i] == '.') ++i;
    return i < text_.size() && text_[i] >= '0' && text_[i] <= '9';
  }

  std::string_view word() {
    const std::size_t from = next_;
    while (!is_end() && std::isalpha(static_cast<unsigned char>(text_[next_])) != 0) ++next_;
    return text_.substr(from, next_ - from);
  }
  static bool is(std::string_view word, std::string_view upper) {
    return std::equal(word.begin(), word.end(), upper.begin(), upper.end(), [](char a, char b) {
      return std::toupper(static_cast<unsigned char>(a)) == b;
    });
  }
  bool accept(char c) {
    skip_space();
    if (is_end() || text_[next_] != c) return false;
    ++next_;
    return true;
  }

  bool is_end() const { return next_ == text_.size(); }
  static bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
  bool is_one_of(std::string_view any) const {
    return any.find(text_[next_]) != std::string_view::npos;
  }
  void skip_space() {
    while (!is_end() && is_space(text_[next_])) ++next_;
  }
  /// Skips white space and lines that start with #.
  void skip_comments() {
    for (skip_space(); !is_end() && text_[next_] == '#' && is_line_start(); skip_space()) {
      next_ = std::min(text_.find('\n', next_), text_.size());
    }
  }
  bool is_line_start() const { return next_ == 0 || text_[next_ - 1] == '\n'; }

  std::size_t line_of(std::size_t at) const {
    return 1 + static_cast<std::size_t>(std::count(
                   text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  }
  /// "line 3, column 7: ", columns in bytes.
  std::string position_text(std::size_t at) const {
    const std::size_t before = text_.substr(0, at).rfind('\n');  // npos + 1 is 0
    return "line " + std::to_string(line_of(at)) + ", column " + std::to_string(at - before) + ": ";
  }
  [[noreturn]] void error(std::size_t at, const std::string& what) const {
    std::string message = position_text(at) + what;
    if (line_of(first_) != line_of(at)) {
      message += " (the geometry begins at line " + std::to_string(line_of(first_)) + ")";
    }
    throw ParseError{message};
  }
  [[noreturn]] void expected(std::size_t at, const std::string& what) const {
    std::size_t end = at;
    while (end < text_.size() && end < at + 20 && !is_space(text_[end])) ++end;
    const bool at_end = at == text_.size();
    error(at, "expected " + what + ", found " +
                  (at_end ? "the end of the text"
                          : "\"" + std::string(text_.substr(at, end - at)) + "\""));
  }

  std::string_view text_;
  std::size_t next_ = 0;
  std::size_t first_ = 0;      // start of the current geometry
  std::size_t ordinates_ = 0;  // per vertex of the current geometry; 0 before its first vertex
  WktObstacles out_;
};

}  // namespace detail

/// Parses obstacles from WKT (OGC 06-103r4, section 7), coordinates in metres: any number of
/// POLYGON, MULTIPOLYGON, LINESTRING, MULTILINESTRING (walls without thickness), POINT and
/// MULTIPOINT geometries, over any number of lines; lines between geometries that start with # are
/// comments. All vertices of a geometry have the same number of ordinates, two to four; those after
/// x and y are dropped with a warning. EMPTY gives no obstacle.
///
/// Errors: `invalid_input` with line and column for anything else. Obstacles are not validated
/// before a space is built.
inline Expected<WktObstacles, Failure> parse_wkt(std::string_view text) {
  return detail::parse_or_fail([&] { return detail::WktReader(text).read(); });
}

}  // namespace tutavia
