// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdio>
#include <string>
#include <string_view>

#include "tutavia/geometry/point.hpp"

/// \file
/// SvgWriter: writes the elements of an SVG document.

namespace tutavia::detail {

/// Writes an SVG document element by element; all positions and lengths are in pixels. A `style` is
/// a list of SVG attributes, such as fill="none".
class SvgWriter {
 public:
  static std::string number(double x) {
    std::array<char, 64> buffer;
    std::snprintf(buffer.data(), buffer.size(), "%.2f", x);
    return buffer.data();
  }
  /// A point of path data.
  static std::string pair(const Point& p) { return number(p.x()) + " " + number(p.y()); }

  void circle(const Point& center, double radius, std::string_view style) {
    svg_.append("<circle cx=\"").append(number(center.x())).append("\" cy=\"");
    svg_.append(number(center.y())).append("\" r=\"").append(number(radius)).append("\" ");
    svg_.append(style).append("/>\n");
  }

  void rect(const Point& corner, const Point& size, std::string_view style) {
    svg_.append("<rect x=\"").append(number(corner.x())).append("\" y=\"");
    svg_.append(number(corner.y())).append("\" width=\"").append(number(size.x()));
    svg_.append("\" height=\"").append(number(size.y())).append("\" ");
    svg_.append(style).append("/>\n");
  }

  void path(std::string_view data, std::string_view style) {
    svg_.append("<path d=\"").append(data).append("\" ").append(style).append("/>\n");
  }
  /// A path that is not filled.
  void stroke(std::string_view data, std::string_view style) {
    svg_.append("<path d=\"").append(data).append("\" fill=\"none\" stroke-linejoin=\"round\" ");
    svg_.append(style).append("/>\n");
  }

  void text(const Point& left, std::string_view content, std::string_view style) {
    svg_.append("<text x=\"").append(number(left.x())).append("\" y=\"");
    svg_.append(number(left.y())).append("\" fill=\"#222b33\" ").append(style).append(">");
    for (const char c : content) {
      if (c == '<') {
        svg_ += "&lt;";
      } else if (c == '>') {
        svg_ += "&gt;";
      } else if (c == '&') {
        svg_ += "&amp;";
      } else {
        svg_ += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;  // XML has no control characters
      }
    }
    svg_ += "</text>\n";
  }

  /// Adds raw markup.
  void raw(std::string_view markup) { svg_.append(markup); }

  /// The document, on a white picture of this size.
  std::string finish(double width, double height) const {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(width) + "\" height=\"" +
           number(height) + "\" viewBox=\"0 0 " + number(width) + " " + number(height) +
           "\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"14\">\n"
           "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" +
           svg_ + "</svg>\n";
  }

 private:
  std::string svg_{};
};

}  // namespace tutavia::detail
