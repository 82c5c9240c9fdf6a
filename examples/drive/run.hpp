// SPDX-License-Identifier: MIT
#pragma once

#include "options.hpp"

/// \file
/// run: the whole program after parsing the command line.

namespace drive_program {

/// Executes the command line. Returns the exit code: 0 if the robot reached the goal, else 1.
/// Throws UsageError.
int run(const Arguments& args);

}  // namespace drive_program
