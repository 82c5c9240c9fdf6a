// SPDX-License-Identifier: MIT
#include "tutavia/search/any_angle.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "support/catch.hpp"
#include "support/corner_paths.hpp"
#include "support/moving_ai_maps.hpp"
#include "support/prepared.hpp"
#include "support/random_grids.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/lazy_theta_star.hpp"
#include "tutavia/search/theta_star.hpp"

namespace {

using namespace tutavia;

Point point(test::Half p) { return {static_cast<double>(p.x) / 2, static_cast<double>(p.y) / 2}; }

/// A search on corners finds an allowed path, which is about as short as the shortest.
template <class A>
void check_corner_search(const CellSpace& space, const test::CornerRules& rules, const A& algorithm,
                         const Query& query, double shortest) {
  INFO(A::name);
  NoObserver no_observer;
  typename A::Scratch scratch;
  const auto route = algorithm.search(space, query, scratch, no_observer);
  REQUIRE(route);
  CHECK(route->curve.start() == query.start);
  CHECK(route->curve.end() == query.goal);
  CHECK(rules.allows(test::joints_in_halves(route->curve)));
  CHECK(route->cost >= shortest * (1 - 1e-9));
  CHECK(route->cost <= shortest * 1.1);
}

TEST_CASE("AnyAngle keeps the searcher contract, on rows and on a mesh") {
  test::searcher_contract(AnyAngle{}, {.robot = test::Robot::point});
  test::searcher_contract(test::PreparedEachTime<AnyAngle>{}, {.robot = test::Robot::point});
}

TEST_CASE("a query finds what it finds alone after one that was stopped") {
  const std::uint64_t seed = 610;
  Random random(seed);
  NoObserver no_observer;
  std::size_t found = 0, stopped = 0;
  for (std::size_t round = 0; round < 300; ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space = CellSpace::build(test::random_grid(random, 40)).value();
    const AnyAngle search{round % 2 == 0 ? nullptr : AnyAngle::prepare(space).value()};
    const auto center = [&] {
      return space.frame().point(test::random_cell(random, space.grid()));
    };
    Query first{center(), center()};
    first.budget.max_expansions = 1 + round % 20;
    const Query second{center(), center()};
    AnyAngle::Scratch scratch, unused;
    const auto cut_short = search.search(space, first, scratch, no_observer);
    const auto after = search.search(space, second, scratch, no_observer);
    const auto alone = search.search(space, second, unused, no_observer);
    REQUIRE(after.has_value() == alone.has_value());
    stopped += !cut_short && cut_short.error().code == PlanError::budget_exhausted;
    if (!alone) continue;
    ++found;
    CHECK(after->cost == alone->cost);
    CHECK(after->stats.expanded == alone->stats.expanded);
  }
  CHECK(found > 100);
  CHECK(stopped > 50);
}

TEST_CASE("any-angle paths are as short as a visibility graph's, between centres and corners",
          "[soak]") {
  const std::uint64_t seed = 600;
  Random random(seed);
  AnyAngle::Scratch scratch, prepared_scratch;
  NoObserver no_observer;
  std::size_t found = 0, bent = 0;
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space = CellSpace::build(test::random_grid(random, 40)).value();
    const OccupancyGrid& grid = space.grid();
    const test::CornerRules rules(grid);
    const auto place = [&] {
      const Cell cell = test::random_cell(random, grid);
      if (random.below(2) == 0) return test::centre_of(cell);
      return test::corner_of(
          cell + Cell{static_cast<int>(random.below(2)), static_cast<int>(random.below(2))});
    };
    const test::Half start = place(), goal = place();
    if (!space.is_free(point(start)) || !space.is_free(point(goal))) continue;
    const auto expected = rules.shortest(start, goal);
    const auto route = AnyAngle{}.search(space, {.start = point(start), .goal = point(goal)},
                                         scratch, no_observer);
    INFO("from " << start.x << ", " << start.y << " to " << goal.x << ", " << goal.y
                 << " in half cells");
    REQUIRE(route.has_value() == expected.has_value());
    if (!route) {
      CHECK(route.error().code == PlanError::unreachable);
      CHECK_FALSE(route.error().detail.empty());
      continue;
    }
    ++found;
    bent += route->curve.pieces().size() > 1 ? 1 : 0;
    CHECK(route->cost == Approx(*expected).epsilon(1e-9));
    CHECK(route->curve.start() == point(start));
    CHECK(route->curve.end() == point(goal));
    CHECK(rules.allows(test::joints_in_halves(route->curve)));
    CHECK(certify(space, route->curve).status == ProofStatus::proved);
    const AnyAngle prepared{.mesh = AnyAngle::prepare(space).value()};
    const auto again = prepared.search(space, {.start = point(start), .goal = point(goal)},
                                       prepared_scratch, no_observer);
    REQUIRE(again);
    CHECK(again->cost == Approx(*expected).epsilon(1e-9));
    CHECK(rules.allows(test::joints_in_halves(again->curve)));
    const Query query{.start = point(start), .goal = point(goal)};
    check_corner_search(space, rules, ThetaStar{NodePlacement::cell_corner}, query, *expected);
    check_corner_search(space, rules, LazyThetaStar{NodePlacement::cell_corner}, query, *expected);
  }
  CHECK(found > test::scaled(300) / 3);
  CHECK(bent > test::scaled(300) / 6);
}

TEST_CASE("starts and goals within rounding of a corner change nothing") {
  const std::uint64_t seed = 610;
  Random random(seed);
  AnyAngle::Scratch scratch;
  NoObserver no_observer;
  std::size_t found = 0, compared = 0;
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space =
        CellSpace::build(test::random_grid(random, 16), {.resolution = 0.03, .origin = {-3.7, 1e3}})
            .value();
    const AnyAngle prepared{.mesh = AnyAngle::prepare(space).value()};
    const auto corner = [&] { return space.corner(test::random_cell(random, space.grid())); };
    const auto beside = [&](double x) {
      return random.below(2) == 0 ? x : std::nextafter(x, random.below(2) == 0 ? -1e9 : 1e9);
    };
    const Point a = corner(), b = corner();
    const Point near_a{beside(a.x()), beside(a.y())}, near_b{beside(b.x()), beside(b.y())};
    const Query query{.start = near_a, .goal = near_b};
    const auto online = AnyAngle{}.search(space, query, scratch, no_observer);
    const auto on_mesh = prepared.search(space, query, scratch, no_observer);
    REQUIRE(online.has_value() == on_mesh.has_value());
    if (!online) continue;
    ++found;
    CHECK(online->cost == Approx(on_mesh->cost).epsilon(1e-9));
    const auto exact = AnyAngle{}.search(space, {.start = a, .goal = b}, scratch, no_observer);
    if (!exact) continue;
    ++compared;
    CHECK(online->cost >= exact->cost - 1e-9);
  }
  CHECK(compared > found / 2);
  CHECK(found > test::scaled(300) / 4);
}

TEST_CASE("no search on cells finds a shorter path than AnyAngle on the MovingAI maps") {
  NoObserver no_observer;
  test::for_each_moving_ai_map(test::scaled(20), [&](const test::MovingAiMap& map) {
    const CellSpace& space = map.space;
    const test::CornerRules rules(space.grid());
    const AnyAngle prepared{.mesh = AnyAngle::prepare(space).value()};
    AnyAngle::Scratch scratch;
    ThetaStar::Scratch theta;
    for (const ScenarioRow& row : map.rows) {
      INFO(map.name << " line " << row.line);
      const Query query = map.query(row);
      const auto route = AnyAngle{}.search(space, query, scratch, no_observer);
      REQUIRE(route);
      CHECK(route->cost <= row.optimal_length + 0.02);
      CHECK(rules.allows(test::joints_in_halves(route->curve)));
      const auto again = prepared.search(space, query, scratch, no_observer);
      REQUIRE(again);
      CHECK(again->cost == Approx(route->cost).epsilon(1e-9));
      CHECK(rules.allows(test::joints_in_halves(again->curve)));
      check_corner_search(space, rules, ThetaStar{NodePlacement::cell_corner}, query, route->cost);
      check_corner_search(space, rules, LazyThetaStar{NodePlacement::cell_corner}, query,
                          route->cost);
      const auto other = ThetaStar{}.search(space, query, theta, no_observer).value();
      const auto lazy = LazyThetaStar{}.search(space, query, theta, no_observer).value();
      CHECK(rules.allows(test::joints_in_halves(other.curve)));
      CHECK(rules.allows(test::joints_in_halves(lazy.curve)));
      CHECK(route->cost <= other.cost * (1 + 1e-9));
      CHECK(route->cost <= lazy.cost * (1 + 1e-9));
    }
  });
}

}  // namespace
