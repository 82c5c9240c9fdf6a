// SPDX-License-Identifier: MIT
#include "tutavia/smooth/redundant_node_removal.hpp"

#include <cmath>

#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
#include "support/smoother_contract.hpp"
#include "support/touching_run.hpp"
#include "tutavia/search/astar.hpp"

namespace {

using namespace tutavia;
using Scan = RedundantNodeRemoval::Scan;

TEST_CASE("RedundantNodeRemoval keeps the smoother contract") {
  test::smoother_contract(RedundantNodeRemoval{});
  test::smoother_contract(RedundantNodeRemoval{.scan = Scan::from_far_end});
}

/// Free space around a disc at (2, 0), half a metre of which is blocked.
InflatedSpace around_a_disc() {
  return InflatedSpace::build(
             {.bounds = {{-9, -9}, {9, 9}}, .safety_radius = 0.2, .obstacles = {Disc{{2, 0}, 0.3}}})
      .value();
}

std::vector<Point> nodes_after(const RedundantNodeRemoval& removal, const InflatedSpace& space,
                               const std::vector<Point>& nodes) {
  return waypoints(removal.smooth(space, Curve::polyline(nodes), Budget{}).value());
}

TEST_CASE("the forward scan stops at the first hidden node, the other one looks beyond") {
  const auto space = around_a_disc();
  const std::vector<Point> nodes{{0, 1}, {0, 0}, {0, -1}, {4, -1}, {4, 1}};
  REQUIRE(space.segment_free(nodes.front(), nodes.back()));
  const std::vector<Point> forward{{0, 1}, {0, -1}, {4, -1}, {4, 1}};
  CHECK(nodes_after({}, space, nodes) == forward);
  const std::vector<Point> straight{{0, 1}, {4, 1}};
  CHECK(nodes_after({.scan = Scan::from_far_end}, space, nodes) == straight);
}

TEST_CASE("a second forward scan can drop what the first one kept") {
  const auto space = around_a_disc();
  const std::vector<Point> nodes{{0, 1}, {0, -1}, {4, -1}, {-3, 0}};
  const std::vector<Point> once{{0, 1}, {0, -1}, {-3, 0}}, twice{{0, 1}, {-3, 0}};
  CHECK(nodes_after({}, space, nodes) == once);
  CHECK(nodes_after({}, space, once) == twice);
}

/// The forward scan word for word.
std::vector<Point> printed_removal(const LatticeSpace& space, const std::vector<Point>& nodes) {
  std::vector<Point> kept{nodes.front()};
  for (std::size_t i = 0, n = nodes.size() - 1; i < n;) {
    std::size_t j = i + 1;
    while (j + 1 <= n && space.segment_free(nodes[i], nodes[j + 1])) ++j;
    kept.push_back(nodes[j]);
    i = j;
  }
  return kept;
}

TEST_CASE("what is kept on random routes is what the scans say") {
  const std::uint64_t seed = 41;
  test::WorldGenerator worlds(seed);
  std::size_t routes = 0;
  for (std::size_t round = 0; round < test::scaled(60); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Workspace world = worlds.workspace();
    const auto space =
        LatticeSpace::build(world, {.resolution = world.bounds.width() / 40}).value();
    const auto route = test::search_once(
        AStar{}, space, {.start = worlds.point(world), .goal = worlds.point(world)});
    if (!route) continue;
    ++routes;
    const std::vector<Point> nodes = waypoints(detail::split_at_nodes(space, route->curve));
    CHECK(waypoints(RedundantNodeRemoval{}.smooth(space, route->curve, {}).value()) ==
          printed_removal(space, nodes));

    const RedundantNodeRemoval from_end{.scan = Scan::from_far_end};
    const auto kept = waypoints(from_end.smooth(space, route->curve, {}).value());
    auto at = nodes.begin();
    for (std::size_t i = 1; i < kept.size(); ++i) {
      at = std::find(at, nodes.end(), kept[i]);
      REQUIRE(at != nodes.end());
      CHECK((at + 1 == nodes.end() || !space.segment_free(kept[i - 1], at[1])));
    }
  }
  CHECK(routes > 10);
}

struct CountingSpace : InflatedSpace {
  explicit CountingSpace(InflatedSpace space) : InflatedSpace(std::move(space)) {}
  mutable std::size_t looks = 0;
  mutable std::stop_source stop{};
  std::size_t stop_at = 0;
  bool segment_free(const Point& p, const Point& q) const {
    if (++looks == stop_at) stop.request_stop();
    return InflatedSpace::segment_free(p, q);
  }
};

TEST_CASE("a scan ends soon after the budget does") {
  CountingSpace space(
      InflatedSpace::build({.bounds = {{-1, -1}, {99, 1}}, .safety_radius = 0.1}).value());
  std::vector<Point> points;
  for (int i = 0; i <= 900; ++i) points.emplace_back(0.1 * i, 0.1 * (i % 2));
  space.stop_at = 100;
  const auto result = RedundantNodeRemoval{}.smooth(space, Curve::polyline(points),
                                                    Budget{.stop = space.stop.get_token()});
  REQUIRE_FALSE(result);
  CHECK(result.error().code == PlanError::cancelled);
  CHECK(space.looks < 200);
}

TEST_CASE("n nodes take n lines of sight, from the far end n log n") {
  const CountingSpace space(
      InflatedSpace::build(
          {.bounds = {{-2, -2}, {2, 2}}, .safety_radius = 0.1, .obstacles = {Disc{{0, 0}, 1}}})
          .value());
  const double step = 3.0 / 1000;
  // At the first radius several nodes are in sight, at the second only the next one.
  for (const double radius : {1.2, 1.1 / std::cos(0.7 * step)}) {
    std::vector<Point> points;
    for (int i = 0; i <= 1000; ++i) {
      points.emplace_back(radius * std::cos(i * step), radius * std::sin(i * step));
    }
    const Curve input = Curve::polyline(points);
    // Every segment of the input is tested once, before lines of sight are.
    const auto lines = [&] { return space.looks - input.pieces().size(); };
    space.looks = 0;
    const auto forward = RedundantNodeRemoval{}.smooth(space, input, {}).value();
    CHECK(lines() <= 999);
    space.looks = 0;
    const RedundantNodeRemoval from_end{.scan = Scan::from_far_end};
    const auto backward = from_end.smooth(space, input, {}).value();
    CHECK(lines() <= (radius == 1.2 ? 100 : 20 * 1000));
    CHECK(test::same_curve(forward, backward));
    CHECK((forward.pieces().size() < 10) == (radius == 1.2));
  }
}

TEST_CASE("a run that touches a zone is kept where its rounded steps enter it") {
  const test::TouchingRun run = test::touching_run();
  for (const Scan scan : {Scan::forward, Scan::from_far_end}) {
    const auto result = RedundantNodeRemoval{.scan = scan}.smooth(run.space, run.input, {});
    REQUIRE(result);
    CHECK(test::same_curve(*result, run.input));
  }
}

TEST_CASE("removal of nodes leaves points alone and refuses what is no free polyline") {
  const auto space = around_a_disc();
  const std::vector<Point> point{{1, 1}}, resting{{1, 1}, {1, 1}, {2, 1}, {2, 1}};
  const std::vector<Point> blocked{{0, 0}, {4, 0}};
  Curve bent;
  bent.push_back(QuadraticBezier{{Point(0, 1), Point(1, 2), Point(2, 1)}});
  std::stop_source source;
  source.request_stop();
  for (const Scan scan : {Scan::forward, Scan::from_far_end}) {
    const RedundantNodeRemoval removal{.scan = scan};
    CHECK(removal.smooth(space, Curve{}, {}).value().empty());
    const auto rest = removal.smooth(space, Curve::polyline(point), {}).value();
    CHECK(test::same_curve(rest, Curve::polyline(point)));
    CHECK(nodes_after(removal, space, resting) == std::vector<Point>{{1, 1}, {2, 1}});
    for (const Curve& bad : {bent, Curve::polyline(blocked)}) {
      CHECK(removal.smooth(space, bad, {}).error().code == PlanError::invalid_input);
    }
    const auto cancelled =
        removal.smooth(space, Curve::polyline(resting), Budget{.stop = source.get_token()});
    CHECK(cancelled.error().code == PlanError::cancelled);
  }
}

}  // namespace
