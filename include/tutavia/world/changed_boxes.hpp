// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>
#include <vector>

#include "tutavia/geometry/box.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// changed_boxes: the boxes in which two workspaces differ.

namespace tutavia {

/// The bounding boxes of the obstacles that only one of two workspaces has, in no particular order:
/// empty if both have the same obstacles, two boxes for an obstacle that moved. Obstacles are the
/// same if all their numbers are equal; duplicates count separately. The order of obstacles does
/// not matter. O(n log n) for n obstacles. \pre both workspaces are valid
std::vector<Box> changed_boxes(const Workspace& before, const Workspace& after);

namespace detail {

/// An obstacle's kind, its counts and coordinates, so that equal numbers mean equal obstacles.
using ObstacleNumbers = std::vector<double>;

inline ObstacleNumbers numbers_of(const Obstacle& obstacle) {
  if (const Disc* disc = std::get_if<Disc>(&obstacle)) {
    return {-1, disc->center.x(), disc->center.y(), disc->radius};
  }
  ObstacleNumbers numbers;
  const auto add = [&](const Ring& ring) {
    numbers.push_back(static_cast<double>(ring.size()));
    for (const Point& p : ring) numbers.insert(numbers.end(), {p.x(), p.y()});
  };
  const Polygon& polygon = std::get<Polygon>(obstacle);
  add(polygon.outer);
  for (const Ring& hole : polygon.holes) add(hole);
  return numbers;
}

}  // namespace detail

inline std::vector<Box> changed_boxes(const Workspace& before, const Workspace& after) {
  using Entry = std::pair<detail::ObstacleNumbers, Box>;
  const auto is_less = [](const Entry& a, const Entry& b) { return a.first < b.first; };
  const auto sorted = [&](const Workspace& workspace) {
    std::vector<Entry> entries;
    entries.reserve(workspace.obstacles.size());
    for (const Obstacle& obstacle : workspace.obstacles) {
      entries.emplace_back(detail::numbers_of(obstacle), detail::box_of(obstacle));
    }
    std::sort(entries.begin(), entries.end(), is_less);
    return entries;
  };
  const std::vector<Entry> old = sorted(before), now = sorted(after);
  std::vector<Entry> changed;
  std::set_symmetric_difference(old.begin(), old.end(), now.begin(), now.end(),
                                std::back_inserter(changed), is_less);
  std::vector<Box> boxes;
  boxes.reserve(changed.size());
  for (const Entry& entry : changed) boxes.push_back(entry.second);
  return boxes;
}

}  // namespace tutavia
