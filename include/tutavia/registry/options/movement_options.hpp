// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

#include "tutavia/grid/movement.hpp"
#include "tutavia/registry/options/option_kind.hpp"
#include "tutavia/space/lattice_space.hpp"

/// \file
/// The names of the movement rules that one can choose, and of the edge rules.

namespace tutavia::detail {

template <>
struct EnumNames<MovementRule> {
  static constexpr std::array<std::string_view, 4> names{"no_cut", "no_squeeze", "allow",
                                                         "four_connected"};
};

template <>
struct EnumNames<EdgeRule> {
  static constexpr std::array<std::string_view, 2> names{"uniform", "paper_strict"};
};

}  // namespace tutavia::detail
