// SPDX-License-Identifier: MIT
#include "tutavia/smooth/taut_string.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "support/homotopy.hpp"
#include "support/random_grids.hpp"
#include "support/random_tasks.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "support/similarity.hpp"
#include "support/smoother_contract.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/metrics/path_metrics.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/smooth/shortcut.hpp"
#include "tutavia/smooth/string_pull.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;
using std::numbers::pi;

TEST_CASE("TautString keeps the smoother contract") { test::smoother_contract(TautString{}); }

InflatedSpace plane_with(std::vector<Obstacle> obstacles, double radius = 1) {
  return InflatedSpace::build({.bounds = {{-50, -50}, {50, 50}},
                               .safety_radius = radius,
                               .obstacles = std::move(obstacles)})
      .value();
}

Curve taut(const InflatedSpace& space, const std::vector<Point>& route) {
  const auto result = TautString{}.smooth(space, Curve::polyline(route), {});
  REQUIRE(result);
  CHECK(certify(space, *result).status == ProofStatus::proved);
  return *result;
}

TEST_CASE("around one post a string is two tangents and an arc") {
  const auto space = plane_with({Disc{{0, 0}, 1}});  // together with the radius: 2
  const Curve over = taut(space, {{-4, 0}, {-4, 6}, {4, 6}, {4, 0}});
  REQUIRE(over.pieces().size() == 3);
  const double tangent = std::sqrt(12.0), sweep = pi - 2 * std::acos(0.5);
  CHECK(over.length() == Approx(2 * tangent + 2 * sweep).epsilon(1e-12));
  const Arc& arc = *over.pieces()[1].get_if<Arc>();
  CHECK(arc.radius == Approx(2).epsilon(1e-12));
  CHECK(arc.sweep < 0);

  // Once around and a half: the arc is cut, the string goes on where it came from.
  const std::vector<Point> round{{-4, 0}, {0, 4}, {4, 0}, {0, -4}, {-4, -1}, {0, 5}, {5, 0}};
  const Curve loop = taut(space, round);
  CHECK(loop.length() ==
        Approx(std::sqrt(12.0) + std::sqrt(21.0) + 2 * (3 * pi - std::acos(0.5) - std::acos(0.4)))
            .epsilon(1e-12));
  CHECK(measure(loop).turning_angle > 2 * pi);
}

TEST_CASE("a string that nothing holds is straight, one that comes back is a point") {
  const auto space = plane_with({Disc{{0, 0}, 1}});
  const Curve straight = taut(space, {{-9, 4}, {-3, 8}, {0, 3}, {1, 3}, {2, 3}, {1, 3}, {9, 4}});
  CHECK(straight.pieces().size() == 1);
  const Curve back = taut(space, {{-9, 4}, {-3, 8}, {0, 3}, {-3, 8}, {-9, 4}});
  CHECK(back.length() == 0);
  CHECK(back.start() == Point(-9, 4));
  // Around the post and back again: nothing is left of it either.
  CHECK(taut(space, {{-4, 0}, {0, 4}, {4, 0}, {0, 4}, {-4, 0}}).length() == 0);
  CHECK(taut(space, {{-4, 0}, {0, 4}, {4, 0}, {0, -4}, {-4, 0}}).length() ==
        Approx(2 * std::sqrt(12.0) + 2 * (2 * pi - 2 * std::acos(0.5))).epsilon(1e-12));
}

TEST_CASE("walls without area hold a string, with all their vertices") {
  const auto space = plane_with({Polygon{{{-20, 0}, {0, 0}, {5, 1}, {0, 0}}}}, 0.5);
  const Curve around = taut(space, {{-10, 3}, {9, 3}, {9, -3}, {-10, -3}});
  CHECK(test::winds_around_nothing(
      space.workspace(), around,
      Curve::polyline(std::vector<Point>{{-10, 3}, {9, 3}, {9, -3}, {-10, -3}})));
  std::size_t arcs = 0;
  for (const Piece& piece : around.pieces()) arcs += piece.holds<Arc>() ? 1 : 0;
  CHECK(arcs >= 1);
  CHECK(measure(around).turning_points <= 2);
}

TEST_CASE("strings of random worlds are smooth, shorter, and pass all obstacles as the route does",
          "[soak]") {
  const std::uint64_t seed = 400;
  test::WorldGenerator worlds(seed);
  std::size_t strings = 0, corners = 0, same_class = 0, other_way = 0;
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto task = test::random_task(worlds);
    if (!task) continue;
    const auto space = InflatedSpace::build(task->world).value();
    const Curve route = Curve::polyline(task->route);
    const Curve string = TautString{}.smooth(space, route, {}).value();
    ++strings;
    CHECK(string.length() <= route.length() * (1 + 1e-12));
    CHECK(certify(space, string).status == ProofStatus::proved);
    CHECK(test::winds_around_nothing(task->world, string, route));
    // A start within rounding of the safety radius may hold a corner beside it.
    if (test::largest_corner(string) > 1e-6) {
      ++corners;
      continue;
    }
    const std::vector<Point> back(task->route.rbegin(), task->route.rend());
    const Curve reversed = TautString{}.smooth(space, Curve::polyline(back), {}).value();
    if (test::largest_corner(reversed) > 1e-6) continue;
    CHECK(reversed.length() == Approx(string.length()).epsilon(1e-9));

    const Curve cut = Shortcut{}.smooth(space, route, {}).value();
    if (!test::winds_around_nothing(task->world, cut, route)) {
      ++other_way;
      continue;
    }
    ++same_class;
    CHECK(TautString{}.smooth(space, cut, {}).value().length() ==
          Approx(string.length()).epsilon(1e-9));
  }
  CAPTURE(strings, corners, same_class, other_way);
  CHECK(strings > test::scaled(50));
  CHECK(corners * 50 <= strings);
  CHECK(same_class > strings / 2);
}

TEST_CASE("strings turn, move and scale with their world; what lies far off does not matter") {
  const std::uint64_t seed = 401;
  test::WorldGenerator worlds(seed);
  std::size_t compared = 0;
  for (std::size_t round = 0; round < test::scaled(100); ++round) {
    INFO("seed " << seed << ", round " << round);
    auto task = test::random_task(worlds);
    if (!task || task->world.bounds.largest_coordinate() > 100) continue;
    task->world.bounds = test::Similarity{}(task->world).bounds;
    const auto space = InflatedSpace::build(task->world).value();
    const Curve string = taut(space, task->route);
    if (test::largest_corner(string) > 1e-6) continue;
    const auto map = test::Similarity::random(worlds.random());
    const auto mapped_space = InflatedSpace::build(map(task->world)).value();
    const auto mapped = TautString{}.smooth(mapped_space, Curve::polyline(map(task->route)), {});
    if (!mapped || test::largest_corner(*mapped) > 1e-6) continue;  // a tie at the radius, rounded
    ++compared;
    CHECK(mapped->length() == Approx(map.scale * string.length()).epsilon(1e-9));

    // An obstacle outside the route's hull, grown by the radius, changes nothing at all.
    const Box hull = test::surroundings(task->route, task->world.safety_radius);
    Workspace more = task->world;
    more.obstacles.push_back(Disc{hull.max + Point(1, 0.5), 0.999});
    more.obstacles.push_back(
        Polygon{{hull.min, {hull.min.x(), hull.max.y()}, {hull.min.x() - 2, hull.max.y()}}});
    CHECK(test::same_curve(taut(InflatedSpace::build(more).value(), task->route), string));
  }
  CHECK(compared > test::scaled(25));
}

TEST_CASE("on cells a string for a point is the pulled string of the grid") {
  const std::uint64_t seed = 402;
  Random random(seed);
  std::size_t strings = 0, bent = 0;
  for (std::size_t round = 0; round < test::scaled(100); ++round) {
    INFO("seed " << seed << ", round " << round);
    OccupancyGrid grid = test::random_grid(random, 30);
    const double radius = random.below(2) == 0 ? 0 : random.uniform(0.05, 0.6);
    const auto space = CellSpace::build(grid, {.safety_radius = radius}).value();
    const Query query{.start = space.frame().point(test::random_cell(random, grid)),
                      .goal = space.frame().point(test::random_cell(random, grid))};
    AStar::Scratch scratch;
    NoObserver no_observer;
    const auto route = AStar{}.search(space, query, scratch, no_observer);
    if (!route) continue;
    const auto string = TautString{}.smooth(space, route->curve, {});
    REQUIRE(string);
    CHECK(certify(space, *string).status == ProofStatus::proved);
    CHECK(string->length() <= route->cost * (1 + 1e-12));
    ++strings;
    if (string->pieces().size() > 1) ++bent;
    if (radius > 0) {
      CHECK(test::largest_corner(*string) < 1e-6);
      continue;
    }
    const auto pulled = StringPull{}.smooth(space, route->curve, {});
    REQUIRE(pulled);
    CHECK(string->length() == Approx(pulled->length()).epsilon(1e-12));
  }
  CHECK(strings > test::scaled(40));
  CHECK(bent > test::scaled(15));
}

/// Whether two curves pass every vertex and disc on the same side.
bool same_class(const InflatedSpace& space, const Curve& a, const Curve& b) {
  return test::winds_around_nothing(space.workspace(), a, b);
}

TEST_CASE("strings bend at every corner of a ring that crosses itself, and at the ends of walls") {
  const auto crossing = plane_with({Polygon{{{-10, 10}, {-10, -10}, {4, 4}, {4, -4}}}}, 0.5);
  const Curve around = Curve::polyline(std::vector<Point>{{2, 6}, {8, 6}, {8, -6}, {2, -6}});
  const auto string = TautString{}.smooth(crossing, around, {});
  REQUIRE(string);
  CHECK(string->length() == Approx(14.530873).margin(1e-6));  // 24 if the corners were overlooked
  // The points of this wall are collinear but for rounding.
  const Point a(0.1, 0.2), b(0.1 + 0.1, 0.2 + 1.0), c(0.1 + 0.2, 0.2 + 2.0);
  const auto wall = plane_with({Polygon{{a, b, c}}}, 0.5);
  const Curve over = Curve::polyline(std::vector<Point>{{-4, 0}, {-4, 6}, {5, 6}, {5, 0}});
  const auto pulled = TautString{}.smooth(wall, over, {});
  REQUIRE(pulled);
  CHECK(pulled->length() < 11);
}

TEST_CASE("a bend of a whole turn is a bend") {
  const auto post = plane_with({Polygon{{{0, 0}}}}, 1);
  const std::vector<Point> loop{{-10, 1 + 1e-13}, {2, 1 + 1e-13},  {2, -2},
                                {-2, -2},         {-2, 1 + 1e-13}, {10, 1 + 1e-13}};
  const Curve string = taut(post, loop);
  CHECK(string.length() == Approx(20 + 2 * pi).epsilon(1e-9));
  CHECK(same_class(post, string, Curve::polyline(loop)));

  const auto posts = plane_with({Polygon{{{9, 2}}}, Polygon{{{10, 4}}}, Polygon{{{11, 6}}}}, 0.5);
  const std::vector<Point> between{{12, 8}, {13, 4}, {10, 3},     {9, 4.25}, {12, 6}, {11, 4},
                                   {9, 6},  {9, 5},  {12.5, 5.8}, {10, 2},   {8, 0}};
  CHECK(same_class(posts, taut(posts, between), Curve::polyline(between)));
}

TEST_CASE("circles that only the straight line would meet are not wound around") {
  const auto first =
      plane_with({Polygon{{{6.8, 6.8}}}, Polygon{{{7, 7}}}, Polygon{{{7, 5.5}}}}, 0.3);
  const std::vector<Point> hook{{3, 8}, {8, 4}, {7, 6.5}};
  const Curve around = taut(first, hook);
  CHECK(same_class(first, around, Curve::polyline(hook)));
  CHECK(around.length() < 7);
  const auto second =
      plane_with({Polygon{{{2.6, 1.9}}}, Polygon{{{3, 2.8}}}, Polygon{{{9.8, 3.3}}}}, 0.1);
  const std::vector<Point> there_and_back{{1, 3}, {14.9, 3.9}, {2.7, 1.9}};
  CHECK(same_class(second, taut(second, there_and_back), Curve::polyline(there_and_back)));
}

TEST_CASE("a large circle may bend a string twice, one within another not at all") {
  const auto discs = plane_with({Disc{{10, 5.9}, 0.5}, Disc{{10, 6.3}, 0.8}}, 0.01);
  const Curve over = taut(discs, {{16, 15}, {13, 2}, {5, 10}});
  CHECK(test::largest_corner(over) < 1e-6);
  CHECK(over.length() < 20);
  const auto rim = plane_with({Disc{{7, 6}, 1}, Disc{{7, 7}, 0}, Disc{{7, 6.2}, 0.5}}, 0.3);
  const Curve past = taut(rim, {{12, 7}, {6, 8}, {5.5, 5}});
  CHECK(test::largest_corner(past) < 1e-6);
  const auto corner =
      plane_with({Polygon{{{9.44, 2.63}, {8.94, 2.97}, {8.31, 2.83}, {8.58, 2.18}, {9.28, 2.17}}},
                  Disc{{9, 2.6}, 0.5}},
                 0.1);
  CHECK(test::largest_corner(taut(corner, {{2, 5}, {10, 0}, {14, 8}})) < 1e-6);
}

TEST_CASE("for a point a string along a wall holds at all its corners") {
  const auto square = plane_with({Polygon{{{6.5, 12.5}, {8, 12.5}, {8, 14}, {6.5, 14}}}}, 0);
  std::vector<Point> route{{8, 12}, {6, 12}, {6, 16}, {6.5, 16}, {8, 15}};
  const double shortest = std::hypot(1.5, 0.5) + 1.5 + std::hypot(1.5, 1);
  CHECK(taut(square, route).length() == Approx(shortest));
  std::reverse(route.begin(), route.end());
  CHECK(taut(square, route).length() == Approx(shortest));
}

TEST_CASE("routes that no search makes keep their class: loops, long legs, lattices of posts",
          "[soak]") {
  const std::uint64_t seed = 403;
  Random random(seed);
  std::size_t strings = 0, corners = 0;
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    INFO("seed " << seed << ", round " << round);
    std::vector<Obstacle> obstacles;
    const bool lattice = random.below(2) == 0;
    for (int i = 0; i < 12; ++i) {
      Point p{random.uniform(0, 16), random.uniform(0, 16)};
      if (lattice) p = Point(std::round(p.x()), std::round(p.y()));
      if (random.below(3) == 0) {
        obstacles.push_back(Disc{p, random.uniform(0, 1)});
      } else {
        obstacles.push_back(Polygon{{p}});
      }
    }
    const auto space = plane_with(obstacles, lattice ? 0.3 : random.uniform(0.05, 0.4));
    std::vector<Point> route;
    for (int i = 0; i < 400 && route.size() < 12; ++i) {
      const Point p{random.uniform(0, 16), random.uniform(0, 16)};
      if (route.empty() ? space.is_free(p) : space.segment_free(route.back(), p)) {
        route.push_back(p);
      }
    }
    if (route.size() < 2) continue;
    const Curve input = Curve::polyline(route);
    const Curve string = taut(space, route);
    ++strings;
    CHECK(string.length() <= input.length() * (1 + 1e-12));
    CHECK(same_class(space, string, input));
    if (test::largest_corner(string) > 1e-6) ++corners;
  }
  CAPTURE(strings, corners);
  CHECK(strings > test::scaled(250));
  CHECK(corners * 50 <= strings);
}

TEST_CASE("a string that runs out of time is what it is by then, a cancelled one is none") {
  const auto space = plane_with({Disc{{0, 0}, 1}});
  const Point route[] = {{-4, 0}, {-4, 6}, {4, 6}, {4, 0}};
  const Curve input = Curve::polyline(route);
  std::stop_source source;
  source.request_stop();
  CHECK(TautString{}.smooth(space, input, {.stop = source.get_token()}).error().code ==
        PlanError::cancelled);
}

TEST_CASE("a route that is not free is refused with its segment, and so are curves") {
  const auto space = plane_with({Disc{{0, 0}, 1}});
  const Point through[] = {{-4, 0}, {-4, 1}, {4, 1}};
  const auto refused = TautString{}.smooth(space, Curve::polyline(through), {});
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == PlanError::invalid_input);
  CHECK(refused.error().detail == "segment 1 of the route, from (-4, 1) to (4, 1), is not free");
  Curve bent;
  bent.push_back(QuadraticBezier{{Point(-4, 5), Point(0, 6), Point(4, 5)}});
  CHECK(TautString{}.smooth(space, bent, {}).error().code == PlanError::invalid_input);
  CHECK(TautString{}.smooth(space, Curve{}, {}).value().empty());
}

}  // namespace
