// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "../plan/input.hpp"
#include "drive.hpp"

/// \file
/// The animated picture of a drive.

namespace drive_program {

/// Writes a drive in the frame of the map as an animated SVG (SMIL), which runs in a loop. Where
/// nothing moves, as on paper, it shows the whole driven path in the colours of its states, the
/// robot at its start, and all obstacles where they appear. Throws UsageError.
void write_animation(const std::string& path, const plan_program::Task& task, const Drive& drive);

}  // namespace drive_program
