// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

#include "tutavia/certify/certificate.hpp"
#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// certify: proves a curve safe, or names a violation.

namespace tutavia {

/// Accuracy and effort; the defaults suit maps from centimetres to kilometres.
struct CertifyOptions {
  double epsilon = 1e-6;  ///< target width of the interval around the clearance [m]
  std::size_t max_evaluations_per_piece = 256;
};

namespace detail {

/// Narrows the interval around the clearance of a whole curve, piece by piece: parts whose lower
/// bound cannot beat the best upper bound by more than epsilon are dropped, the others halved.
template <ClearanceSpace S>
class ClearanceInterval {
 public:
  ClearanceInterval(const S& space, const CertifyOptions& options, Certificate& certificate)
      : space_(space),
        epsilon_(std::max(options.epsilon, 4 * space.distance_error_bound())),
        max_evaluations_(options.max_evaluations_per_piece),
        out_(certificate) {
    out_.lower = std::numeric_limits<double>::infinity();
  }

  /// `error`: how far the piece may lie from the path that is meant [m].
  template <class P>
  void add(const P& piece, std::size_t index, double error = 0) {
    const double magnitude =
        std::fmax(space_.largest_coordinate(), piece.box().largest_coordinate());
    error_bound_ =
        std::fmax(space_.distance_error_bound(), distance_rounding_error(magnitude)) + error;
    error_ = piece_error(piece, magnitude);
    if constexpr (Divisible<P>) {
      PartStack<P> stack(piece);
      std::size_t evaluations = 0;
      while (!stack.empty()) {
        const Part<P> part = stack.pop();
        const Segment chord{part.piece.start(), part.piece.end()};
        const auto [lower, nearest] = narrow(piece, index, part, chord, part.piece.deviation());
        ++evaluations;
        if (lower >= out_.upper - epsilon_ || part.depth == PartStack<P>::max_depth ||
            evaluations >= max_evaluations_) {
          out_.lower = std::min(out_.lower, lower);
        } else {
          stack.push_halves(part, nearest);
        }
      }
    } else {
      out_.lower =
          std::min(out_.lower, narrow(piece, index, Part<P>{piece, 0, 1, 0}, piece, 0).lower);
    }
  }

 private:
  struct Narrowed {
    double lower;    // lower bound of the part's clearance
    double nearest;  // parameter of the nearest point, on the part
  };

  /// Computes the distance of one part from a substitute that deviates from it by at most
  /// `deviation`, and lowers the upper bound if possible.
  template <class P, class Substitute>
  Narrowed narrow(const P& piece, std::size_t index, const Part<P>& part,
                  const Substitute& substitute, double deviation) {
    const double margin = deviation + error_bound_ + error_.at(part.depth);
    const NearestObstacle found = space_.nearest(substitute, out_.upper + margin);
    ++out_.evaluations;
    if (found.distance + margin < out_.upper) {
      out_.upper = found.distance + margin;
      out_.piece = index;
      out_.parameter = part.parameter(found.parameter);
      out_.point = piece.point(out_.parameter);
      out_.obstacle = found.obstacle;
      out_.edge = found.edge;
    }
    return {found.distance - margin, found.parameter};
  }

  const S& space_;
  double epsilon_;
  std::size_t max_evaluations_;
  Certificate& out_;
  // Of the current piece.
  double error_bound_ = 0;
  PieceError error_;
};

/// Certifies `count` pieces at `distance` from obstacles. `visit(i, f)` calls `f(piece, error)`
/// with piece i in its own type and a bound on how far it may lie from the path that is meant [m].
template <ClearanceSpace S, class Visit>
Certificate certify_pieces(const S& space, std::size_t count, double distance, const Visit& visit,
                           const CertifyOptions& options, const Budget& budget) {
  Certificate certificate;
  certificate.distance_error_bound = space.distance_error_bound();
  for (std::size_t i = 0; i < count; ++i) {
    if (i % 64 == 0 && budget.exceeded()) return certificate;
    bool proved = false;
    visit(i, [&](const auto& piece, double error) {
      const PieceProof proof =
          prove_distance(space, piece, distance + error, options.max_evaluations_per_piece);
      certificate.evaluations += proof.evaluations;
      proved = proof.status == ProofStatus::proved;
      if (proved) return;
      certificate.status = proof.status;
      certificate.piece = i;
      certificate.parameter = proof.parameter;
      certificate.point = piece.point(proof.parameter);
      if (proof.status != ProofStatus::violated) return;
      if (error > 0) {  // too close by less than the error is no violation
        const double least = std::fmax(0, distance - error);
        certificate.status =
            prove_distance(space, piece, least, options.max_evaluations_per_piece).status;
        if (certificate.status != ProofStatus::violated) {
          certificate.status = ProofStatus::undecided;
          return;
        }
      }
      certificate.upper =
          space.clearance(certificate.point) + certificate.distance_error_bound + error;
      const NearestObstacle nearest = space.nearest(Segment{certificate.point, certificate.point},
                                                    std::numeric_limits<double>::infinity());
      certificate.obstacle = nearest.obstacle;
      certificate.edge = nearest.edge;
    });
    if (!proved) return certificate;
  }
  certificate.status = ProofStatus::proved;
  ClearanceInterval<S> interval(space, options, certificate);
  for (std::size_t i = 0; i < count; ++i) {
    // Out of time, the interval of a proved curve is worth finding still; cancelled, nothing is.
    if (i % 64 == 0 && budget.cancelled()) {
      return {.distance_error_bound = space.distance_error_bound()};
    }
    visit(i, [&](const auto& piece, double error) { interval.add(piece, i, error); });
  }
  certificate.lower = std::max(certificate.lower, distance);
  certificate.upper = std::max(certificate.upper, certificate.lower);
  return certificate;
}

/// Whether there is a gap between two pieces of a curve.
inline bool has_gap(const Curve& curve) {
  const auto& pieces = curve.pieces();
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    if (start_of(pieces[i]) != end_of(pieces[i - 1])) return true;
  }
  return false;
}

}  // namespace detail

/// Proves that the whole continuous curve lies within the bounds and keeps the space's safety
/// radius from every obstacle, and encloses its clearance in an interval of width `epsilon` (or of
/// the rounding error, if larger). A curve that comes closer than the safety radius anywhere is
/// never `proved`; `violated` names such a point. The result is `undecided` for a curve that is
/// empty or has a gap between two pieces, or if `budget` runs out.
///
/// Example: examples/06_certificate.cpp.
template <ClearanceSpace S>
Certificate certify(const S& space, const Curve& curve, const CertifyOptions& options = {},
                    const Budget& budget = {}) {
  if (curve.empty() || detail::has_gap(curve)) {
    return {.distance_error_bound = space.distance_error_bound()};
  }
  const auto visit = [&](std::size_t i, const auto& use) {
    curve.pieces()[i].visit([&](const auto& piece) { use(piece, 0.0); });
  };
  return detail::certify_pieces(space, curve.pieces().size(), space.safety_radius(), visit, options,
                                budget);
}

}  // namespace tutavia
