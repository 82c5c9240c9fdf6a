// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/vehicle_path.hpp"
#include "tutavia/io/text/svg_footprint.hpp"
#include "tutavia/io/text/svg_paths.hpp"
#include "tutavia/io/text/svg_style.hpp"
#include "tutavia/io/text/svg_visited.hpp"
#include "tutavia/io/text/svg_writer.hpp"
#include "tutavia/plan/vehicle.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// SvgMap: the map of a picture and what is drawn on it.

namespace tutavia::detail {

/// Draws on a map, from metres to pixels; what comes later lies above.
class SvgMap {
 public:
  SvgMap(SvgWriter& svg, const Workspace& workspace, const SvgPaths& paths)
      : svg_(svg), workspace_(workspace), paths_(paths) {}

  /// Draws the floor. What follows is cut off at the bounds, until `end`.
  void begin() {
    svg_.raw("<clipPath id=\"bounds\">");
    frame("");
    svg_.raw("</clipPath>\n");
    frame("fill=\"#f7f9fb\"");
    svg_.raw("<g clip-path=\"url(#bounds)\">\n");
  }
  /// Draws the border.
  void end() {
    svg_.raw("</g>\n");
    frame("fill=\"none\" stroke=\"#33414e\" stroke-width=\"1.5\"");
  }

  void visited(const std::vector<Point>& nodes, double cell_size) {
    const VisitedNodes visited(nodes, {workspace_.bounds.min, cell_size});
    const std::string squares = visited.squares(paths_), dots = visited.dots(paths_);
    const std::string colour(SvgStyle::visited);
    if (!squares.empty()) {
      // Small squares are drawn larger, so that single ones are seen.
      const double stroke = std::max(0.0, 4 - cell_size * paths_.scale);
      svg_.path(squares, "fill=\"" + colour + "\" stroke=\"" + colour + "\" stroke-width=\"" +
                             SvgWriter::number(stroke) + "\" shape-rendering=\"crispEdges\"");
    }
    if (dots.empty()) return;
    const double width = std::clamp(0.7 * cell_size * paths_.scale, 3.0, 8.0);
    svg_.stroke(dots, "stroke=\"" + colour + "\" stroke-linecap=\"round\" stroke-width=\"" +
                          SvgWriter::number(width) + "\"");
  }

  /// All points nearer than `reach` to an obstacle: the shapes, stroked with twice the reach and
  /// round joins.
  void around_obstacles(double reach, const std::string& colour, const std::string& attributes) {
    svg_.raw("<g fill=\"" + colour + "\" stroke=\"" + colour +
             "\" stroke-linejoin=\"round\" stroke-width=\"" +
             SvgWriter::number(2 * reach * paths_.scale) + "\"" + attributes + ">\n");
    shapes(reach);
    svg_.raw("</g>\n");
  }
  void safety_zones(double radius) { around_obstacles(radius, "#f6d9b8", ""); }
  void obstacles() {
    svg_.raw("<g fill=\"#4a5763\" stroke=\"#4a5763\" stroke-width=\"1\">\n");
    shapes(0);
    svg_.raw("</g>\n");
  }

  /// Boxes as paths, so that empty ones show their border.
  void boxes(const std::vector<Box>& boxes, std::string_view style) {
    for (const Box& box : boxes) {
      const Point a = paths_.pixel(box.min), b = paths_.pixel(box.max);
      std::string path("M");
      path.append(SvgWriter::pair(a)).append("H").append(SvgWriter::number(b.x()));
      path.append("V").append(SvgWriter::number(b.y()));
      path.append("H").append(SvgWriter::number(a.x())).append("Z");
      svg_.path(path, style);
    }
  }
  /// Segments as one path.
  void lines(const std::vector<Segment>& segments, std::string_view style) {
    if (segments.empty()) return;
    std::string d;
    for (const Segment& s : segments) {
      d.append("M").append(paths_.at(s.a)).append("L").append(paths_.at(s.b));
    }
    svg_.stroke(d, style);
  }

  void dots(const std::vector<Point>& points, double radius, std::string_view style) {
    for (const Point& p : points) svg_.circle(paths_.pixel(p), radius, style);
  }
  void disc(const Disc& disc, std::string_view style) {
    svg_.circle(paths_.pixel(disc.center), disc.radius * paths_.scale, style);
  }
  void line(const Curve& curve, std::string_view style) {
    svg_.stroke(paths_.of_curve(curve), style);
  }
  /// A curve with dots where its pieces end.
  void polyline(const Curve& curve, std::string_view style, double dot,
                std::string_view dot_style) {
    line(curve, style);
    dots(waypoints(curve), dot, dot_style);
  }
  void curve(const Curve& curve, const std::string& colour) {
    line(curve, SvgStyle::halo);
    line(curve, SvgStyle::curve(colour));
  }
  /// The path of a vehicle, dashed where it drives in reverse.
  void drive(const VehiclePath& path, const std::string& colour) {
    line(path.curve, SvgStyle::halo);
    for (std::size_t i = 0, end = 0; i < path.gears.size(); i = end) {
      Curve part;
      for (end = i; end < path.gears.size() && path.gears[end] == path.gears[i]; ++end) {
        part.push_back(path.curve.pieces()[end]);
      }
      std::string style = SvgStyle::curve(colour);
      if (path.gears[i] == Gear::reverse) style.append(SvgStyle::reverse);
      line(part, style);
    }
  }
  /// Outlines of a vehicle's footprint along its path, at least as far apart as the footprint
  /// reaches if they are few enough.
  void footprints(const Vehicle& vehicle, const VehiclePath& path, const std::string& colour) {
    const std::vector<Arc> outline = outline_of(vehicle.footprint);
    if (outline.empty() || path.empty()) return;
    for (const Pose& pose : poses_along(path, vehicle.reach())) {
      std::string d;
      for (const Arc& arc : outline) {
        Curve part;
        part.push_back(placed(arc, pose));
        d += paths_.of_curve(part);
      }
      svg_.stroke(d, SvgStyle::footprint(colour));
    }
  }

 private:
  /// The bounds.
  void frame(std::string_view style) {
    svg_.rect(paths_.offset,
              {workspace_.bounds.width() * paths_.scale, workspace_.bounds.height() * paths_.scale},
              style);
  }

  void shapes(double reach) {
    for (const Obstacle& obstacle : workspace_.obstacles) {
      if (const Disc* disc = std::get_if<Disc>(&obstacle)) {
        svg_.circle(paths_.pixel(disc->center), (disc->radius + reach) * paths_.scale,
                    "stroke=\"none\"");
        continue;
      }
      const Polygon& polygon = std::get<Polygon>(obstacle);
      svg_.raw("<path fill-rule=\"evenodd\" d=\"" + paths_.of_ring(polygon.outer));
      for (const Ring& hole : polygon.holes) svg_.raw(paths_.of_ring(hole));
      svg_.raw("\"/>\n");
    }
  }

  SvgWriter& svg_;
  const Workspace& workspace_;
  SvgPaths paths_;
};

}  // namespace tutavia::detail
