// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The module world: workspaces, scenes and the built-in maps.

#include "tutavia/world/changed_boxes.hpp"
#include "tutavia/world/frame.hpp"
#include "tutavia/world/maps.hpp"
#include "tutavia/world/moving_obstacle.hpp"
#include "tutavia/world/obstacles_from.hpp"
#include "tutavia/world/scene.hpp"
#include "tutavia/world/workspace.hpp"
#include "tutavia/world/workspace_report.hpp"
