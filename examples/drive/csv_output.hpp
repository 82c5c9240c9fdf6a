// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "drive_result.hpp"

/// \file
/// The trace of a drive as CSV.

namespace drive_program {

/// Writes `time,x,y,heading,v,omega,clearance,status`, one line per period. Throws UsageError.
void write_csv(const std::string& path, const std::vector<TraceRow>& trace);

}  // namespace drive_program
