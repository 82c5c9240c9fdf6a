// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <string_view>

#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/vehicle_path.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/plan/vehicle.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// The concept of smoothers, and their unit of length.

namespace tutavia {

/// A smoother: a regular value whose members are its options. `smooth` maps a curve in free space
/// to another one in free space with the same ends, never longer than its documented bound. It is
/// deterministic and stays within the budget.
///
/// Example: examples/12_own_smoother.cpp.
template <class A, class S>
concept Smoother = std::copyable<A> &&
    requires(const A& a, const S& space, const Curve& curve, const Budget& budget) {
  { A::name } -> std::convertible_to<std::string_view>;
  { a.smooth(space, curve, budget) } -> std::same_as<Expected<Curve, Failure>>;
};

/// A smoother of paths that vehicles drive. The result keeps the ends, the headings there, the
/// turning radius and the gears that the vehicle has.
///
/// Example: tests/smooth/vehicle_shortcut_test.cpp.
template <class A, class S>
concept VehicleSmoother = Smoother<A, S> &&
    requires(const A& a, const S& space, const Vehicle& vehicle, const VehiclePath& path,
             const Budget& budget) {
  { a.smooth(space, vehicle, path, budget) } -> std::same_as<Expected<VehiclePath, Failure>>;
};

namespace detail {

/// The unit [m] of lengths that smoothers take in grid spacings: the grid's resolution, 1 m if the
/// space has no grid.
template <FreeSpace S>
double length_unit([[maybe_unused]] const S& space) {
  if constexpr (LinkedSpace<S>) {
    return space.frame().resolution;
  } else {
    return 1;
  }
}

}  // namespace detail

}  // namespace tutavia
