// SPDX-License-Identifier: MIT
#include "tutavia/search/tangent_graph.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <queue>
#include <vector>

#include "support/catch.hpp"
#include "support/random_tasks.hpp"
#include "support/random_worlds.hpp"
#include "support/registry.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/smooth/taut_string.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;
using std::numbers::pi;

Expected<Route, Failure> search(const InflatedSpace& space, const Query& query,
                                const TangentGraph& graph = {}) {
  detail::TangentScratch scratch;
  NoObserver no_observer;
  return graph.search(space, query, scratch, no_observer);
}

TEST_CASE("edges of a prepared graph are proved tangents, each in both directions") {
  const Scene scene = maps::complex();
  const auto space = InflatedSpace::build(scene.workspace).value();
  const TangentVisibilityGraph map = TangentVisibilityGraph::prepare(space).value();
  CHECK_FALSE(TangentVisibilityGraph(space).is_prepared());
  CHECK(map.memory() > TangentVisibilityGraph(space).memory());
  std::size_t edges = 0;
  for (TangentVisibilityGraph::Node from = 0; from < map.nodes(); ++from) {
    for (const TangentVisibilityGraph::Node to : map.edges(from)) {
      ++edges;
      const auto way = detail::tangent_line(map.circle(from), map.circle(to));
      REQUIRE(way);
      CHECK(is_proved_free(space, Segment{way->from, way->to}));
      const auto back = map.edges(to ^ 1u);
      CHECK(std::find(back.begin(), back.end(), from ^ 1u) != back.end());
    }
  }
  CHECK(edges > 100);
  Scene other = maps::maze();
  CHECK_FALSE(map.matches(InflatedSpace::build(other.workspace).value()));
  CHECK_FALSE(TangentVisibilityGraph::prepare(space, Budget::for_seconds(-1)));
}

TEST_CASE("TangentGraph keeps the searcher contract") {
  // It may close a gap as wide as the robot: of 34 routes of A* among cells it finds 32.
  test::searcher_contract(TangentGraph{}, {.ties = test::Ties::not_proved, .found = 0.9});
}

/// The shortest path by trying everything: all circles, all edges between them, all arcs, no cones
/// and no estimates; Dijkstra from way to way.
class BruteForce {
 public:
  BruteForce(const InflatedSpace& space, const Point& start, const Point& goal) : space_(space) {
    circles_.push_back({start, 0, 1});
    circles_.push_back({goal, 0, 1});
    const double r = space.safety_radius() + 4 * space.distance_error_bound();
    for (const Obstacle& obstacle : space.workspace().obstacles) {
      if (const Disc* disc = std::get_if<Disc>(&obstacle)) {
        add(disc->center, disc->radius + r);
        continue;
      }
      const Polygon& polygon = std::get<Polygon>(obstacle);
      for (const Point& p : polygon.outer) add(p, r);
      for (const Ring& hole : polygon.holes) {
        for (const Point& p : hole) add(p, r);
      }
    }
    for (std::size_t i = 0; i < circles_.size(); ++i) {
      for (std::size_t j = 0; j < circles_.size(); ++j) {
        const auto way = i == j || i == 1 || j == 0
                             ? std::nullopt
                             : detail::tangent_line(circles_[i], circles_[j]);
        if (way && is_proved_free(space, Segment{way->from, way->to})) {
          edges_.push_back({i, j, *way});
        }
      }
    }
  }

  double length() const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<double> best(edges_.size(), infinity);
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    for (std::size_t w = 0; w < edges_.size(); ++w) {
      if (edges_[w].from == 0) open.push({best[w] = edges_[w].way.length, w});
    }
    while (!open.empty()) {
      const auto [cost, w] = open.top();
      open.pop();
      if (cost > best[w]) continue;
      if (edges_[w].to == 1) return cost;
      const detail::OrientedCircle& circle = circles_[edges_[w].to];
      for (std::size_t v = 0; v < edges_.size(); ++v) {
        if (edges_[v].from != edges_[w].to) continue;
        double turn = circle.side * turn_angle(edges_[w].way.direction, edges_[v].way.direction);
        if (turn < -1e-9) turn += 2 * pi;
        const double next = cost + circle.radius * std::fmax(turn, 0) + edges_[v].way.length;
        if (!(next < best[v]) || !is_free(circle, edges_[w].way.to, edges_[v].way.from, turn)) {
          continue;
        }
        open.push({best[v] = next, v});
      }
    }
    return infinity;
  }

 private:
  struct Way {
    std::size_t from, to;
    detail::TangentLine way;
  };

  void add(const Point& center, double radius) {
    for (const int side : {1, -1}) circles_.push_back({center, radius, side});
  }
  bool is_free(const detail::OrientedCircle& circle, const Point& in, const Point& out,
               double turn) const {
    if (distance(in, out) <= space_.distance_error_bound()) return true;
    Arc arc =
        Arc::around(circle.center, circle.radius, heading(in - circle.center), circle.side * turn);
    arc.a = in;
    arc.b = out;
    return is_proved_free(space_, arc);
  }

  const InflatedSpace& space_;
  std::vector<detail::OrientedCircle> circles_;
  std::vector<Way> edges_;
};

TEST_CASE("the tangent graph's paths are those of trying everything", "[soak]") {
  const std::uint64_t seed = 500;
  test::WorldGenerator worlds(seed);
  std::size_t paths = 0, none = 0, bent = 0;
  for (std::size_t round = 0; round < test::scaled(150); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Workspace world = worlds.workspace();
    const Point start = worlds.point(world), goal = worlds.point(world);
    if (!(world.safety_radius > 0) || start == goal) continue;
    const auto space = InflatedSpace::build(world).value();
    if (!space.is_free(start) || !space.is_free(goal)) continue;
    const double expected = BruteForce(space, start, goal).length();
    const auto route = search(space, {.start = start, .goal = goal});
    if (!route) {
      ++none;
      CHECK((route.error().code == PlanError::unreachable ||
             route.error().code == PlanError::not_proved));
      CHECK(expected == std::numeric_limits<double>::infinity());
      const TangentGraph prepared{.tangents = TangentGraph::prepare(space).value()};
      CHECK_FALSE(search(space, {.start = start, .goal = goal}, prepared));
      continue;
    }
    ++paths;
    if (route->curve.pieces().size() > 1) ++bent;
    if (expected == std::numeric_limits<double>::infinity()) {  // an end touches a safety zone
      CHECK((*detail::step_off_zone(space, start) != start ||
             *detail::step_off_zone(space, goal) != goal));
      CHECK(certify(space, route->curve).status == ProofStatus::proved);
      continue;
    }
    CHECK(route->cost == Approx(expected).epsilon(1e-9));
    CHECK(route->curve.start() == start);
    CHECK(route->curve.end() == goal);
    CHECK(certify(space, route->curve).status == ProofStatus::proved);
    CHECK(test::largest_corner(route->curve) < 1e-6);
    CHECK(search(space, {.start = goal, .goal = start})->cost == Approx(route->cost).epsilon(1e-9));
    const TangentGraph prepared{.tangents = TangentGraph::prepare(space).value()};
    CHECK(prepared.tangents->matches(space));
    CHECK(search(space, {.start = start, .goal = goal}, prepared)->cost ==
          Approx(route->cost).epsilon(1e-12));
    // A bound above the length changes nothing, one below leaves no path.
    const TangentGraph wide{.bound = route->cost * (1 + 1e-9)};
    CHECK(search(space, {.start = start, .goal = goal}, wide)->cost ==
          Approx(route->cost).epsilon(1e-12));
    const TangentGraph narrow{.bound = route->cost * (1 - 1e-9)};
    CHECK_FALSE(search(space, {.start = start, .goal = goal}, narrow));
  }
  CAPTURE(paths, bent, none);
  CHECK(paths > test::scaled(30));
  CHECK(bent > test::scaled(10));
}

TEST_CASE("no other planner is ever shorter than the tangent graph", "[soak]") {
  const std::uint64_t seed = 501;
  test::WorldGenerator worlds(seed);
  const auto searches = all_searches<LatticeSpace>();
  const auto smoothers = all_smoothers<LatticeSpace>();
  std::size_t plans = 0;
  double taut = 0, count = 0;
  for (std::size_t round = 0; round < test::scaled(40); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Workspace world = worlds.workspace();
    const Query query{.start = worlds.point(world), .goal = worlds.point(world)};
    if (!(world.safety_radius > 0)) continue;
    const auto space =
        LatticeSpace::build(world, {.resolution = world.bounds.width() / 30}).value();
    const auto optimum = search(space.inflated(), query);
    for (const auto& any_search : searches) {
      Planner planner{any_search};
      const auto plan = planner.plan(space, query);
      if (!plan) continue;
      if (!optimum) {  // only where an end touches a safety zone
        CHECK(optimum.error().code == PlanError::not_proved);
        continue;
      }
      for (const auto& smoother : smoothers) {
        INFO(any_search.name << " and " << smoother.name);
        const auto curve = smoother.smooth(space, plan->curve, {});
        if (!curve) {  // those that take polylines only
          CHECK(any_search.name == TangentGraph::name);
          CHECK(curve.error().code == PlanError::invalid_input);
          continue;
        }
        ++plans;
        CHECK(curve->length() >= optimum->cost * (1 - 1e-9));
        if (any_search.name == "astar" && smoother.name == "taut_string" && optimum->cost > 0) {
          taut += curve->length() / optimum->cost;
          ++count;
        }
      }
    }
  }
  INFO(plans << " plans, taut strings of A* " << taut / count << " times the optimum");
  CHECK(count * 3 > static_cast<double>(test::scaled(40)));
  CHECK(plans > test::scaled(40) * smoothers.size());
}

InflatedSpace space_with(std::vector<Obstacle> obstacles, double radius) {
  return InflatedSpace::build({.bounds = {{-50, -50}, {50, 50}},
                               .safety_radius = radius,
                               .obstacles = std::move(obstacles)})
      .value();
}

TEST_CASE("lengths in closed form: the open, a disc, a wall without area, a ring with a gap") {
  const Query across{.start = {-4, 0}, .goal = {4, 0}};
  CHECK(search(space_with({}, 1), across)->cost == 8);
  const auto disc = search(space_with({Disc{{0, 0}, 1}}, 1), across);
  CHECK(disc->cost == Approx(2 * std::sqrt(12.0) + 2 * (pi - 2 * std::acos(0.5))).epsilon(1e-12));
  const auto wall = search(space_with({Polygon{{{0, -3}, {0, 2}}}}, 1), across);
  const double tangent = std::sqrt(16 + 4 - 1.0);
  const double turn = 2 * (std::atan2(2, 4) + std::asin(1 / std::sqrt(20.0)));
  CHECK(wall->cost == Approx(2 * tangent + turn).epsilon(1e-12));

  const auto caged = space_with(
      {Polygon{{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}, {{{-8, -8}, {8, -8}, {8, 8}, {-8, 8}}}}}, 0.5);
  CHECK(search(caged, across)->cost == 8);
  CHECK(search(caged, {.start = {0, 0}, .goal = {20, 0}}).error().code == PlanError::unreachable);
}

TEST_CASE("with a shrinking disc the length becomes that among points") {
  const std::vector<Obstacle> obstacles{Polygon{{{-1, -2}, {1, -2}, {1, 3}, {-1, 3}}},
                                        Polygon{{{2, -9}, {3, -9}, {3, 1}, {2, 1}}}};
  // Below the first, over the second.
  const double point = std::hypot(3, 2) + 2 + std::hypot(1, 3) + 1 + std::hypot(1, 1);
  const double above = std::hypot(3, 3) + 2 + std::hypot(3, 3);
  double last = std::numeric_limits<double>::infinity();
  for (const double radius : {0.4, 0.1, 1e-2, 1e-3, 1e-4}) {
    const auto route = search(space_with(obstacles, radius), {.start = {-4, 0}, .goal = {4, 0}});
    REQUIRE(route);
    CHECK(route->cost < last);
    CHECK(route->cost - std::min(point, above) < 8 * radius);
    CHECK(route->cost >= std::min(point, above));
    last = route->cost;
  }
}

TEST_CASE("a path leads from an end at exactly the safety radius, and between two zones") {
  const auto space = space_with({Polygon{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}}, 0.1);
  const Query query{.start = {1.1, 0.3}, .goal = {-1.1, 0.3}};
  const auto route = search(space, query);
  REQUIRE(route);
  CHECK(route->curve.start() == query.start);
  CHECK(route->curve.end() == query.goal);
  CHECK(certify(space, route->curve).status == ProofStatus::proved);
  CHECK(route->cost == Approx(2 * 0.7 + 2 + pi * 0.1).epsilon(1e-9));
  // At radius 0: from the top of a disc into the seam between two polygons that touch.
  const auto seam = space_with({Disc{{5, 9}, 1}, Polygon{{{3, 2}, {5, 2}, {5, 4}, {3, 4}}},
                                Polygon{{{5, 2}, {7, 2}, {7, 4}, {5, 4}}}},
                               0);
  const auto into = search(seam, {.start = {5, 10}, .goal = {5, 3}});
  REQUIRE(into);
  CHECK(certify(seam, into->curve).status == ProofStatus::proved);
  // In a corridor just as wide as the robot there is no room to step aside.
  const auto tight =
      space_with({Polygon{{{-9, 1}, {9, 1}, {9, 2}, {-9, 2}}},
                  Polygon{{{-9, -2}, {9, -2}, {9, -1}, {-9, -1}}}, Disc{{0, 0}, 0.5}},
                 1);
  CHECK(search(tight, {.start = {-5, 0}, .goal = {5, 0}}).error().code == PlanError::not_proved);
}

TEST_CASE("bad bounds and bad ends are refused") {
  const auto space = space_with({Disc{{0, 0}, 1}}, 1);
  const Query across{.start = {-4, 0}, .goal = {4, 0}};
  const auto code = [](const Expected<Route, Failure>& result) {
    REQUIRE_FALSE(result);
    return result.error().code;
  };
  CHECK(code(search(space, across, {.bound = std::nan("")})) == PlanError::invalid_option);
  const auto unprepared = std::make_shared<const TangentVisibilityGraph>(space);
  CHECK(code(search(space, across, {.tangents = unprepared})) == PlanError::invalid_option);
  CHECK(code(search(space, {.start = {0, 1}, .goal = {4, 0}})) == PlanError::start_blocked);
  CHECK(code(search(space, {.start = {4, 0}, .goal = {99, 0}})) == PlanError::goal_out_of_bounds);
  CHECK(search(space, {.start = {4, 0}, .goal = {4, 0}})->cost == 0);
  Query limited = across;
  limited.budget.max_expansions = 1;
  CHECK(code(search(space, limited)) == PlanError::budget_exhausted);
}

}  // namespace
