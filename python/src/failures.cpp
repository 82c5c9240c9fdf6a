// SPDX-License-Identifier: MIT
#include "failures.hpp"

#include <optional>

namespace tutavia_python {

namespace {

py::object to_python(const Point& p) { return py::make_tuple(p.x(), p.y()); }

/// The start or the goal, if the failure is about it.
py::object point_of(const Failure& failure, const Query* query) {
  if (query == nullptr) return py::none();
  switch (failure.code) {
    case PlanError::start_blocked:
    case PlanError::start_out_of_bounds:
      return to_python(query->start);
    case PlanError::goal_blocked:
    case PlanError::goal_out_of_bounds:
      return to_python(query->goal);
    default:
      return py::none();
  }
}

}  // namespace

py::object to_exception(const Failure& failure, const Query* query) {
  const auto& safe = failure.nearest_safe_point;
  return py::module_::import("tutavia.failures")
      .attr("_of_code")(to_string(failure.code), failure.detail, point_of(failure, query),
                        failure.obstacle ? py::object(py::int_(*failure.obstacle)) : py::none(),
                        failure.clearance ? py::object(py::float_(*failure.clearance)) : py::none(),
                        safe ? to_python(*safe) : py::none());
}

void raise(const Failure& failure, const Query* query) {
  const py::object exception = to_exception(failure, query);
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(exception.ptr())), exception.ptr());
  throw py::error_already_set();
}

void raise(PlanError code, const std::string& detail) {
  Failure failure;
  failure.code = code;
  failure.detail = detail;
  raise(failure);
}

}  // namespace tutavia_python
