// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "stage.hpp"

/// \file
/// Plans for the page.

namespace playground {

/// Answers the requests `catalogue`, `plan` and `svg`. Throw UsageError and ParseError.
nlohmann::ordered_json catalogue();
nlohmann::ordered_json plan(Stage& stage, const nlohmann::json& request);
nlohmann::ordered_json draw(Stage& stage, const nlohmann::json& request);

}  // namespace playground
