// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "tutavia/plan/failure.hpp"

/// \file
/// ParseError: the internal exception of parsers.

namespace tutavia::detail {

/// Thrown by the parsers of io/ and caught within io/; see `parse_or_fail`.
struct ParseError {
  std::string what;
  PlanError code = PlanError::invalid_input;
};

/// The result of `parse()`, or a failure for the ParseError that it throws.
template <class Parse>
auto parse_or_fail(Parse parse) -> Expected<decltype(parse()), Failure> {
  try {
    return parse();
  } catch (const ParseError& error) {
    return fail(error.code, error.what);
  }
}

}  // namespace tutavia::detail
