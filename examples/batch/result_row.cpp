// SPDX-License-Identifier: MIT
#include "result_row.hpp"

#include "tutavia/core/parts/number_text.hpp"

namespace batch_program {

ResultRow to_row(const Expected<Plan, Failure>& result) {
  ResultRow row;
  if (!result) {
    row.code = result.error().code;
    row.expanded = result.error().stats.expanded;
    return row;
  }
  row.is_planned = true;
  row.length = result->metrics.length;
  row.clearance_lower = result->certificate.lower;
  row.clearance_upper = result->certificate.upper;
  row.turning_angle = result->metrics.turning_angle;
  row.max_curvature = result->metrics.max_curvature;
  row.fell_back = result->fell_back;
  row.expanded = result->stats.expanded;
  return row;
}

void append_line(std::string& text, std::size_t index, const Query& query, const ResultRow& row) {
  using tutavia::detail::number_text;
  text.append(std::to_string(index));
  for (const double x : {query.start.x(), query.start.y(), query.goal.x(), query.goal.y()}) {
    text.append(",").append(number_text(x));
  }
  if (row.is_planned) {
    text.append(",planned");
    for (const double x : {row.length, row.clearance_lower, row.clearance_upper, row.turning_angle,
                           row.max_curvature}) {
      text.append(",").append(number_text(x));
    }
    text.append(row.fell_back ? ",true," : ",false,");
  } else {
    text.append(",").append(to_string(row.code)).append(",,,,,,,");
  }
  text.append(std::to_string(row.expanded)).append("\n");
}

}  // namespace batch_program
