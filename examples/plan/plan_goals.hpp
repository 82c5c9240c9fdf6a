// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "input.hpp"
#include "json_output.hpp"
#include "options.hpp"
#include "result.hpp"

/// \file
/// plan_goals: one search with one smoother on every goal.

namespace plan_program {

/// Plans every goal of the task. Writes the search to the trace if it is not there yet.
/// \pre the names are known
Group plan_goals(const Task& task, const Arguments& args, TraceFile& trace,
                 const std::string& search, const std::string& smoother);

}  // namespace plan_program
