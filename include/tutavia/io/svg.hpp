// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/io/text/write_file.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// SVG pictures of workspaces and plans.

namespace tutavia {

/// What to draw beside the plans; every field has a default.
struct SvgOptions {
  double width = 800;                     ///< of the drawing area, in pixels
  std::vector<Point> critical_corners{};  ///< marked with crosses
  std::vector<Segment> tree{};            ///< what a search by sampling grew, drawn thin
  std::vector<Box> rectangles{};          ///< that a search grew
  std::vector<Segment> intervals{};       ///< from which they grew
  std::string title{};
  bool y_down = false;  ///< y grows downwards, as in images
};

namespace detail {

/// Writes one picture: metres in, pixels out.
class SvgPicture {
 public:
  SvgPicture(const Workspace& workspace, const SvgOptions& options)
      : workspace_(workspace), options_(options), bounds_(workspace.bounds) {
    const double extent = std::max({bounds_.width(), bounds_.height(), 1e-300});
    scale_ = options.width / extent;
    width_ = bounds_.width() * scale_;
    height_ = bounds_.height() * scale_;
  }

  std::string draw(std::span<const Plan> plans) {
    const double top = options_.title.empty() ? margin : margin + 30;
    const double legend_height = 60;
    const double total_width = std::max(width_, 560.0) + 2 * margin;
    const double total_height = top + height_ + legend_height;
    offset_ = {margin, top};
    svg_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(total_width) +
           "\" height=\"" + number(total_height) + "\" viewBox=\"0 0 " + number(total_width) + " " +
           number(total_height) +
           "\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"14\">\n"
           "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
    if (!options_.title.empty()) {
      text({margin, margin + 12}, options_.title, "font-size=\"18\" font-weight=\"bold\"");
    }
    svg_ += "<clipPath id=\"bounds\">" + frame("") + "</clipPath>\n";
    svg_ += frame(" fill=\"#f7f9fb\"") + "<g clip-path=\"url(#bounds)\">\n";
    obstacles();
    rectangles();
    tree();
    for (const Plan& plan : plans) route(plan.route.curve);
    for (std::size_t i = 0; i < plans.size(); ++i) curve(plans[i].curve, colour(i));
    for (const Point& corner : options_.critical_corners) cross_mark(corner);
    svg_ += "</g>\n" + frame(" fill=\"none\" stroke=\"#33414e\" stroke-width=\"1.5\"");
    for (std::size_t i = 0; i < plans.size(); ++i) ends(plans[i].curve, colour(i));
    legend(top + height_ + 24, !plans.empty());
    return svg_ + "</svg>\n";
  }

 private:
  static constexpr double margin = 16;
  static constexpr const char* route_colour = "#7a8794";
  static constexpr const char* tree_colour = "#9cc3b5";
  static constexpr const char* rectangle_style =
      "fill=\"#7fb2d9\" fill-opacity=\"0.16\" stroke=\"#5b8db8\" stroke-width=\"0.8\"";
  static constexpr const char* interval_style =
      "stroke=\"#b8478a\" stroke-width=\"2.4\" stroke-linecap=\"round\"";

  static const char* colour(std::size_t i) {  // after Okabe and Ito: told apart by all eyes
    constexpr std::array<const char*, 6> colours{"#0072b2", "#d55e00", "#009e73",
                                                 "#cc79a7", "#56b4e9", "#a07400"};
    return colours[i % colours.size()];
  }

  static std::string number(double x) {
    std::array<char, 64> buffer;
    std::snprintf(buffer.data(), buffer.size(), "%.2f", x);
    return buffer.data();
  }

  Point pixel(const Point& p) const {
    return {offset_.x() + (p.x() - bounds_.min.x()) * scale_,
            offset_.y() +
                (options_.y_down ? p.y() - bounds_.min.y() : bounds_.max.y() - p.y()) * scale_};
  }
  std::string at(const Point& p) const {
    const Point q = pixel(p);
    return number(q.x()) + " " + number(q.y());
  }

  std::string frame(const std::string& style) const {
    return "<rect x=\"" + number(offset_.x()) + "\" y=\"" + number(offset_.y()) + "\" width=\"" +
           number(width_) + "\" height=\"" + number(height_) + "\"" + style + "/>\n";
  }

  void circle(const Point& pixel_centre, double radius, const std::string& style) {
    svg_ += "<circle cx=\"" + number(pixel_centre.x()) + "\" cy=\"" + number(pixel_centre.y()) +
            "\" r=\"" + number(radius) + "\" " + style + "/>\n";
  }

  void text(const Point& place, const std::string& content, const std::string& style) {
    svg_ += "<text x=\"" + number(place.x()) + "\" y=\"" + number(place.y()) +
            "\" fill=\"#222b33\" " + style + ">";
    for (const char c : content) {
      if (c == '<')
        svg_ += "&lt;";
      else if (c == '&')
        svg_ += "&amp;";
      else
        svg_ += c;
    }
    svg_ += "</text>\n";
  }

  std::string ring_path(const Ring& ring) const {
    std::string d;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      d += i == 0 ? 'M' : 'L';
      d += at(ring[i]);
    }
    d += 'Z';
    return d;
  }

  /// The shapes of all obstacles. Stroked with twice the safety radius and round joins they are
  /// exactly the safety zones.
  std::string shapes(double stroke_radius) const {
    std::string result;
    for (const Obstacle& obstacle : workspace_.obstacles) {
      if (const Disc* disc = std::get_if<Disc>(&obstacle)) {
        const Point c = pixel(disc->center);
        result += "<circle cx=\"" + number(c.x()) + "\" cy=\"" + number(c.y()) + "\" r=\"" +
                  number((disc->radius + stroke_radius) * scale_) + "\" stroke=\"none\"/>\n";
        continue;
      }
      const Polygon& polygon = std::get<Polygon>(obstacle);
      result += "<path fill-rule=\"evenodd\" d=\"" + ring_path(polygon.outer);
      for (const Ring& hole : polygon.holes) result += ring_path(hole);
      result += "\"/>\n";
    }
    return result;
  }

  void obstacles() {
    const double r = workspace_.safety_radius;
    svg_ += "<g fill=\"#f6d9b8\" stroke=\"#f6d9b8\" stroke-linejoin=\"round\" stroke-width=\"" +
            number(2 * r * scale_) + "\">\n" + shapes(r) + "</g>\n";
    svg_ += "<g fill=\"#4a5763\" stroke=\"#4a5763\" stroke-width=\"1\">\n" + shapes(0) + "</g>\n";
  }

  void rectangles() {
    for (const Box& box : options_.rectangles) {  // as paths: those without area show their border
      const Point a = pixel(box.min), b = pixel(box.max);
      svg_.append("<path d=\"M").append(number(a.x())).append(" ").append(number(a.y()));
      svg_.append("H").append(number(b.x())).append("V").append(number(b.y()));
      svg_.append("H").append(number(a.x())).append("Z\" ").append(rectangle_style).append("/>\n");
    }
    std::string d;
    for (const Segment& s : options_.intervals) {
      d.append("M").append(at(s.a)).append("L").append(at(s.b));
    }
    if (!d.empty()) stroke(d, interval_style);
  }

  void tree() {
    if (options_.tree.empty()) return;
    std::string d;
    for (const Segment& edge : options_.tree)
      d.append("M").append(at(edge.a)).append("L").append(at(edge.b));
    stroke(d, std::string("stroke=\"") + tree_colour + "\" stroke-width=\"0.7\"");
  }

  std::string curve_path(const Curve& curve) const {
    if (curve.empty()) return {};
    std::string d = "M" + at(curve.start());
    for (const Piece& any : curve.pieces()) {
      if (const auto* segment = any.get_if<Segment>()) {
        d += "L" + at(segment->b);
      } else if (const auto* q = any.get_if<QuadraticBezier>()) {
        d += "Q" + at(q->points[1]) + " " + at(q->points[2]);
      } else if (const auto* c = any.get_if<CubicBezier>()) {
        d += "C" + at(c->points[1]) + " " + at(c->points[2]) + " " + at(c->points[3]);
      } else if (const auto* arc = any.get_if<Arc>()) {
        // Two halves, because SVG cannot tell a full circle from none; y points down there.
        const bool is_clockwise = (arc->sweep > 0) == options_.y_down;
        const std::string radius = number(arc->radius * scale_);
        for (const double t : {0.5, 1.0}) {
          d.append("A").append(radius).append(" ").append(radius);
          d.append(is_clockwise ? " 0 0 1 " : " 0 0 0 ").append(at(arc->point(t)));
        }
      } else if (const auto* clothoid = any.get_if<Clothoid>()) {
        d += clothoid_path(*clothoid);
      }
    }
    return d;
  }

  /// As cubic Bezier pieces with the same ends and directions, none of which turns much.
  std::string clothoid_path(const Clothoid& clothoid) const {
    const double turn = clothoid.largest_curvature() * clothoid.arc_length;
    const int parts = std::max(1, static_cast<int>(std::ceil(2 * turn)));
    std::string d;
    for (int i = 0; i < parts; ++i) {
      const double from = double(i) / parts, to = (i + 1.0) / parts, handle = (to - from) / 3;
      d.append("C").append(at(advance(clothoid.point(from), handle, clothoid.derivative(from))));
      d.append(" ").append(at(advance(clothoid.point(to), -handle, clothoid.derivative(to))));
      d.append(" ").append(at(clothoid.point(to)));
    }
    return d;
  }

  void stroke(const std::string& d, const std::string& style) {
    svg_ += "<path d=\"" + d + "\" fill=\"none\" stroke-linejoin=\"round\" " + style + "/>\n";
  }

  void route(const Curve& curve) {
    stroke(curve_path(curve), std::string("stroke=\"") + route_colour +
                                  "\" stroke-width=\"1.2\" stroke-dasharray=\"4 3\"");
    for (const Piece& piece : curve.pieces()) {
      circle(pixel(end_of(piece)), 1.6, std::string("fill=\"") + route_colour + "\"");
    }
  }

  void curve(const Curve& curve, const std::string& colour) {
    stroke(curve_path(curve), "stroke=\"#ffffff\" stroke-width=\"6\" stroke-opacity=\"0.7\"");
    stroke(curve_path(curve), "stroke=\"" + colour + "\" stroke-width=\"3\"");
  }

  void cross_at(const Point& q) {
    stroke("M" + number(q.x() - 5) + " " + number(q.y() - 5) + "l10 10m0 -10l-10 10",
           "stroke=\"#c1121f\" stroke-width=\"2.4\"");
  }
  void cross_mark(const Point& p) { cross_at(pixel(p)); }

  void start_at(const Point& q) {
    circle(q, 7, "fill=\"#ffffff\" stroke=\"#222b33\" stroke-width=\"2.5\"");
  }
  void goal_at(const Point& q, const std::string& colour) {
    circle(q, 7, "fill=\"" + colour + "\" stroke=\"#ffffff\" stroke-width=\"2\"");
  }
  void ends(const Curve& curve, const std::string& colour) {
    if (curve.empty()) return;
    start_at(pixel(curve.start()));
    goal_at(pixel(curve.end()), colour);
  }

  void legend(double y, bool has_plans) {
    double x = margin;
    const auto entry = [&](const std::string& label, double width, auto symbol) {
      symbol(Point{x + 14, y});
      text({x + 34, y + 5}, label, "");
      x += width;
    };
    const auto patch = [&](const char* fill) {
      return [this, fill](const Point& q) {
        svg_ += "<rect x=\"" + number(q.x() - 12) + "\" y=\"" + number(q.y() - 7) +
                "\" width=\"24\" height=\"14\" fill=\"" + fill + "\"/>\n";
      };
    };
    const auto line = [&](const std::string& style) {
      return [this, style](const Point& q) {
        stroke("M" + number(q.x() - 13) + " " + number(q.y()) + "h26", style);
      };
    };
    entry("obstacle", 108, patch("#4a5763"));
    entry("safety zone, " + trimmed(workspace_.safety_radius) + " m", 178, patch("#f6d9b8"));
    if (has_plans) {
      entry("proved curve", 136,
            line(std::string("stroke=\"") + colour(0) + "\" stroke-width=\"3\""));
      entry("route", 84,
            line(std::string("stroke=\"") + route_colour +
                 "\" stroke-width=\"1.2\" stroke-dasharray=\"4 3\""));
      x = margin;
      y += 24;
      entry("start", 108, [this](const Point& q) { start_at(q); });
      entry("goal", 178, [this](const Point& q) { goal_at(q, colour(0)); });
    }
    if (!options_.tree.empty()) {
      entry("tree", 84, line(std::string("stroke=\"") + tree_colour + "\" stroke-width=\"1.5\""));
    }
    if (!options_.rectangles.empty()) {
      entry("rectangle", 108, [this](const Point& q) {
        svg_.append("<rect x=\"").append(number(q.x() - 12)).append("\" y=\"");
        svg_.append(number(q.y() - 7)).append("\" width=\"24\" height=\"14\" ");
        svg_.append(rectangle_style).append("/>\n");
      });
    }
    if (!options_.intervals.empty()) entry("interval", 108, line(interval_style));
    if (!options_.critical_corners.empty()) {
      entry("critical corner", 140, [this](const Point& q) { cross_at(q); });
    }
  }

  static std::string trimmed(double x) {
    std::array<char, 64> buffer;
    std::snprintf(buffer.data(), buffer.size(), "%g", x);
    return buffer.data();
  }

  const Workspace& workspace_;
  const SvgOptions& options_;
  Box bounds_;
  double scale_ = 1, width_ = 0, height_ = 0;
  Point offset_ = Point::Zero();
  std::string svg_;
};

}  // namespace detail

/// A picture of the workspace with its true, round safety zones, and of each plan its route and its
/// curve (Beziers as Beziers), with start, goal and a legend.
inline std::string to_svg(const Workspace& workspace, std::span<const Plan> plans,
                          const SvgOptions& options = {}) {
  return detail::SvgPicture(workspace, options).draw(plans);
}

/// Writes `to_svg` to a file; `invalid_input` where that is not possible (nothing is half written).
inline Expected<void, Failure> write_svg(const std::filesystem::path& path,
                                         const Workspace& workspace, std::span<const Plan> plans,
                                         const SvgOptions& options = {}) {
  return detail::write_file(path, to_svg(workspace, plans, options));
}

inline Expected<void, Failure> write_svg(const std::filesystem::path& path,
                                         const Workspace& workspace, const Plan& plan,
                                         const SvgOptions& options = {}) {
  return write_svg(path, workspace, std::span(&plan, 1), options);
}

}  // namespace tutavia
