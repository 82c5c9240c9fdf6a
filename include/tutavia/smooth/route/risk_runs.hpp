// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <utility>

#include "tutavia/core/budget.hpp"
#include "tutavia/core/expected.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/search/risk_zone.hpp"
#include "tutavia/smooth/concepts.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// smooth_outside_risk: smooths a route without leading it into a risk zone.

namespace tutavia::detail {

/// A space that can be had at other safety radii.
template <class S>
concept AdjustableSpace = ClearanceSpace<S> && requires(const S& space, double radius) {
  { space.with_safety_radius(radius) } -> std::same_as<Expected<S, Failure>>;
};

/// Smooths a curve in runs of pieces outside a risk zone and runs of other pieces. For a run
/// outside, the zone is part of the obstacles if the space can be had at a larger safety radius. A
/// smoothed run that costs more than the run itself (length and weighted risk) is not used. Where
/// two runs meet, a corner of the curve stays. Errors: `invalid_option` of the smoother; those of
/// the budget.
template <ClearanceSpace S, Smoother<S> Smooth>
class RiskRuns {
 public:
  RiskRuns(const S& space, const Smooth& smoother, const RiskZone& zone, const Budget& budget)
      : space_(space), smoother_(smoother), zone_(zone), budget_(budget) {
    if constexpr (AdjustableSpace<S>) {
      auto wide = space.with_safety_radius(space.safety_radius() + zone.width);
      if (wide) wide_.emplace(std::move(*wide));
    }
  }

  Expected<Curve, Failure> smooth(const Curve& input) const {
    Curve result, run;
    bool outside = false;
    for (const Piece& piece : input.pieces()) {
      const bool is_out = is_outside(piece);
      if (!run.empty() && is_out != outside) {
        if (auto done = append(run, outside, result); !done) return std::move(done).unexpected();
        run = Curve();
      }
      outside = is_out;
      run.push_back(piece);
    }
    if (run.empty()) return result;
    if (auto done = append(run, outside, result); !done) return std::move(done).unexpected();
    return result;
  }

 private:
  bool is_outside(const Piece& piece) const {
    const auto* line = piece.get_if<Segment>();
    if (line == nullptr) return false;
    return wide_ ? wide_->segment_free(line->a, line->b)
                 : zone_.is_outside(space_, line->a, line->b);
  }

  Expected<void, Failure> append(const Curve& run, bool outside, Curve& result) const {
    auto smoothed = smoother_.smooth(outside && wide_ ? *wide_ : space_, run, budget_);
    if (!smoothed && smoothed.error().code != PlanError::invalid_input) {
      return std::move(smoothed).unexpected();
    }
    const bool is_better = smoothed && cost(*smoothed) <= cost(run) * (1 + zone_.tolerance);
    for (const Piece& piece : (is_better ? *smoothed : run).pieces()) result.push_back(piece);
    return {};
  }

  double cost(const Curve& curve) const {
    return curve.length() + zone_.weight * zone_.integral(space_, curve).value;
  }

  const S& space_;
  const Smooth& smoother_;
  const RiskZone& zone_;
  const Budget& budget_;
  std::optional<S> wide_{};
};

/// Smooths a route's curve; with RiskRuns if the search avoided a risk zone.
template <ClearanceSpace S, Smoother<S> Smooth>
Expected<Curve, Failure> smooth_outside_risk(const S& space, const Smooth& smoother,
                                             const Route& route, const Budget& budget) {
  if (!(route.risk_width > 0)) return smoother.smooth(space, route.curve, budget);
  const RiskZone zone{.width = route.risk_width, .weight = route.risk_weight};
  return RiskRuns<S, Smooth>(space, smoother, zone, budget).smooth(route.curve);
}

}  // namespace tutavia::detail
