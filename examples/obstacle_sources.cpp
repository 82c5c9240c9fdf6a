// SPDX-License-Identifier: MIT
// The same disc and wall from four sources: a workspace, polygons of Boost.Geometry, a clearance
// function and a predicate. Each leads to a space on which the same planner works.

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/geometries.hpp>
#include <cmath>
#include <iostream>
#include <string>
#include <tutavia/geometry/boost_adapt.hpp>
#include <tutavia/tutavia.hpp>

using namespace tutavia;

namespace {

namespace bg = boost::geometry;

const Box bounds{{0, 0}, {10, 6}};
constexpr double safety_radius = 0.4;
const Disc pillar{.center = {3, 3.4}, .radius = 1};
const Box wall{{5, 0}, {6, 3.5}};

/// Builds the space, plans and prints the length. Returns whether there is a plan.
template <ObstacleSource Source>
bool plan_among(const std::string& name, const GridBuilder<Source>& builder) {
  const auto space = builder.build({.resolution = 0.1});
  if (!space) {
    std::cerr << name << ": " << space.error() << '\n';
    return false;
  }
  Planner planner{AStar{}, Pipeline{Shortcut{}, BezierSmoother{}}};
  const auto plan = planner.plan(*space, {.start = {1, 3}, .goal = {9, 1}});
  if (!plan) {
    std::cerr << name << ": " << plan.error() << '\n';
    return false;
  }
  std::cout << name << ": " << plan->metrics.length << " m, clearance at least "
            << plan->certificate.lower << " m\n";
  return true;
}

/// A clearance function: the exact signed distance to the nearer of the two.
double clearance(const Point& p) {
  const Point beyond =
      (p - 0.5 * (wall.min + wall.max)).cwiseAbs() - 0.5 * Point(wall.width(), wall.height());
  const double from_wall = beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0);
  return std::min(from_wall, distance(p, pillar.center) - pillar.radius);
}

/// A predicate: whether a point is free.
bool is_free(const Point& p) {
  return !wall.contains(p) && distance(p, pillar.center) > pillar.radius;
}

}  // namespace

static_assert(Areal<Box> && ClearanceFunction<decltype(&clearance)>);
static_assert(PointPredicate<decltype(&is_free)>);

int main() {
  Workspace workspace{.bounds = bounds, .safety_radius = safety_radius};
  workspace.obstacles = obstacles_from(wall);
  workspace.obstacles.emplace_back(pillar);
  bool all = plan_among("workspace", GridBuilder(workspace));

  // The union of two areas, computed by Boost.Geometry: the pillar as a polygon of 64 corners, for
  // which the proof then holds, and the wall, converted from a box of tutavia.
  using BoostPoint = bg::model::d2::point_xy<double>;
  bg::model::multi_polygon<bg::model::polygon<BoostPoint>> round, obstacles;
  bg::buffer(BoostPoint(pillar.center.x(), pillar.center.y()), round,
             bg::strategy::buffer::distance_symmetric<double>(pillar.radius),
             bg::strategy::buffer::side_straight(), bg::strategy::buffer::join_round(),
             bg::strategy::buffer::end_round(), bg::strategy::buffer::point_circle(64));
  bg::model::box<BoostPoint> boost_wall;
  bg::convert(wall, boost_wall);
  bg::union_(round, boost_wall, obstacles);
  all = plan_among("Boost.Geometry", GridBuilder(obstacles, bounds, safety_radius)) && all;

  all = plan_among("clearance function", GridBuilder(clearance, bounds, safety_radius)) && all;
  all = plan_among("predicate", GridBuilder(is_free, bounds, safety_radius)) && all;
  return all ? 0 : 1;
}
