// SPDX-License-Identifier: MIT
#include "bindings.hpp"
#include "failures.hpp"

/// \file
/// tutavia.CellSpace.from_ros_map where the library was built without what reads such maps.

namespace tutavia_python {

void bind_ros_maps(py::module_& m) {
  const auto refuse = [](const py::args&, const py::kwargs&) {
    raise(PlanError::invalid_option,
          "from_ros_map: tutavia was built without yaml-cpp and stb_image (libyaml-cpp-dev "
          "libstb-dev); from_numpy takes the cells of a map that was read by other means");
  };
  m.attr("CellSpace").attr("from_ros_map") = py::staticmethod(
      py::cpp_function(refuse, "Missing: tutavia was built without yaml-cpp and stb_image."));
}

}  // namespace tutavia_python
