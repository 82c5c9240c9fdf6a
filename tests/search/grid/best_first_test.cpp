// SPDX-License-Identifier: MIT
#include "tutavia/search/grid/best_first.hpp"

#include <vector>

#include "support/archetypes.hpp"
#include "support/catch.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

/// A graph given by its edges; node 0 is the source, the last one the target.
struct ListGraph {
  struct Edge {
    NodeId from, to;
    Cost cost;
  };
  std::size_t nodes;
  std::vector<Edge> edges;

  std::size_t size() const { return nodes; }
  NodeId source() const { return 0; }
  NodeId target() const { return static_cast<NodeId>(nodes - 1); }
  Point point(NodeId) const { return Point::Zero(); }
  template <class Visit>
  void for_each_successor(NodeId node, Visit visit) const {
    for (const Edge& edge : edges) {
      if (edge.from == node) visit(edge.to, edge.cost);
    }
  }
};

struct Outcome {
  std::optional<PlanError> stopped;
  Cost cost = -1;
  Statistics stats;
};

template <class H, class T = Untracked>
Outcome run(const ListGraph& graph, const H& heuristic, BestFirstScratch& scratch,
            const Budget& budget = {}, const T& tracking = {}) {
  Outcome outcome;
  const test::FreeArchetype space;
  const Query query{.budget = budget};
  NoObserver no_observer;
  detail::SearchContext<test::FreeArchetype, NoObserver> context{space, query, no_observer};
  const auto found = best_first(graph, heuristic, scratch, context, tracking);
  outcome.stats = context.statistics;
  if (found) {
    outcome.cost = scratch.find(graph.target())->g;
  } else {
    outcome.stopped = found.error().code;
  }
  return outcome;
}

const auto zero = [](NodeId) -> Cost { return 0; };

TEST_CASE("best-first search re-opens a node when a cheaper way to it is found") {
  // The admissible but inconsistent heuristic delays node 1, so node 2 is expanded too dear first.
  const ListGraph graph{4, {{0, 1, 1}, {0, 2, 4}, {1, 2, 1}, {2, 3, 10}}};
  const auto heuristic = [](NodeId node) -> Cost { return node == 1 ? 11 : 0; };
  BestFirstScratch scratch;
  const Outcome outcome = run(graph, heuristic, scratch);
  REQUIRE_FALSE(outcome.stopped);
  CHECK(outcome.cost == 12);
  CHECK(outcome.stats.expanded == 4);  // source, 2, 1, 2 again
  CHECK_FALSE(outcome.stats.distinct);
  const Outcome counted = run(graph, heuristic, scratch, {}, Tracked{});
  CHECK(counted.cost == 12);
  CHECK(counted.stats.expanded == 4);
  CHECK(counted.stats.distinct == 3u);
  const Outcome closed = run(graph, heuristic, scratch, {}, Tracked{Reopening::never});
  CHECK(closed.cost == 14);
  CHECK(closed.stats.expanded == 3);
  CHECK(closed.stats.distinct == 3u);
}

TEST_CASE("the goal counts when it is taken from the open list, not when it is seen") {
  const ListGraph graph{3, {{0, 2, 10}, {0, 1, 1}, {1, 2, 1}}};
  BestFirstScratch scratch;
  CHECK(run(graph, zero, scratch).cost == 2);
}

TEST_CASE("a search without a path says so, and the next one starts afresh") {
  BestFirstScratch scratch;
  CHECK(run({3, {{0, 1, 1}}}, zero, scratch).stopped == PlanError::unreachable);
  CHECK(run({3, {{0, 2, 7}}}, zero, scratch).cost == 7);
  CHECK(run({5, {{0, 4, 3}}}, zero, scratch).cost == 3);
  CHECK(run({2, {}}, zero, scratch).stopped == PlanError::unreachable);
}

TEST_CASE("a search stops at its budget of expansions") {
  const ListGraph chain{6, {{0, 1, 1}, {1, 2, 1}, {2, 3, 1}, {3, 4, 1}, {4, 5, 1}}};
  BestFirstScratch scratch;
  CHECK(run(chain, zero, scratch, Budget{.max_expansions = 4}).stopped ==
        PlanError::budget_exhausted);
  CHECK(run(chain, zero, scratch, Budget{.max_expansions = 5}).cost == 5);
}

TEST_CASE("costs beyond 32 bits add up exactly") {
  const Cost large = Cost{1} << 40;
  BestFirstScratch scratch;
  CHECK(run({4, {{0, 1, large}, {1, 2, large}, {2, 3, 1}}}, zero, scratch).cost == 2 * large + 1);
}

}  // namespace
