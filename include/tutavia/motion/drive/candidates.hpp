// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/motion/band.hpp"
#include "tutavia/motion/drive/detours.hpp"
#include "tutavia/motion/drive/obstacle_distance.hpp"
#include "tutavia/motion/drive/tracked_path.hpp"
#include "tutavia/motion/local_planner_options.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/world/moving_obstacle.hpp"

/// \file
/// Candidates: the curves by which a robot may come to the end of its path.

namespace tutavia::detail {

/// A path to the end, and the band along its next part.
struct Candidate {
  TrackedPath path{};
  Band band{};
  std::optional<TrackedPath::Block> block{};  // the first one ahead
  double astray = 0;                          // the robot's distance from the path [m]
  bool turns_first = false;                   // on the spot, before its band is optimised

  bool is_blocked() const { return block.has_value(); }
  /// The robot is too far off to get back; near the end there is little path left for it.
  bool is_lost() const { return astray > std::min(1.0, 0.2 + path.remaining()); }
};

/// The path that a robot was given, and detours around what blocks it: the shortest one, and one on
/// the other side of the obstacle. One of them is chosen, with hysteresis.
class Candidates {
 public:
  /// The path alone.
  void reset(Curve path, const LocalPlannerOptions& options) {
    path_ = TrackedPath(std::move(path));
    candidates_.assign(1, Candidate{.path = path_});
    chosen_ = 0;
    failure_.reset();
    seen_.clear();
    since_search_ = options.search_interval;
  }

  bool empty() const { return path_.empty(); }
  const Curve& path() const { return path_.curve(); }
  std::size_t size() const { return candidates_.size(); }
  std::size_t chosen() const { return chosen_; }
  void choose(std::size_t candidate) { chosen_ = candidate; }
  Candidate& operator[](std::size_t candidate) { return candidates_[candidate]; }
  Candidate& current() { return candidates_[chosen_]; }
  const Candidate& current() const { return candidates_[chosen_]; }
  /// Why the last search found no path.
  const std::optional<Failure>& failure() const { return failure_; }
  void forget_failure() { failure_.reset(); }

  /// Whether obstacles near the robot have appeared, vanished or changed their velocity since the
  /// last call, by more than perception may err. Obstacles keep their order.
  bool have_changed(const Point& robot, std::span<const MovingObstacle> observed,
                    const LocalPlannerOptions& options);

  /// Follows the robot along every path, and finds what blocks them. Searches detours if the
  /// current path is blocked or lost, or if `wants_search`; returns whether it did. Chooses the
  /// shortest path that is free, if it is shorter by `switch_gain`.
  template <FeatureSpace S>
  bool update(const S& space, const Point& robot, std::span<const MovingObstacle> observed,
              const LocalPlannerOptions& options, bool wants_search);

 private:
  template <FeatureSpace S>
  void search(const S& space, const Point& robot, std::span<const MovingObstacle> observed,
              const LocalPlannerOptions& options);
  std::optional<TrackedPath::Block> first_block(const TrackedPath& path,
                                                std::span<const MovingObstacle> observed,
                                                double clearance,
                                                const LocalPlannerOptions& options) const {
    return path.first_block(observed, clearance, options.control.limits.max_speed,
                            options.horizon + 1);
  }

  TrackedPath path_;  // as given
  std::vector<Candidate> candidates_{1};
  std::size_t chosen_ = 0;
  std::optional<Failure> failure_;
  std::vector<MovingObstacle> seen_;
  int since_search_ = 0;  // [periods]
};

inline bool Candidates::have_changed(const Point& robot, std::span<const MovingObstacle> observed,
                                     const LocalPlannerOptions& options) {
  constexpr double most_off = 0.05;  // [m] and [m/s]
  bool changed = observed.size() != seen_.size();
  for (std::size_t i = 0; !changed && i < observed.size(); ++i) {
    const Point now = center_of(observed[i].shape);
    const Point expected =
        offset_along(center_of(seen_[i].shape), options.control.period, seen_[i].velocity);
    changed = std::min(distance(robot, now), distance(robot, expected)) < options.window &&
              (distance(seen_[i].velocity, observed[i].velocity) > most_off ||
               distance(expected, now) > most_off);
  }
  seen_.assign(observed.begin(), observed.end());
  return changed;
}

template <FeatureSpace S>
bool Candidates::update(const S& space, const Point& robot,
                        std::span<const MovingObstacle> observed,
                        const LocalPlannerOptions& options, bool wants_search) {
  const double clearance = demanded_clearance(space.safety_radius(), options.control);
  path_.advance(robot);
  for (Candidate& candidate : candidates_) {
    candidate.astray = candidate.path.advance(robot);
    candidate.block = first_block(candidate.path, observed, clearance, options);
  }
  since_search_ = std::min(since_search_, options.search_interval - 1) + 1;
  const bool needed = wants_search || current().is_blocked() || current().is_lost();
  const bool searches = needed && since_search_ >= options.search_interval;
  if (searches) search(space, robot, observed, options);
  const auto cost = [&](const Candidate& candidate) {
    return candidate.astray + candidate.path.remaining() + (candidate.is_blocked() ? 1e6 : 0.0);
  };
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    if (cost(candidates_[i]) + options.switch_gain < cost(current())) chosen_ = i;
  }
  return searches;
}

template <FeatureSpace S>
void Candidates::search(const S& space, const Point& robot,
                        std::span<const MovingObstacle> observed,
                        const LocalPlannerOptions& options) {
  since_search_ = 0;
  failure_.reset();
  const double demanded = demanded_clearance(space.safety_radius(), options.control);
  const auto block = first_block(path_, observed, demanded, options);
  // A robot that stands nearer may leave along paths as near.
  const double most = clearance_among(space, observed, robot) * (1 - 1e-3);
  const double least =
      std::max(space.safety_radius() * (1 + 1e-4), std::min(demanded + 0.2 * options.margin, most));
  const DetourQuery query{robot, std::max(least, std::min(demanded + options.margin, most)), least,
                          options.window,
                          std::min(path_.length(), (block ? block->s : path_.progress()) + 0.5)};
  Detours<S> detours(space, path_, observed);
  auto first = detours.shortest(query);
  if (!first) {
    failure_ = std::move(first.error());
    return;
  }
  std::vector<Candidate> candidates;
  if (!current().is_blocked() && !current().is_lost()) candidates.push_back(std::move(current()));
  auto second = block ? detours.other_side(query, *first, block->obstacle) : std::nullopt;
  candidates.push_back(Candidate{.path = TrackedPath(std::move(*first))});
  if (second) candidates.push_back(Candidate{.path = TrackedPath(std::move(*second))});
  candidates_ = std::move(candidates);
  chosen_ = 0;
}

}  // namespace tutavia::detail
