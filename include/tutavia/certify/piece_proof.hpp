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
/// prove_distance: decides whether one piece keeps a distance from all obstacles.

namespace tutavia {

/// The verdict on one piece.
struct PieceProof {
  ProofStatus status = ProofStatus::undecided;
  double parameter = 0;  ///< of a violating point, in [0, 1]
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

/// A stack of unproved parts. Depth-first search holds one sibling per level.
template <class P>
class PartStack {
 public:
  static constexpr int max_depth = 40;  // deviations fall below rounding much earlier

  explicit PartStack(const P& piece) : parts_{Part<P>{piece, 0, 1, 0}} {}

  bool empty() const { return size_ == 0; }
  Part<P> pop() { return parts_[--size_]; }
  /// Pushes both halves; the one with the parameter `nearest` of the part comes first.
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

/// Pieces that are refined by halving; for segments and arcs distances have a closed form.
template <class P>
concept Divisible = requires(const P& piece) {
  piece.halves();
  piece.deviation();
};

/// Error bounds of the computed points of a piece, and of its computed deviation [m].
struct PieceError {
  double whole = 0;        ///< of the whole piece
  double per_halving = 0;  ///< added by each halving, and by the final test

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

/// Proves a segment: one distance to the obstacles' boundaries, and for ties an exact test: that of
/// the space at its own safety radius, at others every feature near.
template <ClearanceSpace S>
PieceProof prove(const S& space, const Segment& segment, double distance, double error_bound,
                 std::size_t) {
  const NearestObstacle found = space.nearest(segment, distance + error_bound);
  PieceProof proof{ProofStatus::undecided, found.parameter, 1};
  if (found.distance >= distance + error_bound) {
    proof.status = space.is_inside(segment.a) ? ProofStatus::violated : ProofStatus::proved;
  } else if (found.distance < distance - error_bound) {
    proof.status = ProofStatus::violated;
  } else if (distance == space.safety_radius()) {
    if (space.segment_free(segment.a, segment.b)) {
      proof.status = ProofStatus::proved;
    } else if (distance > 0) {  // at radius 0 the space rejects some contacts that are no violation
      proof.status = ProofStatus::violated;
    }
  } else if constexpr (FeatureSpace<S>) {
    bool keeps = true;
    const Box near = segment.box().inflated(distance + 2 * error_bound);
    space.for_each_feature(near, [&](const Segment& core, double radius) {
      keeps = keeps && keeps_distance(segment, core, radius, distance, error_bound);
    });
    proof.status =
        keeps && !space.is_inside(segment.a) ? ProofStatus::proved : ProofStatus::violated;
  }
  return proof;
}

/// Proves an arc: one distance in closed form, and a test of its extremes against the bounds.
template <ClearanceSpace S>
PieceProof prove(const S& space, const Arc& arc, double distance, double error_bound, std::size_t) {
  const double error = error_bound + arc.evaluation_error();
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

/// Proves a curved piece, by halving while its chord and deviation do not decide.
template <ClearanceSpace S, Divisible P>
PieceProof prove(const S& space, const P& piece, double distance, double error_bound,
                 std::size_t max_evaluations) {
  const Box& bounds = space.bounds();
  const double magnitude = std::fmax(space.largest_coordinate(), piece.box().largest_coordinate());
  const PieceError rounding = piece_error(piece, magnitude);
  PieceProof proof;
  PartStack<P> stack(piece);
  bool undecided = false;
  while (!stack.empty()) {
    const Part<P> part = stack.pop();
    const double deviation = part.piece.deviation();
    const double error = error_bound + rounding.at(part.depth);
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
      undecided = true;  // another part may still be violated
    } else {
      stack.push_halves(part, found.parameter);
    }
  }
  proof.status = undecided ? ProofStatus::undecided : ProofStatus::proved;
  return proof;
}

}  // namespace detail

/// Decides whether every point of `piece` lies within the bounds and at `distance` or more from
/// every obstacle.
///
/// Segments and arcs need one distance. For other pieces, the clearance of a part lies within its
/// deviation of the distance between its chord and the obstacles; undecided parts are halved, which
/// divides the deviation by four. The space's exact test decides a segment within rounding of the
/// safety radius; a curved piece in that position is `undecided`. `violated` names a parameter
/// whose point is too close or out of bounds. NaN and infinity are never proved. \pre distance >= 0
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
  const double error_bound =
      std::fmax(space.distance_error_bound(), detail::distance_rounding_error(magnitude));
  PieceProof proof = detail::prove(space, piece, distance, error_bound, max_evaluations);
  // A connected path that avoids all edges is outside all polygons or inside one. (The exact test
  // of a segment, which may touch edges at radius 0, includes the interiors.)
  if constexpr (!std::is_same_v<P, Segment>) {
    if (proof.status == ProofStatus::proved && space.is_inside(piece.start())) {
      return {ProofStatus::violated, 0, proof.evaluations};
    }
  }
  return proof;
}

/// Whether the piece is proved free: within the bounds, at the space's safety radius.
template <ClearanceSpace S, class P>
bool is_proved_free(const S& space, const P& piece) {
  if constexpr (std::is_same_v<P, Segment>) {
    const Box& bounds = space.bounds();  // contain no NaN
    return bounds.contains(piece.a) && bounds.contains(piece.b) &&
           space.segment_free(piece.a, piece.b);  // exact, and faster than a distance
  } else {
    return prove_distance(space, piece, space.safety_radius()).status == ProofStatus::proved;
  }
}

}  // namespace tutavia
