// SPDX-License-Identifier: MIT
#include <string>

#include "arrays.hpp"
#include "bindings.hpp"
#include "failures.hpp"
#include "spaces.hpp"
#include "tutavia/io/ros_map_yaml.hpp"

/// \file
/// tutavia.CellSpace.from_ros_map.

namespace tutavia_python {

namespace {

std::shared_ptr<CellHandle> from_ros_map(const py::object& path, double safety_radius,
                                         const std::string& movement, const std::string& unknown,
                                         const std::string& frame) {
  using Unknown = RosMap::UnknownCells;
  if (unknown != "blocked" && unknown != "free") {
    raise(PlanError::invalid_option, "unknown: expected blocked or free, got \"" + unknown + "\"");
  }
  if (frame != "map" && frame != "grid") {
    raise(PlanError::invalid_option, "frame: expected map or grid, got \"" + frame + "\"");
  }
  const auto file = py::module_::import("os").attr("fspath")(path).cast<std::string>();
  const RosMap map = value_or_raise(read_ros_map(file));
  for (const std::string& warning : map.warnings) {
    if (PyErr_WarnEx(PyExc_UserWarning, (file + ": " + warning).c_str(), 1) != 0) {
      throw py::error_already_set();
    }
  }
  if (map.yaw != 0 && frame == "map") {
    raise(PlanError::invalid_option,
          file + ": the map is turned by " + std::string(py::repr(py::float_(map.yaw))) +
              " rad; give frame=\"grid\" to plan in the frame of its rows, whose origin is the "
              "map's lower left corner");
  }
  OccupancyGrid cells =
      value_or_raise(to_grid(map, unknown == "free" ? Unknown::free : Unknown::blocked));
  return build_cells(std::move(cells), {.resolution = map.resolution,
                                        .origin = frame == "map" ? map.origin : Point(0, 0),
                                        .safety_radius = safety_radius,
                                        .movement = to_movement(movement)});
}

}  // namespace

void bind_ros_maps(py::module_& m) {
  using namespace pybind11::literals;
  m.attr("CellSpace").attr("from_ros_map") = py::staticmethod(
      py::cpp_function(&from_ros_map, py::name("from_ros_map"), "path"_a, "safety_radius"_a = 0.0,
                       "movement"_a = "no_cut", "unknown"_a = "blocked", "frame"_a = "map",
                       R"(The space of a map of ROS' map_server: a YAML file that names an image.

unknown: "blocked" or "free": how to read unknown cells.
frame: "map": in the map's own frame; "grid": with the origin at the lower left corner of the image
    and x along its rows, for maps that are turned.

Doubts about the files are warnings. Raises InvalidInput with the file and the line, InvalidOption
for a map that is turned and frame="map".)"));
}

}  // namespace tutavia_python
