// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tutavia/geometry/vehicle_path.hpp"
#include "tutavia/io/svg_options.hpp"
#include "tutavia/io/text/svg_footprint.hpp"
#include "tutavia/io/text/svg_legend.hpp"
#include "tutavia/io/text/svg_pieces.hpp"
#include "tutavia/io/text/svg_style.hpp"
#include "tutavia/io/text/svg_text.hpp"
#include "tutavia/io/text/svg_writer.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// SvgKey: the legend of a picture of plans.

namespace tutavia::detail {

/// The widths of the risk zones that the routes of plans name, from the widest; each once.
inline std::vector<double> risk_widths(std::span<const Plan> plans, const SvgOptions& options) {
  std::vector<double> widths;
  if (!options.risk_zones) return widths;
  for (const Plan& plan : plans) {
    if (plan.route.risk_width > 0) widths.push_back(plan.route.risk_width);
  }
  std::sort(widths.begin(), widths.end(), std::greater<>());
  widths.erase(std::unique(widths.begin(), widths.end()), widths.end());
  return widths;
}

inline bool shows_rectangles(const SvgOptions& options) {
  return !options.rectangles.empty() || !options.goal_rectangles.empty();
}

/// Whether the footprint of a plan's vehicle is drawn: a point has no outline.
inline bool shows_footprint(const Plan& plan, const SvgOptions& options) {
  return options.footprints && !plan.gears.empty() && plan.route.vehicle &&
         !outline_of(plan.route.vehicle->footprint).empty();
}

/// The legend: the curves, a row each, then what else the picture shows, and the notes.
class SvgKey {
 public:
  /// `first`: the left end of the first row, at half its height.
  SvgKey(SvgWriter& svg, const Point& first, double width, const Workspace& workspace,
         std::span<const Plan> plans, const SvgOptions& options)
      : svg_(svg),
        legend_(svg, first, width),
        workspace_(workspace),
        plans_(plans),
        options_(options) {}

  /// Draws it and returns its lower end.
  double draw() {
    if (has_names()) curves();
    areas();
    search();
    marks();
    legend_.end_row();
    for (const std::string& note : options_.notes) legend_.note(note);
    return legend_.bottom();
  }

 private:
  static constexpr std::size_t most_rows = 12;  // of curves, one in a row; more share rows

  /// Whether curves have names: several ones, and a single one with a label.
  bool has_names() const { return plans_.size() > 1 || !options_.labels.empty(); }

  void curves() {
    for (std::size_t i = 0; i < plans_.size(); ++i) {
      const bool has_label = i < options_.labels.size() && !options_.labels[i].empty();
      std::string label = has_label ? options_.labels[i] : "curve " + std::to_string(i + 1);
      label += ", " + with_decimals(plans_[i].curve.length()) + " m";
      legend_.line(label, SvgStyle::curve(SvgStyle::colour(i)));
      if (plans_.size() <= most_rows) legend_.end_row();
    }
    legend_.end_row();
  }

  void areas() {
    legend_.area("obstacle", SvgStyle::obstacle);
    if (options_.zones && workspace_.safety_radius > 0) {
      legend_.area("safety zone, " + trimmed(workspace_.safety_radius) + " m", SvgStyle::zone);
    }
    for (const double width : risk_widths(plans_, options_)) {
      legend_.area("risk zone, " + trimmed(width) + " m beyond", SvgStyle::risk_zone);
    }
    if (!options_.buffer.empty()) legend_.area("safety buffer", SvgStyle::buffer);
    if (!options_.visited.empty()) {
      legend_.area("visited", "fill=\"" + std::string(SvgStyle::visited) + "\"");
    }
  }

  void search() {
    const bool both = !options_.goal_rectangles.empty() || !options_.goal_intervals.empty();
    const auto side = [&](const char* of_both, const char* alone) {
      return both ? of_both : alone;
    };
    if (!options_.rectangles.empty()) {
      legend_.area(side("forward rectangle", "rectangle"), SvgStyle::forward_rectangle);
    }
    if (!options_.intervals.empty()) {
      legend_.line(side("forward passage", "passage"), SvgStyle::forward_passage);
    }
    if (!options_.goal_rectangles.empty()) {
      legend_.area("backward rectangle", SvgStyle::backward_rectangle);
    }
    if (!options_.goal_intervals.empty()) {
      legend_.line("backward passage", SvgStyle::backward_passage);
    }
    if (!options_.outlines.empty()) legend_.line("outline", SvgStyle::outline);
    if (!options_.tree.empty()) legend_.line("tree", SvgStyle::tree("1.5"));
    if (!options_.tree_paths.empty()) {
      legend_.line("path of the tree, before nodes are removed", SvgStyle::tree_path);
    }
  }

  void marks() {
    if (!plans_.empty()) {
      if (!has_names()) legend_.line("proved curve", SvgStyle::curve(SvgStyle::colour(0)));
      vehicles();
      if (options_.pieces) pieces();
      if (options_.least_clearance) least_clearance();
      legend_.line("route", SvgStyle::route);
      if (shows_rectangles(options_)) {
        legend_.entry("path node", [&](const Point& p) { svg_.circle(p, 4, SvgStyle::path_node); });
      }
    }
    if (!plans_.empty() || !options_.starts.empty()) {
      legend_.entry("start", [&](const Point& p) { start_symbol(svg_, p); });
    }
    if (!plans_.empty() || !options_.goals.empty()) {
      const std::string colour = plans_.empty() ? "#7a8794" : SvgStyle::colour(0);
      legend_.entry("goal", [&](const Point& p) { goal_symbol(svg_, p, colour); });
    }
    if (!options_.critical_corners.empty()) {
      legend_.entry("critical corner", [&](const Point& p) { cross_symbol(svg_, p); });
    }
  }

  /// The kinds of pieces of routes and curves.
  void pieces() {
    std::array<bool, piece_styles.size()> is_there{};
    for (const Plan& plan : plans_) {
      for (const Curve* curve : {&plan.route.curve, &plan.curve}) {
        for (const Piece& piece : curve->pieces()) is_there[style_index(piece)] = true;
      }
    }
    for (std::size_t i = 0; i < piece_styles.size(); ++i) {
      if (is_there[i]) {
        legend_.line(piece_styles[i].label, SvgStyle::curve(piece_styles[i].colour, "2"));
      }
    }
    legend_.entry("end of a piece",
                  [&](const Point& p) { svg_.circle(p, 3, SvgStyle::piece_end); });
  }

  void least_clearance() {
    std::string label = "least clearance";
    if (plans_.size() == 1) {
      if (!touching_disc(plans_.front())) return;
      label += ", " + with_decimals(plans_.front().certificate.upper) + " m";
    }
    legend_.entry(label, [&](const Point& p) { svg_.circle(p, 7, SvgStyle::least_clearance); });
  }

  void vehicles() {
    const std::string colour = SvgStyle::colour(0);
    const auto is_any = [&](const auto& predicate) {
      return std::any_of(plans_.begin(), plans_.end(), predicate);
    };
    if (is_any([](const Plan& plan) {
          return std::find(plan.gears.begin(), plan.gears.end(), Gear::reverse) != plan.gears.end();
        })) {
      legend_.line("in reverse", SvgStyle::curve(colour).append(SvgStyle::reverse));
    }
    if (is_any([&](const Plan& plan) { return shows_footprint(plan, options_); })) {
      legend_.area("footprint", "fill=\"none\" rx=\"6\" " + SvgStyle::footprint(colour));
    }
    if (is_any([](const Plan& plan) { return !plan.gears.empty(); })) {
      legend_.entry("heading", [&](const Point& p) {
        arrow_symbol(svg_, {p.x() - 13, p.y()}, {1, 0}, SvgStyle::start_arrow);
      });
    }
  }

  SvgWriter& svg_;
  SvgLegend legend_;
  const Workspace& workspace_;
  std::span<const Plan> plans_;
  const SvgOptions& options_;
};

}  // namespace tutavia::detail
