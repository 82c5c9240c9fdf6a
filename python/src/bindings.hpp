// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

/// \file
/// The parts of the module.

namespace tutavia_python {

namespace py = pybind11;

void bind_workspaces(py::module_& m);
void bind_spaces(py::module_& m);
void bind_ros_maps(py::module_& m);
void bind_vehicles(py::module_& m);
void bind_results(py::module_& m);
void bind_speed_profiles(py::module_& m);
void bind_batch(py::module_& m);
void bind_planner(py::module_& m);
void bind_descriptions(py::module_& m);
void bind_interrupt(py::module_& m);

}  // namespace tutavia_python
