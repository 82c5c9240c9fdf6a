// SPDX-License-Identifier: MIT
/// \file
/// tutavia-plan: plans on the built-in maps, on a workspace file or on the cells of a grid map,
/// from the command line.

#include <iostream>

#include "options.hpp"
#include "run.hpp"
#include "usage_error.hpp"

int main(int argc, char** argv) {
  try {
    const auto args = plan_program::parse_command_line(argc, argv);
    return args ? plan_program::run(*args) : 0;
  } catch (const plan_program::UsageError& error) {
    std::cerr << "tutavia-plan: " << error.message << '\n';
  }
  return 2;
}
