// SPDX-License-Identifier: MIT
#pragma once

#include "options.hpp"

/// \file
/// run: the whole program after parsing the command line.

namespace plan_program {

/// Executes the command line. Returns the exit code: 0 if every goal has a plan, else 1. Throws
/// UsageError.
int run(const Arguments& args);

}  // namespace plan_program
