// SPDX-License-Identifier: MIT
#pragma once

#include "input.hpp"
#include "json_output.hpp"
#include "names.hpp"
#include "options.hpp"
#include "result.hpp"

/// \file
/// plan_goals: one search with one smoother on every goal.

namespace plan_program {

/// Plans every goal of the task. Writes the search to the trace if it is not there yet.
/// Throws UsageError as `make_planner` does.
Group plan_goals(const Task& task, const Arguments& args, TraceFile& trace,
                 const PipelineText& search, const PipelineText& smoother);

}  // namespace plan_program
