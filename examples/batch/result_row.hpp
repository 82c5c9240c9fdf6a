// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "tutavia/plan/failure.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/planner.hpp"

/// \file
/// ResultRow: what the file of a batch says of one query.

namespace batch_program {

using namespace tutavia;

/// The figures of a plan, or the code of a failure. They do not depend on the machine's speed, so
/// the same queries give the same file.
struct ResultRow {
  bool is_planned = false;
  PlanError code = PlanError::invalid_input;  ///< if it is not planned
  double length = 0;                          ///< [m]
  double clearance_lower = 0;                 ///< proved bounds of the clearance [m]
  double clearance_upper = 0;
  double turning_angle = 0;  ///< [rad]
  double max_curvature = 0;  ///< [1/m]
  bool fell_back = false;
  std::uint64_t expanded = 0;
};

/// The row of a result.
ResultRow to_row(const Expected<Plan, Failure>& result);

/// The first line of the file, without a line break.
inline constexpr std::string_view result_header =
    "query,start_x,start_y,goal_x,goal_y,status,length,clearance_lower,clearance_upper,"
    "turning_angle,max_curvature,fell_back,expanded";

/// Appends the line of query `index`, with its line break. `status` is "planned" or the code of the
/// failure, whose figures are empty but for `expanded`. Numbers are the shortest texts that read
/// back to the same bits.
void append_line(std::string& text, std::size_t index, const Query& query, const ResultRow& row);

}  // namespace batch_program
