// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <string_view>

#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// What a smoother is, and what many have in common.

namespace tutavia {

/// A smoother: a regular value that is its own options. `smooth` maps a curve in free space to
/// another one in free space with the same ends, never longer than its documented bound; it is
/// deterministic and keeps within the budget.
template <class A, class S>
concept Smoother = std::copyable<A> &&
    requires(const A& a, const S& space, const Curve& curve, const Budget& budget) {
  { A::name } -> std::convertible_to<std::string_view>;
  { a.smooth(space, curve, budget) } -> std::same_as<Expected<Curve, Failure>>;
};

namespace detail {

/// The metres in a length that smoothers take in spacings of the space's grid: its resolution, 1 m
/// where the space has no grid.
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
