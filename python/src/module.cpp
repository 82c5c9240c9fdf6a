// SPDX-License-Identifier: MIT
#include "bindings.hpp"
#include "tutavia/core/version.hpp"

/// \file
/// The module tutavia._native: the library as Python sees it.

PYBIND11_MODULE(_native, m) {
  using namespace tutavia_python;
  m.doc() = "The compiled part of tutavia. Import tutavia instead.";
  m.attr("__version__") = tutavia::version_text();
  m.attr("_pybind11_major") = PYBIND11_VERSION_MAJOR;
  // Types before the functions that take or return them, so that signatures name them.
  bind_workspaces(m);
  bind_spaces(m);
  bind_ros_maps(m);
  bind_vehicles(m);
  bind_results(m);
  bind_speed_profiles(m);
  bind_batch(m);
  bind_planner(m);
  bind_descriptions(m);
  bind_interrupt(m);
}
