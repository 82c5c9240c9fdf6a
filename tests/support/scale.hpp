// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>

/// \file
/// scaled: the length of random tests.

namespace tutavia::test {

/// `count` rounds times TUTAVIA_TEST_SCALE (default 1; 100 for a soak test), at least one.
inline std::size_t scaled(std::size_t count) {
  const char* text = std::getenv("TUTAVIA_TEST_SCALE");
  const double scale = text == nullptr ? 1.0 : std::atof(text);
  const double rounds = static_cast<double>(count) * (scale > 0 ? scale : 1.0);
  return std::max<std::size_t>(1, static_cast<std::size_t>(rounds));
}

}  // namespace tutavia::test
