// SPDX-License-Identifier: MIT
/// \file
/// tutavia-plan: plans on the built-in maps, on a workspace file or on the cells of a grid map,
/// from the command line.

#include "options.hpp"
#include "run.hpp"
#include "run_program.hpp"

int main(int argc, char** argv) {
  return plan_program::run_program("tutavia-plan", [&] {
    const auto args = plan_program::parse_command_line(argc, argv);
    return args ? plan_program::run(*args) : 0;
  });
}
