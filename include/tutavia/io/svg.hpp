// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "tutavia/core/expected.hpp"
#include "tutavia/io/svg_options.hpp"
#include "tutavia/io/text/svg_picture.hpp"
#include "tutavia/io/text/write_file.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// SVG pictures of workspaces and plans.

namespace tutavia {

/// A picture of the workspace with its exact, round safety zones; for each plan its route, its
/// curve (Beziers as Beziers), start and goal; what the options add; and a legend, which names the
/// curves if there are several or if they have labels. Of a vehicle, curves in reverse are dashed,
/// arrows show the heading at both ends, and outlines of the footprint 10 to 25 poses on the way.
inline std::string to_svg(const Workspace& workspace, std::span<const Plan> plans,
                          const SvgOptions& options = {}) {
  return detail::SvgPicture(workspace, plans, options).draw();
}

/// Writes `to_svg` to a file, completely or not at all. Errors: `invalid_input` if the file cannot
/// be written.
inline Expected<void, Failure> write_svg(const std::filesystem::path& path,
                                         const Workspace& workspace, std::span<const Plan> plans,
                                         const SvgOptions& options = {}) {
  return detail::write_file(path, to_svg(workspace, plans, options));
}

inline Expected<void, Failure> write_svg(const std::filesystem::path& path,
                                         const Workspace& workspace, const Plan& plan,
                                         const SvgOptions& options = {}) {
  return write_svg(path, workspace, std::span(&plan, 1), options);
}

}  // namespace tutavia
