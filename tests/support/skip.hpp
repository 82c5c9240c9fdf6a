// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>

#include "support/catch.hpp"

/// \file
/// Skips tests whose data is missing.

namespace tutavia::test {

inline constexpr int skip_code = 4;  // as in CMakeLists.txt

inline bool& any_skipped() {
  static bool value = false;
  return value;
}

/// The folder of MovingAI files, or nullptr; the test is then reported as skipped and has to
/// return.
inline const char* moving_ai_folder() {
  const char* folder = std::getenv("TUTAVIA_MOVINGAI_DIR");
  if (folder != nullptr && *folder == '\0') folder = nullptr;
  if (folder == nullptr) {
    WARN("skipped: TUTAVIA_MOVINGAI_DIR is not set");
    any_skipped() = true;
  }
  return folder;
}

}  // namespace tutavia::test
