// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <utility>

#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/smooth/concepts.hpp"

/// \file
/// Pipeline: several smoothers in sequence.

namespace tutavia {

namespace detail {

/// A space on which all the smoothers work.
template <class S, class... Stages>
concept SmoothableSpace = (Smoother<Stages, S> && ...);

}  // namespace detail

/// Applies smoothers in sequence, each to the result of the one before:
///
///     Planner planner{ThetaStar{}, Pipeline{TautString{}, BezierSmoother{.trim = 0.2}}};
///
/// Fails as soon as one of them fails; smoothers that take only segments and arcs must come first.
/// The result keeps every bound that the last smoother keeps. Its length is bounded by the product
/// of all bounds.
///
/// Example: examples/smoothers.cpp.
template <class... Stages>
class Pipeline {
  static_assert(sizeof...(Stages) > 0);

 public:
  Pipeline() = default;
  explicit Pipeline(Stages... stages) : stages_(std::move(stages)...) {}

  template <detail::SmoothableSpace<Stages...> S>
  Expected<Curve, Failure> smooth(const S& space, const Curve& input, const Budget& budget) const {
    return in_sequence(input, [&](const auto& stage, const Curve& curve) {
      return stage.smooth(space, curve, budget);
    });
  }

  /// The same for the path of a vehicle, if every stage smooths such paths.
  template <detail::SmoothableSpace<Stages...> S>
  requires(VehicleSmoother<Stages, S>&&...) Expected<VehiclePath, Failure> smooth(
      const S& space, const Vehicle& vehicle, const VehiclePath& input, const Budget& budget)
  const {
    return in_sequence(input, [&](const auto& stage, const VehiclePath& path) {
      return stage.smooth(space, vehicle, path, budget);
    });
  }

 private:
  /// Calls `smooth(stage, path)` for every stage with the result of the one before.
  template <class Path, class Smooth>
  Expected<Path, Failure> in_sequence(const Path& input, const Smooth& smooth) const {
    Expected<Path, Failure> result = input;
    const auto run = [&](const auto& stage) {
      result = smooth(stage, *result);
      return result.has_value();
    };
    std::apply([&](const auto&... stages) { static_cast<void>((run(stages) && ...)); }, stages_);
    return result;
  }

  /// The names of all stages with a plus between them.
  static constexpr auto joined_names() {
    std::array<char, (std::string_view(Stages::name).size() + ...) + sizeof...(Stages) - 1> text{};
    auto at = text.begin();
    const auto append = [&](std::string_view stage) {
      if (at != text.begin()) *at++ = '+';
      at = std::copy(stage.begin(), stage.end(), at);
    };
    (append(Stages::name), ...);
    return text;
  }
  static constexpr auto joined = joined_names();

  std::tuple<Stages...> stages_;

 public:
  static constexpr std::string_view name{joined.data(), joined.size()};
};

}  // namespace tutavia
