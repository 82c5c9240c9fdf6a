// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tutavia/geometry/point.hpp"
#include "tutavia/io/text/svg_paths.hpp"
#include "tutavia/io/text/svg_writer.hpp"

/// \file
/// VisitedNodes: the nodes that a search expanded, as squares and dots.

namespace tutavia::detail {

/// The centres of cells with this side from `origin` on [m]; with side 0 there are none.
struct CellCentres {
  Point origin;
  double side;

  /// Column and row of the cell of which `p` is the centre, up to rounding.
  std::optional<Point> cell_at(const Point& p) const {
    if (!(side > 0)) return std::nullopt;
    const double x = (p.x() - origin.x()) / side - 0.5, y = (p.y() - origin.y()) / side - 0.5;
    const Point cell(std::round(x), std::round(y));
    const bool is_centre = std::abs(x - cell.x()) < 1e-6 && std::abs(y - cell.y()) < 1e-6;
    return is_centre ? std::optional(cell) : std::nullopt;
  }
};

/// Nodes, each once. Those at the centres of cells are squares, which share a rectangle along a
/// row; all others are dots.
class VisitedNodes {
 public:
  VisitedNodes(const std::vector<Point>& nodes, const CellCentres& centres)
      : origin_(centres.origin), side_(centres.side) {
    for (const Point& node : nodes) {
      if (const auto cell = centres.cell_at(node)) {
        cells_.emplace_back(cell->y(), cell->x());
      } else {
        dots_.emplace_back(node.y(), node.x());
      }
    }
    for (auto* list : {&cells_, &dots_}) {
      std::sort(list->begin(), list->end());
      list->erase(std::unique(list->begin(), list->end()), list->end());
    }
  }

  /// Path data of the squares.
  std::string squares(const SvgPaths& paths) const {
    std::string d;
    for (std::size_t i = 0, end = 0; i < cells_.size(); i = end) {
      const auto [y, x] = cells_[i];
      for (end = i + 1; end < cells_.size(); ++end) {
        if (cells_[end] != std::pair(y, x + static_cast<double>(end - i))) break;
      }
      const Point low = paths.pixel(origin_ + side_ * Point(x, y));
      const Point high =
          paths.pixel(origin_ + side_ * Point(x + static_cast<double>(end - i), y + 1));
      d.append("M").append(SvgWriter::pair(low)).append("H").append(SvgWriter::number(high.x()));
      d.append("V").append(SvgWriter::number(high.y()));
      d.append("H").append(SvgWriter::number(low.x())).append("Z");
    }
    return d;
  }

  /// Path data of the dots: lines of length 0, for a stroke with round ends.
  std::string dots(const SvgPaths& paths) const {
    std::string d;
    for (const auto& [y, x] : dots_) d.append("M").append(paths.at({x, y})).append("h0");
    return d;
  }

 private:
  Point origin_;
  double side_;
  std::vector<std::pair<double, double>> cells_{}, dots_{};  // y first: row by row
};

}  // namespace tutavia::detail
