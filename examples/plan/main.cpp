// SPDX-License-Identifier: MIT
/// \file
/// tutavia-plan: plans on the built-in maps, on a workspace file or on the cells of a grid map,
/// from the command line.

#include <cstdio>
#include <iostream>

#include "options.hpp"
#include "run.hpp"
#include "usage_error.hpp"

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
    const auto args = plan_program::parse_command_line(argc, argv);
    const int code = args ? plan_program::run(*args) : 0;
    check_stdout();
    return code;
  } catch (const plan_program::UsageError& error) {
    std::cerr << "tutavia-plan: " << error.message << '\n';
  }
  return 2;
}
