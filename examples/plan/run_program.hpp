// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <iostream>
#include <string_view>

#include "usage_error.hpp"

/// \file
/// run_program: what the main functions of the programs have in common.

namespace plan_program {

/// Throws a UsageError if the tables did not all reach stdout: a full disk, a closed pipe.
inline void check_stdout() {
  std::cout.flush();
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout) return;
  throw UsageError{"stdout could not be written"};
}

/// Returns the exit code of `run()`, or 2 after a UsageError, with its message as one line on
/// stderr.
template <class Run>
int run_program(std::string_view name, const Run& run) {
  try {
    const int code = run();
    check_stdout();
    return code;
  } catch (const UsageError& error) {
    std::cerr << name << ": " << error.message << '\n';
  }
  return 2;
}

}  // namespace plan_program
