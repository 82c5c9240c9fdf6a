// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/certify/revalidate.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/smooth/route/curve_side.hpp"
#include "tutavia/smooth/taut_string.hpp"

/// \file
/// repair: a plan for a space whose obstacles have changed, with as much of an earlier plan as can
/// be kept.

namespace tutavia {

/// The same for a plan's curve and certificate. The path of a vehicle is certified as a whole: then
/// all of its pieces have failed, or none has.
template <ClearanceSpace S>
Revalidation revalidate(const S& after, const Plan& plan, std::span<const Box> changed,
                        const Budget& budget = {}, const CertifyOptions& options = {}) {
  if (!plan.route.vehicle) {
    return revalidate(after, plan.curve, plan.certificate, changed, budget, options);
  }
  const auto proof = certify(after, *plan.route.vehicle, {plan.curve, plan.gears}, options, budget);
  Revalidation result{proof.clearance, {}, plan.gears.size()};
  result.certificate.status = proof.status;
  for (std::size_t i = 0; proof.status != ProofStatus::proved && i < plan.gears.size(); ++i) {
    result.failed.push_back(i);
  }
  return result;
}

namespace detail {

/// Whether a plan has the headings that a query asks for (to 1e-12 rad).
inline bool has_headings_of(const Plan& plan, const Query& query) {
  if (plan.gears.empty()) return !query.start_heading && !query.goal_heading;
  const VehiclePath path{plan.curve, plan.gears};
  const auto is_same = [](const std::optional<double>& asked, double heading) {
    return !asked || std::abs(wrapped_angle(*asked - heading)) <= 1e-12;
  };
  return is_same(query.start_heading, path.start().heading) &&
         is_same(query.goal_heading, path.end().heading);
}

}  // namespace detail

/// What a repair had to do.
enum class RepairKind : std::uint8_t {
  kept,           ///< nothing: the whole curve is proved in the new space
  searched_part,  ///< searched a way around the pieces that failed, and kept both ends
  planned_anew,   ///< planned anew from start to goal
};

/// A plan for the new space, and what it has from the earlier plan.
struct Repaired {
  /// Pieces of the earlier curve, equal in all their numbers.
  struct Kept {
    std::size_t pieces = 0;
    double length = 0;  ///< [m]
  };

  Plan plan{};
  RepairKind kind = RepairKind::planned_anew;
  Kept at_start{};  ///< all pieces if the whole curve was kept
  Kept at_end{};    ///< none if the whole curve was kept
};

/// Limits of what a repair accepts. If a part exceeds them, the repair searches between points that
/// are farther apart, and in the end plans anew.
struct RepairOptions {
  /// Largest length of a new part, in lengths of the part that it replaces.
  double max_detour = 2;
  /// Largest distance along the curve between the points of a search, in lengths of the curve.
  double largest_part = 0.6;
};

namespace detail {

/// Turns up to this much between two pieces count as smooth [rad].
inline constexpr double smooth_turn = 1e-7;

/// One repair: see `repair`.
template <ClearanceSpace S, class Search, class Smooth>
class CurveRepair {
 public:
  CurveRepair(Planner<Search, Smooth>& planner, const S& space, const Plan& old, const Query& query,
              const RepairOptions& options)
      : planner_(planner),
        space_(space),
        old_(old),
        query_(query),
        options_(options),
        is_polyline_(is_polyline(old.curve)) {
    stats_.seed = query.seed;
  }

  /// Searches around the pieces from `first` to `last`. Nothing: no part was good enough.
  Expected<std::optional<Repaired>, Failure> around(std::size_t first, std::size_t last) {
    first_ = first;
    last_ = old_.curve.pieces().size() - 1 - last;
    for (const std::size_t spare : {std::size_t{1}, std::size_t{4}}) {
      spare_front_ = spare_back_ = spare;
      if (!set_anchors() || replaced_length() > options_.largest_part * old_.curve.length()) break;
      auto local = planner_.plan(space_, query_between(from_.point, to_.point));
      add(local ? local->stats : local.error().stats);
      if (!local) {
        const PlanError code = local.error().code;
        if (code != PlanError::cancelled && code != PlanError::budget_exhausted) continue;
        local.error().stats = stats_;
        return std::move(local).unexpected();
      }
      if (turns_back(local->route.curve)) continue;
      if (auto joined = smooth_and_join(*local)) return joined;
      if (auto joined = pull_and_join(*local)) return joined;
    }
    return std::optional<Repaired>();
  }

  /// Plans from start to goal. The statistics include all earlier searches.
  Expected<Repaired, Failure> anew() {
    auto plan = planner_.plan(space_, query_between(query_.start, query_.goal));
    if (!plan) {
      add(plan.error().stats);
      plan.error().stats = stats_;
      return std::move(plan).unexpected();
    }
    add(plan->stats);
    plan->stats = stats_;
    return Repaired{std::move(*plan), RepairKind::planned_anew, {}, {}};
  }

 private:
  using Clock = std::chrono::steady_clock;

  void add(const Statistics& other) {
    stats_.distinct = stats_.expanded == 0 ? other.distinct : std::nullopt;
    stats_.expanded += other.expanded;
    stats_.generated += other.generated;
    stats_.search_us += other.search_us;
    stats_.smooth_us += other.smooth_us;
    stats_.certify_us += other.certify_us;
  }
  static double micros_since(Clock::time_point begin) {
    return std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
  }

  /// The query between two points, within what is left of the budget.
  Query query_between(const Point& start, const Point& goal) const {
    Query query = query_;
    query.start = start;
    query.goal = goal;
    query.budget.max_expansions -= std::min(stats_.expanded, query.budget.max_expansions);
    return query;
  }

  /// Sets the anchors. Returns false if nothing of the curve would stay.
  bool set_anchors() {
    from_ = CurveSide(old_.curve, false).anchor(first_, spare_front_, is_polyline_);
    to_ = CurveSide(old_.curve, true).anchor(last_, spare_back_, is_polyline_);
    return from_.stub || to_.stub;
  }

  /// Joins what the planner made of the part.
  std::optional<Repaired> smooth_and_join(const Plan& local) {
    front_fits_ = back_fits_ = false;
    if (!local.fell_back) {
      if (auto joined = join(local.curve, false, local.route.curve, local)) return joined;
    }
    if constexpr (std::same_as<Smooth, NoSmoothing>) {
      return std::nullopt;
    } else {
      // A smoother of corners keeps the directions at both ends if it begins on the stubs.
      const auto begin = Clock::now();
      const auto smoothed =
          planner_.smoother().smooth(space_, with_leads(local.route.curve), query_.budget);
      stats_.smooth_us += micros_since(begin);
      if (!smoothed) return std::nullopt;
      const bool front = front_fits_, back = back_fits_;
      auto joined = join(*smoothed, true, local.route.curve, local);
      front_fits_ = front;
      back_fits_ = back;
      return joined;
    }
  }

  /// Moves the anchors outwards where the directions differ, and pulls the part together with the
  /// earlier curve up to the new anchors taut.
  std::optional<Repaired> pull_and_join(const Plan& local) {
    if constexpr (FeatureSpace<S>) {
      const RepairAnchor inner_from = from_, inner_to = to_;
      for (int i = 0; i < 3 && !is_polyline_ && !(front_fits_ && back_fits_); ++i) {
        if (!front_fits_) spare_front_ *= 2;
        if (!back_fits_) spare_back_ *= 2;
        if (!set_anchors()) return std::nullopt;
        const auto begin = Clock::now();
        const auto pulled = pull(local.route.curve, inner_from, inner_to);
        stats_.smooth_us += micros_since(begin);
        if (!pulled) return std::nullopt;
        if (auto joined = join(pulled->second, false, pulled->first, local)) return joined;
      }
    }
    return std::nullopt;
  }

  /// The taut string along the earlier curve, the route between the inner anchors and the earlier
  /// curve again; and the planner's curve for it.
  std::optional<std::pair<Curve, Curve>> pull(const Curve& route, const RepairAnchor& inner_from,
                                              const RepairAnchor& inner_to) const {
    Curve string;
    const auto before = CurveSide(old_.curve, false).corners(from_, inner_from);
    const auto after = CurveSide(old_.curve, true).corners(to_, inner_to);
    for (std::size_t i = 1; i < before.size(); ++i) {
      string.push_back(Segment{before[i - 1], before[i]});
    }
    for (const Piece& piece : route.pieces()) string.push_back(piece);
    for (std::size_t i = after.size(); i-- > 1;) string.push_back(Segment{after[i], after[i - 1]});
    auto taut = TautString{}.smooth(space_, string, query_.budget);
    if (!taut) return std::nullopt;
    if constexpr (std::same_as<Smooth, NoSmoothing> || std::same_as<Smooth, TautString>) {
      return std::pair(*taut, *taut);
    } else {
      auto smoothed = planner_.smoother().smooth(space_, *taut, query_.budget);
      if (!smoothed) return std::nullopt;
      return std::pair(std::move(*taut), std::move(*smoothed));
    }
  }

  /// Whether the new route begins or ends against the direction of the earlier curve.
  bool turns_back(const Curve& route) const {
    const auto leaves = [](const RepairAnchor& anchor, const Point& direction) {
      return anchor.stub && (anchor.stub->b - anchor.stub->a).dot(direction) < 0;
    };
    const Point first = route.pieces().front().visit(
        [](const auto& piece) -> Point { return piece.start_direction(); });
    const Point last = route.pieces().back().visit(
        [](const auto& piece) -> Point { return piece.end_direction(); });
    return leaves(from_, first) || leaves(to_, -last);
  }

  Curve with_leads(const Curve& route) const {
    Curve curve;
    if (from_.stub) curve.push_back(from_.stub->part(0.5, 1));
    for (const Piece& piece : route.pieces()) curve.push_back(piece);
    if (to_.stub) curve.push_back(to_.stub->part(0.5, 1).reversed());
    return curve;
  }

  /// The pieces between those that stay: `middle` and both stubs, or the halves of them that
  /// `middle` lacks.
  std::vector<Piece> new_pieces(const Curve& middle, bool has_leads) const {
    std::vector<Piece> pieces;
    const double cut = has_leads ? 0.5 : 1;
    if (from_.stub) pieces.emplace_back(from_.stub->part(0, cut));
    for (const Piece& piece : middle.pieces()) pieces.push_back(piece);
    if (to_.stub) pieces.emplace_back(to_.stub->part(0, cut).reversed());
    return pieces;
  }

  /// Whether the new pieces may be joined to the earlier ones: without a corner where the earlier
  /// curve was straight, and without too long a detour.
  bool fit(const std::vector<Piece>& pieces) {
    const double limit = is_polyline_ ? std::numbers::pi / 2 : smooth_turn;
    const std::size_t n = pieces.size();
    front_fits_ = !from_.stub || turn_between(pieces[0], pieces[1]) <= limit;
    back_fits_ = !to_.stub || turn_between(pieces[n - 2], pieces[n - 1]) <= limit;
    double length = 0;
    for (const Piece& piece : pieces)
      length += piece.visit([](const auto& p) { return p.length(); });
    return front_fits_ && back_fits_ && length <= options_.max_detour * replaced_length();
  }

  /// The length of the earlier curve between the kept pieces [m].
  double replaced_length() const {
    const std::size_t end = old_.curve.pieces().size() - to_.kept;
    return old_.curve.length_before(end) - old_.curve.length_before(from_.kept);
  }

  bool prove(const std::vector<Piece>& pieces, Certificate& certificate) const {
    return std::all_of(pieces.begin(), pieces.end(), [&](const Piece& any) {
      const PieceProof proof = any.visit(
          [&](const auto& piece) { return prove_distance(space_, piece, space_.safety_radius()); });
      certificate.evaluations += proof.evaluations;
      return proof.status == ProofStatus::proved;
    });
  }

  /// The earlier curve with `pieces` between what stays of it.
  Curve with_ends(const std::vector<Piece>& pieces) const {
    const auto& old = old_.curve.pieces();
    Curve curve;
    curve.reserve(from_.kept + pieces.size() + to_.kept);
    for (std::size_t i = 0; i < from_.kept; ++i) curve.push_back(old[i]);
    for (const Piece& piece : pieces) curve.push_back(piece);
    for (std::size_t i = old.size() - to_.kept; i < old.size(); ++i) curve.push_back(old[i]);
    return curve;
  }

  /// Joins a new curve between the anchors (or, with leads, between the middles of the stubs) to
  /// what stays, and proves it. Nothing if it does not fit. `route` is the curve between the
  /// anchors before smoothing.
  std::optional<Repaired> join(const Curve& middle, bool has_leads, const Curve& route,
                               const Plan& local) {
    const auto begin = Clock::now();
    std::vector<Piece> pieces = new_pieces(middle, has_leads);
    if (!fit(pieces)) return std::nullopt;
    while (pieces.size() > 1 && merge_straight(pieces, 0)) continue;
    while (pieces.size() > 1 && merge_straight(pieces, pieces.size() - 2)) continue;
    Plan plan;
    if (!prove(pieces, plan.certificate)) return std::nullopt;
    plan.curve = with_ends(pieces);
    plan.metrics = measure(plan.curve);
    const double limit = std::max(smooth_turn, old_.metrics.max_joint_deflection);
    if (!(plan.metrics.max_joint_deflection <= limit)) return std::nullopt;
    plan.certificate.status = ProofStatus::proved;
    plan.certificate.distance_error_bound = space_.distance_error_bound();
    enclose_clearance(
        space_, plan.curve, [](std::size_t) { return true; }, 0, {}, plan.certificate);
    plan.metrics.min_clearance = plan.certificate.lower;
    plan.route = local.route;
    plan.route.curve = with_ends(new_pieces(route, false));
    plan.route.cost += plan.route.curve.length() - local.route.curve.length();
    plan.fell_back = old_.fell_back;
    stats_.certify_us += micros_since(begin);
    plan.stats = stats_;
    Repaired repaired{std::move(plan), RepairKind::searched_part, {}, {}};
    tell_kept(pieces, repaired);
    return repaired;
  }

  void tell_kept(const std::vector<Piece>& pieces, Repaired& repaired) const {
    const auto& old = old_.curve.pieces();
    const std::size_t front = from_.kept, back = to_.kept, n = old.size();
    const bool more_front = from_.stub && equal_segments(pieces.front(), old[front]);
    const bool more_back = to_.stub && equal_segments(pieces.back(), old[n - 1 - back]);
    repaired.at_start.pieces = front + (more_front ? 1 : 0);
    repaired.at_start.length = old_.curve.length_before(repaired.at_start.pieces);
    repaired.at_end.pieces = back + (more_back ? 1 : 0);
    repaired.at_end.length =
        old_.curve.length() - old_.curve.length_before(n - repaired.at_end.pieces);
  }

  Planner<Search, Smooth>& planner_;
  const S& space_;
  const Plan& old_;
  const Query& query_;
  const RepairOptions& options_;
  bool is_polyline_;
  Statistics stats_{};
  std::size_t first_ = 0, last_ = 0;  // pieces that failed, each counted from its end
  std::size_t spare_front_ = 1, spare_back_ = 1;
  RepairAnchor from_{}, to_{};
  bool front_fits_ = false, back_fits_ = false;  // whether the last part may be joined there
};

}  // namespace detail

/// Repairs the plan of an earlier space for the space `after`, given its revalidation there.
///
/// If all pieces are proved, the plan keeps its curve and gets the new certificate. Else the
/// planner searches and smooths a path around the pieces that failed, between two points of the
/// curve that stays (middles of straight pieces; waypoints of a polyline). The path joins both ends
/// without a corner where the curve was straight, and with none sharper than the earlier curve's.
/// It does not turn back where the two parts join, and is no longer than `max_detour` allows. If
/// there is no such path, the points move outwards, and in the end the planner plans anew. Curves
/// without straight pieces and plans that avoid a risk zone are always planned anew, and so is
/// another query than the plan's.
///
/// Guarantees: the plan is proved as Planner's are, and its interval and metrics are those of the
/// whole new curve. A part that was searched is only as short as its ends allow; and a plan that is
/// kept may be longer than a new one, for instance after an obstacle has vanished. Its statistics
/// are those of the repair. Takes a fraction of the time of a new plan if few pieces fail: see
/// docs/performance.md.
///
/// Tables that the planner's search has prepared must be those of `after`. Errors: those of
/// Planner::plan. \pre the revalidation is that of the plan's curve in `after`
///
/// Example: examples/repair.cpp.
template <class Search, class Smooth, detail::PlannableSpace<Search, Smooth> S>
Expected<Repaired, Failure> repair(Planner<Search, Smooth>& planner, const S& after,
                                   const Plan& plan, const Revalidation& revalidation,
                                   const Query& query, const RepairOptions& options = {}) {
  if (query.budget.cancelled()) return fail(PlanError::cancelled);
  const bool same_query = !plan.curve.empty() && plan.curve.start() == query.start &&
                          plan.curve.end() == query.goal && detail::has_headings_of(plan, query);
  if (same_query && revalidation.certificate.status == ProofStatus::proved) {
    Repaired kept{plan, RepairKind::kept, {plan.curve.pieces().size(), plan.curve.length()}, {}};
    kept.plan.certificate = revalidation.certificate;
    kept.plan.metrics.min_clearance = revalidation.certificate.lower;
    kept.plan.stats = {.seed = query.seed};
    return kept;
  }
  detail::CurveRepair<S, Search, Smooth> repairs(planner, after, plan, query, options);
  const bool may_join = !(plan.route.risk_width > 0) && !plan.route.vehicle;
  if (same_query && !revalidation.failed.empty() && may_join) {
    auto part = repairs.around(revalidation.failed.front(), revalidation.failed.back());
    if (!part) return std::move(part).unexpected();
    if (*part) return std::move(**part);
  }
  return repairs.anew();
}

}  // namespace tutavia
