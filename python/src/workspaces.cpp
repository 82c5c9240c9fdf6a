// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "failures.hpp"
#include "tutavia/world/maps.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// tutavia.Workspace, and the built-in maps.

namespace tutavia_python {

namespace {

Ring to_ring(py::handle points, const std::string& name) {
  const Numbers table = to_table(points, 2, name.c_str());
  Ring ring;
  const auto rows = static_cast<std::size_t>(table.shape(0));
  ring.reserve(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    ring.emplace_back(table.data()[2 * i], table.data()[2 * i + 1]);
  }
  return ring;
}

/// An obstacle from what `tutavia.obstacles` makes of any: (center, radius) or (outer, holes).
Obstacle to_obstacle(const py::tuple& shape, std::size_t index) {
  const std::string name = "obstacles[" + std::to_string(index) + "]";
  const bool is_disc = py::hasattr(shape, "radius");
  if (is_disc) {
    return Disc{to_point(shape[0], (name + ".center").c_str()),
                to_optional_number(shape[1], (name + ".radius").c_str()).value()};
  }
  Polygon polygon{to_ring(shape[0], name + ".outer")};
  for (const py::handle hole : shape[1]) {
    polygon.holes.push_back(to_ring(hole, name + ".holes"));
  }
  return polygon;
}

Numbers to_array(const Ring& ring) {
  return make_points(ring.size(), [&](std::size_t i) -> const Point& { return ring[i]; });
}

py::list obstacles_of(const Workspace& workspace) {
  const py::module_ shapes = py::module_::import("tutavia.obstacles");
  const py::object disc_type = shapes.attr("Disc"), polygon_type = shapes.attr("Polygon");
  py::list result;
  for (const Obstacle& obstacle : workspace.obstacles) {
    if (const Disc* disc = std::get_if<Disc>(&obstacle)) {
      result.append(disc_type(py::make_tuple(disc->center.x(), disc->center.y()), disc->radius));
      continue;
    }
    const Polygon& polygon = std::get<Polygon>(obstacle);
    py::list holes;
    for (const Ring& hole : polygon.holes) holes.append(to_array(hole));
    result.append(polygon_type(to_array(polygon.outer), holes));
  }
  return result;
}

py::tuple bounds_of(const Workspace& workspace) {
  const Box& box = workspace.bounds;
  return py::make_tuple(box.min.x(), box.min.y(), box.max.x(), box.max.y());
}

Workspace make_workspace(const py::object& bounds, const py::object& obstacles,
                         double safety_radius) {
  const Numbers box = to_column(bounds, 4, "bounds (min_x, min_y, max_x, max_y)");
  Workspace workspace{.bounds = {{box.at(0), box.at(1)}, {box.at(2), box.at(3)}},
                      .safety_radius = safety_radius};
  const py::object shapes = py::module_::import("tutavia.obstacles").attr("flatten")(obstacles);
  for (const py::handle shape : shapes) {
    workspace.obstacles.push_back(
        to_obstacle(py::reinterpret_borrow<py::tuple>(shape), workspace.obstacles.size()));
  }
  if (const auto valid = validate(workspace); !valid) raise(valid.error());
  return workspace;
}

/// The scene of a name as (workspace, start, goals, resolution).
py::tuple builtin_map(const std::string& name) {
  for (const Scene& scene :
       {maps::array(), maps::complex(), maps::maze(), maps::rrt_scene_1(), maps::rrt_scene_2()}) {
    if (scene.name != name) continue;
    py::list goals;
    for (const Point& goal : scene.goals) goals.append(py::make_tuple(goal.x(), goal.y()));
    return py::make_tuple(scene.workspace, py::make_tuple(scene.start.x(), scene.start.y()), goals,
                          scene.resolution.value());
  }
  raise(PlanError::invalid_option, "no built-in map is named \"" + name +
                                       "\": they are array, complex, maze, rrt_scene_1 and "
                                       "rrt_scene_2");
}

}  // namespace

void bind_workspaces(py::module_& m) {
  using namespace pybind11::literals;
  py::class_<Workspace>(m, "Workspace", R"(Bounds, obstacles and the distance to keep from them.

Free space is closed: the points of the bounds at a distance of `safety_radius` or more from every
obstacle. The bounds limit the robot's centre and are not inflated. Obstacles may overlap, touch,
nest or extend beyond the bounds.

bounds: (min_x, min_y, max_x, max_y) [m].
obstacles: an iterable, or one, of: arrays of shape (n, 2) (the corners of a polygon), Polygon,
    Disc, shapely geometries, anything with `__geo_interface__`, GeoJSON objects as dicts. Lines are
    walls without thickness; points are discs of radius 0, or of the property `radius` of their
    feature.
safety_radius: the robot's radius plus any extra margin [m].

Raises InvalidInput, with the obstacle and its index, for what is no obstacle, for coordinates that
are not finite and for empty bounds.)")
      .def(py::init(&make_workspace), "bounds"_a, "obstacles"_a = py::tuple(),
           "safety_radius"_a = 0.0)
      .def_property_readonly("bounds", &bounds_of, "(min_x, min_y, max_x, max_y) [m].")
      .def_property_readonly("obstacles", &obstacles_of,
                             "A list of Polygon and Disc, in the order given.")
      .def_readonly("safety_radius", &Workspace::safety_radius, "[m]")
      .def("__repr__",
           [](const Workspace& workspace) {
             return "<Workspace of " + std::to_string(workspace.obstacles.size()) +
                    " obstacles, safety_radius " +
                    std::string(py::repr(py::float_(workspace.safety_radius))) + ">";
           })
      .def(py::pickle(
          [](const Workspace& workspace) {
            return pickle_head("Workspace") + py::make_tuple(bounds_of(workspace),
                                                             obstacles_of(workspace),
                                                             workspace.safety_radius);
          },
          [](const py::tuple& state) {
            check_pickle(state, "Workspace", 6);
            return make_workspace(state[3], state[4], state[5].cast<double>());
          }));
  m.def("_builtin_map", &builtin_map, "name"_a);
}

}  // namespace tutavia_python
