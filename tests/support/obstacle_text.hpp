// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "tutavia/plan/failure.hpp"
#include "tutavia/world/scene.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// Exact texts of what readers return, for tables of expected results.

namespace tutavia::test {

/// The shortest text that reads back to the same double.
inline std::string exact_text(double x) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), x).ptr;
  return {text.data(), end};
}
inline std::string exact_text(const Point& p) {
  return exact_text(p.x()) + " " + exact_text(p.y());
}

/// "(0 0,4 0,4 4)".
inline std::string exact_text(const Ring& ring) {
  std::string text;
  for (const Point& p : ring) text.append(text.empty() ? "(" : ",").append(exact_text(p));
  return text + ")";
}

/// A line per obstacle, such as "disc 1 2 r 0" and "polygon (0 0,4 0,4 4) hole (1 1,2 1,2 2)", and
/// one per warning: "! line 1, column 3: ...".
inline std::string exact_text(const std::vector<Obstacle>& obstacles,
                              const std::vector<std::string>& warnings) {
  std::string text;
  for (const Obstacle& obstacle : obstacles) {
    if (const Disc* disc = std::get_if<Disc>(&obstacle)) {
      text.append("disc ").append(exact_text(disc->center));
      text.append(" r ").append(exact_text(disc->radius));
    } else {
      const Polygon& polygon = std::get<Polygon>(obstacle);
      text.append("polygon ").append(exact_text(polygon.outer));
      for (const Ring& hole : polygon.holes) text.append(" hole ").append(exact_text(hole));
    }
    text += '\n';
  }
  for (const std::string& warning : warnings) text.append("! ").append(warning).append("\n");
  return text;
}

/// The same of many vertices in short: "! ..." and "2 obstacles of 9 points in (0 0,4 4)".
inline std::string summary_text(const std::vector<Obstacle>& obstacles,
                                const std::vector<std::string>& warnings) {
  std::size_t points = 0;
  for (const Obstacle& obstacle : obstacles) {
    const Polygon* polygon = std::get_if<Polygon>(&obstacle);
    points += polygon == nullptr ? 1 : polygon->outer.size();
    if (polygon == nullptr) continue;
    for (const Ring& hole : polygon->holes) points += hole.size();
  }
  const Box box = Workspace{.bounds = {}, .obstacles = obstacles}.extent();
  return exact_text({}, warnings) + std::to_string(obstacles.size()) + " obstacles of " +
         std::to_string(points) + " points in " + exact_text(Ring{box.min, box.max}) + "\n";
}

/// The first of them that has at most 400 bytes.
inline std::string short_text(const std::vector<Obstacle>& obstacles,
                              const std::vector<std::string>& warnings) {
  std::string text = exact_text(obstacles, warnings);
  return text.size() <= 400 ? text : summary_text(obstacles, warnings);
}

/// "error: line 1, column 3: ...\n"; other codes than `invalid_input` are named.
inline std::string exact_text(const Failure& failure) {
  const bool is_usual = failure.code == PlanError::invalid_input;
  std::string text = "error: ";
  if (!is_usual) text.append(to_string(failure.code)).append(": ");
  return text.append(failure.detail).append("\n");
}

}  // namespace tutavia::test
