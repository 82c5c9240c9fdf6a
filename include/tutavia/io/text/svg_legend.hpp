// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "tutavia/geometry/point.hpp"
#include "tutavia/io/text/svg_writer.hpp"

/// \file
/// SvgLegend: the symbols of a picture, and rows that explain them.

namespace tutavia::detail {

/// \name Symbols around a pixel
/// @{
inline void start_symbol(SvgWriter& svg, const Point& p) {
  svg.circle(p, 7, "fill=\"#ffffff\" stroke=\"#222b33\" stroke-width=\"2.5\"");
}
inline void goal_symbol(SvgWriter& svg, const Point& p, const std::string& colour) {
  svg.circle(p, 7, "fill=\"" + colour + "\" stroke=\"#ffffff\" stroke-width=\"2\"");
}
inline void cross_symbol(SvgWriter& svg, const Point& p) {
  svg.stroke(std::string("M") + SvgWriter::pair({p.x() - 5, p.y() - 5}) + "l10 10m0 -10l-10 10",
             "stroke=\"#c1121f\" stroke-width=\"2.4\"");
}
/// A short line.
inline void line_symbol(SvgWriter& svg, const Point& p, std::string_view style) {
  svg.stroke(std::string("M") + SvgWriter::pair({p.x() - 13, p.y()}) + "h26", style);
}
/// A small filled rectangle.
inline void area_symbol(SvgWriter& svg, const Point& p, std::string_view style) {
  svg.raw("<rect x=\"" + SvgWriter::number(p.x() - 12) + "\" y=\"" + SvgWriter::number(p.y() - 7) +
          "\" width=\"24\" height=\"14\" ");
  svg.raw(style);
  svg.raw("/>\n");
}
/// @}

/// Rows of symbols with labels to the right of them.
class SvgLegend {
 public:
  /// `first`: the left end of the first row, at half its height.
  SvgLegend(SvgWriter& svg, const Point& first) : svg_(svg), left_(first.x()), next_(first) {}

  /// Calls `symbol(pixel)` for an entry that takes `width` pixels of its row.
  template <class Symbol>
  void entry(std::string_view label, double width, const Symbol& symbol) {
    symbol(Point{next_.x() + 14, next_.y()});
    svg_.text({next_.x() + 34, next_.y() + 5}, label, "");
    next_.x() += width;
  }
  void line(std::string_view label, double width, std::string_view style) {
    entry(label, width, [&](const Point& p) { line_symbol(svg_, p, style); });
  }
  void area(std::string_view label, double width, std::string_view style) {
    entry(label, width, [&](const Point& p) { area_symbol(svg_, p, style); });
  }

  void next_row() { next_ = {left_, next_.y() + 24}; }

 private:
  SvgWriter& svg_;
  double left_;
  Point next_;
};

}  // namespace tutavia::detail
