// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/b_spline.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// CornerSpline: a B-spline along a polyline, tightened at corners until it is proved.

namespace tutavia::detail {

/// A cubic B-spline whose control points are the waypoints of a free polyline and auxiliary points
/// on the legs beside waypoints.
///
/// An auxiliary point lies at the waypoint's `reach` from it, or at a third of the leg if that is
/// less, and holds the spline to the legs: the shorter the reach, the tighter the corner. A
/// waypoint without auxiliary points has infinite reach. At reach 0 the waypoint is a triple
/// control point and the spline has a corner there. If all four control points of a piece lie on
/// one leg, the piece is a segment. `prove` shortens reaches until every piece is proved; the limit
/// is the polyline.
class CornerSpline {
 public:
  static constexpr double no_auxiliary_points = std::numeric_limits<double>::infinity();

  /// Repeated waypoints count once. \pre there is a waypoint
  CornerSpline(std::vector<Point> waypoints, double reach) : waypoints_(std::move(waypoints)) {
    waypoints_.erase(std::unique(waypoints_.begin(), waypoints_.end()), waypoints_.end());
    reaches_.assign(waypoints_.size(), reach);
    halvings_.assign(waypoints_.size(), 0);
  }

  /// The spline, proved at the space's safety radius, between the first and the last waypoint and
  /// no longer than the polyline. O(n) for n waypoints. Errors: those of the budget. \pre every leg
  /// is proved
  template <ClearanceSpace S>
  Expected<Curve, Failure> prove(const S& space, const Budget& budget) {
    for (int round = 0; waypoints_.size() > 2 && round < 3 * max_halvings; ++round) {
      if (const auto exceeded = budget.exceeded()) return fail(*exceeded, "while smoothing");
      place_control_points();
      const std::vector<Part> parts = this->parts();
      bool proved = true;
      for (const Part& part : parts) {
        if (part.piece.visit([&](const auto& p) { return is_proved_free(space, p); })) {
          continue;
        }
        proved = false;
        // In the last rounds, collapse the corner immediately.
        for (std::size_t i : part.waypoints) shorten(i, round >= 2 * max_halvings);
      }
      if (!proved) continue;
      Curve curve;
      curve.reserve(parts.size());
      for (const Part& part : parts) curve.push_back(part.piece);
      return curve;
    }
    return Curve::polyline(waypoints_);
  }

 private:
  static constexpr int max_halvings = 6;

  /// A control point and the legs on which it lies; leg i leads from waypoint i to the next.
  struct Control {
    std::size_t waypoint;
    std::size_t first_leg, last_leg;
    bool is_waypoint;
  };
  /// A piece, and the waypoints to tighten if it cannot be proved.
  struct Part {
    Piece piece;
    std::vector<std::size_t> waypoints;
  };

  std::size_t legs() const { return waypoints_.size() - 1; }
  double leg_length(std::size_t i) const { return distance(waypoints_[i], waypoints_[i + 1]); }

  void add(const Point& p, const Control& control) {
    points_.push_back(p);
    controls_.push_back(control);
  }

  void place_control_points() {
    points_.clear();
    controls_.clear();
    // Three points are too few for a cubic spline; the midpoints of both legs are added.
    const bool too_few =
        waypoints_.size() == 3 && reaches_[0] == no_auxiliary_points && reaches_[1] > 0;
    for (std::size_t i = 0; i < waypoints_.size(); ++i) {
      const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i, legs() - 1);
      const Control control{i, before, after, true};
      const double reach = reaches_[i];
      if (reach == 0) {
        for (int k = 0; k < 3; ++k) add(waypoints_[i], control);
        continue;
      }
      const bool has_auxiliary_points = reach != no_auxiliary_points || (too_few && i == 1);
      const auto add_auxiliary_point = [&](std::size_t leg, std::size_t from, std::size_t to) {
        const double length = leg_length(leg), most = too_few ? length / 2 : length / 3;
        add(lerp(waypoints_[from], waypoints_[to], std::min(reach, most) / length),
            {i, leg, leg, false});
      };
      if (has_auxiliary_points && i > 0) add_auxiliary_point(before, i, i - 1);
      add(waypoints_[i], control);
      if (has_auxiliary_points && i < legs()) add_auxiliary_point(after, i, i + 1);
    }
  }

  std::vector<Part> parts() const {
    std::vector<Part> parts;
    const std::vector<CubicBezier> pieces = bezier_pieces(points_);
    const std::size_t none = waypoints_.size();
    std::size_t straight = none;  // the leg of the last part, if that is a segment
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const auto first = controls_.begin() + static_cast<std::ptrdiff_t>(k);
      std::size_t from = 0, to = legs();
      for (auto c = first; c != first + 4; ++c) {
        from = std::max(from, c->first_leg), to = std::min(to, c->last_leg);
      }
      const CubicBezier& piece = pieces[k];
      if (from > to) {
        parts.push_back({piece, {}});
        for (auto c = first; c != first + 4; ++c) {
          if (c->is_waypoint) parts.back().waypoints.push_back(c->waypoint);
        }
        straight = none;
      } else if (straight != none && from <= straight && straight <= to) {
        parts.back().piece = Segment{start_of(parts.back().piece), piece.end()};
      } else if (piece.start() != piece.end()) {
        parts.push_back({Segment{piece.start(), piece.end()}, {from, from + 1}});
        straight = from;
      }
    }
    return parts;
  }

  /// Tightens a corner; the polyline's ends are not corners.
  void shorten(std::size_t i, bool at_once) {
    if (i == 0 || i == legs() || reaches_[i] == 0) return;
    if (at_once || halvings_[i] == max_halvings) {
      reaches_[i] = 0;
    } else if (reaches_[i] == no_auxiliary_points) {
      reaches_[i] = std::min(leg_length(i - 1), leg_length(i)) / 3;
    } else {
      // Starts from the actual position: a reach of more than a third of both legs has no effect.
      reaches_[i] = std::min(reaches_[i], std::max(leg_length(i - 1), leg_length(i)) / 3) / 2;
      ++halvings_[i];
    }
  }

  std::vector<Point> waypoints_;
  std::vector<double> reaches_;
  std::vector<int> halvings_;
  std::vector<Point> points_;
  std::vector<Control> controls_;
};

}  // namespace tutavia::detail
