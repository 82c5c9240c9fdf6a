// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "tutavia/certify/certificate.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// Decides whether one piece keeps a distance from all obstacles.

namespace tutavia {

/// The verdict on one piece.
struct PieceProof {
  ProofStatus status = ProofStatus::undecided;
  double parameter = 0;  ///< violated: where, in [0, 1]
  std::size_t evaluations = 0;
};

namespace detail {

/// A part of a piece, over the parameters [from, to].
template <class P>
struct Part {
  P piece;
  double from = 0;
  double to = 1;
  int depth = 0;

  double parameter(double local) const { return from + local * (to - from); }
};

/// Parts still to be looked at. Depth-first search holds one sibling per level.
template <class P>
class PartStack {
 public:
  static constexpr int max_depth = 40;  // halving takes deviations below rounding long before

  explicit PartStack(const P& piece) : parts_{Part<P>{piece, 0, 1, 0}}, size_(1) {}

  bool empty() const { return size_ == 0; }
  Part<P> pop() { return parts_[--size_]; }
  /// Puts both halves on the stack, the first on top.
  void push_halves(const Part<P>& part) {
    const auto [left, right] = part.piece.halves();
    const double middle = part.parameter(0.5);
    parts_[size_++] = {right, middle, part.to, part.depth + 1};
    parts_[size_++] = {left, part.from, middle, part.depth + 1};
  }

 private:
  std::array<Part<P>, max_depth + 2> parts_;
  std::size_t size_;
};

/// How far a computed part of a piece can be from the true one, and its computed deviation from the
/// true deviation [m]: six roundings per halving and as many at the end.
inline double part_error(int depth, double magnitude) {
  return 6 * (depth + 1) * 0x1p-53 * magnitude;
}

}  // namespace detail

/// Decides whether every point of `piece` lies within the bounds and at `distance` or more from
/// every obstacle.
///
/// For any part of the piece with chord S and deviation dev from it, the clearance lies within dev
/// of the distance between S and the obstacles; parts that this leaves open are halved, which
/// divides dev by four. Straight pieces need one distance; where that is within rounding of the
/// safety radius they are decided by the space's exact test. `violated` names a parameter whose
/// point is closer or out of bounds. NaN and infinity are never proved. \pre distance >= 0
template <ClearanceSpace S, class P>
PieceProof prove_distance(const S& space, const P& piece, double distance,
                          std::size_t max_evaluations = 256) {
  using Part = detail::Part<P>;
  if (!piece.is_finite()) return {};
  const Box bounds = space.bounds();
  for (const double t : {0.0, 1.0}) {
    if (!bounds.contains(t == 0 ? piece.start() : piece.end())) {
      return {ProofStatus::violated, t, 0};
    }
  }
  // A connected path that meets no edge is outside all polygons or inside one.
  if (space.is_inside(piece.start())) return {ProofStatus::violated, 0, 0};

  const double magnitude = std::fmax(space.magnitude(), piece.box().magnitude());
  const double slack = 16 * 0x1p-53 * magnitude;
  PieceProof proof;
  if constexpr (std::is_same_v<P, Segment>) {
    proof.evaluations = 1;
    const Proximity found = space.nearest(piece, distance + slack);
    if (found.distance >= distance + slack) {
      proof.status = ProofStatus::proved;
    } else if (found.distance < distance - slack) {
      proof = {ProofStatus::violated, found.parameter, 1};
    } else if (distance == space.safety_radius()) {
      const bool free = space.segment_free(piece.a, piece.b);
      proof = {free ? ProofStatus::proved : ProofStatus::violated, found.parameter, 1};
    }
    return proof;
  } else {
    detail::PartStack<P> stack(piece);
    bool open = false;
    while (!stack.empty()) {
      const Part part = stack.pop();
      const double deviation = part.piece.deviation();
      const double error = slack + detail::part_error(part.depth, magnitude);
      const double margin = deviation + error;
      if (!std::isfinite(margin) || proof.evaluations == max_evaluations) return proof;
      const Box hull = part.depth == 0 ? part.piece.box() : part.piece.box().inflated(error);
      const bool within = bounds.contains(hull);
      ++proof.evaluations;
      const Segment chord{part.piece.start(), part.piece.end()};
      const Proximity found = space.nearest(chord, distance + margin);
      if (within && found.distance >= distance + margin) continue;
      if (found.distance < distance - margin) {
        proof.status = ProofStatus::violated;
        proof.parameter = part.parameter(found.parameter);
        return proof;
      }
      if (!bounds.inflated(error).contains(part.piece.end())) {
        proof.status = ProofStatus::violated;
        proof.parameter = part.to;
        return proof;
      }
      if (deviation <= error || part.depth == detail::PartStack<P>::max_depth) {
        open = true;  // too close to call here; another part may still be violated
      } else {
        stack.push_halves(part);
      }
    }
    proof.status = open ? ProofStatus::undecided : ProofStatus::proved;
    return proof;
  }
}

/// Whether the piece is proved to be in free space: at the space's safety radius, within the
/// bounds.
template <ClearanceSpace S, class P>
bool is_proved_free(const S& space, const P& piece) {
  return prove_distance(space, piece, space.safety_radius()).status == ProofStatus::proved;
}

}  // namespace tutavia
