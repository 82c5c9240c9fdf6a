// SPDX-License-Identifier: MIT
#include "results.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "bindings.hpp"
#include "failures.hpp"
#include "tutavia/registry.hpp"

/// \file
/// tutavia.Curve, Certificate, Metrics, Statistics and Plan.

namespace tutavia_python {

namespace {

using namespace pybind11::literals;

constexpr std::array<const char*, 5> kinds{"segment", "quadratic_bezier", "cubic_bezier", "arc",
                                           "clothoid"};
constexpr std::array<std::size_t, 5> sizes{4, 6, 8, 9, 8};

/// The numbers that a piece consists of, in the order of its members.
void append_numbers(const Piece& piece, std::vector<double>& numbers) {
  const auto add = [&](const Point& p) { numbers.insert(numbers.end(), {p.x(), p.y()}); };
  piece.visit([&]<class P>(const P& part) {
    if constexpr (std::is_same_v<P, QuadraticBezier> || std::is_same_v<P, CubicBezier>) {
      for (const Point& p : part.points) add(p);
    } else {
      add(part.a);
      add(part.b);
    }
    if constexpr (std::is_same_v<P, Arc>) {
      add(part.center);
      numbers.insert(numbers.end(), {part.radius, part.start_angle, part.sweep});
    }
    if constexpr (std::is_same_v<P, Clothoid>) {
      numbers.insert(numbers.end(),
                     {part.start_heading, part.start_curvature, part.sharpness, part.arc_length});
    }
  });
}

Piece to_piece(std::size_t kind, const double* x) {
  const auto at = [x](std::size_t i) { return Point(x[2 * i], x[2 * i + 1]); };
  switch (kind) {
    case 0:
      return Segment{at(0), at(1)};
    case 1:
      return QuadraticBezier{{at(0), at(1), at(2)}};
    case 2:
      return CubicBezier{{at(0), at(1), at(2), at(3)}};
    case 3:
      return Arc{at(0), at(1), at(2), x[6], x[7], x[8]};
    default:
      return Clothoid{at(0), at(1), x[4], x[5], x[6], x[7]};
  }
}

void check_step(double step, double whole, const char* name) {
  constexpr double most = 1e8;
  if (step > 0 && std::isfinite(step) && whole / step <= most) return;
  raise(PlanError::invalid_option,
        std::string(name) + ": expected a positive number that gives at most 10^8 samples, got " +
            std::string(py::repr(py::float_(step))));
}

void check_not_empty(const Curve& curve) {
  if (curve.empty()) raise(PlanError::invalid_input, "the curve is empty");
}

py::object samples_of(const std::vector<CurvePoint>& states) {
  return py::module_::import("tutavia.samples")
      .attr("CurveSamples")(
          make_column(states.size(), [&](std::size_t i) { return states[i].s; }),
          make_points(states.size(),
                      [&](std::size_t i) -> const Point& { return states[i].position; }),
          make_column(states.size(), [&](std::size_t i) { return states[i].heading; }),
          make_column(states.size(), [&](std::size_t i) { return states[i].curvature; }));
}

py::object sample(const Curve& curve, double ds) {
  check_not_empty(curve);
  check_step(ds, curve.length(), "ds");
  return samples_of(curve.sample(ds));
}

py::object at(const Curve& curve, const py::object& s) {
  check_not_empty(curve);
  if (is_number(s)) {
    const double length = to_number(s, "s");
    if (std::isnan(length)) raise(PlanError::invalid_input, "s: expected a number, got nan");
    const CurvePoint state = curve.at(length);
    return py::module_::import("tutavia.samples")
        .attr("CurveSamples")(state.s, py::make_tuple(state.position.x(), state.position.y()),
                              state.heading, state.curvature);
  }
  const Numbers lengths = to_column_without_nan(s, "s");
  std::vector<CurvePoint> states;
  for (py::ssize_t i = 0; i < lengths.size(); ++i) states.push_back(curve.at(lengths.at(i)));
  return samples_of(states);
}

py::list pieces_of(const Curve& curve) {
  py::list pieces;
  for (const Piece& piece : curve.pieces()) {
    std::vector<double> numbers;
    append_numbers(piece, numbers);
    pieces.append(py::make_tuple(
        kinds[piece.index()], Numbers(static_cast<py::ssize_t>(numbers.size()), numbers.data())));
  }
  return pieces;
}

void bind_curve(py::module_& m) {
  py::class_<Curve>(m, "Curve", R"(A chain of segments, Bezier pieces, arcs and clothoids.

It is addressed by arc length from its start [m]; values outside are clamped. `len` is the number of
its pieces.)")
      .def_property_readonly("length", &Curve::length, "[m]")
      .def("__len__", [](const Curve& curve) { return curve.pieces().size(); })
      .def("sample", &sample, "ds"_a,
           R"(States at equal steps of arc length, at most `ds` [m] apart.

Both ends are included. Returns CurveSamples: the arrays s (n,) [m], position (n, 2) [m], heading
(n,), the direction of travel in (-pi, pi] [rad], and curvature (n,) [1/m], left turns positive.
Raises InvalidOption for a step that is not positive.)")
      .def("at", &at, "s"_a,
           "The state at an arc length [m], or CurveSamples of arrays for an array of them.")
      .def(
          "nearest",
          [](const Curve& curve, const py::object& point) {
            check_not_empty(curve);
            const Curve::Nearest near = curve.nearest(to_finite_point(point, "point"));
            return py::make_tuple(near.s, py::make_tuple(near.position.x(), near.position.y()),
                                  near.distance);
          },
          "point"_a, "The nearest point of the curve: (s, (x, y), distance) [m].")
      .def_property_readonly(
          "waypoints",
          [](const Curve& curve) {
            const std::vector<Point> points = waypoints(curve);
            return make_points(points.size(),
                               [&](std::size_t i) -> const Point& { return points[i]; });
          },
          "The start and the end of every piece: an array of shape (n + 1, 2) [m].")
      .def_property_readonly("pieces", &pieces_of,
                             R"(The pieces, as (kind, numbers), numbers to the last bit:

segment: ax, ay, bx, by.
quadratic_bezier, cubic_bezier: the control points.
arc: ax, ay, bx, by, centre x, centre y, radius, start_angle, sweep.
clothoid: ax, ay, bx, by, start_heading, start_curvature, sharpness, length.)")
      .def("reversed", &Curve::reversed, "The curve from its end to its start.")
      .def("__eq__",
           [](const Curve& a, const py::object& b) {
             return py::isinstance<Curve>(b) &&
                    curve_state(a).equal(curve_state(b.cast<const Curve&>()));
           })
      .def("__repr__",
           [](const Curve& curve) {
             return "<Curve of " + std::to_string(curve.pieces().size()) + " pieces, " +
                    std::string(py::repr(py::float_(curve.length()))) + " m>";
           })
      .def(py::pickle([](const Curve& curve) { return pickle_head("Curve") + curve_state(curve); },
                      [](const py::tuple& state) {
                        check_pickle(state, "Curve", 5);
                        return curve_of(py::make_tuple(state[3], state[4]));
                      }))
      .attr("__hash__") = py::none();
}

py::tuple certificate_state(const Certificate& c) {
  return py::make_tuple(static_cast<int>(c.status), c.lower, c.upper, c.point.x(), c.point.y(),
                        c.piece, c.parameter, c.obstacle, c.edge, c.distance_error_bound,
                        c.evaluations);
}

Certificate certificate_of(const py::tuple& state) {
  const int status = state[0].cast<int>();
  if (status < 0 || status > static_cast<int>(ProofStatus::undecided)) {
    raise(PlanError::invalid_input, "the pickle of this certificate is damaged");
  }
  return {static_cast<ProofStatus>(status), state[1].cast<double>(),
          state[2].cast<double>(),          {state[3].cast<double>(), state[4].cast<double>()},
          state[5].cast<std::size_t>(),     state[6].cast<double>(),
          state[7].cast<std::uint32_t>(),   state[8].cast<std::uint32_t>(),
          state[9].cast<double>(),          state[10].cast<std::size_t>()};
}

void bind_certificate(py::module_& m) {
  py::class_<Certificate>(m, "Certificate", R"(The proved bounds of a curve's clearance.

lower <= c <= upper holds for the least distance c between any point of the continuous curve and any
obstacle, rounding included.)")
      .def_property_readonly(
          "status", [](const Certificate& c) { return std::string(to_string(c.status)); },
          "\"proved\", \"violated\" or \"undecided\"; that of a plan is always \"proved\".")
      .def_readonly("lower", &Certificate::lower, "[m]")
      .def_readonly("upper", &Certificate::upper, "[m]")
      .def_property_readonly(
          "point", [](const Certificate& c) { return py::make_tuple(c.point.x(), c.point.y()); },
          "The point of the curve that attains `upper`, (x, y) [m].")
      .def_readonly("piece", &Certificate::piece, "The index of the piece with that point.")
      .def_readonly("parameter", &Certificate::parameter, "Of the point on that piece, 0 to 1.")
      .def_property_readonly(
          "obstacle",
          [](const Certificate& c) {
            return c.obstacle == NearestObstacle::none ? py::object(py::none())
                                                       : py::object(py::int_(c.obstacle));
          },
          "The index of the obstacle nearest to it, of a CellSpace that of the blocked cell; None "
          "without obstacles.")
      .def_readonly("evaluations", &Certificate::evaluations, "Distances computed.")
      .def("__repr__",
           [](const Certificate& c) {
             return "<Certificate: " + std::string(to_string(c.status)) + ", clearance " +
                    std::string(py::repr(py::float_(c.lower))) + " to " +
                    std::string(py::repr(py::float_(c.upper))) + " m>";
           })
      .def(py::pickle(
          [](const Certificate& c) { return pickle_head("Certificate") + certificate_state(c); },
          [](const py::tuple& state) {
            check_pickle(state, "Certificate", 14);
            return certificate_of(state[py::slice(3, 14, 1)].cast<py::tuple>());
          }));
}

void bind_metrics(py::module_& m) {
  using M = PathMetrics;
  py::class_<M>(m, "Metrics", "Length, smoothness and clearance of a path.")
      .def_readonly("length", &M::length, "[m]")
      .def_readonly("turning_points", &M::turning_points, "Turns of more than half a degree.")
      .def_readonly("turning_angle", &M::turning_angle,
                    "The sum of the magnitudes of all changes of heading [rad].")
      .def_readonly("max_joint_deflection", &M::max_joint_deflection,
                    "The largest turn between two consecutive pieces [rad]; 0 for a smooth path.")
      .def_readonly("max_curvature", &M::max_curvature, "Of the pieces [1/m].")
      .def_readonly("max_curvature_jump", &M::max_curvature_jump,
                    "Between consecutive pieces [1/m]; 0 up to rounding if it is continuous.")
      .def_readonly("min_clearance", &M::min_clearance, "The proved lower bound [m].")
      .def("__repr__",
           [](const M& metrics) {
             return "<Metrics: length " + std::string(py::repr(py::float_(metrics.length))) +
                    " m, clearance at least " +
                    std::string(py::repr(py::float_(metrics.min_clearance))) + " m>";
           })
      .def(py::pickle(
          [](const M& x) {
            return pickle_head("Metrics") + py::make_tuple(x.length, x.turning_points,
                                                           x.turning_angle, x.interior_angle_sum,
                                                           x.max_joint_deflection, x.max_curvature,
                                                           x.max_curvature_jump, x.min_clearance);
          },
          [](const py::tuple& state) {
            check_pickle(state, "Metrics", 11);
            return M{state[3].cast<double>(), state[4].cast<std::size_t>(), state[5].cast<double>(),
                     state[6].cast<double>(), state[7].cast<double>(),      state[8].cast<double>(),
                     state[9].cast<double>(), state[10].cast<double>()};
          }));
}

py::tuple statistics_state(const Statistics& s) {
  return py::make_tuple(s.expanded, s.generated, s.distinct, s.search_us, s.smooth_us, s.certify_us,
                        s.seed);
}

Statistics statistics_of(const py::tuple& state) {
  Statistics s;
  s.expanded = state[0].cast<std::uint64_t>();
  s.generated = state[1].cast<std::uint64_t>();
  s.distinct = state[2].cast<std::optional<std::uint64_t>>();
  s.search_us = state[3].cast<double>();
  s.smooth_us = state[4].cast<double>();
  s.certify_us = state[5].cast<double>();
  s.seed = state[6].cast<std::uint64_t>();
  return s;
}

void bind_statistics(py::module_& m) {
  py::class_<Statistics>(m, "Statistics", "The effort of one query; times are wall-clock.")
      .def_readonly("expanded", &Statistics::expanded)
      .def_readonly("generated", &Statistics::generated)
      .def_readonly("search_us", &Statistics::search_us, "[us]")
      .def_readonly("smooth_us", &Statistics::smooth_us, "[us]")
      .def_readonly("certify_us", &Statistics::certify_us, "[us]")
      .def_readonly("seed", &Statistics::seed)
      .def("__repr__",
           [](const Statistics& s) {
             return "<Statistics: " + std::to_string(s.expanded) + " expanded, " +
                    std::string(py::repr(py::float_(s.search_us + s.smooth_us + s.certify_us))) +
                    " us>";
           })
      .def(py::pickle(
          [](const Statistics& s) { return pickle_head("Statistics") + statistics_state(s); },
          [](const py::tuple& state) {
            check_pickle(state, "Statistics", 10);
            return statistics_of(state[py::slice(3, 10, 1)].cast<py::tuple>());
          }));
}

/// The name of a search as the library keeps it.
std::string_view known_name(const std::string& name) {
  static const std::vector<AlgorithmDescription> all = describe_searches();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const AlgorithmDescription& a) { return a.name == name; });
  return found != all.end() ? std::string_view(found->name) : std::string_view{};
}

py::bytes gears_state(const std::vector<Gear>& gears) {
  std::string bytes;
  for (const Gear gear : gears) bytes.push_back(gear == Gear::forward ? 'f' : 'r');
  return bytes;
}

std::vector<Gear> gears_of(const std::string& bytes) {
  std::vector<Gear> gears;
  gears.reserve(bytes.size());
  for (const char gear : bytes) gears.push_back(gear == 'f' ? Gear::forward : Gear::reverse);
  return gears;
}

py::tuple route_state(const Route& route) {
  return py::make_tuple(curve_state(route.curve), route.cost, statistics_state(route.stats),
                        route.vehicle, gears_state(route.gears), route.risk_width,
                        route.risk_weight, std::string(route.found_by));
}

Route route_of(const py::tuple& state) {
  Route route{.curve = curve_of(state[0]), .cost = state[1].cast<double>()};
  route.stats = statistics_of(state[2]);
  route.vehicle = state[3].cast<std::optional<Vehicle>>();
  route.gears = gears_of(state[4].cast<std::string>());
  route.risk_width = state[5].cast<double>();
  route.risk_weight = state[6].cast<double>();
  route.found_by = known_name(state[7].cast<std::string>());
  return route;
}

py::tuple plan_state(const PlanHandle& self) {
  const Plan& plan = self.plan;
  return pickle_head("Plan") + py::make_tuple(curve_state(plan.curve), gears_state(plan.gears),
                                              certificate_state(plan.certificate),
                                              route_state(plan.route), plan.fell_back,
                                              statistics_state(plan.stats));
}

PlanHandle plan_of(const py::tuple& state) {
  check_pickle(state, "Plan", 9);
  Plan plan{.curve = curve_of(state[3]),
            .gears = gears_of(state[4].cast<std::string>()),
            .certificate = certificate_of(state[5]),
            .route = route_of(state[6]),
            .fell_back = state[7].cast<bool>(),
            .stats = statistics_of(state[8])};
  const auto fit = [](const Curve& curve, const std::vector<Gear>& gears) {
    return !curve.empty() && (gears.empty() || gears.size() == curve.pieces().size());
  };
  if (!fit(plan.curve, plan.gears) || !fit(plan.route.curve, plan.route.gears)) {
    raise(PlanError::invalid_input, "the pickle of this plan is damaged");
  }
  plan.metrics = measure(plan.curve, plan.certificate, plan.gears);
  return {std::move(plan)};
}

void bind_plan(py::module_& m) {
  const auto inside = py::return_value_policy::reference_internal;
  const auto gear_names = [](const PlanHandle& self) {
    py::list names;
    for (const Gear gear : self.plan.gears) names.append(to_string(gear));
    return names;
  };
  py::class_<PlanHandle>(m, "Plan", R"(A path that is proved safe.

Pickles hold everything but the space.)")
      .def_property_readonly(
          "curve", [](const PlanHandle& self) -> const Curve& { return self.plan.curve; }, inside,
          "From start to goal, both exact.")
      .def_property_readonly(
          "route", [](const PlanHandle& self) -> const Curve& { return self.plan.route.curve; },
          inside, "The result of the search, before smoothing.")
      .def_property_readonly(
          "certificate",
          [](const PlanHandle& self) -> const Certificate& { return self.plan.certificate; },
          inside, "The proof, of a vehicle for its whole footprint.")
      .def_property_readonly(
          "metrics", [](const PlanHandle& self) -> const PathMetrics& { return self.plan.metrics; },
          inside)
      .def_property_readonly(
          "stats", [](const PlanHandle& self) -> const Statistics& { return self.plan.stats; },
          inside)
      .def_property_readonly(
          "length", [](const PlanHandle& self) { return self.plan.metrics.length; }, "[m]")
      .def_property_readonly(
          "fell_back", [](const PlanHandle& self) { return self.plan.fell_back; },
          "Whether the curve, or a part of it, is the route's, because no smoothed one is proved.")
      .def_property_readonly(
          "found_by", [](const PlanHandle& self) { return std::string(self.plan.route.found_by); },
          "The search that found the route, if several took part; else empty.")
      .def_property_readonly("gears", gear_names,
                             "\"forward\" or \"reverse\" for each piece of a vehicle's path; else "
                             "empty.")
      .def_property_readonly(
          "vehicle", [](const PlanHandle& self) { return self.plan.route.vehicle; },
          "The Vehicle that was planned for, or None.")
      .def_property_readonly(
          "space", [](const PlanHandle& self) { return self.space; },
          "The space of the plan; None after unpickling.")
      .def("__repr__",
           [](const PlanHandle& self) {
             return "<Plan of " + std::string(py::repr(py::float_(self.plan.metrics.length))) +
                    " m, clearance at least " +
                    std::string(py::repr(py::float_(self.plan.certificate.lower))) + " m>";
           })
      .def(py::pickle(&plan_state, &plan_of));
}

}  // namespace

py::tuple curve_state(const Curve& curve) {
  std::string indices;
  std::vector<double> numbers;
  for (const Piece& piece : curve.pieces()) {
    indices.push_back(static_cast<char>(piece.index()));
    append_numbers(piece, numbers);
  }
  return py::make_tuple(py::bytes(indices), py::bytes(reinterpret_cast<const char*>(numbers.data()),
                                                      numbers.size() * sizeof(double)));
}

Curve curve_of(const py::tuple& state) {
  const auto indices = state[0].cast<std::string>(), bytes = state[1].cast<std::string>();
  std::vector<double> numbers(bytes.size() / sizeof(double));
  std::copy_n(bytes.data(), numbers.size() * sizeof(double),
              reinterpret_cast<char*>(numbers.data()));
  Curve curve;
  curve.reserve(indices.size());
  std::size_t next = 0;
  for (const char index : indices) {
    const auto kind = static_cast<std::size_t>(index);
    if (kind >= sizes.size() || next + sizes[kind] > numbers.size()) {
      raise(PlanError::invalid_input, "the pickle of this curve is damaged");
    }
    const Piece piece = to_piece(kind, numbers.data() + next);
    if (!curve.empty() && start_of(piece) != curve.end()) {
      raise(PlanError::invalid_input, "the pickle of this curve is damaged");
    }
    curve.push_back(piece);
    next += sizes[kind];
  }
  return curve;
}

void bind_results(py::module_& m) {
  bind_curve(m);
  bind_certificate(m);
  bind_metrics(m);
  bind_statistics(m);
  bind_plan(m);
}

}  // namespace tutavia_python
