// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "engine.hpp"

/// \file
/// Maps and files as scenes of the page.

namespace playground {

/// Answers the requests `builtin`, `open`, `open_ros` and `open_scenarios`. Throws UsageError and
/// ParseError.
Reply builtin_scene(const nlohmann::json& request);
Reply open_file(const nlohmann::json& request, std::string_view bytes);
Reply open_ros_map(const nlohmann::json& request, std::string_view bytes);
Reply open_scenarios(std::string_view bytes);

}  // namespace playground
