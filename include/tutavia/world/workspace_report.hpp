// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <ostream>
#include <vector>

#include "tutavia/world/workspace.hpp"

/// \file
/// WorkspaceReport: unusual features of a workspace, and how the library treats them.

namespace tutavia {

/// Features of a workspace that its author may not have intended. None is an error: the library
/// treats each as described here.
struct WorkspaceReport {
  std::size_t repeated_points = 0;          ///< removed
  std::size_t clockwise_rings = 0;          ///< outer rings; both orientations are valid
  std::vector<std::size_t> without_area{};  ///< obstacles kept as segments or points
  /// Obstacles with rings that touch or cross themselves or each other: every edge blocks, and the
  /// interior is chosen so that the obstacle never shrinks (see tutavia::contains).
  std::vector<std::size_t> self_crossing{};

  bool empty() const {
    return repeated_points == 0 && clockwise_rings == 0 && without_area.empty() &&
           self_crossing.empty();
  }
};

/// Inspects a valid workspace. O(n log n) per obstacle, unless very many edges share abscissas.
inline WorkspaceReport inspect(const Workspace& workspace) {
  WorkspaceReport report;
  for (std::size_t i = 0; i < workspace.obstacles.size(); ++i) {
    const Polygon* polygon = std::get_if<Polygon>(&workspace.obstacles[i]);
    if (polygon == nullptr) continue;
    const auto count_repeated = [&](const Ring& ring) {
      for (std::size_t k = 1; k < ring.size(); ++k) {
        if (ring[k] == ring[k - 1]) ++report.repeated_points;
      }
    };
    count_repeated(polygon->outer);
    for (const Ring& hole : polygon->holes) count_repeated(hole);
    const double area = detail::signed_area_twice(polygon->outer);
    if (area < 0) ++report.clockwise_rings;
    if (detail::is_flat(polygon->outer)) {
      report.without_area.push_back(i);
    } else if (!is_simple(*polygon)) {
      report.self_crossing.push_back(i);
    }
  }
  return report;
}

inline std::ostream& operator<<(std::ostream& out, const WorkspaceReport& report) {
  const char* separator = "";
  const auto item = [&](std::size_t count, const char* text) {
    if (count == 0) return;
    out << separator << count << text;
    separator = ", ";
  };
  item(report.repeated_points, " repeated points removed");
  item(report.clockwise_rings, " clockwise rings accepted");
  item(report.without_area.size(), " obstacles without area kept as segments or points");
  item(report.self_crossing.size(), " self-crossing obstacles read conservatively");
  return out;
}

}  // namespace tutavia
