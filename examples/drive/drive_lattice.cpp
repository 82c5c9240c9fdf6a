// SPDX-License-Identifier: MIT
#include "drive_on_space.hpp"

namespace drive_program {

Expected<Drive, Failure> drive(const LatticeSpace& space, const plan_program::Task& task,
                               const Arguments& args, const Progress& progress) {
  return drive_on(space, task, args, progress);
}

}  // namespace drive_program
