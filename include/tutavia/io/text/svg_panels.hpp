// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "tutavia/io/svg_options.hpp"
#include "tutavia/io/text/svg_picture.hpp"
#include "tutavia/io/text/svg_writer.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// SvgPanels: small pictures of one workspace side by side.

namespace tutavia::detail {

/// Writes pictures of one workspace, or of parts of it, into one document, from left to right.
class SvgPanels {
 public:
  static constexpr double margin = 16;  ///< around every panel, in pixels

  /// `width`: of the map in each panel, in pixels.
  SvgPanels(const Workspace& workspace, double width)
      : panel_width_(width),
        map_height_(workspace.bounds.height() * width /
                    std::max({workspace.bounds.width(), workspace.bounds.height(), 1e-300})) {}

  /// Adds a map, without title, profile and legend. `workspace`: with the bounds of the first one,
  /// or others of the same shape, which are magnified.
  void add(const Workspace& workspace, std::span<const Plan> plans, SvgOptions options) {
    options.width = panel_width_;
    options.title.clear();
    options.profile = false;
    options.legend = false;
    const double wide = std::max(panel_width_, 560.0) + 2 * margin;  // of any picture
    svg_.raw("<svg x=\"" + SvgWriter::number(width() - margin) + "\" width=\"" +
             SvgWriter::number(wide) + "\">\n");
    svg_.raw(SvgPicture(workspace, plans, options).draw());
    svg_.raw("</svg>\n");
    ++count_;
  }

  /// For what lies below the panels.
  SvgWriter& svg() { return svg_; }
  /// Of all panels, with the margins, in pixels.
  double width() const { return static_cast<double>(count_) * (panel_width_ + margin) + margin; }
  double height() const { return map_height_ + 2 * margin; }

 private:
  double panel_width_, map_height_;
  std::size_t count_ = 0;
  SvgWriter svg_{};
};

}  // namespace tutavia::detail
