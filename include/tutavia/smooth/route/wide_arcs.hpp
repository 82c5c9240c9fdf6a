// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/core/budget.hpp"
#include "tutavia/core/expected.hpp"
#include "tutavia/geometry/bezier.hpp"
#include "tutavia/geometry/curvature.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// WideArcs: rounds the vertices of a polyline by quadratic arcs that are as wide as space allows.

namespace tutavia::detail {

/// A vertex of a polyline that WideArcs may move away from an obstacle.
struct ArcVertex {
  Point at;
  Point outward = Point::Zero();  ///< unit vector away from the obstacle; zero: it may not move
  double room = 0;                ///< how far it may move [m]
};

/// Rounds every vertex of a polyline by one quadratic Bezier arc, whose ends lie at equal distances
/// from the vertex. First it drops vertices that are not needed and moves others outward, where
/// that makes the arcs wider.
///
/// Guarantees: the ends are exact; every arc and line is proved at the space's safety radius; the
/// direction is continuous but at vertices around which no arc is free. \pre every leg is proved
template <ClearanceSpace S>
class WideArcs {
 public:
  WideArcs(const S& space, std::vector<ArcVertex> path) : space_(space), path_(std::move(path)) {
    const auto same = [](const ArcVertex& a, const ArcVertex& b) { return a.at == b.at; };
    path_.erase(std::unique(path_.begin(), path_.end(), same), path_.end());
  }

  /// Errors: those of the budget.
  Expected<Curve, Failure> curve(const Budget& budget) {
    bends_.assign(path_.size(), 0);
    for (std::size_t k = 1; k + 1 < path_.size(); ++k) bends_[k] = bend_at(k);
    for (std::size_t k = 1; k + 1 < path_.size();) {
      if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "while smoothing");
      k = drop(k) ? std::max<std::size_t>(k - 1, 1) : k + 1;
    }
    for (std::size_t k = 1; k + 1 < path_.size(); ++k) {
      if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "while smoothing");
      move_outward(k);
    }
    if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "while smoothing");
    round_vertices();
    return assemble();
  }

 private:
  /// An arc around a vertex, from a parameter of the leg before it to one of the leg after it.
  struct Rounding {
    double begin = 1, end = 0;
    std::optional<QuadraticBezier> arc{};
  };

  /// The widest proved arc that starts at parameter `first` of the leg a, b or later and ends at
  /// parameter `last` of the leg b, c or earlier. Wider than `known`, or `known`.
  Rounding widest(const Point& a, const Point& b, const Point& c, double first, double last,
                  const Rounding& known) const {
    const Point u = b - a, v = c - b;
    if (!(std::abs(cross(u, v)) > 1e-9 * std::abs(u.dot(v)))) return known;  // nothing to round
    const double before = distance(a, b), after = distance(b, c);
    const double most = std::min((1 - first) * before, last * after);
    const auto rounding = [&](double reach) {
      Rounding result{1 - reach / before, reach / after};
      // Arcs that meet do so in one point.
      if (result.begin - first < 1e-9) result.begin = first;
      if (last - result.end < 1e-9) result.end = last;
      result.arc = QuadraticBezier{{lerp(a, b, result.begin), b, lerp(b, c, result.end)}};
      return result;
    };
    Rounding best = known;
    double low = known.end * after, high = most;
    for (int tries = 0; tries <= 8 && high > low; ++tries) {
      const double reach = tries == 0 ? most : low + (high - low) / 2;
      const Rounding candidate = rounding(reach);
      if (candidate.begin < 1 && candidate.end > 0 && is_proved_free(space_, *candidate.arc)) {
        best = candidate;
        low = reach;
      } else {
        high = reach;
      }
    }
    return best;
  }

  /// The curvature of the widest arc around b that takes at most half of each leg; infinite if the
  /// corner at b cannot be rounded.
  double bend(const Point& a, const Point& b, const Point& c) const {
    const Rounding rounding = widest(a, b, c, 0.5, 0.5, {});
    if (rounding.arc) return max_curvature(*rounding.arc);
    const Point u = b - a, v = c - b;
    const bool is_straight = std::abs(cross(u, v)) <= 1e-9 * u.dot(v);
    return is_straight ? 0 : std::numeric_limits<double>::infinity();
  }
  double bend_at(std::size_t k) const {
    return bend(path_[k - 1].at, path_[k].at, path_[k + 1].at);
  }

  /// Drops vertex k if its neighbours see each other. One at an obstacle's corner goes only if the
  /// path does not become sharper.
  bool drop(std::size_t k) {
    if (!space_.segment_free(path_[k - 1].at, path_[k + 1].at)) return false;
    const std::size_t end = path_.size() - 1;
    const double before =
        k > 1 ? bend(path_[k - 2].at, path_[k - 1].at, path_[k + 1].at) : bends_[k - 1];
    const double after =
        k + 1 < end ? bend(path_[k - 1].at, path_[k + 1].at, path_[k + 2].at) : bends_[k + 1];
    const double now = std::max({bends_[k - 1], bends_[k], bends_[k + 1]});
    if (!is_zero(path_[k].outward) && std::max(before, after) > now) return false;
    erase(k);
    bends_[k - 1] = before;
    bends_[k] = after;
    if (path_[k - 1].at == path_[k].at) {  // the path went there and back
      erase(k);
      if (k > 1 && k < path_.size()) bends_[k - 1] = bend_at(k - 1);
    }
    return true;
  }

  void erase(std::size_t k) {
    path_.erase(path_.begin() + static_cast<std::ptrdiff_t>(k));
    bends_.erase(bends_.begin() + static_cast<std::ptrdiff_t>(k));
  }

  /// Moves vertex k outward to where its arc is widest. A longer path has to be worth it.
  void move_outward(std::size_t k) {
    constexpr int tries = 10;
    constexpr double worth = 0.9;
    const ArcVertex vertex = path_[k];
    const Point &a = path_[k - 1].at, &c = path_[k + 1].at;
    double least = bend_at(k);
    if (is_zero(vertex.outward) || !(vertex.room > 0)) return;
    for (int i = 1; i <= tries; ++i) {
      const Point moved = offset_along(vertex.at, vertex.room * i / tries, vertex.outward);
      if (!space_.segment_free(a, moved) || !space_.segment_free(moved, c)) return;
      const double bent = bend(a, moved, c);
      if (!(bent < worth * least)) continue;
      least = bent;
      path_[k].at = moved;
    }
  }

  /// Gives each vertex half of its legs, then what its neighbours leave.
  void round_vertices() {
    roundings_.assign(path_.size(), {});
    for (std::size_t k = 1; k + 1 < path_.size(); ++k) {
      roundings_[k] = widest(path_[k - 1].at, path_[k].at, path_[k + 1].at, 0.5, 0.5, {});
    }
    for (std::size_t k = 1; k + 1 < path_.size(); ++k) {
      roundings_[k] = widest(path_[k - 1].at, path_[k].at, path_[k + 1].at, roundings_[k - 1].end,
                             roundings_[k + 1].begin, roundings_[k]);
    }
    // The rest of a leg lies on it up to rounding. If that makes it unprovable, the leg stays.
    for (std::size_t k = 0; k + 1 < path_.size();) {
      const bool is_whole = !roundings_[k].arc && !roundings_[k + 1].arc;  // proved as it came
      if (is_whole || arc_end(k) == arc_start(k + 1) ||
          space_.segment_free(arc_end(k), arc_start(k + 1))) {
        ++k;
      } else {
        roundings_[k] = roundings_[k + 1] = {};
        if (k > 0) --k;
      }
    }
  }

  Point arc_start(std::size_t k) const {
    return roundings_[k].arc ? roundings_[k].arc->start() : path_[k].at;
  }
  Point arc_end(std::size_t k) const {
    return roundings_[k].arc ? roundings_[k].arc->end() : path_[k].at;
  }

  Curve assemble() const {
    Curve result;
    if (path_.size() == 1) result.push_back(Segment{path_[0].at, path_[0].at});
    for (std::size_t k = 0; k + 1 < path_.size(); ++k) {
      if (roundings_[k].arc) result.push_back(*roundings_[k].arc);
      const Point from = arc_end(k), to = arc_start(k + 1);
      if (from != to) result.push_back(Segment{from, to});
    }
    return result;
  }

  const S& space_;
  std::vector<ArcVertex> path_;
  std::vector<double> bends_;  // per vertex, while vertices are dropped
  std::vector<Rounding> roundings_;
};

}  // namespace tutavia::detail
