// SPDX-License-Identifier: MIT
#include "spaces.hpp"

#include <pybind11/stl.h>

#include "arrays.hpp"
#include "batch/job.hpp"
#include "bindings.hpp"
#include "failures.hpp"
#include "interrupt.hpp"
#include "tutavia/io/moving_ai.hpp"
#include "tutavia/optimum.hpp"
#include "tutavia/registry/movement_name.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// tutavia.LatticeSpace and tutavia.CellSpace.

namespace tutavia_python {

namespace {

using namespace pybind11::literals;

std::shared_ptr<LatticeHandle> build_lattice(const Workspace& workspace,
                                             const std::optional<double>& resolution,
                                             const std::string& movement, const std::string& edges,
                                             std::int64_t max_nodes) {
  LatticeOptions options{.resolution = resolution,
                         .movement = to_movement(movement),
                         .max_nodes = max_nodes,
                         .edges = value_or_raise(parse_edge_rule(edges))};
  auto space = [&] {
    const GilRelease released;
    return LatticeSpace::build(workspace, options);
  }();
  return std::make_shared<LatticeHandle>(
      LatticeHandle{value_or_raise(std::move(space)), options, workspace.safety_radius});
}

/// The cells of a grid as bytes, 0 and 1.
py::array_t<bool> to_bools(const OccupancyGrid& grid) {
  py::array_t<bool> free({grid.height(), grid.width()});
  bool* cell = free.mutable_data();
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) *cell++ = grid.is_free(Cell{x, y});
  }
  return free;
}

OccupancyGrid to_grid(const py::object& cells) {
  if (py::hasattr(cells, "mask")) {
    raise(PlanError::invalid_input,
          "free: a masked array does not say whether its masked cells are free: give "
          "free.filled(False)");
  }
  py::array free;
  if (py::isinstance<py::array>(cells)) free = py::reinterpret_borrow<py::array>(cells);
  if (!free || free.dtype().kind() != 'b') {
    const std::string found = free ? "one of dtype " + std::string(py::str(free.dtype())) +
                                         ": say what is free, such as "
                                         "`costs < 100`"
                                   : std::string(py::str(py::type::of(cells)));
    raise(PlanError::invalid_input,
          "free: expected a numpy array of dtype bool, True where a cell is free, got " + found);
  }
  if (free.ndim() != 2) {
    raise(PlanError::invalid_input, "free: expected an array of shape (height, width), got shape " +
                                        std::string(py::str(free.attr("shape"))));
  }
  const auto view = py::array_t<bool, py::array::c_style | py::array::forcecast>::ensure(free);
  const auto height = static_cast<std::int64_t>(view.shape(0)),
             width = static_cast<std::int64_t>(view.shape(1));
  OccupancyGrid grid = value_or_raise(OccupancyGrid::blocked(width, height));
  const bool* cell = view.data();
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) grid.set({x, y}, *cell++);
  }
  return grid;
}

std::shared_ptr<CellHandle> from_numpy(const py::object& free, double resolution,
                                       const py::object& origin, double safety_radius,
                                       const std::string& movement) {
  const CellOptions options{.resolution = resolution,
                            .origin = to_point(origin, "origin"),
                            .safety_radius = safety_radius,
                            .movement = to_movement(movement)};
  return build_cells(to_grid(free), options);
}

std::shared_ptr<CellHandle> from_moving_ai(const py::object& path, double safety_radius,
                                           const std::string& movement,
                                           const std::string& terrain) {
  using Terrain = MovingAiOptions::DirectionalTerrain;
  MovingAiOptions options;
  if (terrain == "blocked" || terrain == "free") {
    options.directional = terrain == "free" ? Terrain::free : Terrain::blocked;
  } else if (terrain != "refused") {
    raise(PlanError::invalid_option,
          "terrain: expected refused, blocked or free, got \"" + terrain + "\"");
  }
  const auto file = py::module_::import("os").attr("fspath")(path).cast<std::string>();
  return build_cells(value_or_raise(read_moving_ai_map(file, options)),
                     {.safety_radius = safety_radius, .movement = to_movement(movement)});
}

py::bytes packed(const OccupancyGrid& grid) {
  return py::module_::import("numpy").attr("packbits")(to_bools(grid)).attr("tobytes")();
}

py::array unpacked(const py::object& bytes, const py::object& height, const py::object& width) {
  const py::module_ numpy = py::module_::import("numpy");
  const py::object bits = numpy.attr("frombuffer")(bytes, "uint8");
  return numpy.attr("unpackbits")(bits, "count"_a = height * width)
      .attr("reshape")(height, width)
      .attr("astype")("bool");
}

/// Calls `ask(point)` for one point, or for every row of an array of shape (n, 2).
template <class Result, class Ask>
py::object for_points(const py::object& points, const Ask& ask) {
  const bool is_table =
      py::isinstance<py::array>(points) && py::reinterpret_borrow<py::array>(points).ndim() == 2;
  if (!is_table) return py::cast(Result(ask(to_point(points, "point"))));
  const Numbers table = to_table(points, 2, "points");
  py::array_t<Result> results(table.shape(0));
  Result* const data = results.mutable_data();
  const auto count = static_cast<std::size_t>(table.shape(0));
  const double* const xy = table.data();
  const GilRelease released;
  for (std::size_t i = 0; i < count; ++i) data[i] = ask(Point(xy[2 * i], xy[2 * i + 1]));
  return results;
}

/// What both kinds of spaces answer.
template <class Handle>
void bind_questions(py::class_<Handle, std::shared_ptr<Handle>>& space) {
  space
      .def_property_readonly(
          "bounds",
          [](const Handle& self) {
            const Box& box = self.space.bounds();
            return py::make_tuple(box.min.x(), box.min.y(), box.max.x(), box.max.y());
          },
          "(min_x, min_y, max_x, max_y) [m].")
      .def_property_readonly(
          "safety_radius", [](const Handle& self) { return self.space.safety_radius(); }, "[m]")
      .def_property_readonly(
          "resolution", [](const Handle& self) { return self.space.frame().resolution; },
          "The distance between neighbours of the grid [m].")
      .def_property_readonly(
          "shape",
          [](const Handle& self) {
            return py::make_tuple(self.space.grid().height(), self.space.grid().width());
          },
          "(height, width) of the grid.")
      .def_property_readonly(
          "grid", [](const Handle& self) { return to_bools(self.space.grid()); },
          "Where a path may step: a bool array of shape (height, width), made anew at each call.")
      .def(
          "is_free",
          [](const Handle& self, const py::object& points) {
            return for_points<bool>(points, [&](const Point& p) { return self.space.is_free(p); });
          },
          "points"_a,
          "Whether a point (x, y) is free; for an array of shape (n, 2) an array of bools. Exact.")
      .def(
          "clearance",
          [](const Handle& self, const py::object& points) {
            return for_points<double>(points,
                                      [&](const Point& p) { return self.space.clearance(p); });
          },
          "points"_a,
          "The signed distance from a point to the nearest obstacle [m], negative inside; for an "
          "array of shape (n, 2) an array.")
      .def(
          "segment_free",
          [](const Handle& self, const py::object& a, const py::object& b) {
            return self.space.segment_free(to_point(a, "a"), to_point(b, "b"));
          },
          "a"_a, "b"_a, "Whether the segment between two points is free. Exact.")
      .def(
          "shortest_length",
          [](const Handle& self, const py::object& start, const py::object& goal) {
            Query query{.start = to_point(start, "start"), .goal = to_point(goal, "goal")};
            const auto length = run_interruptible([&](const std::stop_token& stop) {
              query.budget.stop = stop;
              return find_optimum(self.space, query);
            });
            if (!length) raise(length.error(), &query);
            return *length;
          },
          "start"_a, "goal"_a,
          "The length of the shortest path there is [m]. Raises the failures of a plan.")
      .def("_digest", [](const Handle& self) { return batch_program::digest_of(self.space); });
}

std::string describe(const char* name, const OccupancyGrid& grid, double radius) {
  return std::string("<") + name + " of " + std::to_string(grid.width()) + " x " +
         std::to_string(grid.height()) + ", safety_radius " +
         std::string(py::repr(py::float_(radius))) + ">";
}

void bind_lattices(py::module_& m) {
  py::class_<LatticeHandle, std::shared_ptr<LatticeHandle>> space(
      m, "LatticeSpace",
      R"(The free space of a workspace with a lattice on which every step is safe.

workspace: a Workspace.
resolution: the distance between neighbours of the lattice [m]; None: 1/200 of the larger side of
    the bounds.
movement: "no_cut", "no_squeeze", "allow" or "four_connected"; every rule is safe.
edges: "uniform", or "paper_strict", which reproduces a paper's tables.
max_nodes: more nodes than these are refused.

Immutable: threads may share it. Raises InvalidInput, InvalidOption and LimitExceeded.)");
  space
      .def(py::init(&build_lattice), "workspace"_a, "resolution"_a = py::none(),
           "movement"_a = "no_cut", "edges"_a = "uniform",
           "max_nodes"_a = LatticeOptions{}.max_nodes)
      .def_property_readonly(
          "workspace", [](const LatticeHandle& self) { return self.space.workspace(); },
          "The obstacles, as a Workspace.")
      .def("__repr__",
           [](const LatticeHandle& self) {
             return describe("LatticeSpace", self.space.grid(), self.space.safety_radius());
           })
      .def(py::pickle(
          [](const LatticeHandle& self) {
            using tutavia::detail::EnumNames;
            const auto name = [](auto rule) {
              return EnumNames<decltype(rule)>::names[static_cast<std::size_t>(rule)];
            };
            Workspace source = self.space.workspace();
            source.safety_radius = self.safety_radius;
            return pickle_head("LatticeSpace") +
                   py::make_tuple(source, self.options.resolution, name(self.options.movement),
                                  name(self.options.edges), self.options.max_nodes);
          },
          [](const py::tuple& state) {
            check_pickle(state, "LatticeSpace", 8);
            return build_lattice(state[3].cast<Workspace>(), state[4].cast<std::optional<double>>(),
                                 state[5].cast<std::string>(), state[6].cast<std::string>(),
                                 state[7].cast<std::int64_t>());
          }));
  bind_questions(space);
}

void bind_cells(py::module_& m) {
  py::class_<CellHandle, std::shared_ptr<CellHandle>> space(
      m, "CellSpace", R"(The free space between the blocked cells of a grid map.

Made by `from_numpy`, `from_ros_map` or `from_moving_ai`. Blocked cells are closed squares, from
which every point of a path keeps the safety radius. Immutable: threads may share it.)");
  space
      .def_static("from_numpy", &from_numpy, "free"_a, "resolution"_a = 1.0,
                  "origin"_a = py::make_tuple(0.0, 0.0), "safety_radius"_a = 0.0,
                  "movement"_a = "no_cut", R"(The space of an array of cells.

free: a bool array of shape (height, width), True where a cell is free. Cell (x, y) is free[y, x];
    its centre is origin + resolution * (x + 0.5, y + 0.5).
resolution: the side of a cell [m].
origin: the lower left corner of cell (0, 0), (x, y) [m].
safety_radius: the distance to keep from blocked cells [m].
movement: "no_cut", "no_squeeze", "allow" or "four_connected".

Raises InvalidInput for other dtypes and shapes, InvalidOption for options out of range.)")
      .def_static("from_moving_ai", &from_moving_ai, "path"_a, "safety_radius"_a = 0.0,
                  "movement"_a = "no_cut", "terrain"_a = "refused",
                  R"(The space of a map file of the MovingAI benchmarks.

Cells have the side 1; y grows downwards, from row 0 at the top of the file. `terrain` says how to
read swamp and water: "refused", "blocked" or "free". Raises InvalidInput with the line.)")
      .def_property_readonly(
          "free", [](const CellHandle& self) { return to_bools(self.space.cells()); },
          "The map as given: a bool array of shape (height, width), made anew at each call.")
      .def_property_readonly(
          "origin",
          [](const CellHandle& self) {
            const Point corner = self.space.corner({0, 0});
            return py::make_tuple(corner.x(), corner.y());
          },
          "The lower left corner of cell (0, 0), (x, y) [m].")
      .def("__repr__",
           [](const CellHandle& self) {
             return describe("CellSpace", self.space.cells(), self.space.safety_radius());
           })
      .def(py::pickle(
          [](const CellHandle& self) {
            using tutavia::detail::EnumNames;
            const OccupancyGrid& cells = self.space.cells();
            const CellOptions& options = self.options;
            return pickle_head("CellSpace") +
                   py::make_tuple(
                       packed(cells), cells.height(), cells.width(), options.resolution,
                       py::make_tuple(options.origin.x(), options.origin.y()),
                       options.safety_radius,
                       EnumNames<MovementRule>::names[static_cast<std::size_t>(options.movement)]);
          },
          [](const py::tuple& state) {
            check_pickle(state, "CellSpace", 10);
            return from_numpy(unpacked(state[3], state[4], state[5]), state[6].cast<double>(),
                              state[7], state[8].cast<double>(), state[9].cast<std::string>());
          }));
  bind_questions(space);
}

}  // namespace

MovementRule to_movement(const std::string& name) {
  auto rule = parse_movement_rule(name);
  if (!rule) raise(rule.error().code, "movement: " + rule.error().detail);
  return *rule;
}

std::shared_ptr<CellHandle> build_cells(OccupancyGrid cells, const CellOptions& options) {
  auto space = [&] {
    const GilRelease released;
    return CellSpace::build(std::move(cells), options);
  }();
  return std::make_shared<CellHandle>(CellHandle{value_or_raise(std::move(space)), options});
}

void bind_spaces(py::module_& m) {
  bind_lattices(m);
  bind_cells(m);
}

}  // namespace tutavia_python
