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
#include "tutavia/world/workspace.hpp"

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

  explicit PartStack(const P& piece) : parts_{Part<P>{piece, 0, 1, 0}} {}

  bool empty() const { return size_ == 0; }
  Part<P> pop() { return parts_[--size_]; }
  /// Puts both halves on the stack; the one looked at next is that which holds `nearest`, a
  /// parameter of the part.
  void push_halves(const Part<P>& part, double nearest) {
    const auto [left, right] = part.piece.halves();
    const double middle = part.parameter(0.5);
    const Part<P> first{left, part.from, middle, part.depth + 1};
    const Part<P> second{right, middle, part.to, part.depth + 1};
    parts_[size_++] = nearest < 0.5 ? second : first;
    parts_[size_++] = nearest < 0.5 ? first : second;
  }

 private:
  std::array<Part<P>, max_depth + 2> parts_;
  std::size_t size_ = 1;
};

/// Pieces that are refined by halving; segments and arcs have distances in closed form.
template <class P>
concept Divisible = requires(const P& piece) {
  piece.halves();
  piece.deviation();
};

/// How far computed places of a piece can be from the true ones, and its computed deviation from
/// the true one [m].
struct PieceError {
  double whole = 0;        ///< of the piece as it is given
  double per_halving = 0;  ///< added by each halving, and by the last look

  double at(int depth) const { return whole + (depth + 1) * per_halving; }
};
inline PieceError piece_error(const Segment&, double) { return {}; }
inline PieceError piece_error(const Arc& arc, double) { return {arc.evaluation_error(), 0}; }
inline PieceError piece_error(const Clothoid& clothoid, double) {
  return {clothoid.evaluation_error(), clothoid.rounding()};
}
template <std::size_t Degree>
PieceError piece_error(const Bezier<Degree>&, double magnitude) {
  return {0, 6 * 0x1p-53 * magnitude};
}

/// A segment against the obstacles' boundaries: one distance, and the space's exact test for ties
/// at its own safety radius.
template <ClearanceSpace S>
PieceProof prove(const S& space, const Segment& segment, double distance, double slack,
                 std::size_t) {
  const NearestObstacle found = space.nearest(segment, distance + slack);
  PieceProof proof{ProofStatus::undecided, found.parameter, 1};
  if (found.distance >= distance + slack) {
    proof.status = space.is_inside(segment.a) ? ProofStatus::violated : ProofStatus::proved;
  } else if (found.distance < distance - slack) {
    proof.status = ProofStatus::violated;
  } else if (distance == space.safety_radius()) {
    if (space.segment_free(segment.a, segment.b)) {
      proof.status = ProofStatus::proved;
    } else if (distance > 0) {  // at radius 0 the space refuses some contacts that are no violation
      proof.status = ProofStatus::violated;
    }
  }
  return proof;
}

/// An arc: one distance in closed form, and its extremes against the bounds.
template <ClearanceSpace S>
PieceProof prove(const S& space, const Arc& arc, double distance, double slack, std::size_t) {
  const double error = slack + arc.evaluation_error();
  if (!std::isfinite(error)) return {};
  const NearestObstacle found = space.nearest(arc, distance + error);
  PieceProof proof{ProofStatus::proved, found.parameter, 1};
  if (found.distance < distance - error) {
    proof.status = ProofStatus::violated;
    return proof;
  }
  if (!(found.distance >= distance + error)) proof.status = ProofStatus::undecided;
  arc.for_each_extreme([&](double t) {
    const Point p = arc.point(t);
    if (proof.status == ProofStatus::violated || space.bounds().inflated(-error).contains(p)) {
      return;
    }
    const bool outside = !space.bounds().inflated(error).contains(p);
    proof.status = outside ? ProofStatus::violated : ProofStatus::undecided;
    if (outside) proof.parameter = t;
  });
  return proof;
}

/// A piece that is halved where its chord and its deviation leave the answer open.
template <ClearanceSpace S, Divisible P>
PieceProof prove(const S& space, const P& piece, double distance, double slack,
                 std::size_t max_evaluations) {
  const Box& bounds = space.bounds();
  const double magnitude = std::fmax(space.largest_coordinate(), piece.box().largest_coordinate());
  const PieceError rounding = piece_error(piece, magnitude);
  PieceProof proof;
  PartStack<P> stack(piece);
  bool open = false;
  while (!stack.empty()) {
    const Part<P> part = stack.pop();
    const double deviation = part.piece.deviation();
    const double error = slack + rounding.at(part.depth);
    const double margin = deviation + error;
    if (!std::isfinite(margin) || proof.evaluations == max_evaluations) return proof;
    const Box hull = part.piece.box().inflated(part.depth == 0 ? rounding.whole : error);
    const Segment chord{part.piece.start(), part.piece.end()};
    const NearestObstacle found = space.nearest(chord, distance + margin);
    ++proof.evaluations;
    if (bounds.contains(hull) && found.distance >= distance + margin) continue;
    if (found.distance < distance - margin) {
      return {ProofStatus::violated, part.parameter(found.parameter), proof.evaluations};
    }
    if (!bounds.inflated(error).contains(part.piece.end())) {
      return {ProofStatus::violated, part.to, proof.evaluations};
    }
    if (deviation <= error || part.depth == PartStack<P>::max_depth) {
      open = true;  // too close to call here; another part may still be violated
    } else {
      stack.push_halves(part, found.parameter);
    }
  }
  proof.status = open ? ProofStatus::undecided : ProofStatus::proved;
  return proof;
}

}  // namespace detail

/// Decides whether every point of `piece` lies within the bounds and at `distance` or more from
/// every obstacle.
///
/// Segments and arcs need one distance. For any part of another piece with chord S and deviation
/// dev from it, the clearance lies within dev of the distance between S and the obstacles; parts
/// that this leaves open are halved, which divides dev by four. A segment within rounding of the
/// safety radius is decided by the space's exact test; a curved piece in that position is
/// `undecided`. `violated` names a parameter whose point is closer or out of bounds. NaN and
/// infinity are never proved. \pre distance >= 0
template <ClearanceSpace S, class P>
PieceProof prove_distance(const S& space, const P& piece, double distance,
                          std::size_t max_evaluations = 256) {
  if (!piece.is_finite()) return {};
  const Box& bounds = space.bounds();
  for (const double t : {0.0, 1.0}) {
    if (!bounds.contains(t == 0 ? piece.start() : piece.end())) {
      return {ProofStatus::violated, t, 0};
    }
  }
  const double magnitude = std::fmax(space.largest_coordinate(), piece.box().largest_coordinate());
  const double slack = detail::distance_rounding_error(magnitude);
  PieceProof proof = detail::prove(space, piece, distance, slack, max_evaluations);
  // A connected path that keeps off all edges is outside all polygons or inside one. (The exact
  // test of a segment, which may touch edges at radius 0, has looked at the insides itself.)
  if constexpr (!std::is_same_v<P, Segment>) {
    if (proof.status == ProofStatus::proved && space.is_inside(piece.start())) {
      return {ProofStatus::violated, 0, proof.evaluations};
    }
  }
  return proof;
}

/// Whether the piece is proved to be in free space: at the space's safety radius, within the
/// bounds.
template <ClearanceSpace S, class P>
bool is_proved_free(const S& space, const P& piece) {
  return prove_distance(space, piece, space.safety_radius()).status == ProofStatus::proved;
}

}  // namespace tutavia
