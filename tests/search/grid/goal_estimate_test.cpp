// SPDX-License-Identifier: MIT
#include "tutavia/search/grid/goal_estimate.hpp"

#include <algorithm>
#include <initializer_list>
#include <limits>

#include "support/catch.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

/// A goal at a cell, or between the cells around it where `links` says so.
GridQuery query_to(Cell goal, const EndpointLinks& links) {
  GridQuery linked;
  linked.goal_cell = goal;
  linked.goals = CellLinks(links, 1);
  linked.goal_offset = GridQuery::least_offset(linked.goals, goal);
  return linked;
}

EndpointLinks links_of(std::initializer_list<EndpointLink> list) {
  EndpointLinks links;
  for (const EndpointLink& link : list) links.push_back(link);
  return links;
}

TEST_CASE("estimates to a cell are the distances of their names") {
  const GridQuery linked = query_to({10, 5}, links_of({{{10, 5}, 0}}));
  const auto estimate = [&](HeuristicKind heuristic) {
    return GoalEstimate(heuristic, linked)({7, 1});  // 3 columns and 4 rows away
  };
  CHECK(estimate(HeuristicKind::octile) == straight_cost + 3 * diagonal_cost);
  CHECK(estimate(HeuristicKind::euclidean) == 5 * straight_cost);
  CHECK(estimate(HeuristicKind::chebyshev) == 4 * straight_cost);
  CHECK(estimate(HeuristicKind::manhattan) == 7 * straight_cost);
  CHECK(OctileHeuristic(linked)({7, 1}) == estimate(HeuristicKind::octile));
  CHECK(ZeroHeuristic(linked)({7, 1}) == 0);
}

TEST_CASE("a goal off the grid is estimated by its links, and no estimate exceeds the cost") {
  // The goal lies between the cells (10, 5) and (11, 5), nearer to the former.
  const GridQuery linked = query_to({10, 5}, links_of({{{10, 5}, 0.4}, {{11, 5}, 0.6}}));
  for (const HeuristicKind heuristic :
       {HeuristicKind::octile, HeuristicKind::euclidean, HeuristicKind::chebyshev}) {
    const GoalEstimate estimate(heuristic, linked);
    for (int x = 0; x <= 20; ++x) {
      for (int y = 0; y <= 10; ++y) {
        Cost cost = std::numeric_limits<Cost>::max();
        for (const auto& [cell, link] : linked.goals) {
          cost = std::min(cost, link + octile_cost({x, y}, cell));
        }
        CAPTURE(static_cast<int>(heuristic), x, y);
        CHECK(estimate({x, y}) <= cost);
        CHECK(estimate({x, y}) >= 0);
        CHECK(OctileHeuristic(linked)({x, y}) <= cost);
      }
    }
  }
  CHECK(GoalEstimate(HeuristicKind::octile, linked)({11, 5}) < straight_cost);
}

}  // namespace
