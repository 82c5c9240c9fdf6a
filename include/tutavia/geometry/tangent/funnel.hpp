// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

#include "tutavia/geometry/point.hpp"
#include "tutavia/geometry/predicates.hpp"

/// \file
/// funnel_path: the shortest path through a sequence of portals.

namespace tutavia::detail {

/// Two chains that part at an apex, the last known vertex of the shortest path.
class Funnel {
 public:
  explicit Funnel(const Point& start) : path_{start}, chains_{start} {}

  /// Adds a right end. Points that would make the right chain bend outwards are removed first.
  void add_right(const Point& p) {
    while (chains_.size() > 1) {
      const std::size_t last = chains_.size() - 1;
      if (last > apex_) {  // the right chain stays convex
        if (orientation(chains_[last - 1], chains_[last], p) < 0) break;
        chains_.pop_back();
      } else {  // the right chain is the apex alone, which moves along the left chain
        if (orientation(chains_[apex_], chains_[apex_ - 1], p) <= 0) break;
        chains_.pop_back();
        --apex_;
        path_.push_back(chains_[apex_]);
      }
    }
    chains_.push_back(p);
  }
  void add_left(const Point& p) {
    while (chains_.size() > 1) {
      if (apex_ > 0) {
        if (orientation(chains_[1], chains_[0], p) > 0) break;
        chains_.pop_front();
        --apex_;
      } else {
        if (orientation(chains_[0], chains_[1], p) >= 0) break;
        chains_.pop_front();
        path_.push_back(chains_[0]);
      }
    }
    chains_.push_front(p);
    ++apex_;
  }

  /// The path to the right end.
  std::vector<Point> finish() {
    for (std::size_t i = apex_ + 1; i < chains_.size(); ++i) path_.push_back(chains_[i]);
    return std::move(path_);
  }

 private:
  std::vector<Point> path_;   // to the apex
  std::deque<Point> chains_;  // from the left end via the apex to the right end
  std::size_t apex_ = 0;      // index of the apex in chains_
};

/// The shortest path through a sequence of portals. Each portal is (right, left) as seen when
/// crossing it. Returns the path's vertices; a vertex shared by several portals appears once per
/// portal. Exact: bends are decided by exact orientations. Linear in the number of portals.
/// Source: Lee and Preparata 1984, "Euclidean shortest paths in the presence of rectilinear
/// barriers".
inline std::vector<Point> funnel_path(const std::vector<std::pair<Point, Point>>& portals,
                                      const Point& start, const Point& goal) {
  Funnel funnel(start);
  for (const auto& [right, left] : portals) {
    funnel.add_right(right);
    funnel.add_left(left);
  }
  funnel.add_right(goal);
  return funnel.finish();
}

}  // namespace tutavia::detail
