// SPDX-License-Identifier: MIT
#include "csv_output.hpp"

#include <cmath>

#include "../plan/usage_error.hpp"
#include "tutavia/core/parts/number_text.hpp"
#include "tutavia/io/text/write_file.hpp"

namespace drive_program {

void write_csv(const std::string& path, const std::vector<TraceRow>& trace) {
  std::string text = "time,x,y,heading,v,omega,clearance,status\n";
  for (const TraceRow& row : trace) {
    const double time = std::round(row.time * 1e6) / 1e6;
    for (const double number : {time, row.pose.position.x(), row.pose.position.y(),
                                row.pose.heading, row.twist.v, row.twist.omega, row.clearance}) {
      text.append(tutavia::detail::number_text(number)).append(",");
    }
    text.append(to_string(row.status)).append("\n");
  }
  plan_program::throw_failure(tutavia::detail::write_file(path, text));
}

}  // namespace drive_program
