// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/io/svg_options.hpp"
#include "tutavia/io/text/svg_key.hpp"
#include "tutavia/io/text/svg_legend.hpp"
#include "tutavia/io/text/svg_map.hpp"
#include "tutavia/io/text/svg_paths.hpp"
#include "tutavia/io/text/svg_picture.hpp"
#include "tutavia/io/text/svg_style.hpp"
#include "tutavia/io/text/svg_text.hpp"
#include "tutavia/io/text/svg_writer.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/search_record.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// SvgAnimation: an animated picture of one query.

namespace tutavia::detail {

/// The events of a search between two shares of it, in [0, 1]. Nodes and all others are counted
/// apart, because trees report their edges in the end.
inline SearchRecord events_between(const SearchRecord& record, double from, double to) {
  using Kind = SearchRecord::Event::Kind;
  const auto is_node = [](const SearchRecord::Event& event) {
    return event.kind == Kind::expanded || event.kind == Kind::generated;
  };
  const auto nodes =
      static_cast<std::size_t>(std::count_if(record.events.begin(), record.events.end(), is_node));
  const std::array<double, 2> counts{static_cast<double>(record.events.size() - nodes),
                                     static_cast<double>(nodes)};
  std::array<double, 2> numbers{};
  SearchRecord part;
  for (const SearchRecord::Event& event : record.events) {
    const std::size_t group = is_node(event) ? 1 : 0;
    const double number = numbers[group]++;
    if (from * counts[group] <= number && number < to * counts[group]) part.events.push_back(event);
  }
  return part;
}

/// A search in parts, each as options that show its events. A node that was visited before is left
/// out.
inline std::vector<SvgOptions> search_parts(const SearchRecord& record, std::size_t count) {
  std::vector<SvgOptions> parts;
  std::set<std::pair<double, double>> seen;
  const auto total = static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto first = static_cast<double>(i);
    SearchRecord part = events_between(record, first / total, (first + 1) / total);
    std::erase_if(part.events, [&](const SearchRecord::Event& event) {
      return event.kind == SearchRecord::Event::Kind::expanded &&
             !seen.emplace(event.a.x(), event.a.y()).second;
    });
    parts.emplace_back();
    add_search(parts.back(), part);
  }
  return parts;
}

/// Draws the search as it grows, then its route, then the curve, and a robot that drives along it;
/// again and again, by SMIL. Viewers without animations show the whole of it.
class SvgAnimation {
 public:
  SvgAnimation(const Workspace& workspace, const Plan& plan, const SearchRecord& record,
               const SvgOptions& options)
      : workspace_(workspace),
        plan_(plan),
        options_(options),
        parts_(search_parts(record, most_parts)),
        scale_(options.width /
               std::max({workspace.bounds.width(), workspace.bounds.height(), 1e-300})),
        width_(std::max(workspace.bounds.width() * scale_, 560.0)) {
    add_search(options_, record, plan.route.curve);  // for the legend
  }

  std::string draw() {
    double y = margin;
    for (const std::string& line : wrapped(options_.title, width_ / 1.4)) {
      svg_.text({margin, y + 12}, line, "font-size=\"18\" font-weight=\"bold\"");
      y += 24;
    }
    const SvgPaths paths{workspace_.bounds, scale_, {margin, y}, options_.y_down};
    SvgMap map(svg_, workspace_, paths);
    map.begin();
    for_each_part([&](const SvgOptions& part) { map.visited(part.visited, options_.cell_size); });
    draw_areas(map, workspace_, std::span(&plan_, 1), options_);
    map.lines(options_.outlines, SvgStyle::outline);
    for_each_part([&](const SvgOptions& part) { lines(map, part); });
    appear(route_time, [&] { route(map); });
    appear(curve_time, [&] { curve(map, paths); });
    map.end();
    start_symbol(svg_, paths.pixel(plan_.curve.start()));
    goal_symbol(svg_, paths.pixel(plan_.curve.end()), SvgStyle::colour(0));
    if (!plan_.gears.empty()) {
      draw_headings(svg_, paths, {plan_.curve, plan_.gears}, SvgStyle::colour(0));
    }
    robot(paths);
    y += workspace_.bounds.height() * scale_ + 24;
    if (options_.legend) {
      y = SvgKey(svg_, {margin, y}, width_, workspace_, std::span(&plan_, 1), options_).draw();
    }
    return svg_.finish(width_ + 2 * margin, y);
  }

 private:
  static constexpr double margin = 16;
  static constexpr std::size_t most_parts = 48;
  // As shares of the loop.
  static constexpr double route_time = 0.44, curve_time = 0.5, drive_time = 0.58, end_time = 0.94;
  static constexpr std::string_view loop = "\" dur=\"9s\" repeatCount=\"indefinite\"/>";

  static std::string share(double x) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4f", x);
    return text.data();
  }

  /// Draws what is hidden before a time of the loop.
  template <class Draw>
  void appear(double time, const Draw& draw) {
    svg_.raw(
        "<g><animate attributeName=\"opacity\" calcMode=\"discrete\" values=\"0;1\" keyTimes=\"0;" +
        share(time) + std::string(loop));
    draw();
    svg_.raw("</g>\n");
  }

  template <class Draw>
  void for_each_part(const Draw& draw) {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      appear(route_time * static_cast<double>(i + 1) / static_cast<double>(parts_.size() + 1),
             [&] { draw(parts_[i]); });
    }
  }

  void lines(SvgMap& map, const SvgOptions& part) const {
    const CellCentres centres{workspace_.bounds.min, options_.cell_size};
    map.boxes(whole_cells(part.rectangles, centres), SvgStyle::forward_rectangle);
    map.boxes(whole_cells(part.goal_rectangles, centres), SvgStyle::backward_rectangle);
    map.lines(part.intervals, SvgStyle::forward_passage);
    map.lines(part.goal_intervals, SvgStyle::backward_passage);
    map.lines(part.tree, SvgStyle::tree("0.7"));
  }

  void route(SvgMap& map) const {
    for (const Curve& path : options_.tree_paths) {
      map.polyline(path, SvgStyle::tree_path, 2.2, "fill=\"#000000\"");
    }
    map.polyline(plan_.route.curve, SvgStyle::route, 1.6, "fill=\"#7a8794\"");
    if (shows_rectangles(options_)) map.dots(waypoints(plan_.route.curve), 4, SvgStyle::path_node);
  }

  /// The curve grows from its start; that of a vehicle is there at once, with footprints.
  void curve(SvgMap& map, const SvgPaths& paths) {
    if (!plan_.gears.empty()) {
      const VehiclePath path{plan_.curve, plan_.gears};
      if (shows_footprint(plan_, options_)) {
        map.footprints(*plan_.route.vehicle, path, SvgStyle::colour(0));
      }
      return map.drive(path, SvgStyle::colour(0));
    }
    svg_.raw(
        "<path fill=\"none\" stroke-linejoin=\"round\" pathLength=\"1\" " +
        SvgStyle::curve(SvgStyle::colour(0)) + " d=\"" + paths.of_curve(plan_.curve) +
        "\"><animate attributeName=\"stroke-dasharray\" values=\"0 1;0 1;1 0;1 0\" keyTimes=\"0;" +
        share(curve_time) + ";" + share(drive_time) + ";1" + std::string(loop) + "</path>\n");
  }

  /// A disc with the safety radius, at least a dot, that drives along the curve. Without animation
  /// it stays hidden.
  void robot(const SvgPaths& paths) {
    const double radius = std::max(workspace_.safety_radius * scale_, 5.0);
    svg_.raw(
        "<circle r=\"" + SvgWriter::number(radius) + "\" fill=\"" + SvgStyle::colour(0) +
        "\" fill-opacity=\"0.5\" stroke=\"#222b33\" visibility=\"hidden\"><set "
        "attributeName=\"visibility\" to=\"visible\"/><animateMotion calcMode=\"linear\" path=\"" +
        paths.of_curve(plan_.curve) + "\" keyPoints=\"0;0;1;1\" keyTimes=\"0;" + share(drive_time) +
        ";" + share(end_time) + ";1" + std::string(loop) + "</circle>\n");
  }

  const Workspace& workspace_;
  const Plan& plan_;
  SvgOptions options_;
  std::vector<SvgOptions> parts_;
  double scale_;  // pixels per metre
  double width_;  // of the title and the legend, in pixels
  SvgWriter svg_{};
};

}  // namespace tutavia::detail
