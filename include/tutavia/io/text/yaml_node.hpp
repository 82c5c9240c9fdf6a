// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// \file
/// YamlDocument: the nodes of a YAML document with their lines.

namespace tutavia::detail {

/// A node of a YAML document.
struct YamlNode {
  enum class Kind { nothing, scalar, list, map };
  Kind kind = Kind::nothing;
  std::size_t line = 0;
  std::string text{};                   ///< of a scalar, without quotes
  std::vector<std::size_t> children{};  ///< items; of a map its keys and values, by turns
};

/// The root first. Children are indices. An alias is the node that it stands for, not a copy, so
/// the document is no larger than its text; an alias may stand for a node around it.
using YamlDocument = std::vector<YamlNode>;

}  // namespace tutavia::detail
