// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// \file
/// The version of the library; CMake reads it from here.

#define TUTAVIA_VERSION_MAJOR 0
#define TUTAVIA_VERSION_MINOR 2
#define TUTAVIA_VERSION_PATCH 0

#ifdef __FAST_MATH__
#error "tutavia proves its paths with IEEE 754 arithmetic: compile without -ffast-math"
#endif

namespace tutavia {

/// The version as a text, such as "0.2.0".
inline std::string version_text() {
  return std::to_string(TUTAVIA_VERSION_MAJOR) + "." + std::to_string(TUTAVIA_VERSION_MINOR) + "." +
         std::to_string(TUTAVIA_VERSION_PATCH);
}

}  // namespace tutavia
