// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <concepts>
#include <optional>
#include <utility>
#include <vector>

#include "tutavia/certify/certify.hpp"
#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/core/budget.hpp"
#include "tutavia/core/expected.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/search/risk_zone.hpp"
#include "tutavia/smooth/concepts.hpp"
#include "tutavia/smooth/no_smoothing.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// smooth_outside_risk: smooths a route without leading it into a risk zone.

namespace tutavia::detail {

/// A space that can be had at other safety radii.
template <class S>
concept AdjustableSpace = ClearanceSpace<S> && requires(const S& space, double radius) {
  { space.with_safety_radius(radius) } -> std::same_as<Expected<S, Failure>>;
};

/// A smoothed curve, and whether it is wholly the smoother's.
struct SmoothedCurve {
  Curve curve;
  bool is_whole = true;
};

/// Smooths a curve without leading it farther into a risk zone.
///
/// A curve outside the zone is smoothed in a space of which the zone is part. Any other curve is
/// smoothed in a space at its own least clearance, and the result used unless it costs more (length
/// and weighted risk, to 1 %). If it does, runs of pieces outside the zone and runs of other pieces
/// are smoothed likewise, each on its own; a run for which that fails stays as it is. A space that
/// cannot be had at other radii is used as it is; then a run outside is used only if it is proved
/// to stay outside. Errors: `invalid_option` of the smoother; those of the budget.
template <ClearanceSpace S, Smoother<S> Smooth>
class RiskRuns {
 public:
  RiskRuns(const S& space, const Smooth& smoother, const RiskZone& zone, const Budget& budget)
      : space_(space), smoother_(smoother), zone_(zone), budget_(budget) {}

  Expected<SmoothedCurve, Failure> smooth(const Curve& input) {
    std::vector<Run> runs;
    for (const Piece& piece : input.pieces()) {
      const bool outside = is_outside(piece);
      if (runs.empty() || runs.back().outside != outside) runs.push_back({Curve(), outside});
      runs.back().curve.push_back(piece);
    }
    auto whole = smooth(Run{input, runs.size() == 1 && runs.front().outside});
    if (!whole) return std::move(whole).unexpected();
    if (*whole || runs.size() <= 1)
      return SmoothedCurve{whole->value_or(input), whole->has_value()};
    SmoothedCurve result{Curve(), false};
    for (const Run& run : runs) {
      const auto smoothed = smooth(run);
      if (!smoothed) return Unexpected{smoothed.error()};
      const Curve& part = *smoothed ? **smoothed : run.curve;
      for (const Piece& piece : part.pieces()) result.curve.push_back(piece);
    }
    return result;
  }

 private:
  struct Run {
    Curve curve;
    bool outside;
  };

  bool is_outside(const Piece& piece) {
    const auto* line = piece.get_if<Segment>();
    if (line == nullptr || !zone_.is_outside(space_, line->a, line->b)) return false;
    const S* wide = space_outside();
    return wide == nullptr || wide->segment_free(line->a, line->b);
  }

  /// The space of which the zone is part; null if it cannot be had. Built at the first call.
  const S* space_outside() {
    if constexpr (AdjustableSpace<S>) {
      if (!std::exchange(is_built_, true)) {
        auto wide = space_.with_safety_radius(space_.safety_radius() + zone_.width);
        if (wide) wide_.emplace(std::move(*wide));
      }
    }
    return wide_ ? &*wide_ : nullptr;
  }

  std::optional<S> at_radius(double radius) const {
    if constexpr (AdjustableSpace<S>) {
      if (auto space = space_.with_safety_radius(radius)) return std::move(*space);
    }
    return std::nullopt;
  }

  /// The run, smoothed; nothing if the result is worse.
  Expected<std::optional<Curve>, Failure> smooth(const Run& run) {
    if (run.outside) {
      const S* wide = space_outside();
      auto smoothed = smooth_in(wide != nullptr ? *wide : space_, run.curve);
      if (smoothed && *smoothed && wide == nullptr && !stays_outside(**smoothed)) {
        return std::optional<Curve>();
      }
      return smoothed;
    }
    const double clearance = certify(space_, run.curve, {}, budget_).lower;
    if (clearance > space_.safety_radius()) {
      if (const auto narrow = at_radius(clearance)) return smooth_in(*narrow, run.curve);
    }
    return smooth_in(space_, run.curve);
  }

  Expected<std::optional<Curve>, Failure> smooth_in(const S& space, const Curve& run) const {
    auto smoothed = smoother_.smooth(space, run, budget_);
    if (smoothed && cost(*smoothed) <= cost(run) * (1 + zone_.tolerance)) {
      return std::optional(std::move(*smoothed));
    }
    if (smoothed || smoothed.error().code == PlanError::invalid_input) {
      return std::optional<Curve>();
    }
    return std::move(smoothed).unexpected();
  }

  bool stays_outside(const Curve& curve) const {
    const double distance = space_.safety_radius() + zone_.width;
    return std::all_of(curve.pieces().begin(), curve.pieces().end(), [&](const Piece& any) {
      return any.visit([&](const auto& piece) {
        return prove_distance(space_, piece, distance).status == ProofStatus::proved;
      });
    });
  }

  double cost(const Curve& curve) const {
    return curve.length() + zone_.weight * zone_.integral(space_, curve).value;
  }

  const S& space_;
  const Smooth& smoother_;
  const RiskZone& zone_;
  const Budget& budget_;
  bool is_built_ = false;
  std::optional<S> wide_{};
};

/// Smooths a route's curve; with RiskRuns if the search avoided a risk zone.
template <ClearanceSpace S, Smoother<S> Smooth>
Expected<SmoothedCurve, Failure> smooth_outside_risk(const S& space, const Smooth& smoother,
                                                     const Route& route, const Budget& budget) {
  if (!(route.risk_width > 0) || std::same_as<Smooth, NoSmoothing>) {
    auto curve = smoother.smooth(space, route.curve, budget);
    if (!curve) return std::move(curve).unexpected();
    return SmoothedCurve{std::move(*curve)};
  }
  const RiskZone zone{.width = route.risk_width, .weight = route.risk_weight};
  return RiskRuns<S, Smooth>(space, smoother, zone, budget).smooth(route.curve);
}

}  // namespace tutavia::detail
