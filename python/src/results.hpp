// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/planner.hpp"

/// \file
/// tutavia.Plan: a plan with the space it was made in.

namespace tutavia_python {

namespace py = pybind11;
using namespace tutavia;

/// A plan of Python. Pickles leave the space out.
struct PlanHandle {
  Plan plan;
  py::object space = py::none();
};

/// A curve as (kinds, numbers), and back, to the last bit.
py::tuple curve_state(const Curve& curve);
Curve curve_of(const py::tuple& state);

}  // namespace tutavia_python
