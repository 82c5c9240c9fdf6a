// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "tutavia/plan/failure.hpp"

/// \file
/// ParseError: how a parser gives up in the middle of a text.

namespace tutavia::detail {

/// Thrown by the parsers of io/, and caught before their results leave it: see `parse_or_fail`.
struct ParseError {
  std::string what;
  PlanError code = PlanError::invalid_input;
};

/// What `parse()` returns, or the ParseError that it throws as a failure.
template <class Parse>
auto parse_or_fail(Parse parse) -> Expected<decltype(parse()), Failure> {
  try {
    return parse();
  } catch (const ParseError& error) {
    return fail(error.code, error.what);
  }
}

}  // namespace tutavia::detail
