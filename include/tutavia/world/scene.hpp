// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "tutavia/world/workspace.hpp"

/// \file
/// Scene: a workspace with a start and goals.

namespace tutavia {

/// A workspace with a name, a start, goals and a suitable resolution.
struct Scene {
  std::string name{};
  Workspace workspace{};
  Point start{std::numeric_limits<double>::quiet_NaN(),
              std::numeric_limits<double>::quiet_NaN()};  ///< NaN: not given
  std::vector<Point> goals{};
  std::optional<double> resolution{};  ///< lattice spacing [m]
};

/// A parsed scene, and warnings about ignored parts.
struct SceneFile {
  Scene scene{};
  std::vector<std::string> warnings{};  ///< one line each
};

}  // namespace tutavia
