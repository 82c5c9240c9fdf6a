// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/vehicle_path.hpp"
#include "tutavia/io/svg_options.hpp"
#include "tutavia/io/text/svg_panels.hpp"
#include "tutavia/io/text/svg_picture.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// A picture of how a route was smoothed.

namespace tutavia {

namespace detail {

/// The part of a map, a quarter as wide and as high, in which a curve turns most.
/// \pre the curve is not empty
inline Box part_with_most_turns(const Curve& curve, const Box& map) {
  const Point half = (map.max - map.min) / 8;
  const auto part_around = [&](const Point& p) -> Box {
    const Point center = Box{map.min + half, map.max - half}.clamp(p);
    return {center - half, center + half};
  };
  Point center = curve.point(curve.length() / 2);
  if (!(curve.length() > 0)) return part_around(center);
  const std::vector<CurvePoint> points = curve.sample(curve.length() / 400);
  double most = 0;
  for (std::size_t k = 0; k < points.size(); k += 4) {
    const Box part = part_around(points[k].position);
    double turns = 0;
    Point sum = Point::Zero();
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (!part.contains(points[i].position)) continue;
      const double turn = std::abs(wrapped_angle(points[i].heading - points[i - 1].heading));
      turns += turn;
      sum += turn * points[i].position;
    }
    if (turns <= most) continue;
    most = turns;
    center = sum / turns;
  }
  return part_around(center);
}

}  // namespace detail

/// Three pictures side by side: the route with its waypoints; the curve and the route in the part
/// of the map where the curve turns most, four times as large, with the ends of its pieces, control
/// polygons, radii and critical corners; and the curve with a disc around its point of least
/// clearance. A frame in the first picture is the border of the second, which shows the whole map
/// for a vehicle. Below them are a profile and a legend. Each picture is `options.width` wide.
/// \pre the curve is not empty
inline std::string to_svg_smoothing(const Workspace& workspace, const Plan& plan,
                                    const SvgOptions& options = {}) {
  Plan route = plan;
  route.curve = plan.route.curve;
  route.gears = plan.route.gears;
  SvgOptions whole = options, built = options, all = options;
  whole.critical_corners.clear();
  built.footprints = false;
  built.pieces = all.pieces = all.least_clearance = true;
  SvgOptions before = whole, after = whole;
  before.footprints = false;
  before.pieces = after.least_clearance = true;
  Workspace magnified = workspace;
  if (plan.gears.empty()) {  // turns of vehicles, with their radii, take half of the map
    magnified.bounds = detail::part_with_most_turns(plan.curve, workspace.bounds);
    const auto& [a, c] = magnified.bounds;
    const Point b(c.x(), a.y()), d(a.x(), c.y());
    before.outlines.insert(before.outlines.end(), {{a, b}, {b, c}, {c, d}, {d, a}});
  }

  detail::SvgPanels panels(workspace, options.width);
  panels.add(workspace, std::span(&route, 1), before);
  panels.add(magnified, std::span(&plan, 1), built);
  panels.add(workspace, std::span(&plan, 1), after);
  const double margin = detail::SvgPanels::margin;
  const double bottom =
      detail::draw_below(panels.svg(), {margin, panels.height() - margin},
                         panels.width() - 2 * margin, workspace, std::span(&plan, 1), all);
  return panels.svg().finish(panels.width(), bottom);
}

}  // namespace tutavia
