// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tutavia/io/svg_options.hpp"
#include "tutavia/io/text/svg_key.hpp"
#include "tutavia/io/text/svg_legend.hpp"
#include "tutavia/io/text/svg_map.hpp"
#include "tutavia/io/text/svg_paths.hpp"
#include "tutavia/io/text/svg_pieces.hpp"
#include "tutavia/io/text/svg_profile.hpp"
#include "tutavia/io/text/svg_style.hpp"
#include "tutavia/io/text/svg_text.hpp"
#include "tutavia/io/text/svg_visited.hpp"
#include "tutavia/io/text/svg_writer.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// SvgPicture: one picture of a workspace and plans.

namespace tutavia::detail {

/// Rectangles from centre of cell to centre of cell cover these cells.
inline std::vector<Box> whole_cells(std::vector<Box> boxes, const CellCentres& centres) {
  for (Box& box : boxes) {
    if (!centres.cell_at(box.min) || !centres.cell_at(box.max)) continue;
    box = box.inflated(centres.side / 2);
  }
  return boxes;
}

/// Draws what lies below the lines, but visited nodes: risk zones, buffer, safety zones, obstacles.
inline void draw_areas(SvgMap& map, const Workspace& workspace, std::span<const Plan> plans,
                       const SvgOptions& options) {
  for (const double width : risk_widths(plans, options)) {
    map.around_obstacles(workspace.safety_radius + width, "#b4bbc2", " opacity=\"0.6\"");
  }
  map.boxes(options.buffer, SvgStyle::buffer);
  if (options.zones && workspace.safety_radius > 0) map.safety_zones(workspace.safety_radius);
  map.obstacles();
}

/// Draws the headings at both ends of a vehicle's path.
inline void draw_headings(SvgWriter& svg, const SvgPaths& paths, const VehiclePath& path,
                          const std::string& colour) {
  const auto draw = [&](const Pose& pose, std::string_view its_colour) {
    if (!paths.shows(pose.position)) return;
    arrow_symbol(svg, paths.pixel(pose.position), paths.direction(pose.heading), its_colour);
  };
  draw(path.start(), SvgStyle::start_arrow);
  draw(path.end(), colour);
}

/// Draws the profile and the legend, from `corner` down, and returns the lower end.
inline double draw_below(SvgWriter& svg, Point corner, double width, const Workspace& workspace,
                         std::span<const Plan> plans, const SvgOptions& options) {
  constexpr double margin = 16, first_row = 24;
  if (options.profile && !plans.empty()) {
    SvgProfile(svg, corner, width, workspace, plans).draw();
    corner.y() += SvgProfile::height;
  }
  if (!options.legend) return corner.y() + margin;
  corner.y() += first_row;
  return SvgKey(svg, corner, width, workspace, plans, options).draw();
}

/// Draws one picture: the title, the map, the profile and the legend, from the top down.
class SvgPicture {
 public:
  SvgPicture(const Workspace& workspace, std::span<const Plan> plans, const SvgOptions& options)
      : workspace_(workspace),
        options_(options),
        plans_(plans),
        scale_(options.width /
               std::max({workspace.bounds.width(), workspace.bounds.height(), 1e-300})),
        width_(std::max(workspace.bounds.width() * scale_, 560.0)) {}

  std::string draw() {
    double y = title(margin);
    const SvgPaths paths{workspace_.bounds, scale_, {margin, y}, options_.y_down};
    map(paths);
    y += workspace_.bounds.height() * scale_;
    y = draw_below(svg_, {margin, y}, width_, workspace_, plans_, options_);
    return svg_.finish(width_ + 2 * margin, y);
  }

 private:
  static constexpr double margin = 16;
  static constexpr std::string_view route_dot = "fill=\"#7a8794\"";

  /// Returns the lower end.
  double title(double y) {
    for (const std::string& line : wrapped(options_.title, width_ / 1.4)) {
      svg_.text({margin, y + 12}, line, "font-size=\"18\" font-weight=\"bold\"");
      y += 24;
    }
    return options_.title.empty() ? y : y + 6;
  }

  void map(const SvgPaths& paths) {
    SvgMap map(svg_, workspace_, paths);
    map.begin();
    map.visited(options_.visited, options_.cell_size);
    draw_areas(map, workspace_, plans_, options_);
    const CellCentres centres{workspace_.bounds.min, options_.cell_size};
    map.boxes(whole_cells(options_.rectangles, centres), SvgStyle::forward_rectangle);
    map.boxes(whole_cells(options_.goal_rectangles, centres), SvgStyle::backward_rectangle);
    map.lines(options_.intervals, SvgStyle::forward_passage);
    map.lines(options_.goal_intervals, SvgStyle::backward_passage);
    map.lines(options_.outlines, SvgStyle::outline);
    map.lines(options_.tree, SvgStyle::tree("0.7"));
    for (const Curve& path : options_.tree_paths) {
      map.polyline(path, SvgStyle::tree_path, 2.2, "fill=\"#000000\"");
    }
    for (std::size_t i = 0; i < plans_.size(); ++i) {
      if (!shows_footprint(plans_[i], options_)) continue;
      map.footprints(*plans_[i].route.vehicle, {plans_[i].curve, plans_[i].gears},
                     SvgStyle::colour(i));
    }
    for (const Plan& plan : plans_) map.polyline(plan.route.curve, SvgStyle::route, 1.6, route_dot);
    for (std::size_t i = 0; i < plans_.size(); ++i) curve(map, plans_[i], SvgStyle::colour(i));
    if (options_.least_clearance) {
      for (const Plan& plan : plans_) draw_least_clearance(map, plan);
    }
    if (shows_rectangles(options_)) {
      for (const Plan& plan : plans_) map.dots(waypoints(plan.route.curve), 4, SvgStyle::path_node);
    }
    for (const Point& corner : options_.critical_corners) cross_symbol(svg_, paths.pixel(corner));
    map.end();
    ends(paths);
  }

  void curve(SvgMap& map, const Plan& plan, const std::string& colour) const {
    if (options_.pieces) {
      draw_pieces(map, plan.curve, plan.gears);
    } else if (plan.gears.empty()) {
      map.curve(plan.curve, colour);
    } else {
      map.drive({plan.curve, plan.gears}, colour);
    }
  }

  void ends(const SvgPaths& paths) {
    for (const Point& p : options_.starts) start_symbol(svg_, paths.pixel(p));
    for (const Point& p : options_.goals) goal_symbol(svg_, paths.pixel(p), "#7a8794");
    for (std::size_t i = 0; i < plans_.size(); ++i) {
      const Curve& curve = plans_[i].curve;
      if (curve.empty()) continue;
      if (!plans_[i].gears.empty()) {
        draw_headings(svg_, paths, {curve, plans_[i].gears}, SvgStyle::colour(i));
      }
      if (paths.shows(curve.start())) start_symbol(svg_, paths.pixel(curve.start()));
      if (paths.shows(curve.end())) {
        goal_symbol(svg_, paths.pixel(curve.end()), SvgStyle::colour(i));
      }
    }
  }

  const Workspace& workspace_;
  const SvgOptions& options_;
  std::span<const Plan> plans_;
  double scale_;  // pixels per metre
  double width_;  // of the title, the profile and the legend, in pixels
  SvgWriter svg_{};
};

}  // namespace tutavia::detail
