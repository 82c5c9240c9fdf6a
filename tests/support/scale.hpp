// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdlib>

/// \file
/// How long random tests run.

namespace tutavia::test {

/// `count` rounds times TUTAVIA_TEST_SCALE (1 where it is not set; 100 makes a soak).
inline std::size_t scaled(std::size_t count) {
  const char* text = std::getenv("TUTAVIA_TEST_SCALE");
  const double scale = text == nullptr ? 1.0 : std::atof(text);
  return static_cast<std::size_t>(static_cast<double>(count) * (scale > 0 ? scale : 1.0));
}

}  // namespace tutavia::test
