// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "tutavia/plan/failure.hpp"
#include "tutavia/plan/query.hpp"

/// \file
/// parse_queries: the queries of a batch from CSV.

namespace batch_program {

using namespace tutavia;

/// Reads queries from CSV with a header, separated by commas, one query a line: `start_x`,
/// `start_y`, `goal_x` and `goal_y` [m], and, if there are such columns, `start_heading` and
/// `goal_heading` [rad; empty: any] and `seed`. Other columns are skipped, and so are empty lines.
/// Errors: `invalid_input` with the line for a missing column (with the one that may be meant), a
/// line with too few or too many columns, and anything that is no finite number.
Expected<std::vector<Query>, Failure> parse_queries(std::string_view text);

}  // namespace batch_program
