// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tutavia/registry/options/bound_option.hpp"

/// \file
/// AlgorithmDescription: an algorithm and its options, for people.

namespace tutavia {

/// An option in words.
struct OptionDescription {
  std::string name;
  std::string type;           ///< "number", "whole number", "true|false", "a|b|c"; with "|none" if
                              ///< it need not be given
  std::string unit;           ///< empty for plain numbers
  std::string default_value;  ///< as a text that sets it
  std::string sentence;
};

/// An algorithm in words.
struct AlgorithmDescription {
  std::string name;
  std::string sentence;
  std::vector<OptionDescription> options{};
};

namespace detail {

template <class A>
AlgorithmDescription describe() {
  A algorithm{};
  AlgorithmDescription described{std::string(A::name), std::string(OptionTable<A>::sentence)};
  for (const BoundOption& option : bind_options(&algorithm, OptionTable<A>::fields.all)) {
    const OptionField& field = *option.field;
    described.options.push_back({option.name, type_text(*field.kind), std::string(field.unit),
                                 to_text(option.value()), std::string(field.sentence)});
  }
  return described;
}

}  // namespace detail

}  // namespace tutavia
