// SPDX-License-Identifier: MIT
#include "tutavia/smooth/string_pull.hpp"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "support/catch.hpp"
#include "support/corner_paths.hpp"
#include "support/random_grids.hpp"
#include "support/scale.hpp"
#include "support/skip.hpp"
#include "support/smoother_contract.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/io/moving_ai.hpp"
#include "tutavia/search/any_angle.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/jps.hpp"
#include "tutavia/search/theta_star.hpp"

namespace {

using namespace tutavia;

/// Whether no bend can be drawn straighter: each lies against a blocked cell on its inner side.
bool is_taut(const OccupancyGrid& grid, const std::vector<test::Half>& path) {
  const test::CornerRules rules(grid);
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const test::Half a = path[i - 1], b = path[i], c = path[i + 1];
    if (b.x % 2 != 0 || b.y % 2 != 0) return false;
    const std::int64_t bend = (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
    // Some cell around the corner is blocked and lies between the two sides of the bend.
    bool against = false;
    for (const int dy : {-1, 0}) {
      for (const int dx : {-1, 0}) {
        const std::int64_t x = b.x / 2 + dx, y = b.y / 2 + dy;
        const test::Half middle{2 * x + 1, 2 * y + 1};
        const auto side = [&](test::Half p, test::Half q) {
          const std::int64_t area = (q.x - p.x) * (middle.y - p.y) - (q.y - p.y) * (middle.x - p.x);
          return bend > 0 ? area : -area;
        };
        against = against || (rules.blocked(x, y) && side(a, b) > 0 && side(b, c) > 0);
      }
    }
    if (bend == 0 || !against) return false;
  }
  return true;
}

TEST_CASE("StringPull keeps the smoother contract") {
  test::smoother_contract(StringPull{}, {.robot = test::Robot::point});
}

TEST_CASE("strings pulled from shortest paths are shortest, from others taut and no longer") {
  const std::uint64_t seed = 660;
  Random random(seed);
  NoObserver no_observer;
  AStar::Scratch astar;
  ThetaStar::Scratch theta;
  AnyAngle::Scratch any_angle;
  std::size_t found = 0, shorter = 0;
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space = CellSpace::build(test::random_grid(random, 40)).value();
    const OccupancyGrid& grid = space.grid();
    const test::CornerRules rules(grid);
    const Point start = space.frame().point(test::random_cell(random, grid));
    const Point goal = space.frame().point(test::random_cell(random, grid));
    const Query query{.start = start, .goal = goal};
    const auto shortest = AnyAngle{}.search(space, query, any_angle, no_observer);
    if (!shortest) continue;
    const auto again = StringPull{}.smooth(space, shortest->curve, {});
    REQUIRE(again);
    CHECK(again->length() == Approx(shortest->cost).epsilon(1e-12));

    for (const auto& route :
         {AStar{}.search(space, query, astar, no_observer),
          ThetaStar{}.search(space, query, theta, no_observer),
          ThetaStar{NodePlacement::cell_corner}.search(space, query, theta, no_observer)}) {
      REQUIRE(route);
      const auto pulled = StringPull{}.smooth(space, route->curve, {});
      REQUIRE(pulled);
      ++found;
      shorter += pulled->length() < route->cost * (1 - 1e-9) ? 1 : 0;
      CHECK(pulled->start() == start);
      CHECK(pulled->end() == goal);
      CHECK(pulled->length() <= route->cost * (1 + 1e-12));
      CHECK(pulled->length() >= shortest->cost * (1 - 1e-12));
      CHECK(rules.allows(test::joints_in_halves(*pulled)));
      CHECK(is_taut(grid, test::joints_in_halves(*pulled)));
      CHECK(certify(space, *pulled).status == ProofStatus::proved);
      // Once taut, it stays as it is; pulled from the other end as well.
      const auto twice = StringPull{}.smooth(space, *pulled, {});
      REQUIRE(twice);
      CHECK(test::joints_in_halves(*twice) == test::joints_in_halves(*pulled));
    }
  }
  CHECK(found > test::scaled(300));
  CHECK(shorter > test::scaled(300) / 4);
}

/// A random walk over cells crosses itself and runs around blocked ones; pulled, it keeps its
/// class: its winding numbers around every blocked cell, if it is closed by its straight line.
TEST_CASE("a string keeps its winding around every blocked cell") {
  const std::uint64_t seed = 661;
  Random random(seed);
  std::size_t walks = 0, wound = 0;
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space = CellSpace::build(test::random_grid(random, 12)).value();
    const OccupancyGrid& grid = space.grid();
    Cell at = test::random_cell(random, grid);
    if (!grid.is_free(at)) continue;
    Curve walk;
    for (int i = 0; i < 600; ++i) {
      const std::size_t step = random.below(8);
      if (!grid.can_step(at, step, MovementRule::no_cut)) continue;
      const Cell next = at + steps[step];
      walk.push_back(Segment{space.frame().point(at), space.frame().point(next)});
      at = next;
    }
    if (walk.empty()) continue;
    ++walks;
    const auto pulled = StringPull{}.smooth(space, walk, {});
    REQUIRE(pulled);
    CHECK(pulled->length() <= walk.length() * (1 + 1e-12));
    CHECK(test::CornerRules(grid).allows(test::joints_in_halves(*pulled)));
    CHECK((pulled->pieces().size() < 2 || is_taut(grid, test::joints_in_halves(*pulled))));
    // The angle by which the way from start to end turns around a point is the same.
    const auto turning = [](const Curve& curve, const Point& around) {
      double sum = 0;
      for (const Piece& piece : curve.pieces()) {
        const Point a = start_of(piece) - around, b = end_of(piece) - around;
        sum += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
      }
      return sum;
    };
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        if (grid.is_free(Cell{x, y})) continue;
        const Point middle = space.frame().point(Cell{x, y});
        const double before = turning(walk, middle), after = turning(*pulled, middle);
        CHECK(before == Approx(after).margin(1e-6));
        wound += std::abs(before) > 3.2 ? 1 : 0;
      }
    }
  }
  CHECK(walks > test::scaled(300) / 3);
  CHECK(wound > test::scaled(300) / 10);
}

TEST_CASE("strings on the MovingAI maps are free, taut and not shorter than the optimum") {
  const char* folder = test::moving_ai_folder();
  if (folder == nullptr) return;
  NoObserver no_observer;
  Jps::Scratch scratch;
  AnyAngle::Scratch any_angle;
  std::size_t strings = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".map") continue;
    const auto space = CellSpace::build(read_moving_ai_map(entry.path()).value()).value();
    const auto scenario = read_moving_ai_scenario(entry.path().string() + ".scen").value();
    const AnyAngle optimal{.mesh = AnyAngle::prepare(space).value()};
    const std::size_t count = std::min(test::scaled(20), scenario.size());
    for (std::size_t i = 0; i < count; ++i) {
      const ScenarioRow& row = scenario[i * scenario.size() / count];
      INFO(entry.path().string() << " line " << row.line);
      const Query query{.start = space.frame().point(row.start),
                        .goal = space.frame().point(row.goal)};
      const auto route = Jps{}.search(space, query, scratch, no_observer).value();
      const auto pulled = StringPull{}.smooth(space, route.curve, {});
      REQUIRE(pulled);
      ++strings;
      CHECK(pulled->length() <= route.cost * (1 + 1e-12));
      CHECK(pulled->length() >=
            optimal.search(space, query, any_angle, no_observer).value().cost * (1 - 1e-9));
      CHECK(test::CornerRules(space.grid()).allows(test::joints_in_halves(*pulled)));
      CHECK(is_taut(space.grid(), test::joints_in_halves(*pulled)));
    }
  }
  CHECK(strings > 0);
}

TEST_CASE("a segment is followed exactly where the competition's rules allow it") {
  const std::uint64_t seed = 662;
  Random random(seed);
  std::size_t allowed = 0, refused = 0;
  for (std::size_t round = 0; round < test::scaled(3000); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space = CellSpace::build(test::random_grid(random, 14)).value();
    const test::CornerRules rules(space.grid());
    const auto any = [&] {
      const auto below = [&](int cells) {
        return static_cast<std::int64_t>(random.below(2 * static_cast<std::uint32_t>(cells) + 1));
      };
      return test::Half{below(space.grid().width()), below(space.grid().height())};
    };
    const auto point = [](test::Half h) {
      return Point(static_cast<double>(h.x) / 2, static_cast<double>(h.y) / 2);
    };
    for (int i = 0; i < 20; ++i) {
      const test::Half a = any(), b = any();
      if (a == b || !space.is_free(point(a)) || !space.is_free(point(b))) continue;
      const Point ends[] = {point(a), point(b)};
      const auto pulled = StringPull{}.smooth(space, Curve::polyline(ends), {});
      const bool expected = rules.allows(a, b);
      REQUIRE(pulled.has_value() == expected);
      if (expected) CHECK(pulled->pieces().size() == 1);
      (expected ? allowed : refused) += 1;
    }
  }
  CHECK(allowed > test::scaled(3000));
  CHECK(refused > test::scaled(3000));
}

TEST_CASE("strings run along lines of the grid and refuse what is not free") {
  OccupancyGrid grid = OccupancyGrid::blocked(6, 4).value();
  for (int y = 0; y < 4; ++y) grid.set_run(y, 0, 5, true);
  grid.set({2, 1}, false);
  grid.set({3, 2}, false);  // touches the other by the corner (3, 2)
  const auto space = CellSpace::build(grid).value();
  const auto pull = [&](std::initializer_list<Point> points) {
    Curve curve;
    const Point* from = points.begin();
    for (const Point* to = from + 1; to != points.end(); from = to++) {
      curve.push_back(Segment{*from, *to});
    }
    return StringPull{}.smooth(space, curve, {});
  };
  // Along the map's border, along blocked cells, up and down a line between cells.
  CHECK(pull({{0, 0}, {6, 0}, {6, 4}, {0, 4}}).value().pieces().size() >= 2);
  CHECK(pull({{0, 1}, {5, 1}}).value().pieces().size() == 1);
  CHECK(pull({{2, 0}, {2, 4}}).value().pieces().size() == 1);
  CHECK(pull({{0, 2}, {3, 2}}).value().length() == 3);
  // A way there and back is nothing.
  CHECK(pull({{0.5, 0.5}, {5.5, 0.5}, {0.5, 0.5}}).value().length() == 0);
  for (const auto& refused : {pull({{0, 2}, {6, 2}}), pull({{2.5, 2.5}, {3.5, 1.5}}),
                              pull({{3, 1}, {3, 3}}), pull({{2.5, 0.5}, {2.5, 3.5}}),
                              pull({{0.5, 0.5}, {7, 0.5}}), pull({{2.5, 1.5}, {2.5, 1.25}})}) {
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == PlanError::invalid_input);
  }
  Curve bent;
  bent.push_back(CubicBezier{{Point(0, 0), Point(1, 0), Point(2, 0), Point(3, 0)}});
  CHECK(StringPull{}.smooth(space, bent, {}).error().code == PlanError::invalid_input);
  const auto wide = CellSpace::build(grid, {.safety_radius = 0.1}).value();
  CHECK(StringPull{}.smooth(wide, Curve{}, {}).error().code == PlanError::invalid_option);
  CHECK(StringPull{}.smooth(space, Curve{}, {}).value().empty());
}

}  // namespace
