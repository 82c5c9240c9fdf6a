// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/search/search_record.hpp"

/// \file
/// SvgOptions: what a picture shows.

namespace tutavia {

/// Options of a picture, and what to draw besides the plans. `add_search` fills in what a search
/// recorded.
struct SvgOptions {
  double width = 800;                 ///< of the drawing area, in pixels
  std::vector<std::string> labels{};  ///< names of the plans in the legend: "astar, delta"
  bool zones = true;                  ///< whether to draw the safety zones
  bool risk_zones = true;             ///< whether to draw the risk zones that routes name, in grey
  bool footprints = true;             ///< whether to outline vehicles along their paths
  bool profile = false;  ///< whether to plot clearance and curvature along the plans, below the map
  /// Whether to show how curves are built: pieces in the colours of their kinds and the ends of
  /// pieces, with control polygons and the radii of arcs.
  bool pieces = false;
  bool least_clearance = false;  ///< whether to mark the points of plans nearest to an obstacle
  std::vector<Point> visited{};  ///< nodes that a search expanded, light blue, below all else
  /// The side of cells, counted from the lower corner of the bounds [m]. Visited nodes at centres
  /// of cells are squares, all others dots. Rectangles between centres of cells cover whole cells.
  double cell_size = 0;
  std::vector<Box> buffer{};              ///< cells of a safety buffer, light blue
  std::vector<Point> critical_corners{};  ///< marked with crosses
  std::vector<Segment> outlines{};        ///< thin lines, such as the border of a turned map
  std::vector<Segment> tree{};            ///< edges of a random tree, drawn thin
  std::vector<Curve> tree_paths{};        ///< paths before nodes are removed, black
  std::vector<Box> rectangles{};          ///< rectangles of a rectangle expansion from the start
  std::vector<Segment> intervals{};       ///< the passages into them: the intervals they grew from
  std::vector<Box> goal_rectangles{};     ///< rectangles of an expansion from the goal
  std::vector<Segment> goal_intervals{};  ///< the passages into them
  std::vector<Point> starts{};            ///< marked besides those of the plans
  std::vector<Point> goals{};             ///< the same
  std::vector<std::string> notes{};       ///< lines below the legend
  std::string title{};
  bool legend = true;   ///< whether to explain below the map what is drawn
  bool y_down = false;  ///< y grows downwards, as in images
};

/// Adds the visited nodes, the tree and the rectangles that a search recorded. The best path of its
/// tree is added if it is not the route, from which the search then removed nodes.
inline void add_search(SvgOptions& options, const SearchRecord& record, const Curve& route = {}) {
  using Kind = SearchRecord::Event::Kind;
  for (const auto& [kind, a, b, side] : record.events) {
    const bool is_forward = side == SearchSide::start;
    if (kind == Kind::expanded) options.visited.push_back(a);
    if (kind == Kind::edge) options.tree.push_back({a, b});
    if (kind == Kind::rectangle) {
      (is_forward ? options.rectangles : options.goal_rectangles).push_back({a, b});
    }
    if (kind == Kind::interval) {
      (is_forward ? options.intervals : options.goal_intervals).push_back({a, b});
    }
  }
  if (record.tree_path.empty()) return;
  if (waypoints(record.tree_path) != waypoints(route)) {
    options.tree_paths.push_back(record.tree_path);
  }
}

}  // namespace tutavia
