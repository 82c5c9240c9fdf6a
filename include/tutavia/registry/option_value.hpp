// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

/// \file
/// OptionValue: the value of an algorithm's option, whatever its type.

namespace tutavia {

/// The value of an option: nothing if an optional number is not given, a switch, a whole number, a
/// number, or the name of an enumerator.
using OptionValue =
    std::variant<std::monostate, bool, std::int64_t, std::uint64_t, double, std::string>;

/// An option with its value. Options of a nested aggregate are called "weights.density".
struct OptionSetting {
  std::string name;
  OptionValue value{};
};

/// All options of one algorithm, in the order of their declaration.
using OptionSettings = std::vector<OptionSetting>;

}  // namespace tutavia
