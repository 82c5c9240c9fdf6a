// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "tutavia/certify/certificate.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// revalidate: proves a curve again after obstacles have changed, without proving all of it.

namespace tutavia {

/// The certificate of a curve after a change, and what it took.
struct Revalidation {
  /// Of the curve in the new space: status, interval, witness and meaning as `certify` gives them.
  /// `evaluations` counts the distances computed for the revalidation alone.
  Certificate certificate{};
  /// Indices of the pieces that are not proved in the new space, in order. If the budget ended, all
  /// pieces that were still to be proved are among them.
  std::vector<std::size_t> failed{};
  std::size_t proved_again = 0;  ///< number of pieces whose proof did not carry over
};

namespace detail {

/// Tests which pieces of a curve the changes of a space may concern.
template <ClearanceSpace S>
class ChangedSurroundings {
 public:
  ChangedSurroundings(const S& after, std::span<const Box> changed)
      : space_(after), changed_(changed) {}

  /// Whether a changed obstacle may be at `reach` from the piece, or nearer. Never wrong about a
  /// change that is.
  template <class P>
  bool reach(const P& piece, double reach) const {
    const Box box = piece.box();
    const double magnitude = std::fmax(space_.largest_coordinate(), box.largest_coordinate());
    const double error = error_bound(piece, magnitude);
    const Box zone = box.inflated(reach + error);
    return std::any_of(changed_.begin(), changed_.end(),
                       [&](const Box& b) { return b.meets(zone); });
  }

  /// Whether the whole piece lies within the bounds for sure.
  template <class P>
  bool is_within_bounds(const P& piece) const {
    const Box box = piece.box();
    const double magnitude = std::fmax(space_.largest_coordinate(), box.largest_coordinate());
    return space_.bounds().contains(box.inflated(piece_error(piece, magnitude).whole));
  }

  /// Error bound of a distance between a computed point of the piece and an obstacle [m].
  template <class P>
  double error_bound(const P& piece, double magnitude) const {
    return std::fmax(space_.distance_error_bound(), distance_rounding_error(magnitude)) +
           piece_error(piece, magnitude).at(0);
  }

 private:
  const S& space_;
  std::span<const Box> changed_;
};

/// Encloses the clearance of a proved curve. `certificate.upper` is valid before the call, and
/// `known_lower` bounds the clearance of all pieces for which `is_open(index)` is false.
template <ClearanceSpace S, class IsOpen>
void enclose_clearance(const S& space, const Curve& curve, const IsOpen& is_open,
                       double known_lower, const CertifyOptions& options,
                       Certificate& certificate) {
  ClearanceInterval<S> interval(space, options, certificate);
  bool all_open = true;
  for (std::size_t i = 0; i < curve.pieces().size(); ++i) {
    if (!is_open(i)) {
      all_open = false;
      continue;
    }
    curve.pieces()[i].visit([&](const auto& piece) { interval.add(piece, i); });
  }
  if (!all_open) certificate.lower = std::min(certificate.lower, known_lower);
  certificate.lower = std::max(certificate.lower, space.safety_radius());
  certificate.upper = std::max(certificate.upper, certificate.lower);
}

/// Evaluates the witness of an earlier certificate in a new space. The certificate then has it as
/// its witness, with a valid upper bound. \pre `before.upper` is finite
template <ClearanceSpace S>
void evaluate_witness(const S& after, const Curve& curve, const Certificate& before,
                      Certificate& certificate) {
  const NearestObstacle found =
      after.nearest(Segment{before.point, before.point}, std::numeric_limits<double>::infinity());
  ++certificate.evaluations;
  const ChangedSurroundings<S> surroundings(after, {});
  const double error = curve.pieces()[before.piece].visit([&](const auto& piece) {
    return surroundings.error_bound(
        piece, std::fmax(after.largest_coordinate(), piece.box().largest_coordinate()));
  });
  certificate.upper = found.distance + error;
  certificate.point = before.point;
  certificate.piece = before.piece;
  certificate.parameter = before.parameter;
  certificate.obstacle = found.obstacle;
  certificate.edge = found.edge;
}

/// Proves the pieces for which `is_open(piece)` holds, and lists those that fail. Returns
/// false if the budget ended. The first piece that fails gives the certificate its status.
template <ClearanceSpace S, class IsOpen>
bool prove_pieces(const S& space, const Curve& curve, const IsOpen& is_open,
                  const CertifyOptions& options, const Budget& budget, Revalidation& result) {
  Certificate& certificate = result.certificate;
  bool goes_on = true;
  for (std::size_t i = 0; i < curve.pieces().size(); ++i) {
    const Piece& any = curve.pieces()[i];
    if (!any.visit(is_open)) continue;
    ++result.proved_again;
    if (result.proved_again % 64 == 1) goes_on = goes_on && !budget.exceeded();
    PieceProof proof;
    const bool has_gap = i > 0 && start_of(any) != end_of(curve.pieces()[i - 1]);
    if (goes_on && !has_gap) {
      proof = any.visit([&](const auto& piece) {
        return prove_distance(space, piece, space.safety_radius(),
                              options.max_evaluations_per_piece);
      });
    }
    certificate.evaluations += proof.evaluations;
    if (proof.status == ProofStatus::proved) continue;
    result.failed.push_back(i);
    if (result.failed.size() > 1) continue;
    certificate.status = proof.status;
    certificate.piece = i;
    certificate.parameter = proof.parameter;
    certificate.point = any.visit([&](const auto& p) { return p.point(proof.parameter); });
    if (proof.status == ProofStatus::violated) {
      certificate.upper = space.clearance(certificate.point) + certificate.distance_error_bound;
    }
  }
  return goes_on;
}

}  // namespace detail

/// Proves a curve in a space in which some obstacles were added, removed or moved, given its
/// certificate `before` from the earlier space.
///
/// A piece is proved again only if a changed box meets its own box, grown by the safety radius and
/// the rounding errors. The interval around the clearance is narrowed again only for pieces with a
/// change within the earlier upper bound; if the obstacle that gave that bound is gone, for all
/// pieces. Without a change near the curve it takes one distance, and without any change none. O(n
/// k) tests of boxes for n pieces and k boxes.
///
/// `changed` must cover every obstacle that only one of the two spaces has, and both positions of
/// an obstacle that moved; `changed_boxes` computes it for two workspaces. If it misses an
/// obstacle, the certificate is wrong. `before` must be the curve's own. Everything is proved again
/// if `before` is not proved, if the new safety radius exceeds its lower bound, or if the rounding
/// error of a distance (so the largest coordinate) differs. Pieces that are not wholly inside the
/// new bounds are proved again, too. The result is `undecided` if `budget` runs out.
///
/// Example: examples/repair.cpp.
template <ClearanceSpace S>
Revalidation revalidate(const S& after, const Curve& curve, const Certificate& before,
                        std::span<const Box> changed, const Budget& budget = {},
                        const CertifyOptions& options = {}) {
  const double radius = after.safety_radius();
  const bool carries_over = before.status == ProofStatus::proved && !curve.empty() &&
                            before.distance_error_bound == after.distance_error_bound() &&
                            radius <= before.lower;
  const detail::ChangedSurroundings<S> surroundings(after, changed);
  Revalidation result;
  Certificate& certificate = result.certificate;
  certificate.distance_error_bound = after.distance_error_bound();
  if (curve.empty()) return result;
  const auto is_open = [&](const auto& piece) {
    return !carries_over || surroundings.reach(piece, radius) ||
           !surroundings.is_within_bounds(piece);
  };
  const bool is_complete = detail::prove_pieces(after, curve, is_open, options, budget, result);
  if (!is_complete || !result.failed.empty()) return result;
  certificate.status = ProofStatus::proved;
  if (carries_over && changed.empty()) {
    const std::size_t evaluations = certificate.evaluations;
    certificate = before;
    certificate.evaluations = evaluations;
    return result;
  }
  bool has_witness = carries_over && std::isfinite(before.upper);
  if (has_witness) {
    detail::evaluate_witness(after, curve, before, certificate);
    // Without its obstacle the witness may be farther from all others than the rest of the curve.
    has_witness = certificate.upper <= before.upper + 4 * before.distance_error_bound;
  }
  detail::enclose_clearance(
      after, curve,
      [&](std::size_t i) {
        return !has_witness || curve.pieces()[i].visit([&](const auto& piece) {
          return surroundings.reach(piece, certificate.upper);
        });
      },
      before.lower, options, certificate);
  return result;
}

}  // namespace tutavia
