// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "tutavia/io/svg_options.hpp"
#include "tutavia/io/text/svg_animation.hpp"
#include "tutavia/io/text/svg_panels.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/search_record.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// Pictures of how a search proceeds: animated, and in steps side by side.

namespace tutavia {

/// An animated picture of a query: the search grows, then come its route and the proved curve, and
/// a robot drives along it. It needs no script, so it moves in web pages as an image, too. Viewers
/// without animations show all of it at once. The robot is a disc with the safety radius.
inline std::string to_animated_svg(const Workspace& workspace, const Plan& plan,
                                   const SearchRecord& record, const SvgOptions& options = {}) {
  return detail::SvgAnimation(workspace, plan, record, options).draw();
}

/// `panels` pictures side by side: all but the last show what the search has done after equal parts
/// of its events, the last one its route and the proved curve. Each is `options.width` wide.
/// \pre panels >= 2
inline std::string to_svg_steps(const Workspace& workspace, const Plan& plan,
                                const SearchRecord& record, std::size_t panels,
                                const SvgOptions& options = {}) {
  detail::SvgPanels pictures(workspace, options.width);
  for (std::size_t i = 0; i < panels; ++i) {
    const bool is_last = i + 1 == panels;
    SvgOptions panel = options;
    if (!is_last) {
      add_search(panel,
                 detail::events_between(
                     record, 0, static_cast<double>(i + 1) / static_cast<double>(panels - 1)));
      panel.starts.push_back(plan.curve.start());
      panel.goals.push_back(plan.curve.end());
    }
    pictures.add(workspace, std::span(&plan, is_last ? 1 : 0), panel);
  }
  return pictures.svg().finish(pictures.width(), pictures.height());
}

}  // namespace tutavia
