// SPDX-License-Identifier: MIT
#include "tutavia/space/grid_builder.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/geometries.hpp>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include "support/catch.hpp"
#include "tutavia/geometry/boost_adapt.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/jps.hpp"
#include "tutavia/search/rrt_star.hpp"
#include "tutavia/search/theta_star.hpp"
#include "tutavia/smooth/b_spline_smoother.hpp"
#include "tutavia/smooth/bezier_smoother.hpp"
#include "tutavia/smooth/shortcut.hpp"

namespace {

using namespace tutavia;

const Box bounds{{0, 0}, {8, 6}};
const Box wall{{3, 0}, {4, 4}};
constexpr double radius = 0.5;

double clearance_of_wall(const Point& p) {
  const double dx = std::max(wall.min.x() - p.x(), p.x() - wall.max.x());
  const double dy = std::max(wall.min.y() - p.y(), p.y() - wall.max.y());
  return std::hypot(std::max(dx, 0.0), std::max(dy, 0.0)) + std::min(std::max(dx, dy), 0.0);
}
bool is_outside_wall(const Point& p) { return !wall.contains(p); }

Workspace workspace_of_wall() { return {bounds, radius, obstacles_from(wall)}; }

bool same_cells(const OccupancyGrid& a, const OccupancyGrid& b) {
  if (a.width() != b.width() || a.height() != b.height()) return false;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      if (a.is_free({x, y}) != b.is_free({x, y})) return false;
    }
  }
  return true;
}

/// Plans round the wall with several planners, and checks the curves against the wall itself.
/// `slack` is the distance between the wall and what the space knows of it.
template <class S>
void check_plans(const S& space, double slack) {
  const auto exact = InflatedSpace::build(workspace_of_wall()).value();
  const auto check = [&](auto planner) {
    const auto plan = planner.plan(space, {.start = {1, 1}, .goal = {7, 1.2}});
    REQUIRE(plan);
    CHECK_FALSE(plan->fell_back);
    CHECK(plan->curve.length() > 9);  // round the wall
    CHECK(certify(exact.with_safety_radius(radius - slack).value(), plan->curve).status ==
          ProofStatus::proved);
  };
  check(Planner{AStar{}, BezierSmoother{}});
  check(Planner{Jps{}, BSplineSmoother{}});
  check(Planner{ThetaStar{}, Shortcut{}});
  check(Planner{RrtStar{}, Shortcut{}});
}

TEST_CASE("a workspace gives the lattice that LatticeSpace gives") {
  const auto space = GridBuilder(workspace_of_wall()).build({.resolution = 0.2}).value();
  static_assert(std::is_same_v<decltype(space), const LatticeSpace>);
  const auto lattice = LatticeSpace::build(workspace_of_wall(), {.resolution = 0.2}).value();
  CHECK(same_cells(space.grid(), lattice.grid()));
  CHECK(GridBuilder(workspace_of_wall()).build()->frame().resolution == 8.0 / 200);
  CHECK(GridBuilder(workspace_of_wall()).build({.movement = MovementRule::allow})->movement() ==
        MovementRule::allow);
  check_plans(space, 0);
}

TEST_CASE("areas give the lattice of a workspace with them") {
  namespace bg = boost::geometry;
  const auto lattice = LatticeSpace::build(workspace_of_wall(), {.resolution = 0.2}).value();
  const auto check = [&](const auto& area) {
    const auto space = GridBuilder(area, bounds, radius).build({.resolution = 0.2}).value();
    static_assert(std::is_same_v<decltype(space), const LatticeSpace>);
    CHECK(same_cells(space.grid(), lattice.grid()));
  };
  check(wall);
  check(to_polygons(wall));
  check(to_polygons(wall)[0]);
  check(to_polygons(wall)[0].outer);
  using BoostPoint = bg::model::d2::point_xy<double>;
  bg::model::polygon<BoostPoint> polygon;
  bg::convert(wall, polygon);
  check(polygon);
  check(polygon.outer());
  check(bg::model::multi_polygon<bg::model::polygon<BoostPoint>>{polygon});
  check(bg::model::box<BoostPoint>(BoostPoint(3, 0), BoostPoint(4, 4)));
  check_plans(GridBuilder(polygon, bounds, radius).build({.resolution = 0.2}).value(), 0);
}

TEST_CASE("a clearance function gives a distance field with the same lattice") {
  const auto space =
      GridBuilder(clearance_of_wall, bounds, radius).build({.resolution = 0.2}).value();
  const auto lattice = LatticeSpace::build(workspace_of_wall(), {.resolution = 0.2}).value();
  CHECK(same_cells(space.grid(), lattice.grid()));
  check_plans(space, 0);
}

TEST_CASE("a predicate gives cells, blocked if their centres are not free") {
  std::size_t calls = 0;
  const auto counted = [&calls](const Point& p) {
    ++calls;
    return is_outside_wall(p);
  };
  const auto space = GridBuilder(counted, bounds, radius).build({.resolution = 0.1}).value();
  static_assert(std::is_same_v<decltype(space), const CellSpace>);
  CHECK(space.cells().width() == 80);
  CHECK(space.cells().height() == 60);
  CHECK(calls == 80 * 60);
  CHECK(space.cells().count_free() == 80 * 60 - 10 * 40);
  CHECK(space.safety_radius() == radius);
  CHECK_FALSE(space.is_free({2.6, 1}));
  CHECK(space.is_free({2.4, 1}));
  check_plans(space, 0.1);
  // A wall between the centres is missed.
  const auto thin = [](const Point& p) { return std::abs(p.x() - 4) > 0.01; };
  CHECK(GridBuilder(thin, bounds, 0).build({.resolution = 0.1})->cells().count_free() == 80 * 60);
}

TEST_CASE("only whole cells are within the bounds, and rounding costs none") {
  const auto everywhere = [](const Point&) { return true; };
  const auto cells = [&](const Box& box, double resolution) {
    const auto space = GridBuilder(everywhere, box, 0).build({.resolution = resolution}).value();
    return Cell{space.cells().width(), space.cells().height()};
  };
  CHECK(cells({{0, 0}, {0.3, 0.7}}, 0.1) == Cell{3, 7});  // 0.3 / 0.1 < 3
  CHECK(cells({{-1, -2}, {1.05, 0.99}}, 0.5) == Cell{4, 5});
  CHECK(cells({{0, 0}, {1, 1}}, 2) == Cell{0, 0});
}

TEST_CASE("options and bounds that make no grid are refused from every source") {
  const auto code = [](const auto& builder, const GridOptions& options) {
    const auto space = builder.build(options);
    REQUIRE_FALSE(space);
    return space.error().code;
  };
  const auto check = [&](const auto& builder) {
    for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
      CHECK(code(builder, {.resolution = bad}) == PlanError::invalid_option);
    }
    CHECK(code(builder, {.movement = MovementRule::by_edge}) == PlanError::invalid_option);
    CHECK(code(builder, {.resolution = 0.1, .max_nodes = 1000}) == PlanError::limit_exceeded);
    CHECK(code(builder, {.resolution = 1e-9}) == PlanError::limit_exceeded);
  };
  check(GridBuilder(workspace_of_wall()));
  check(GridBuilder(wall, bounds, radius));
  check(GridBuilder(clearance_of_wall, bounds, radius));
  check(GridBuilder(is_outside_wall, bounds, radius));
  CHECK(code(GridBuilder(wall, Box{}, radius), {}) == PlanError::invalid_input);
  CHECK(code(GridBuilder(clearance_of_wall, bounds, -1), {}) == PlanError::invalid_input);
  CHECK(code(GridBuilder(is_outside_wall, Box{}, radius), {}) == PlanError::invalid_input);
  CHECK(code(GridBuilder(is_outside_wall, bounds, std::nan("")), {}) == PlanError::invalid_input);
}

}  // namespace
