// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "input.hpp"
#include "result.hpp"

/// \file
/// SVG pictures.

namespace plan_program {

/// Draws all plans into one picture, and moves them out of `groups`. Throws UsageError.
void draw(const std::string& path, const Task& task, std::vector<Group> groups);

}  // namespace plan_program
