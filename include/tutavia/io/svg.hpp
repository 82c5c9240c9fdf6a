// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/io/text/svg_legend.hpp"
#include "tutavia/io/text/svg_paths.hpp"
#include "tutavia/io/text/svg_writer.hpp"
#include "tutavia/io/text/write_file.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// SVG pictures of workspaces and plans.

namespace tutavia {

/// Options of a picture, and what to draw besides the plans.
struct SvgOptions {
  double width = 800;                     ///< of the drawing area, in pixels
  std::vector<Point> critical_corners{};  ///< marked with crosses
  std::vector<Segment> tree{};            ///< edges of a random tree, drawn thin
  std::vector<Box> rectangles{};          ///< rectangles of a rectangle expansion
  std::vector<Segment> intervals{};       ///< their start intervals
  std::string title{};
  bool y_down = false;  ///< y grows downwards, as in images
};

namespace detail {

/// Draws one picture, from metres to pixels.
class SvgPicture {
 public:
  SvgPicture(const Workspace& workspace, const SvgOptions& options)
      : workspace_(workspace),
        options_(options),
        paths_{
            workspace.bounds,
            options.width / std::max({workspace.bounds.width(), workspace.bounds.height(), 1e-300}),
            Point(margin, options.title.empty() ? margin : margin + 30), options.y_down},
        size_{workspace.bounds.width() * paths_.scale, workspace.bounds.height() * paths_.scale},
        svg_(std::max(size_.x(), 560.0) + 2 * margin,
             paths_.offset.y() + size_.y() + legend_height) {}

  std::string draw(std::span<const Plan> plans) {
    if (!options_.title.empty()) {
      svg_.text({margin, margin + 12}, options_.title, "font-size=\"18\" font-weight=\"bold\"");
    }
    svg_.raw("<clipPath id=\"bounds\">");
    frame("");
    svg_.raw("</clipPath>\n");
    frame(" fill=\"#f7f9fb\"");
    svg_.raw("<g clip-path=\"url(#bounds)\">\n");
    obstacles();
    rectangles();
    tree();
    for (const Plan& plan : plans) route(plan.route.curve);
    for (std::size_t i = 0; i < plans.size(); ++i) curve(plans[i].curve, colour(i));
    for (const Point& corner : options_.critical_corners) cross_symbol(svg_, paths_.pixel(corner));
    svg_.raw("</g>\n");
    frame(" fill=\"none\" stroke=\"#33414e\" stroke-width=\"1.5\"");
    for (std::size_t i = 0; i < plans.size(); ++i) ends(plans[i].curve, colour(i));
    legend(!plans.empty());
    return svg_.finish();
  }

 private:
  static constexpr double margin = 16, legend_height = 60;
  static constexpr std::string_view route_style =
      "stroke=\"#7a8794\" stroke-width=\"1.2\" stroke-dasharray=\"4 3\"";
  static constexpr std::string_view rectangle_style =
      "fill=\"#7fb2d9\" fill-opacity=\"0.16\" stroke=\"#5b8db8\" stroke-width=\"0.8\"";
  static constexpr std::string_view interval_style =
      "stroke=\"#b8478a\" stroke-width=\"2.4\" stroke-linecap=\"round\"";

  static std::string colour(std::size_t i) {  // after Okabe and Ito, for colour-blind readers
    constexpr std::array<const char*, 6> colours{"#0072b2", "#d55e00", "#009e73",
                                                 "#cc79a7", "#56b4e9", "#a07400"};
    return colours[i % colours.size()];
  }
  static std::string curve_style(const std::string& colour) {
    return "stroke=\"" + colour + "\" stroke-width=\"3\"";
  }

  static std::string number(double x) { return SvgWriter::number(x); }

  /// Draws the bounds.
  void frame(std::string_view style) {
    svg_.raw("<rect x=\"" + number(paths_.offset.x()) + "\" y=\"" + number(paths_.offset.y()) +
             "\" width=\"" + number(size_.x()) + "\" height=\"" + number(size_.y()) + "\"");
    svg_.raw(style);
    svg_.raw("/>\n");
  }

  /// Draws the shapes of all obstacles. Stroked with twice the safety radius and round joins, they
  /// are exactly the safety zones.
  void shapes(double stroke_radius) {
    for (const Obstacle& obstacle : workspace_.obstacles) {
      if (const Disc* disc = std::get_if<Disc>(&obstacle)) {
        svg_.circle(paths_.pixel(disc->center), (disc->radius + stroke_radius) * paths_.scale,
                    "stroke=\"none\"");
        continue;
      }
      const Polygon& polygon = std::get<Polygon>(obstacle);
      svg_.raw("<path fill-rule=\"evenodd\" d=\"" + paths_.of_ring(polygon.outer));
      for (const Ring& hole : polygon.holes) svg_.raw(paths_.of_ring(hole));
      svg_.raw("\"/>\n");
    }
  }

  void obstacles() {
    const double r = workspace_.safety_radius;
    svg_.raw("<g fill=\"#f6d9b8\" stroke=\"#f6d9b8\" stroke-linejoin=\"round\" stroke-width=\"" +
             number(2 * r * paths_.scale) + "\">\n");
    shapes(r);
    svg_.raw("</g>\n<g fill=\"#4a5763\" stroke=\"#4a5763\" stroke-width=\"1\">\n");
    shapes(0);
    svg_.raw("</g>\n");
  }

  void rectangles() {
    for (const Box& box : options_.rectangles) {  // as paths, so that empty ones show their border
      const Point a = paths_.pixel(box.min), b = paths_.pixel(box.max);
      std::string path = "M";
      path += SvgWriter::pair(a);
      path += "H";
      path += number(b.x());
      path += "V";
      path += number(b.y());
      path += "H";
      path += number(a.x());
      path += "Z";
      svg_.path(path, rectangle_style);
    }
    lines(options_.intervals, interval_style);
  }

  void tree() { lines(options_.tree, tree_style("0.7")); }
  static std::string tree_style(const std::string& width) {
    return "stroke=\"#9cc3b5\" stroke-width=\"" + width + "\"";
  }

  /// Draws segments as one path.
  void lines(const std::vector<Segment>& segments, std::string_view style) {
    if (segments.empty()) return;
    std::string d;
    for (const Segment& s : segments)
      d.append("M").append(paths_.at(s.a)).append("L").append(paths_.at(s.b));
    svg_.stroke(d, style);
  }

  void route(const Curve& curve) {
    svg_.stroke(paths_.of_curve(curve), route_style);
    for (const Piece& piece : curve.pieces()) {
      svg_.circle(paths_.pixel(end_of(piece)), 1.6, "fill=\"#7a8794\"");
    }
  }

  void curve(const Curve& curve, const std::string& colour) {
    const std::string d = paths_.of_curve(curve);
    svg_.stroke(d, "stroke=\"#ffffff\" stroke-width=\"6\" stroke-opacity=\"0.7\"");
    svg_.stroke(d, curve_style(colour));
  }

  void ends(const Curve& curve, const std::string& colour) {
    if (curve.empty()) return;
    start_symbol(svg_, paths_.pixel(curve.start()));
    goal_symbol(svg_, paths_.pixel(curve.end()), colour);
  }

  void legend(bool has_plans) {
    SvgLegend legend(svg_, {margin, paths_.offset.y() + size_.y() + 24});
    legend.area("obstacle", 108, "fill=\"#4a5763\"");
    legend.area("safety zone, " + trimmed(workspace_.safety_radius) + " m", 178,
                "fill=\"#f6d9b8\"");
    if (has_plans) {
      legend.line("proved curve", 136, curve_style(colour(0)));
      legend.line("route", 84, route_style);
      legend.next_row();
      legend.entry("start", 108, [&](const Point& p) { start_symbol(svg_, p); });
      legend.entry("goal", 178, [&](const Point& p) { goal_symbol(svg_, p, colour(0)); });
    }
    if (!options_.tree.empty()) legend.line("tree", 84, tree_style("1.5"));
    if (!options_.rectangles.empty()) legend.area("rectangle", 108, rectangle_style);
    if (!options_.intervals.empty()) legend.line("interval", 108, interval_style);
    if (!options_.critical_corners.empty()) {
      legend.entry("critical corner", 140, [&](const Point& p) { cross_symbol(svg_, p); });
    }
  }

  static std::string trimmed(double x) {
    std::array<char, 64> buffer;
    std::snprintf(buffer.data(), buffer.size(), "%g", x);
    return buffer.data();
  }

  const Workspace& workspace_;
  const SvgOptions& options_;
  SvgPaths paths_;
  Point size_;  // of the bounds, in pixels
  SvgWriter svg_;
};

}  // namespace detail

/// A picture of the workspace with its exact, round safety zones; for each plan its route, its
/// curve (Beziers as Beziers), start and goal; and a legend.
inline std::string to_svg(const Workspace& workspace, std::span<const Plan> plans,
                          const SvgOptions& options = {}) {
  return detail::SvgPicture(workspace, options).draw(plans);
}

/// Writes `to_svg` to a file, completely or not at all. Errors: `invalid_input` if the file cannot
/// be written.
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
