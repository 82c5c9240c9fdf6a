// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "bindings.hpp"
#include "failures.hpp"
#include "tutavia/motion/speed_profile.hpp"
#include "tutavia/plan/vehicle.hpp"

/// \file
/// tutavia.Vehicle and tutavia.SpeedProfile.

namespace tutavia_python {

namespace {

using namespace pybind11::literals;

Vehicle checked(Vehicle vehicle) {
  if (const auto valid = validate(vehicle); !valid) raise(valid.error());
  return vehicle;
}

Vehicle make_vehicle(double min_turning_radius, bool reverse, const py::object& footprint) {
  Vehicle vehicle{.min_turning_radius = min_turning_radius, .reverse = reverse};
  if (!footprint.is_none()) {
    const Numbers discs = to_table(footprint, 3, "footprint (x, y, radius)");
    vehicle.footprint.clear();
    for (py::ssize_t i = 0; i < discs.shape(0); ++i) {
      vehicle.footprint.push_back({{discs.at(i, 0), discs.at(i, 1)}, discs.at(i, 2)});
    }
  }
  return checked(std::move(vehicle));
}

Vehicle make_car(double length, double width, double wheelbase, double min_turning_radius,
                 bool reverse, double margin) {
  const auto is_side = [](double x) { return x > 0 && std::isfinite(x); };
  if (!is_side(length) || !is_side(width)) {
    raise(PlanError::invalid_option, "car: length and width must be positive and finite");
  }
  if (!(0 <= wheelbase && wheelbase <= length)) {
    raise(PlanError::invalid_option, "car: wheelbase must lie between 0 and the length");
  }
  const double used = margin == 0 ? std::fmin(length, width) / 18 : margin;
  if (!(used > 0) || !(std::fmax(length, width) <= 1e4 * used)) {
    raise(PlanError::invalid_option,
          "car: margin must be positive, and no side as long as 10^4 margins");
  }
  return checked(Vehicle::car(length, width, wheelbase, min_turning_radius, reverse, margin));
}

Numbers footprint_of(const Vehicle& vehicle) {
  Numbers discs({static_cast<py::ssize_t>(vehicle.footprint.size()), py::ssize_t{3}});
  double* data = discs.mutable_data();
  for (const FootprintDisc& disc : vehicle.footprint) {
    for (const double x : {disc.offset.x(), disc.offset.y(), disc.radius}) *data++ = x;
  }
  return discs;
}

void bind_vehicle(py::module_& m) {
  py::class_<Vehicle>(m, "Vehicle", R"(What a vehicle may drive, and the room that it takes.

The reference point is the one whose path is planned: the middle of the rear axle of a car. The
footprint is a union of discs, each of which keeps the safety radius of the space.

min_turning_radius: of the reference point [m]; 0: the vehicle turns on the spot, which only a
    footprint of one disc around the reference point may do.
reverse: whether it may drive backwards.
footprint: an array of shape (n, 3): ahead, to the left and radius of each disc [m]; None: a point.

Raises InvalidOption for values out of range.)")
      .def(py::init(&make_vehicle), "min_turning_radius"_a = 0.0, "reverse"_a = false,
           "footprint"_a = py::none())
      .def_static("car", &make_car, "length"_a, "width"_a, "wheelbase"_a, "min_turning_radius"_a,
                  "reverse"_a = true, "margin"_a = 0.0,
                  R"(A rectangle, covered by few discs that stay within `margin` of it [m].

The rear axle lies as far from the back as the front axle from the front. Margin 0 stands for an
eighteenth of the shorter side.)")
      .def_readonly("min_turning_radius", &Vehicle::min_turning_radius, "[m]")
      .def_readonly("reverse", &Vehicle::reverse)
      .def_property_readonly("footprint", &footprint_of,
                             "An array of shape (n, 3): ahead, to the left, radius [m].")
      .def("__eq__",
           [](const Vehicle& a, const py::object& other) {
             if (!py::isinstance<Vehicle>(other)) return false;
             const auto& b = other.cast<const Vehicle&>();
             const bool same = a.min_turning_radius == b.min_turning_radius &&
                               a.reverse == b.reverse && a.footprint.size() == b.footprint.size();
             for (std::size_t i = 0; same && i < a.footprint.size(); ++i) {
               if (a.footprint[i].offset != b.footprint[i].offset ||
                   a.footprint[i].radius != b.footprint[i].radius) {
                 return false;
               }
             }
             return same;
           })
      .def("__hash__",
           [](const Vehicle& vehicle) {
             return py::hash(py::make_tuple(vehicle.min_turning_radius, vehicle.reverse,
                                            vehicle.footprint.size()));
           })
      .def("__repr__",
           [](const Vehicle& vehicle) {
             return "<Vehicle of " + std::to_string(vehicle.footprint.size()) +
                    " discs, min_turning_radius " +
                    std::string(py::repr(py::float_(vehicle.min_turning_radius))) + ">";
           })
      .def(py::pickle(
          [](const Vehicle& vehicle) {
            return pickle_head("Vehicle") + py::make_tuple(vehicle.min_turning_radius,
                                                           vehicle.reverse, footprint_of(vehicle));
          },
          [](const py::tuple& state) {
            check_pickle(state, "Vehicle", 6);
            return make_vehicle(state[3].cast<double>(), state[4].cast<bool>(), state[5]);
          }));
}

/// A profile with the limits that built it, for pickles.
struct ProfileHandle {
  SpeedProfile profile;
  SpeedLimits limits;
};

ProfileHandle make_profile(const Curve& curve, const SpeedLimits& limits) {
  return {value_or_raise(SpeedProfile::build(curve, limits)), limits};
}

SpeedLimits make_limits(double max_speed, double max_acceleration, double max_deceleration,
                        double max_lateral_acceleration, double max_jerk, double max_curvature_rate,
                        double start_speed, double end_speed) {
  return {max_speed, max_acceleration,   max_deceleration, max_lateral_acceleration,
          max_jerk,  max_curvature_rate, start_speed,      end_speed};
}

py::tuple limits_state(const SpeedLimits& l) {
  return py::make_tuple(l.max_speed, l.max_acceleration, l.max_deceleration,
                        l.max_lateral_acceleration, l.max_jerk, l.max_curvature_rate, l.start_speed,
                        l.end_speed);
}

py::object to_samples(const std::vector<SpeedProfile::State>& states) {
  const auto column = [&](double SpeedProfile::State::*member) {
    return make_column(states.size(), [&](std::size_t i) { return states[i].*member; });
  };
  using State = SpeedProfile::State;
  return py::module_::import("tutavia.samples")
      .attr("SpeedSamples")(
          column(&State::time), column(&State::s),
          make_points(states.size(),
                      [&](std::size_t i) -> const Point& { return states[i].position; }),
          column(&State::heading), column(&State::curvature), column(&State::speed),
          column(&State::acceleration));
}

py::object sample(const ProfileHandle& self, double dt) {
  if (!(dt > 0) || !std::isfinite(dt) || self.profile.duration() / dt > 1e8) {
    raise(PlanError::invalid_option,
          "dt: expected a positive number that gives at most 10^8 samples");
  }
  return to_samples(self.profile.sample(dt));
}

py::object at(const ProfileHandle& self, const py::object& times) {
  const Numbers column = to_column_without_nan(times, "times");
  std::vector<SpeedProfile::State> states;
  for (py::ssize_t i = 0; i < column.size(); ++i) states.push_back(self.profile.at(column.at(i)));
  return to_samples(states);
}

void bind_profile(py::module_& m) {
  const SpeedLimits defaults;
  py::class_<ProfileHandle>(m, "SpeedProfile", R"(The fastest speed along a curve within limits.

curve: a Curve.
max_speed [m/s]; max_acceleration and max_deceleration, along the curve [m/s^2], and
max_lateral_acceleration, across it [m/s^2]: positive and finite.
max_jerk: the change of the acceleration [m/s^3]; infinity allows jumps.
max_curvature_rate: the change of the curvature [1/(m s)], on curves of segments, arcs and clothoids;
    infinity allows jumps.
start_speed; end_speed, an upper bound at the end [m/s].

The limits hold everywhere on the curve, not only at samples. Raises InvalidOption for limits out of
range and a start speed from which the robot cannot brake, InvalidInput for a curve with a cusp.)")
      .def(py::init([](const Curve& curve, double max_speed, double max_acceleration,
                       double max_deceleration, double max_lateral_acceleration, double max_jerk,
                       double max_curvature_rate, double start_speed, double end_speed) {
             return make_profile(curve, make_limits(max_speed, max_acceleration, max_deceleration,
                                                    max_lateral_acceleration, max_jerk,
                                                    max_curvature_rate, start_speed, end_speed));
           }),
           "curve"_a, py::kw_only(), "max_speed"_a = defaults.max_speed,
           "max_acceleration"_a = defaults.max_acceleration,
           "max_deceleration"_a = defaults.max_deceleration,
           "max_lateral_acceleration"_a = defaults.max_lateral_acceleration,
           "max_jerk"_a = defaults.max_jerk, "max_curvature_rate"_a = defaults.max_curvature_rate,
           "start_speed"_a = defaults.start_speed, "end_speed"_a = defaults.end_speed)
      .def_property_readonly(
          "duration", [](const ProfileHandle& self) { return self.profile.duration(); },
          "Of the whole motion [s].")
      .def_property_readonly("curve",
                             [](const ProfileHandle& self) { return self.profile.curve(); })
      .def("sample", &sample, "dt"_a, R"(States at equal steps of time, at most `dt` [s] apart.

Returns SpeedSamples: the arrays time (n,) [s], s (n,) [m], position (n, 2) [m], heading (n,) [rad],
curvature (n,) [1/m], speed (n,) [m/s] and acceleration (n,) [m/s^2].)")
      .def("at", &at, "times"_a, "SpeedSamples at an array of times [s], clamped to the duration.")
      .def("__repr__",
           [](const ProfileHandle& self) {
             return "<SpeedProfile of " +
                    std::string(py::repr(py::float_(self.profile.duration()))) + " s>";
           })
      .def(py::pickle(
          [](const ProfileHandle& self) {
            return pickle_head("SpeedProfile") +
                   py::make_tuple(self.profile.curve(), limits_state(self.limits));
          },
          [](const py::tuple& state) {
            check_pickle(state, "SpeedProfile", 5);
            const auto l = state[4].cast<std::vector<double>>();
            return make_profile(state[3].cast<const Curve&>(),
                                make_limits(l.at(0), l.at(1), l.at(2), l.at(3), l.at(4), l.at(5),
                                            l.at(6), l.at(7)));
          }));
}

}  // namespace

void bind_vehicles(py::module_& m) { bind_vehicle(m); }

void bind_speed_profiles(py::module_& m) { bind_profile(m); }

}  // namespace tutavia_python
