// SPDX-License-Identifier: MIT
#include "tutavia/space/distance_field_space.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "support/catch.hpp"
#include "support/exact_checker.hpp"
#include "support/field_space.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/geometry/bezier.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/rrt_star.hpp"
#include "tutavia/search/safe_rrt_star.hpp"
#include "tutavia/search/theta_star.hpp"
#include "tutavia/smooth/bezier_smoother.hpp"
#include "tutavia/smooth/shortcut.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;
using test::FieldSpace;

static_assert(ClearanceGridSpace<FieldSpace> && ColumnSpace<FieldSpace> && JumpSpace<FieldSpace>);
static_assert(LineOfSightSpace<FieldSpace> && !FeatureSpace<FieldSpace>);
static_assert(ClearanceFunction<float (*)(const Point&)>);
static_assert(!ClearanceFunction<bool (*)(const Point&)>);
static_assert(!ClearanceFunction<int (*)(const Point&)>);

const Box square{{-8, -8}, {8, 8}};

/// A half plane: the obstacle is y <= 0.
double above_ground(const Point& p) { return p.y(); }

/// A single point in the origin.
double from_origin(const Point& p) { return p.norm(); }

template <class F>
auto space_of(F clearance, double radius) {
  return DistanceFieldSpace<F>::build(clearance, square, radius, {.resolution = 0.25}).value();
}

TEST_CASE("a function that is no space is refused") {
  const auto code = [](const Box& bounds, double radius, const DistanceFieldOptions& options) {
    const auto space =
        DistanceFieldSpace<double (*)(const Point&)>::build(above_ground, bounds, radius, options);
    REQUIRE_FALSE(space);
    return space.error().code;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(code(Box{}, 1, {}) == PlanError::invalid_input);
  CHECK(code(square, -1, {}) == PlanError::invalid_input);
  CHECK(code(square, nan, {}) == PlanError::invalid_input);
  for (const double bad : {0.0, -1.0, nan, infinity}) {
    CHECK(code(square, 1, {.resolution = bad}) == PlanError::invalid_option);
    CHECK(code(square, 1, {.tolerance = bad}) == PlanError::invalid_option);
  }
  CHECK(code(square, 1, {.movement = MovementRule::by_edge}) == PlanError::invalid_option);
  CHECK(code(square, 1, {.resolution = 1e-9}) == PlanError::limit_exceeded);
  CHECK(code(square, 1, {.resolution = 0.25, .max_nodes = 100}) == PlanError::limit_exceeded);
}

TEST_CASE("segments beside a point obstacle are decided up to rounding") {
  const auto space = space_of(from_origin, 0.5);
  CHECK(space.segment_free({-7, 0.5 + 1e-9}, {7, 0.5 + 1e-9}));
  CHECK(space.segment_free({-7.3, 0.5 + 1e-9}, {1.1, 0.5 + 1e-9}));
  CHECK_FALSE(space.segment_free({-7, 0.5}, {7, 0.5}));  // a tie
  CHECK_FALSE(space.segment_free({-7, 0.5 - 1e-9}, {7, 0.5 - 1e-9}));
  CHECK_FALSE(space.segment_free({-7, 1}, {8.1, 1}));  // out of bounds
  CHECK_FALSE(space.is_free({8.1, 1}));
  CHECK(space.is_free({0, 0.5 + 1e-9}));
  CHECK_FALSE(space.is_free({0, 0.5}));
}

TEST_CASE("segments beside a straight wall are decided up to the tolerance") {
  const auto space = space_of(above_ground, 0.5);
  const double tolerance = 1e-5 * 0.25;
  CHECK(space.segment_free({-7, 0.5 + tolerance}, {7, 0.5 + tolerance}));
  CHECK(space.segment_free({-7, 0.5 + tolerance}, {7, 3}));
  CHECK_FALSE(space.segment_free({-7, 0.5}, {7, 0.5}));
  CHECK_FALSE(space.segment_free({-7, 0.5 - tolerance}, {7, 0.5 - tolerance}));
  const auto fine = DistanceFieldSpace<double (*)(const Point&)>::build(
                        above_ground, square, 0.5, {.resolution = 0.25, .tolerance = 1e-7})
                        .value();
  CHECK(fine.segment_free({-7, 0.5 + 1e-7}, {7, 0.5 + 1e-7}));
  CHECK(fine.distance_error_bound() < 3e-7);
}

TEST_CASE("a point robot passes between obstacles, not through them") {
  const auto two_points = [](const Point& p) -> double {
    return std::min((p - Point(0, 1)).norm(), (p - Point(0, -1)).norm());
  };
  const auto space = space_of(two_points, 0);
  CHECK(space.segment_free({-7, 0}, {7, 0}));
  CHECK(space.segment_free({-7, 0.999}, {7, 0.999}));
  CHECK_FALSE(space.segment_free({-7, 1}, {7, 1}));
  CHECK_FALSE(space.segment_free({0, -7}, {0, 7}));
  const auto wall = space_of([](const Point& p) -> double { return std::abs(p.x()); }, 0);
  CHECK_FALSE(wall.segment_free({-7, 0}, {7, 0}));
}

TEST_CASE("distances of pieces lie within their error of those to the obstacles") {
  const std::uint64_t seed = 7100;
  INFO("seed " << seed);
  test::WorldGenerator worlds(seed);
  Random random(seed);
  std::size_t near = 0, far = 0;
  for (std::size_t round = 0; round < test::scaled(40); ++round) {
    INFO("round " << round);
    const Workspace world = worlds.workspace();
    const auto exact = InflatedSpace::build(world).value();
    const double size = world.bounds.width();
    const FieldSpace field = test::field_space(world, {.resolution = size / 40});
    const double cap = size / 10, error = field.distance_error_bound();
    const auto compare = [&](const auto& piece, double evaluation_error) {
      if (exact.clearance(piece.start()) < 0 || exact.nearest(piece, cap).distance <= 0) return;
      const double expected = exact.nearest(piece, cap).distance;
      const NearestObstacle found = field.nearest(piece, cap);
      CHECK(std::abs(found.distance - expected) <= error + evaluation_error);
      CHECK((found.obstacle == NearestObstacle::none) == (found.distance == cap));
      if (found.distance < cap) {
        CHECK(field.clearance(piece.point(found.parameter)) <= found.distance + 2 * error);
      }
      (found.distance < cap ? near : far) += 1;
    };
    for (int i = 0; i < 10; ++i) {
      compare(Segment{worlds.point(world), worlds.point(world)}, 0);
      const Arc arc = Arc::around(worlds.point(world), size * random.uniform(0, 0.2),
                                  random.uniform(-3, 3), random.uniform(-6, 6));
      compare(arc, arc.evaluation_error());
    }
  }
  CHECK(near > 50);
  CHECK(far > 20);
}

TEST_CASE("segments that are free by distances alone are free to the exact checker") {
  const std::uint64_t seed = 7101;
  INFO("seed " << seed);
  test::WorldGenerator worlds(seed);
  std::size_t refused = 0, free = 0;
  for (std::size_t round = 0; round < test::scaled(60); ++round) {
    INFO("round " << round);
    const Workspace world = worlds.workspace();
    const auto exact = InflatedSpace::build(world).value();
    const FieldSpace field = test::field_space(world, {.resolution = world.bounds.width() / 40});
    for (int i = 0; i < 20; ++i) {
      const Segment s{worlds.point(world), worlds.point(world)};
      const bool is_free = exact.segment_free(s.a, s.b);
      if (field.segment_free(s.a, s.b)) {
        CHECK(is_free);
        ++free;
      } else if (is_free) {
        ++refused;
      }
    }
  }
  CHECK(free > 100);
  CHECK(refused * 50 < free);
}

TEST_CASE("every step of the lattice is proved by the function") {
  const std::uint64_t seed = 7102;
  INFO("seed " << seed);
  test::WorldGenerator worlds(seed);
  std::size_t steps = 0, unproved = 0;
  for (std::size_t round = 0; round < test::scaled(20); ++round) {
    const Workspace world = worlds.workspace();
    const FieldSpace field = test::field_space(world, {.resolution = world.bounds.width() / 30});
    const OccupancyGrid& grid = field.grid();
    for (int y = 0; y + 1 < grid.height(); ++y) {
      for (int x = 0; x + 1 < grid.width(); ++x) {
        for (const Cell to : {Cell{x + 1, y}, Cell{x, y + 1}, Cell{x + 1, y + 1}}) {
          if (!grid.is_free({x, y}) || !grid.is_free(to)) continue;
          ++steps;
          if (!field.line_of_sight({x, y}, to)) ++unproved;
        }
      }
    }
  }
  CHECK(steps > 5000);
  CHECK(unproved == 0);
}

TEST_CASE("a plan on distances alone is a plan among the obstacles") {
  for (const Scene& scene : {maps::array(), maps::complex(), maps::maze()}) {
    INFO(scene.name);
    const FieldSpace field = test::field_space(scene.workspace, {.resolution = scene.resolution});
    const auto exact = InflatedSpace::build(scene.workspace).value();
    const auto check = [&](auto planner) {
      for (const Point& goal : scene.goals) {
        const auto plan = planner.plan(field, {.start = scene.start, .goal = goal});
        REQUIRE(plan);
        CHECK_FALSE(plan->fell_back);
        const Certificate judge = certify(exact, plan->curve);
        CHECK(judge.status == ProofStatus::proved);
        CHECK(plan->certificate.lower <= judge.upper);
        CHECK(plan->certificate.upper >= judge.lower);
        CHECK(plan->certificate.upper - plan->certificate.lower < 8 * field.distance_error_bound());
      }
    };
    check(Planner{AStar{}, BezierSmoother{}});
    check(Planner{ThetaStar{}, Shortcut{}});
    check(Planner{RrtStar{}, Shortcut{}});
  }
}

TEST_CASE("zones of risk are avoided on distances alone") {
  const Scene scene = maps::complex();
  const FieldSpace field = test::field_space(scene.workspace, {.resolution = scene.resolution});
  const auto exact = InflatedSpace::build(scene.workspace).value();
  Planner planner{SafeRrtStar{.max_iterations = 1500}, Shortcut{}};
  const auto plan = planner.plan(field, {.start = scene.start, .goal = scene.goals[0]});
  REQUIRE(plan);
  CHECK(plan->route.risk_width > 0);
  CHECK(certify(exact, plan->curve).status == ProofStatus::proved);
  CHECK(plan->certificate.lower > scene.workspace.safety_radius);
}

TEST_CASE("a function that is too low is still proved, and NaN is blocked") {
  const auto low = [](const Point& p) -> double { return 0.5 * p.norm(); };
  const auto space = space_of(low, 0.5);
  CHECK(space.segment_free({-7, 1.01}, {7, 1.01}));
  CHECK_FALSE(space.segment_free({-7, 0.4}, {7, 0.4}));
  const auto partial = [](const Point& p) -> double {
    return p.x() > 0 ? std::numeric_limits<double>::quiet_NaN() : 5;
  };
  const auto half = space_of(partial, 0.5);
  CHECK(half.segment_free({-7, 0}, {-6, 0}));
  CHECK_FALSE(half.is_free({1, 0}));
  CHECK_FALSE(half.grid().is_free(half.frame().nearest_cell({1, 0})));
  CHECK(half.grid().is_free(half.frame().nearest_cell({-1, 0})));
  CHECK(half.nearest(Segment{{1, 0}, {2, 0}}, 1).distance < -1e9);
  const auto empty =
      space_of([](const Point&) -> double { return std::numeric_limits<double>::infinity(); }, 1);
  CHECK(empty.segment_free({-8, -8}, {8, 8}));
  CHECK(empty.nearest(Segment{{-8, 0}, {8, 0}}, 3).obstacle == NearestObstacle::none);
  CHECK(empty.grid().count_free() == 65 * 65);
}

TEST_CASE("the space can be had at another safety radius") {
  const auto space = space_of(from_origin, 0.5);
  const auto wide = space.with_safety_radius(2).value();
  CHECK(wide.safety_radius() == 2);
  CHECK_FALSE(wide.is_free({1.5, 0}));
  CHECK(wide.function()({3, 4}) == 5);
  CHECK_FALSE(space.with_safety_radius(-1));
}

}  // namespace
