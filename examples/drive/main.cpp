// SPDX-License-Identifier: MIT
/// \file
/// tutavia-drive: drives a simulated robot on a built-in map, a workspace file or a grid map,
/// from the command line.

#include "../plan/run_program.hpp"
#include "options.hpp"
#include "run.hpp"

int main(int argc, char** argv) {
  return plan_program::run_program("tutavia-drive", [&] {
    const auto args = drive_program::parse_command_line(argc, argv);
    return args ? drive_program::run(*args) : 0;
  });
}
