// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <string>

#include "tutavia/core/expected.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/plan/query.hpp"

/// \file
/// Failures of the library as exceptions of tutavia.failures.

namespace tutavia_python {

namespace py = pybind11;
using namespace tutavia;

/// The exception of a failure, not raised. `query` gives it the point that it is about.
py::object to_exception(const Failure& failure, const Query* query = nullptr);

/// Throws the exception of a failure.
[[noreturn]] void raise(const Failure& failure, const Query* query = nullptr);
[[noreturn]] void raise(PlanError code, const std::string& detail);

/// The value of a result, or the exception of its failure.
template <class T>
T value_or_raise(Expected<T, Failure> result) {
  if (!result) raise(result.error());
  return std::move(*result);
}

}  // namespace tutavia_python
