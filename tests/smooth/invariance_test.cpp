// SPDX-License-Identifier: MIT
/// \file
/// Smoothed curves turn, move, scale and run backwards with their input.

#include <cmath>
#include <cstdint>

#include "support/catch.hpp"
#include "support/random_tasks.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "support/similarity.hpp"
#include "tutavia/smooth/b_spline_smoother.hpp"
#include "tutavia/smooth/bezier_smoother.hpp"
#include "tutavia/smooth/clothoid_smoother.hpp"
#include "tutavia/smooth/redundant_node_removal.hpp"

namespace {

using namespace tutavia;

/// A route from which neither direction has anything to drop.
std::vector<Point> pruned_both_ways(const InflatedSpace& space, std::vector<Point> route) {
  for (std::size_t before = 0; before != route.size();) {
    before = route.size();
    for (int i = 0; i < 2; ++i) {
      route = waypoints(RedundantNodeRemoval{}.smooth(space, Curve::polyline(route), {}).value());
      std::reverse(route.begin(), route.end());
    }
  }
  return route;
}

/// Whether one curve is the other one mapped, to 1e-9 of its size.
template <class Map>
bool agree(const Curve& curve, const Curve& mapped, double scale, bool backwards, const Map& map) {
  const double tolerance = 1e-9 * scale * (1 + curve.length());
  if (std::abs(mapped.length() - scale * curve.length()) > tolerance) return false;
  for (int i = 0; i <= 20; ++i) {
    const double part = i / 20.0, other = backwards ? 1 - part : part;
    const Point expected = map(curve.point(part * curve.length()));
    if (distance(mapped.point(other * mapped.length()), expected) > tolerance) return false;
  }
  return true;
}

/// `smoother(scale)` is the smoother for a world that is scaled.
template <class Make>
void check_invariance(const Make& smoother) {
  const std::uint64_t seed = 410;
  test::WorldGenerator worlds(seed);
  std::size_t compared = 0, bent = 0;
  for (std::size_t round = 0; round < test::scaled(100); ++round) {
    INFO("seed " << seed << ", round " << round);
    auto task = test::random_task(worlds);
    if (!task || task->world.bounds.largest_coordinate() > 100) continue;
    task->world.bounds = test::Similarity{}(task->world).bounds;
    const auto space = InflatedSpace::build(task->world).value();
    const std::vector<Point> route = pruned_both_ways(space, task->route);
    const double reach = task->world.bounds.width() / 100;
    const Curve curve = smoother(reach).smooth(space, Curve::polyline(route), {}).value();

    const std::vector<Point> back(route.rbegin(), route.rend());
    const Curve reversed = smoother(reach).smooth(space, Curve::polyline(back), {}).value();
    CHECK(agree(curve, reversed, 1, true, [](const Point& p) { return p; }));

    const auto map = test::Similarity::random(worlds.random());
    const auto mapped_space = InflatedSpace::build(map(task->world)).value();
    const auto mapped =
        smoother(map.scale * reach).smooth(mapped_space, Curve::polyline(map(route)), {});
    if (!mapped) continue;  // a tie at the radius, rounded
    ++compared;
    if (curve.pieces().size() > 1) ++bent;
    CHECK(agree(curve, *mapped, map.scale, false, [&](const Point& p) { return map(p); }));

    // An obstacle outside the route's hull, grown by the radius, changes nothing.
    const Box hull = test::surroundings(route, task->world.safety_radius);
    Workspace more = task->world;
    more.obstacles.push_back(Disc{hull.max + Point(1, 0.5), 0.999});
    const auto more_space = InflatedSpace::build(more).value();
    const auto same = smoother(reach).smooth(more_space, Curve::polyline(route), {});
    REQUIRE(same);
    CHECK(test::same_curve(*same, curve));
  }
  CHECK(compared > test::scaled(25));
  CHECK(bent > test::scaled(10));
}

TEST_CASE("Bezier corners turn, move, scale and run backwards with their route") {
  check_invariance([](double trim) { return BezierSmoother{.trim = trim}; });
}

TEST_CASE("B-splines turn, move, scale and run backwards with their route") {
  check_invariance([](double reach) { return BSplineSmoother{.reach = reach}; });
}

TEST_CASE("paths of continuous curvature turn, move, scale and run backwards with their route") {
  check_invariance([](double) { return ClothoidSmoother{}; });
}

}  // namespace
