// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdlib>

/// \file
/// scaled: the length of random tests.

namespace tutavia::test {

/// `count` rounds times TUTAVIA_TEST_SCALE (default 1; 100 for a soak test).
inline std::size_t scaled(std::size_t count) {
  const char* text = std::getenv("TUTAVIA_TEST_SCALE");
  const double scale = text == nullptr ? 1.0 : std::atof(text);
  return static_cast<std::size_t>(static_cast<double>(count) * (scale > 0 ? scale : 1.0));
}

}  // namespace tutavia::test
