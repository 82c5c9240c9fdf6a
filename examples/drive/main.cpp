// SPDX-License-Identifier: MIT
/// \file
/// tutavia-drive: drives a simulated robot on a built-in map, a workspace file or a grid map,
/// from the command line.

#include <cstdio>
#include <iostream>

#include "../plan/usage_error.hpp"
#include "options.hpp"
#include "run.hpp"

namespace {

/// Throws a UsageError if the tables did not all reach stdout: a full disk, a closed pipe.
void check_stdout() {
  std::cout.flush();
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout) return;
  throw plan_program::UsageError{"stdout could not be written"};
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const auto args = drive_program::parse_command_line(argc, argv);
    const int code = args ? drive_program::run(*args) : 0;
    check_stdout();
    return code;
  } catch (const plan_program::UsageError& error) {
    std::cerr << "tutavia-drive: " << error.message << '\n';
  }
  return 2;
}
