// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "tutavia/world/workspace.hpp"

/// \file
/// Scene: a workspace with something to do in it.

namespace tutavia {

/// A workspace with a name, a start, goals and the resolution that suits it.
struct Scene {
  std::string name{};
  Workspace workspace{};
  Point start{std::numeric_limits<double>::quiet_NaN(),
              std::numeric_limits<double>::quiet_NaN()};  ///< NaN: not given
  std::vector<Point> goals{};
  std::optional<double> resolution{};  ///< lattice spacing [m]
};

}  // namespace tutavia
