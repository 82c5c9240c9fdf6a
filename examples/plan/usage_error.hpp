// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>

#include "tutavia/core/expected.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// UsageError: bad usage or bad input.

namespace plan_program {

/// Ends the program with exit code 2 and the message as one line on stderr.
struct UsageError {
  std::string message;
};

/// The value of a result. Throws the detail of a failure as a UsageError.
template <class T>
T value_or_throw(tutavia::Expected<T, tutavia::Failure> result) {
  if (!result) throw UsageError{std::move(result.error().detail)};
  return std::move(*result);
}

/// Throws the detail of a failure as a UsageError.
inline void throw_failure(const tutavia::Expected<void, tutavia::Failure>& result) {
  if (!result) throw UsageError{result.error().detail};
}

}  // namespace plan_program
