// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tutavia/geometry/point.hpp"
#include "tutavia/io/text/svg_text.hpp"
#include "tutavia/io/text/svg_writer.hpp"

/// \file
/// SvgLegend: the symbols of a picture, and rows that explain them.

namespace tutavia::detail {

/// \name Symbols around a pixel
/// @{
inline void start_symbol(SvgWriter& svg, const Point& p) {
  svg.circle(p, 7, "fill=\"#ffffff\" stroke=\"#222b33\" stroke-width=\"2.5\"");
}
inline void goal_symbol(SvgWriter& svg, const Point& p, std::string_view colour) {
  std::string style("fill=\"");
  style.append(colour).append("\" stroke=\"#ffffff\" stroke-width=\"2\"");
  svg.circle(p, 7, style);
}
inline void cross_symbol(SvgWriter& svg, const Point& p) {
  svg.stroke(std::string("M") + SvgWriter::pair({p.x() - 5, p.y() - 5}) + "l10 10m0 -10l-10 10",
             "stroke=\"#c1121f\" stroke-width=\"2.4\"");
}
/// An arrow from the pixel on. `direction`: a unit vector.
inline void arrow_symbol(SvgWriter& svg, const Point& p, const Point& direction,
                         std::string_view colour) {
  const Point left(-direction.y(), direction.x()), tip = p + 26 * direction;
  const Point neck = tip - 8 * direction;
  std::string d("M");
  d.append(SvgWriter::pair(p)).append("L").append(SvgWriter::pair(tip));
  d.append("M").append(SvgWriter::pair(neck + 5 * left)).append("L").append(SvgWriter::pair(tip));
  d.append("L").append(SvgWriter::pair(neck - 5 * left));
  svg.stroke(d, "stroke=\"#ffffff\" stroke-width=\"5\" stroke-opacity=\"0.8\"");
  std::string style("stroke=\"");
  svg.stroke(d, style.append(colour).append("\" stroke-width=\"2.4\""));
}
/// A short line.
inline void line_symbol(SvgWriter& svg, const Point& p, std::string_view style) {
  svg.stroke(std::string("M") + SvgWriter::pair({p.x() - 13, p.y()}) + "h26", style);
}
/// A small filled rectangle.
inline void area_symbol(SvgWriter& svg, const Point& p, std::string_view style) {
  svg.rect({p.x() - 12, p.y() - 7}, {24, 14}, style);
}
/// @}

/// Rows of symbols with labels to the right of them. An entry begins a new row where the row before
/// has no room for it; a label that is wider than a row has several lines.
class SvgLegend {
 public:
  /// `first`: the left end of the first row, at half its height. `width`: of the rows.
  SvgLegend(SvgWriter& svg, const Point& first, double width)
      : svg_(svg), first_(first), width_(width), next_(first) {}

  /// Calls `symbol(pixel)` for an entry.
  template <class Symbol>
  void entry(std::string_view label, const Symbol& symbol) {
    const double room = text_width(label) + indent + 18;
    if (next_.x() > first_.x() && next_.x() + room > first_.x() + width_) next_row();
    symbol(Point{next_.x() + 14, next_.y()});
    text(label, indent);
    next_.x() += room;
  }
  void line(std::string_view label, std::string_view style) {
    entry(label, [&](const Point& p) { line_symbol(svg_, p, style); });
  }
  void area(std::string_view label, std::string_view style) {
    entry(label, [&](const Point& p) { area_symbol(svg_, p, style); });
  }
  /// A row of text alone.
  void note(std::string_view words) {
    end_row();
    text(words, 2);
    next_row();
  }

  /// Ends the row, if it has entries.
  void end_row() {
    if (next_.x() > first_.x()) next_row();
  }
  /// The lower end, in pixels.
  double bottom() {
    end_row();
    return next_.y();
  }

 private:
  static constexpr double indent = 34, row_height = 24, line_height = 17;

  void text(std::string_view label, double left) {
    const std::vector<std::string> lines = wrapped(label, width_ - left);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (i > 0) next_.y() += line_height;
      svg_.text({next_.x() + left, next_.y() + 5}, lines[i], "");
    }
  }
  void next_row() { next_ = {first_.x(), next_.y() + row_height}; }

  SvgWriter& svg_;
  Point first_;
  double width_;
  Point next_;
};

}  // namespace tutavia::detail
