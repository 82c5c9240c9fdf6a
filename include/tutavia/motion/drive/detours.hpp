// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/motion/drive/tracked_path.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/search/tangent_graph.hpp"
#include "tutavia/space/overlay_space.hpp"
#include "tutavia/world/moving_obstacle.hpp"

/// \file
/// Detours: paths from a robot around what it observes, back to the path that it follows.

namespace tutavia::detail {

/// Where detours are searched, and how wide they must be.
struct DetourQuery {
  Point from;
  double clearance;        // that a detour keeps where it can [m]
  double least_clearance;  // that it must keep [m]
  double window;           // half the side of the square in which it stays at first [m]
  double after;            // it rejoins the path beyond this arc length [m]
};

/// The centre of an obstacle's box.
inline Point center_of(const Obstacle& obstacle) {
  const Box box = box_of(obstacle);
  return lerp(box.min, box.max, 0.5);
}

/// Searches detours by the tangent graph of a window: obstacles that move are taken where they are
/// now and in the next two seconds.
template <FeatureSpace S>
class Detours {
 public:
  Detours(const S& space, const TrackedPath& path, std::span<const MovingObstacle> observed)
      : space_(space), path_(path), observed_(observed) {}

  /// The shortest path from the robot to the end: a detour, and the rest of the path from where it
  /// rejoins it. The window grows until there is one. Errors: those of TangentGraph for the whole
  /// map.
  Expected<Curve, Failure> shortest(const DetourQuery& query) {
    std::optional<Curve> best;
    Failure failure;
    for (double window = query.window;; window *= 3) {
      const Box box = Box::around({query.from}).inflated(window);
      const bool is_whole = box.contains(space_.bounds());
      auto found = in_window(query, box);
      if (found) {
        const bool better = !best || found->curve.length() < best->length();
        if (better) best = std::move(found->curve);
        // Where the detour bends sharply into the path, a wider window may show a shorter way.
        if (!found->is_bent || window > query.window) return std::move(*best);
      } else {
        failure = std::move(found.error());
      }
      if (is_whole) break;
    }
    if (best) return std::move(*best);
    return Unexpected{std::move(failure)};
  }

  /// The shortest path that passes an obstacle on the other side than `first` does, within the
  /// window.
  std::optional<Curve> other_side(const DetourQuery& query, const Curve& first,
                                  std::size_t obstacle) {
    const Point center = center_of(observed_[obstacle].shape);
    const Curve::Nearest passed = first.nearest(center);
    const Point across = passed.position - center;
    if (!(passed.distance > 0)) return std::nullopt;
    std::vector<Obstacle> obstacles = this->obstacles(Motion::swept);
    // A wall from the obstacle through the gap where the first path passes.
    const double reach = 3 * query.window;
    obstacles.emplace_back(
        polyline_obstacle({center, offset_along(center, reach / passed.distance, across)}));
    auto found = within(query, Box::around({query.from}).inflated(query.window),
                        query.least_clearance, std::move(obstacles));
    if (!found) return std::nullopt;
    return std::move(found->curve);
  }

 private:
  enum class Motion { swept, now };

  struct Found {
    Curve curve;
    bool is_bent = false;  // by more than a third of a half turn where it rejoins the path
  };

  Expected<Found, Failure> in_window(const DetourQuery& query, const Box& window) {
    Failure failure;
    for (const Motion motion : {Motion::swept, Motion::now}) {
      if (motion == Motion::now && !any_moves()) continue;
      for (const double clearance : {query.clearance, query.least_clearance}) {
        auto found = within(query, window, clearance, obstacles(motion));
        if (found) return found;
        failure = std::move(found.error());
      }
    }
    return Unexpected{std::move(failure)};
  }

  bool any_moves() const {
    return std::any_of(observed_.begin(), observed_.end(),
                       [](const MovingObstacle& o) { return !o.stands(); });
  }

  std::vector<Obstacle> obstacles(Motion motion) const {
    std::vector<Obstacle> result;
    for (const MovingObstacle& obstacle : observed_) {
      result.push_back(obstacle.shape);
      if (motion == Motion::now || obstacle.stands()) continue;
      for (const double time : {1.0, 2.0}) result.push_back(at_time(obstacle, time));
    }
    return result;
  }

  Expected<Found, Failure> within(const DetourQuery& query, const Box& window, double clearance,
                                  std::vector<Obstacle> obstacles) {
    auto overlay = OverlaySpace<S>::build(space_, window, clearance, std::move(obstacles));
    if (!overlay) return std::move(overlay).unexpected();
    Failure failure{.code = PlanError::goal_blocked, .detail = "the path is blocked to its end"};
    // The farthest point of the path first; a few, in case that some are walled in.
    const auto samples = path_.samples();
    int tries = 0;
    for (std::size_t i = samples.size(); i-- > 0 && samples[i].s >= query.after && tries < 3;) {
      if (!overlay->bounds().contains(samples[i].position)) continue;
      auto [before, rest] = path_.curve().split(samples[i].s);
      if (!overlay->is_free(rest.start())) continue;
      ++tries;
      NoObserver no_observer;
      auto route = TangentGraph{}.search(*overlay, {.start = query.from, .goal = rest.start()},
                                         scratch_, no_observer);
      if (route) {
        Found result{std::move(route->curve)};
        if (!(rest.length() > 0)) return result;
        const double turn = rest.heading(0) - result.curve.heading(result.curve.length());
        result.is_bent = std::abs(std::remainder(turn, 2 * std::numbers::pi)) > 1;
        for (const Piece& piece : rest.pieces()) result.curve.push_back(piece);
        return result;
      }
      failure = std::move(route.error());
      if (failure.code == PlanError::start_blocked) break;
      i -= std::min<std::size_t>(i, 9);  // the next metre
    }
    return Unexpected{std::move(failure)};
  }

  const S& space_;
  const TrackedPath& path_;
  std::span<const MovingObstacle> observed_;
  TangentGraph::Scratch scratch_;
};

}  // namespace tutavia::detail
