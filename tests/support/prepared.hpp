// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <utility>

#include "tutavia/search/concepts.hpp"

/// \file
/// PreparedEachTime: a search that prepares its tables itself.

namespace tutavia::test {

/// A search whose first option is prepared for the space at every query.
template <class A>
struct PreparedEachTime {
  static constexpr std::string_view name = A::name;
  using Scratch = typename A::Scratch;

  template <class S, Observer O>
  auto search(const S& space, const Query& query, Scratch& scratch, O& observer) const
      -> decltype(A{*A::prepare(space)}.search(space, query, scratch, observer)) {
    auto prepared = A::prepare(space);
    if (!prepared) return Unexpected{std::move(prepared.error())};
    return A{*prepared}.search(space, query, scratch, observer);
  }
};

}  // namespace tutavia::test
