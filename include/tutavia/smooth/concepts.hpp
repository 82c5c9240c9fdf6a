// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <string_view>

#include "tutavia/core/budget.hpp"
#include "tutavia/core/error.hpp"
#include "tutavia/geometry/curve.hpp"

/// \file
/// What a smoother is.

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

}  // namespace tutavia
