// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include "../plan/blocked_boxes.hpp"
#include "contact.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/auto_search.hpp"
#include "tutavia/search/tangent_graph.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/space/lattice_space.hpp"
#include "tutavia/world/moving_obstacle.hpp"

/// \file
/// GlobalPlanner: paths with room for a controller, around obstacles of the map and others.

namespace drive_program {

using namespace tutavia;

/// The space with more obstacles, standing where they are now, with a margin beyond the safety
/// radius, and within the bounds [m].
inline Expected<LatticeSpace, Failure> with_obstacles(const LatticeSpace& space,
                                                      std::span<const MovingObstacle> obstacles,
                                                      double margin) {
  Workspace workspace = space.workspace();
  workspace.safety_radius += margin;
  workspace.bounds = workspace.bounds.inflated(-margin);
  for (const MovingObstacle& obstacle : obstacles) workspace.obstacles.push_back(obstacle.shape);
  return LatticeSpace::build(
      workspace, {.resolution = space.frame().resolution, .movement = space.movement()});
}

/// The same on cells: all that an obstacle may touch are blocked. The bounds stay.
inline Expected<CellSpace, Failure> with_obstacles(const CellSpace& space,
                                                   std::span<const MovingObstacle> obstacles,
                                                   double margin) {
  const double safety_radius = space.safety_radius() + margin;
  if (obstacles.empty()) return space.with_safety_radius(safety_radius);
  OccupancyGrid cells = space.cells();
  const double side = space.frame().resolution;
  const Point origin = space.corner({0, 0});
  for (const MovingObstacle& obstacle : obstacles) {
    const Box box = tutavia::detail::box_of(obstacle.shape);
    const auto column = [&](double x) {
      return static_cast<int>(std::floor((x - origin.x()) / side));
    };
    const auto row = [&](double y) {
      return static_cast<int>(std::floor((y - origin.y()) / side));
    };
    for (int y = std::max(0, row(box.min.y())); y <= std::min(cells.height() - 1, row(box.max.y()));
         ++y) {
      for (int x = std::max(0, column(box.min.x()));
           x <= std::min(cells.width() - 1, column(box.max.x())); ++x) {
        const Point center = space.corner({x, y}) + Point(0.5 * side, 0.5 * side);
        const double gap = approach({.from = {center, 0}}, obstacle).distance;
        if (gap <= 0.71 * side) cells.set({x, y}, false);
      }
    }
  }
  return CellSpace::build(std::move(cells), {.resolution = side,
                                             .origin = origin,
                                             .safety_radius = safety_radius,
                                             .movement = space.movement()});
}

/// A path, and the room that it keeps beyond the safety radius [m].
struct GlobalPath {
  Curve curve{};
  double margin = 0;
};

/// Plans paths that keep a margin beyond the safety radius, so that a controller can follow them:
/// the widest margin with which there is a path. Replanning from a start in the margin, or a little
/// outside the bounds, leaves it on a segment to the nearest point with the margin; the controller
/// has to prove that segment.
template <class S>
class GlobalPlanner {
 public:
  /// `space` must outlive the planner. `margin`: the widest to try [m].
  explicit GlobalPlanner(const S& space, double margin = 0.1) : space_(space), margin_(margin) {}

  /// A path around the obstacles of the map and others, which are taken to stand. A start nearer to
  /// an obstacle than the margin is left on a segment to the nearest point that is not. Errors:
  /// those of the search without a margin.
  Expected<GlobalPath, Failure> plan(const Point& start, const Point& goal,
                                     std::span<const MovingObstacle> obstacles = {}) {
    constexpr std::array shares{1.0, 0.5, 0.2};
    for (const double share : shares) {
      auto path = plan_with(share * margin_, start, goal, obstacles);
      if (path) return path;
    }
    return plan_with(0, start, goal, obstacles);
  }

 private:
  Expected<GlobalPath, Failure> plan_with(double margin, const Point& start, const Point& goal,
                                          std::span<const MovingObstacle> obstacles) {
    const auto space = with_obstacles(space_, obstacles, margin);
    if (!space) return Unexpected{space.error()};
    auto plan = planner_.plan(*space, {.start = space->bounds().clamp(start), .goal = goal});
    if (!plan && plan.error().code == PlanError::start_blocked) {
      if (const std::optional<Point> safe = plan.error().nearest_safe_point) {
        plan = planner_.plan(*space, {.start = *safe, .goal = goal});
      }
    }
    if (!plan) return std::move(plan).unexpected();
    if (plan->curve.start() == start) return GlobalPath{std::move(plan->curve), margin};
    Curve curve;
    curve.push_back(Segment{start, plan->curve.start()});
    for (const Piece& piece : plan->curve.pieces()) curve.push_back(piece);
    return GlobalPath{std::move(curve), margin};
  }

  const S& space_;
  double margin_;
  Planner<AutoSearch, DeltaSmoother> planner_{};
};

/// The obstacles of a map as polygons and discs.
inline Workspace workspace_of(const LatticeSpace& space) { return space.workspace(); }
inline Workspace workspace_of(const CellSpace& space) {
  Workspace workspace{.bounds = space.bounds(), .safety_radius = space.safety_radius()};
  for (const Box& b :
       plan_program::blocked_boxes(space.cells(), space.corner({0, 0}), space.frame().resolution)) {
    workspace.obstacles.emplace_back(
        Polygon{{b.min, {b.max.x(), b.min.y()}, b.max, {b.min.x(), b.max.y()}}});
  }
  return workspace;
}

/// Whether there is a path from a robot to the goal that keeps the safety radius and a margin from
/// the map and from obstacles, by an exact search; nothing if that takes longer than ten seconds or
/// the robot is in contact.
template <class S>
std::optional<bool> is_connected(const S& space, const Point& robot, const Point& goal,
                                 std::span<const MovingObstacle> obstacles, double margin = 0) {
  Workspace workspace = workspace_of(space);
  workspace.safety_radius += margin;
  for (const MovingObstacle& obstacle : obstacles) workspace.obstacles.push_back(obstacle.shape);
  const auto inflated = InflatedSpace::build(std::move(workspace));
  if (!inflated) return std::nullopt;
  // Odometry's errors may have led the robot out of the bounds a little.
  const Point start = inflated->bounds().clamp(robot);
  Planner planner{TangentGraph{}};
  const auto plan =
      planner.plan(*inflated, {.start = start, .goal = goal, .budget = Budget::for_seconds(10)});
  if (plan) return true;
  const PlanError code = plan.error().code;
  if (code == PlanError::unreachable || code == PlanError::goal_blocked) return false;
  return std::nullopt;
}

}  // namespace drive_program
