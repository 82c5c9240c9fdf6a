// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

/// \file
/// A chart with logarithmic axes, as SVG.

namespace bench {

/// One line of a chart.
struct ChartLine {
  std::string name;
  std::vector<std::pair<double, double>> points;  ///< positive
};

/// Draws lines over logarithmic axes, with grid lines at the powers of ten and each line's name at
/// its last point; names too close to each other move apart.
inline std::string log_log_chart(const std::string& x_title, const std::string& y_title,
                                 const std::vector<ChartLine>& lines) {
  constexpr double left = 70, right = 560, top = 20, bottom = 400;
  constexpr std::array colours{"#1b6ca8", "#c0392b", "#2e7d32", "#8e44ad",
                               "#d35400", "#00838f", "#6d4c41", "#455a64"};
  double x0 = 1e300, x1 = 0, y0 = 1e300, y1 = 0;
  for (const ChartLine& line : lines) {
    for (const auto& [x, y] : line.points) {
      x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
    }
  }
  // Whole decades below and above the values of y.
  const double y_low = std::floor(std::log10(y0)), y_high = std::ceil(std::log10(y1));
  const double x_low = std::log10(x0), x_high = std::log10(x1);
  const auto at_x = [&](double x) {
    return left + (right - left) * (std::log10(x) - x_low) / std::max(1e-9, x_high - x_low);
  };
  const auto at_y = [&](double y) {
    return bottom - (bottom - top) * (std::log10(y) - y_low) / std::max(1.0, y_high - y_low);
  };
  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"720\" height=\"450\" "
      "font-family=\"sans-serif\" font-size=\"12\">\n"
      "<rect width=\"720\" height=\"450\" fill=\"white\"/>\n";
  char text[400];
  const auto add = [&](const char* format, auto... values) {
    std::snprintf(text, sizeof text, format, values...);
    svg += text;
  };
  for (double power = y_low; power <= y_high; ++power) {
    const double y = at_y(std::pow(10, power));
    add("<path d=\"M%g %.1fH%g\" stroke=\"#ddd\"/>\n", left, y, right);
    add("<text x=\"%g\" y=\"%.1f\" text-anchor=\"end\">%.*f</text>\n", left - 6, y + 4,
        static_cast<int>(std::max(0.0, -power)), std::pow(10, power));
  }
  if (!lines.empty()) {
    for (const auto& [x, y] : lines.front().points) {
      add("<path d=\"M%.1f %gV%g\" stroke=\"#ddd\"/>\n", at_x(x), top, bottom);
      add("<text x=\"%.1f\" y=\"%g\" text-anchor=\"middle\">%.3g</text>\n", at_x(x), bottom + 18,
          x);
    }
  }
  add("<text x=\"%g\" y=\"%g\" text-anchor=\"middle\">%s</text>\n", (left + right) / 2, bottom + 38,
      x_title.c_str());
  add("<text x=\"18\" y=\"%g\" text-anchor=\"middle\" transform=\"rotate(-90 18 %g)\">%s</text>\n",
      (top + bottom) / 2, (top + bottom) / 2, y_title.c_str());
  std::vector<std::pair<double, std::size_t>> names;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].points.empty()) continue;
    std::string path;
    for (const auto& [x, y] : lines[i].points) {
      std::snprintf(text, sizeof text, "%s%.1f %.1f", path.empty() ? "M" : "L", at_x(x), at_y(y));
      path += text;
    }
    svg += "<path d=\"" + path + "\" fill=\"none\" stroke-width=\"2\" stroke=\"" +
           colours[i % colours.size()] + "\"/>\n";
    names.emplace_back(at_y(lines[i].points.back().second), i);
  }
  std::sort(names.begin(), names.end());
  double last = 0;
  for (const auto& [y, i] : names) {
    last = std::max(y + 4, last + 14);
    add("<text x=\"%g\" y=\"%.1f\" fill=\"%s\">%s</text>\n", right + 8, last,
        colours[i % colours.size()], lines[i].name.c_str());
  }
  return svg + "</svg>\n";
}

}  // namespace bench
