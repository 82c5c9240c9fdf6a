// SPDX-License-Identifier: MIT
#include "support/archetypes.hpp"

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "support/catch.hpp"
#include "support/registry.hpp"
#include "tutavia/optimum.hpp"
#include "tutavia/search/flow_field.hpp"
#include "tutavia/search/grid/goal_estimate.hpp"
#include "tutavia/search/grid/search_context.hpp"
#include "tutavia/search/grid/search_grid.hpp"
#include "tutavia/search/risk_zone.hpp"
#include "tutavia/search/search_record.hpp"
#include "tutavia/space/clearance_costs.hpp"
#include "tutavia/space/grid_builder.hpp"
#include "tutavia/tuning/ssa_tuning.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::test;

const Query query{.start = {1, 1}, .goal = {7, 5}};

template <class S>
void check_route(const Expected<Route, Failure>& route, const S& space) {
  REQUIRE(route);
  CHECK(route->curve.start() == query.start);
  CHECK(route->curve.end() == query.goal);
  CHECK(route->curve.length() >= distance(query.start, query.goal) * (1 - 1e-12));
  for (const Point& p : waypoints(route->curve)) CHECK(space.is_free(p));
}

/// Runs some searches on a new space of type S and notes their names.
class Runs {
 public:
  template <class S, class... Searches>
  void on(const Searches&... searches) {
    const S space;
    (run(searches, space), ...);
  }

  template <class A, class S>
  void run(const A& search, const S& space) {
    static_assert(Searcher<A, S>);
    INFO(A::name);
    typename A::Scratch scratch;
    ObserverArchetype observer;
    check_route(search.search(space, query, scratch, observer), space);
    names_.push_back(A::name);
  }

  bool has(std::string_view name) const {
    return std::find(names_.begin(), names_.end(), name) != names_.end();
  }

 private:
  std::vector<std::string_view> names_;
};

TEST_CASE("every search works on any space that has the operations its concept names") {
  Runs runs;
  runs.on<FreeArchetype>(Rrt{}, RrtStar{}, RrtConnect{}, InformedRrtStar{});
  runs.on<ClearanceArchetype>(SafeRrtStar{});
  runs.on<FeatureArchetype>(TangentGraph{});
  runs.on<WorkspaceArchetype>(AutoSearch{});
  runs.on<GridArchetype>(Dijkstra{}, AStar{}, WeightedAStar{}, CanonicalAStar{},
                         BidirectionalAStar{}, PenaltyAStar{}, SsaAStar{}, AntColony{},
                         JpsPlus{*JpsPlus::prepare(GridArchetype{})}, AutoSearch{});
  runs.on<JumpArchetype>(Jps{}, AutoSearch{});
  runs.on<SightArchetype>(ThetaStar{}, LazyThetaStar{});
  runs.on<StepSightArchetype>(ThetaStar{}, LazyThetaStar{});
  runs.on<JumpSightArchetype>(JpsThetaStar{},
                              JpsThetaStar{.lines_of_sight = JpsThetaStar::LineOfSight::in_search});
  runs.on<ColumnArchetype>(ReaStar{}, SbReaStar{});
  runs.on<ColumnSightArchetype>(ImprovedReaStar{});
  for (const auto& search : all_searches<LatticeSpace>()) {
    INFO(search.name);
    CHECK(runs.has(search.name));
  }
}

// And on no others.
static_assert(!Searcher<Rrt, int>);
static_assert(!Searcher<SafeRrtStar, GridArchetype>);
static_assert(!Searcher<TangentGraph, ClearanceArchetype>);
static_assert(!Searcher<TangentGraph, CornerArchetype>);
static_assert(!Searcher<AStar, LinkedArchetype> && !Searcher<AStar, StepArchetype>);
static_assert(!Searcher<Dijkstra, LinkedArchetype>);
static_assert(!Searcher<WeightedAStar, LinkedArchetype>);
static_assert(!Searcher<CanonicalAStar, LinkedArchetype>);
static_assert(!Searcher<BidirectionalAStar, LinkedArchetype>);
static_assert(!Searcher<PenaltyAStar, LinkedArchetype>);
static_assert(!Searcher<SsaAStar, LinkedArchetype>);
static_assert(!Searcher<AntColony, LinkedArchetype>);
static_assert(!Searcher<JpsPlus, LinkedArchetype>);
static_assert(!Searcher<Jps, GridArchetype>);
static_assert(!Searcher<ThetaStar, GridArchetype> && !Searcher<ThetaStar, StepArchetype>);
static_assert(!Searcher<LazyThetaStar, GridArchetype> && !Searcher<LazyThetaStar, StepArchetype>);
static_assert(!Searcher<ThetaStar, WithSight<WithNodes<LinkedArchetype>>>);
static_assert(!Searcher<JpsThetaStar, JumpArchetype> && !Searcher<JpsThetaStar, SightArchetype>);
static_assert(!Searcher<ReaStar, GridArchetype> && !Searcher<SbReaStar, GridArchetype>);
static_assert(!Searcher<ImprovedReaStar, ColumnArchetype>);
static_assert(!Searcher<ImprovedReaStar, SightArchetype>);
static_assert(!Searcher<AnyAngle, WorkspaceArchetype> && Searcher<AnyAngle, CellSpace>);

static_assert(!std::constructible_from<detail::FreeRectangles, const GridArchetype&>);

TEST_CASE("the registry lists the searches that work on a space") {
  const auto count = [](const auto& searches, std::string_view name) {
    return std::count_if(searches.begin(), searches.end(),
                         [&](const auto& search) { return search.name == name; });
  };
  const auto free = all_searches<FreeArchetype>();
  CHECK(free.size() == 4);
  CHECK(count(free, "rrt") == 1);
  CHECK(count(free, "tangent_graph") == 0);
  CHECK(count(all_searches<FeatureArchetype>(), "tangent_graph") == 1);
  CHECK(count(all_searches<FeatureArchetype>(), "auto") == 0);
  CHECK(count(all_searches<WorkspaceArchetype>(), "auto") == 1);
}

TEST_CASE("what is prepared for searches is made from any space of its concept") {
  const GridArchetype grid;
  const auto field = FlowField::build(grid, std::span(&query.goal, 1));
  REQUIRE(field);
  check_route(field->path(grid, query.start), grid);
  CHECK(field->reached(grid, {0, 0}));
  CHECK(field->nearest_reached(grid, query.start) == Cell{1, 1});
  const SsaTraining training{.swarm = {.population = 2, .iterations = 1}};
  CHECK(tune_ssa(std::span(&grid, 1), std::span(&query, 1), training));

  const ClearanceGridArchetype with_clearance;
  Runs runs;
  runs.run(AStar{.costs = clearance_costs(with_clearance, {}).value()}, with_clearance);
  runs.run(Dijkstra{.costs = clearance_costs(with_clearance, {}).value()}, with_clearance);

  const ClearanceArchetype clearance;
  const auto function = [&clearance](const Point& p) -> double { return clearance.clearance(p); };
  const GridBuilder builder(function, clearance.bounds(), 0.25);
  CHECK(builder.build({.resolution = 1})->grid().is_free({8, 8}));
  CHECK(RiskZone{}.cost(clearance, query.start, query.goal) == distance(query.start, query.goal));
  CHECK(RiskZone{}.length_inside(clearance, Curve{}).value == 0);

  const FeatureArchetype features;
  runs.run(TangentGraph{.tangents = *TangentGraph::prepare(features)}, features);
  CHECK(find_optimum(features, query).value() == Approx(distance(query.start, query.goal)));
  CHECK(TangentVisibilityGraph(features).updated(features, {}).value().matches(features));
}

/// Models StepCosts: all steps at one price.
struct PricesArchetype {
  static constexpr Cost scale = 2;
  Cost step_cost(Cell, std::size_t) const { return scale * straight_cost; }
};
static_assert(detail::StepCosts<PricesArchetype> && detail::StepCosts<CellCosts> &&
              detail::StepCosts<detail::PlainStepCosts>);
static_assert(!detail::StepCosts<int>);

/// Models GridSearch: steps from the first start to the first goal, or fails.
struct GridSearchArchetype {
  std::vector<Cell>& cells;
  std::optional<PlanError> error{};

  template <GridSpace S, Observer O>
  Expected<detail::GridPath, Failure> run(const detail::GridQuery& linked,
                                          detail::SearchContext<S, O>& context) const {
    context.count_expanded(linked.start_cell);
    context.count_generated(context.query.goal);
    if (error) return fail(*error);
    cells.assign({linked.goals.begin()->cell, linked.starts.begin()->cell});
    return detail::GridPath{cells, 42.0};
  }
};
static_assert(detail::GridSearch<GridSearchArchetype, GridArchetype, NoObserver>);
static_assert(!detail::GridSearch<int, GridArchetype, NoObserver>);

TEST_CASE("a search on a grid is run between the links of start and goal, and counted") {
  const GridArchetype space;
  std::vector<Cell> cells;
  SearchRecord record;
  const auto route = detail::search_grid(space, query, record, GridSearchArchetype{cells});
  check_route(route, space);
  CHECK(route->cost == 42);
  CHECK(route->stats.expanded == 1);
  REQUIRE(record.events.size() == 2);
  CHECK(record.events[0].a == query.start);
  CHECK(record.events[1].a == query.goal);

  const GridSearchArchetype failing{cells, PlanError::unreachable};
  const auto none = detail::search_grid(space, query, record, failing);
  REQUIRE_FALSE(none);
  CHECK(none.error().code == PlanError::unreachable_at_resolution);
  CHECK(none.error().stats.generated == 1);
}

TEST_CASE("a grid is searched by prices of any kind") {
  const GridArchetype space;
  detail::GridGraphScratch scratch;
  ObserverArchetype observer;
  const auto route =
      detail::graph_search(space, query, scratch, observer, PricesArchetype{},
                           [](const detail::GridQuery&) { return [](Cell) { return Cost{0}; }; });
  check_route(route, space);
  CHECK(route->cost == Approx(6));
}

/// Models JumpGuide.
struct GuideArchetype {
  using Open = detail::BinaryHeap;
  Cost estimate(Cell) const { return 0; }
};
static_assert(detail::JumpGuide<GuideArchetype> && !detail::LookBackGuide<GuideArchetype>);
static_assert(detail::JumpScanner<detail::PlaneScanner> &&
              !detail::PrefetchingScanner<detail::PlaneScanner>);
static_assert(!detail::JumpScanner<int> && !detail::JumpGuide<int> && !detail::OpenList<int>);
static_assert(!detail::BucketHeuristic<detail::GoalEstimate> &&
              detail::BucketHeuristic<detail::ZeroHeuristic>);

TEST_CASE("jump point search takes guides of any kind") {
  const JumpArchetype space;
  detail::JumpScratchWith<detail::BinaryHeap> scratch;
  ObserverArchetype observer;
  const detail::PlaneScanner scanner(space);
  check_route(detail::jump_search(
                  space, query, scanner, [](const detail::GridQuery&) { return GuideArchetype{}; },
                  scratch, observer, [](std::vector<Cell>&) {}),
              space);
}

/// Models RewiredTreeOptions.
struct TreeOptionsArchetype {
  std::optional<double> step{};
  double goal_bias = 0.5;
  std::uint32_t max_iterations = 100;
  Neighbours neighbours = Neighbours::radius;
  double rewire_factor = 1.1;
};

/// Models EdgeCost.
struct EdgeCostArchetype {
  double operator()(const Point&, const Point&, double length) const { return 2 * length; }
};

TEST_CASE("a tree grows by edge costs and samples of any kind") {
  const FreeArchetype space;
  const TreeOptionsArchetype options;
  ObserverArchetype observer;
  detail::RewiredTreeScratch scratch;
  detail::TreeGrowth growth(space, query, options.step, observer);
  const EdgeCostArchetype cost;
  detail::RewiredTree tree(growth, {options.neighbours, options.rewire_factor}, cost, scratch);
  const auto route = detail::grow(tree, growth, options, [](double) { return query.goal; });
  check_route(route, space);
  CHECK(route->cost == Approx(2 * route->curve.length()));
}

static_assert(detail::ConvexPieces<detail::FreeRuns> &&
              !detail::PiecesWithDeadEnds<detail::FreeRuns>);
static_assert(detail::PiecesWithDeadEnds<NavigationMesh>);
static_assert(detail::CellwiseEvaluation<detail::OctileCost>);
static_assert(detail::ExitEvaluation<detail::MidpointCost>);
static_assert(!detail::CellwiseEvaluation<detail::MidpointCost>);

}  // namespace
