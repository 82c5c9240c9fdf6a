// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

/// \file
/// count: how often a text contains another one.

namespace tutavia::test {

inline std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t i = text.find(part); i != std::string::npos; i = text.find(part, i + 1)) ++n;
  return n;
}

}  // namespace tutavia::test
