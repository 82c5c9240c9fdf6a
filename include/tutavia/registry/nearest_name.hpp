// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// \file
/// nearest_name: the name that a misspelt one is likely to mean.

namespace tutavia {

namespace detail {

/// The least number of letters to insert, remove, replace or swap with their neighbour that turns
/// one word into the other, where no letter is changed twice. O(product of the lengths).
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] =
          std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
  }
  return row[b.size()];
}

}  // namespace detail

/// The name that differs least from `word`, the first of several. Empty if every name differs in
/// more than half of the letters of `word`. Words of more than 100 letters are near no name. A word
/// of four letters or more that is a part of a name differs by one.
///
/// The difference is the number of letters inserted, removed, replaced or swapped with their
/// neighbour (Damerau 1964, "A technique for computer detection and correction of spelling
/// errors").
inline std::optional<std::string> nearest_name(std::string_view word,
                                               std::span<const std::string> names) {
  if (word.size() > 100) return std::nullopt;
  std::size_t least = std::max<std::size_t>(1, word.size() / 2) + 1;
  const std::string* nearest = nullptr;
  for (const std::string& name : names) {
    const bool is_part = word.size() >= 4 && name.find(word) != std::string::npos;
    const std::size_t distance = is_part ? 1 : detail::edit_distance(word, name);
    if (distance >= least || distance >= word.size()) continue;
    least = distance;
    nearest = &name;
  }
  return nearest != nullptr ? std::optional(*nearest) : std::nullopt;
}

}  // namespace tutavia
