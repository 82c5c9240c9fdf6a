// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <iterator>
#include <utility>
#include <variant>
#include <vector>

#include "support/cell_world.hpp"
#include "support/contract.hpp"
#include "support/exact_checker.hpp"
#include "support/field_space.hpp"
#include "support/random_query.hpp"
#include "support/random_worlds.hpp"
#include "support/reference_distance.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/space/lattice_space.hpp"
#include "tutavia/world/maps.hpp"

/// \file
/// The spaces for contract tests, and independent judges of the results.

namespace tutavia::test {

/// A space, and the same free space as polygons for the judges.
template <class S>
struct Arena {
  S space;
  Workspace world;
};

/// The cells of a world, blocked if their centres are inside an obstacle.
inline OccupancyGrid cells_of(const Workspace& world, double resolution) {
  const auto space = InflatedSpace::build(world).value();
  const auto count = [&](double size) { return static_cast<int>(std::lround(size / resolution)); };
  OccupancyGrid grid =
      OccupancyGrid::blocked(count(world.bounds.width()), count(world.bounds.height())).value();
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const Point centre = world.bounds.min + resolution * Point(x + 0.5, y + 0.5);
      grid.set({x, y}, space.clearance(centre) > 0);
    }
  }
  return grid;
}

/// The safety radius for a robot in a world with `radius`.
inline double radius_for(Robot robot, double radius, double resolution) {
  if (robot == Robot::point) return 0;
  return robot == Robot::disc && radius == 0 ? resolution / 4 : radius;
}

/// The arena of a world; `resolution` is the size of nodes or cells, if the space has them.
template <class S>
Arena<S> arena(Workspace world, double resolution, Robot robot) {
  world.safety_radius = radius_for(robot, world.safety_radius, resolution);
  if constexpr (std::same_as<S, CellSpace>) {
    S space = CellSpace::build(cells_of(world, resolution), {.resolution = resolution,
                                                             .origin = world.bounds.min,
                                                             .safety_radius = world.safety_radius})
                  .value();
    Workspace cells = world_of_cells(space);
    return {std::move(space), std::move(cells)};
  } else if constexpr (std::same_as<S, LatticeSpace>) {
    return {LatticeSpace::build(world, {.resolution = resolution}).value(), world};
  } else if constexpr (std::same_as<S, FieldSpace>) {
    return {field_space(world, {.resolution = resolution}), world};
  } else {
    return {InflatedSpace::build(world).value(), world};
  }
}

/// The built-in maps for contract tests.
inline std::vector<Scene> contract_scenes() {
  return {maps::array(), maps::complex(), maps::maze()};
}

/// Draws random arenas of one kind, and queries in them whose ends may be blocked.
template <class S>
class RandomArenas {
 public:
  RandomArenas(std::uint64_t seed, Robot robot) : worlds_(seed), robot_(robot) {}

  Arena<S> next() {
    const Workspace world = worlds_.workspace();
    return arena<S>(world, world.bounds.width() / 40, robot_);
  }
  Query query(const Arena<S>& arena) {
    const Point start = worlds_.point(arena.world);
    return {.start = start, .goal = worlds_.point(arena.world)};
  }

 private:
  WorldGenerator worlds_;
  Robot robot_;
};

template <>
class RandomArenas<CellSpace> {
 public:
  RandomArenas(std::uint64_t seed, Robot robot) : random_(seed), robot_(robot) {}

  /// Every third safety radius is 0; the others are at most one cell, some exactly half a cell.
  Arena<CellSpace> next() {
    constexpr double sizes[] = {1, 0.25, 0.1, 0.05};
    const Point origins[] = {{0, 0}, {-12.3, 4.7}, {1000.5, -2000}};
    constexpr double radii[] = {0, 0.25, 0.5};
    CellOptions options{.resolution = sizes[random_.below(std::size(sizes))],
                        .origin = origins[random_.below(std::size(origins))]};
    const std::uint64_t which = random_.below(6);
    options.safety_radius =
        options.resolution * (which < 4 ? radii[which % 3] : random_.uniform(0, 1));
    options.safety_radius = radius_for(robot_, options.safety_radius, options.resolution);
    CellSpace space = CellSpace::build(random_grid(random_, 30), options).value();
    Workspace world = world_of_cells(space);
    return {std::move(space), std::move(world)};
  }
  /// Half of the ends are not at cell centres.
  Query query(const Arena<CellSpace>& arena) {
    Query query = random_query(random_, arena.space);
    for (Point* end : {&query.start, &query.goal}) {
      if (random_.below(2) == 0) continue;
      const Point offset{random_.uniform(-0.5, 0.5), random_.uniform(-0.5, 0.5)};
      *end += arena.space.frame().resolution * offset;
    }
    return query;
  }

 private:
  Random random_;
  Robot robot_;
};

/// The route of A* through an arena, on a lattice if the space has no grid.
template <class S>
Expected<Route, Failure> grid_route(const Arena<S>& arena, const Query& query) {
  AStar::Scratch scratch;
  NoObserver no_observer;
  if constexpr (GridSpace<S>) {
    return AStar{}.search(arena.space, query, scratch, no_observer);
  } else {
    const Arena<LatticeSpace> grid{
        LatticeSpace::build(arena.world, {.resolution = arena.world.bounds.width() / 40}).value(),
        arena.world};
    return grid_route(grid, query);
  }
}

/// A world with only the obstacles that can block something in `box`.
inline Workspace near(const Workspace& world, const Box& box) {
  Workspace result = world;
  const Box reach =
      box.inflated(1.001 * world.safety_radius + 1e-6 * (1 + world.bounds.largest_coordinate()));
  std::erase_if(result.obstacles, [&](const Obstacle& obstacle) {
    Box extent;
    if (const Disc* disc = std::get_if<Disc>(&obstacle)) {
      extent.include(disc->center);
      extent = extent.inflated(disc->radius);
    } else {
      for (const Point& p : std::get<Polygon>(obstacle).outer) extent.include(p);
    }
    return extent.min.x() > reach.max.x() || extent.max.x() < reach.min.x() ||
           extent.min.y() > reach.max.y() || extent.max.y() < reach.min.y();
  });
  return result;
}

/// Checks the clauses for every curve that an algorithm returns between two points.
template <class S>
void check_curve(Breaches& breaches, const Arena<S>& arena, const Curve& curve, const Point& start,
                 const Point& goal, int samples) {
  breaches.check(!curve.empty() && curve.start() == start && curve.end() == goal,
                 "it begins at the start and ends at the goal");
  breaches.check(certify(arena.space, curve).status == ProofStatus::proved, "it is proved free");
  for (const Piece& piece : curve.pieces()) {
    const Workspace obstacles =
        near(arena.world, piece.visit([](const auto& p) { return p.box(); }));
    breaches.check(sampled_clearance(obstacles, piece, samples) >=
                       obstacles.safety_radius - 1e-12 * arena.space.largest_coordinate(),
                   "it keeps the safety radius, by brute force");
    breaches.check(ExactChecker(obstacles).check(piece) != ExactVerdict::blocked,
                   "it is free to the exact checker");
  }
}

}  // namespace tutavia::test
