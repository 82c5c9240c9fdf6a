// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tutavia/geometry/box.hpp"
#include "tutavia/io/text/svg_style.hpp"
#include "tutavia/io/text/svg_text.hpp"
#include "tutavia/io/text/svg_writer.hpp"

/// \file
/// SvgPlot: a plot with axes.

namespace tutavia::detail {

/// A step of 1, 2 or 5 times a power of ten that divides `range` into at most `parts` parts.
inline double tick_step(double range, double parts) {
  const double least = range / parts, power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

/// A plot of values over arc length, both from 0 on.
class SvgPlot {
 public:
  /// `area`: within the axes, in pixels. `range`: the upper ends of both axes; kept within bounds
  /// that leave room for steps.
  SvgPlot(SvgWriter& svg, const Box& area, const Point& range)
      : svg_(svg),
        area_(area),
        range_(std::clamp(range.x(), 1e-300, 1e300), std::clamp(range.y(), 1e-300, 1e300)) {}

  /// Grid lines with their numbers, the frame, and a title above.
  void axes(std::string_view title, std::string_view note) {
    const double x_step = tick_step(range_.x(), area_.width() / 60);
    for (double i = 0; i * x_step <= range_.x() * (1 + 1e-9); ++i) {
      const Point p = pixel({i * x_step, 0});
      upright(p, SvgStyle::grid_line);
      label({p.x(), p.y() + 15}, trimmed(i * x_step), "middle");
    }
    const double y_step = tick_step(range_.y(), area_.height() / 22);
    for (double i = 0; i * y_step <= range_.y() * (1 + 1e-9); ++i) {
      const Point p = pixel({0, i * y_step});
      level(i * y_step, SvgStyle::grid_line);
      label({p.x() - 6, p.y() + 4}, trimmed(i * y_step), "end");
    }
    svg_.rect(area_.min, area_.max - area_.min,
              std::string("fill=\"none\" ").append(SvgStyle::axis));
    svg_.text({area_.min.x(), area_.min.y() - 7}, title, "font-size=\"13\"");
    label({area_.max.x(), area_.min.y() - 7}, note, "end");
  }
  /// The name of the horizontal axis, below its numbers.
  void name_horizontal(std::string_view name) {
    label({area_.max.x(), area_.max.y() + 31}, name, "end");
  }

  /// A curve through points whose values are clipped to the plot. Points with a value that is not a
  /// number or has no end are left out; points on the line between their neighbours, too.
  void curve(const std::vector<Point>& points, std::string_view style) {
    std::vector<Point> kept;
    bool is_between = false;  // the last point kept lies between two others
    for (const Point& p : points) {
      if (!std::isfinite(p.y())) continue;
      const Point q = pixel(p);
      if (is_between && lies_between(kept[kept.size() - 2], kept.back(), q)) kept.pop_back();
      kept.push_back(q);
      is_between = kept.size() > 1;
    }
    if (kept.empty()) return;
    std::string d("M");
    for (std::size_t i = 0; i < kept.size(); ++i) {
      d.append(i == 0 ? "" : "L").append(SvgWriter::pair(kept[i]));
    }
    svg_.stroke(d, style);
  }
  /// A line from the bottom to the top.
  void spike(double x, std::string_view style) { upright(pixel({x, 0}), style); }
  /// A line of constant value.
  void level(double y, std::string_view style) {
    std::string d("M");
    d.append(SvgWriter::pair(pixel({0, y}))).append("H");
    svg_.stroke(d.append(SvgWriter::number(area_.max.x())), style);
  }

 private:
  Point pixel(const Point& p) const {
    const double x = std::clamp(p.x() / range_.x(), 0.0, 1.0);
    const double y = std::clamp(p.y() / range_.y(), 0.0, 1.0);
    return {area_.min.x() + x * area_.width(), area_.max.y() - y * area_.height()};
  }
  void upright(const Point& foot, std::string_view style) {
    std::string d("M");
    d.append(SvgWriter::pair(foot)).append("V");
    svg_.stroke(d.append(SvgWriter::number(area_.min.y())), style);
  }
  static bool lies_between(const Point& a, const Point& p, const Point& b) {
    const double run = b.x() - a.x();
    if (!(run > 0)) return a.x() == b.x() && a.y() == p.y() && p.y() == b.y();
    const double at = a.y() + (b.y() - a.y()) * (p.x() - a.x()) / run;
    return std::abs(at - p.y()) < 0.02;
  }
  void label(const Point& p, std::string_view text, const std::string& anchor) {
    if (text.empty()) return;
    svg_.text(p, text, "font-size=\"11\" text-anchor=\"" + anchor + "\"");
  }

  SvgWriter& svg_;
  Box area_;
  Point range_;
};

}  // namespace tutavia::detail
