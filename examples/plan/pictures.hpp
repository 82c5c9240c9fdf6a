// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "input.hpp"
#include "options.hpp"
#include "result.hpp"

/// \file
/// SVG pictures.

namespace plan_program {

/// Draws all plans into the picture --svg, and moves them out of `groups`. Throws UsageError.
void draw(const Arguments& args, const Task& task, std::vector<Group> groups);

}  // namespace plan_program
