// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "tutavia/geometry/box.hpp"
#include "tutavia/world/scene.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// warn_of_degrees: tells coordinates in degrees from those in metres.

namespace tutavia::detail {

/// What is known of the coordinates of a file.
class DegreeCheck {
 public:
  void add(const Point& p) {
    box_.include(p);
    for (const double x : {p.x(), p.y()}) {
      if (std::abs(std::remainder(x, 1e-3)) > 1e-7) has_fine_digits_ = true;
    }
  }
  void add(const Ring& ring) {
    for (const Point& p : ring) add(p);
  }
  void add(const std::vector<Obstacle>& obstacles) {
    for (const Obstacle& obstacle : obstacles) {
      if (const Disc* disc = std::get_if<Disc>(&obstacle)) {
        add(disc->center);
      } else {
        const Polygon& polygon = std::get<Polygon>(obstacle);
        add(polygon.outer);
        for (const Ring& hole : polygon.holes) add(hole);
      }
    }
  }

  /// Whether all of these hold. The coordinates are degrees of longitude and latitude, in either
  /// order: one within +-180, the other within +-90. They span more than 0 and at most 1, and the
  /// largest of them is at least 10 times the span. One of them has more than three decimals, which
  /// are 100 m in degrees and a millimetre in metres.
  bool looks_like_degrees() const {
    if (!has_fine_digits_ || !is_finite(box_.min) || !is_finite(box_.max)) return false;
    const double x = std::fmax(std::abs(box_.min.x()), std::abs(box_.max.x()));
    const double y = std::fmax(std::abs(box_.min.y()), std::abs(box_.max.y()));
    const double span = std::fmax(box_.width(), box_.height());
    return std::fmax(x, y) <= 180 && std::fmin(x, y) <= 90 && span > 0 && span <= 1 &&
           std::fmax(x, y) >= 10 * span;
  }

 private:
  Box box_{};
  bool has_fine_digits_ = false;
};

inline void warn_of_degrees(const DegreeCheck& check, std::vector<std::string>& warnings) {
  if (!check.looks_like_degrees()) return;
  warnings.emplace_back(
      "the coordinates look like degrees of longitude and latitude; planning is in metres: project "
      "them first");
}

/// The warning for the obstacles, bounds, start and goals of a scene.
inline void warn_of_degrees(const Scene& scene, std::vector<std::string>& warnings) {
  DegreeCheck check;
  check.add(scene.workspace.obstacles);
  for (const Point& p : {scene.workspace.bounds.min, scene.workspace.bounds.max, scene.start}) {
    if (is_finite(p)) check.add(p);
  }
  check.add(scene.goals);
  warn_of_degrees(check, warnings);
}

}  // namespace tutavia::detail
