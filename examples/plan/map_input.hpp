// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "tutavia/core/expected.hpp"
#include "tutavia/geometry/box.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/io/moving_ai.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/world/scene.hpp"

/// \file
/// What all programs do with maps alike: built-in maps by name, bounds for scenes without them, and
/// the swamp and water of MovingAI maps.

namespace plan_program {

/// A built-in map by its name; empty if none has it.
std::optional<tutavia::Scene> builtin_map(std::string_view name);

/// Bounds for files without them: a box around everything in the scene, a tenth larger and with
/// room for the robot to pass outside; 1 m larger around a single point. A start that is not finite
/// does not count.
tutavia::Box bounds_around(const tutavia::Scene& scene);

/// How swamp and water are read: `terrain` is "free", "blocked", or else they are refused.
tutavia::MovingAiOptions moving_ai_options(std::string_view terrain);

/// The cells of a MovingAI map. Throws a UsageError, in which the option about swamp and water has
/// the name that the program gives it.
tutavia::OccupancyGrid cells_or_throw(
    tutavia::Expected<tutavia::OccupancyGrid, tutavia::Failure> cells,
    std::string_view terrain_option);

}  // namespace plan_program
