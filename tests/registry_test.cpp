// SPDX-License-Identifier: MIT

#include <algorithm>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "support/registry.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;

static_assert(Searcher<AnySearch<LatticeSpace>, LatticeSpace>);
static_assert(Smoother<AnySmoother<LatticeSpace>, LatticeSpace>);

TEST_CASE("algorithms chosen by name give what the algorithms themselves give") {
  const Scene scene = maps::maze();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.2}).value();
  const Query query{.start = scene.start, .goal = scene.goals[0]};
  const auto searches = all_searches<LatticeSpace>();
  const auto smoothers = all_smoothers<LatticeSpace>();
  const auto named = [](const auto& all, std::string_view name) {
    for (const auto& any : all) {
      if (any.name == name) return any;
    }
    FAIL("no algorithm is called " << name);
    return all.front();
  };
  Planner by_name{named(searches, "astar"), named(smoothers, "delta")};
  Planner by_type{AStar{}, DeltaSmoother{}};
  CHECK(test::same_curve(by_name.plan(space, query).value().curve,
                         by_type.plan(space, query).value().curve));
  CHECK(named(searches, "dijkstra").name == "dijkstra");
  CHECK(named(smoothers, "none").name == "none");
  CHECK(named(smoothers, "shortcut").name == "shortcut");

  const auto count = [](const SearchRecord& record, SearchRecord::Event::Kind kind) {
    return static_cast<std::uint64_t>(
        std::count_if(record.events.begin(), record.events.end(),
                      [&](const SearchRecord::Event& event) { return event.kind == kind; }));
  };
  using Kind = SearchRecord::Event::Kind;
  for (const auto& search : searches) {
    INFO(search.name);
    SearchRecord record;
    AnySearch<LatticeSpace>::Scratch scratch;
    const auto route = search.search(space, query, scratch, record);
    REQUIRE(route);
    const bool is_tree = search.name.find("rrt") != std::string_view::npos;
    // Trees count tries, of which those that fail add no node.
    CHECK(count(record, Kind::expanded) <= route->stats.expanded);
    if (!is_tree) CHECK(count(record, Kind::expanded) == route->stats.expanded);
    if (search.name == "rrt") CHECK(count(record, Kind::edge) == route->stats.generated);
    CHECK((count(record, Kind::edge) > 0) == is_tree);
    const bool is_rectangles = search.name.find("rea_star") != std::string_view::npos;
    CHECK(count(record, Kind::rectangle) == (is_rectangles ? route->stats.expanded : 0));
    CHECK(count(record, Kind::interval) == count(record, Kind::rectangle));
  }
}

TEST_CASE("one scratch serves searches of any kind, one after the other") {
  const Scene scene = maps::array();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.2}).value();
  AnySearch<LatticeSpace>::Scratch shared;
  NoObserver no_observer;
  for (const Point& goal : scene.goals) {
    const Query query{.start = scene.start, .goal = goal, .seed = 3};
    for (const auto& search : all_searches<LatticeSpace>()) {
      INFO(search.name);
      AnySearch<LatticeSpace>::Scratch own;
      const auto expected = search.search(space, query, own, no_observer);
      const auto route = search.search(space, query, shared, no_observer);
      REQUIRE(route);
      CHECK(test::same_curve(route->curve, expected->curve));
    }
  }
}

template <class All, class Make>
void check_made_like(const All& all, const Make& make) {
  for (const auto& any : all) {
    INFO(any.name);
    const auto made = make(any.name, {});
    REQUIRE(made);
    CHECK(made->name == any.name);
    CHECK(made->options.size() == any.options.size());
  }
}

TEST_CASE("every algorithm can be made by its name") {
  check_made_like(all_searches<LatticeSpace>(), &make_search<LatticeSpace>);
  check_made_like(all_smoothers<LatticeSpace>(), &make_smoother<LatticeSpace>);
}

TEST_CASE("an algorithm made with options plans as its own value with these members does") {
  const Scene scene = maps::maze();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.2}).value();
  const Query query{.start = scene.start, .goal = scene.goals[0], .seed = 7};
  const std::vector<OptionText> tree{{"max_iterations", "2500"}, {"goal_bias", "0.2"}};
  const std::vector<OptionText> arcs{{"corner_threshold", "0.1"}, {"join", "tangent"}};
  const auto search = make_search<LatticeSpace>("rrt_star", tree).value();
  const auto smoother = make_smoother<LatticeSpace>("delta", arcs).value();
  Planner by_name{search, smoother};
  Planner by_type{RrtStar{.goal_bias = 0.2, .max_iterations = 2500},
                  DeltaSmoother{.corner_threshold = 0.1, .join = DeltaSmoother::Join::tangent}};
  Planner by_default{RrtStar{}, DeltaSmoother{}};
  const auto plan = by_name.plan(space, query).value();
  CHECK(test::same_curve(plan.curve, by_type.plan(space, query).value().curve));
  CHECK_FALSE(test::same_curve(plan.curve, by_default.plan(space, query).value().curve));

  REQUIRE(search.options.size() == 5);
  CHECK(search.options[0].name == "step");
  CHECK(std::holds_alternative<std::monostate>(search.options[0].value));
  CHECK(std::get<double>(search.options[1].value) == 0.2);
  CHECK(std::get<std::uint64_t>(search.options[2].value) == 2500);
  CHECK(std::get<std::string>(search.options[3].value) == "k_nearest");
  REQUIRE(smoother.options.size() == 1);
  const auto chained = detail::chain(smoother, make_smoother<LatticeSpace>("bezier").value());
  REQUIRE(chained.options.size() == 2);
  CHECK(chained.options[0].size() == smoother.options[0].size());
  CHECK(chained.options[1][0].name == "trim");
}

TEST_CASE("searches and smoothers for vehicles are made by name, and stand in lists of their own") {
  const auto has_name = [](const auto& all, std::string_view name) {
    return std::any_of(all.begin(), all.end(), [&](const auto& any) { return any.name == name; });
  };
  CHECK(has_name(vehicle_searches<LatticeSpace>(), "hybrid_astar"));
  CHECK(has_name(vehicle_smoothers<LatticeSpace>(), "vehicle_shortcut"));
  CHECK(has_name(vehicle_smoothers<LatticeSpace>(), "continuous_curvature"));
  CHECK_FALSE(has_name(all_searches<LatticeSpace>(), "hybrid_astar"));
  CHECK_FALSE(has_name(all_smoothers<LatticeSpace>(), "vehicle_shortcut"));
  check_made_like(vehicle_searches<LatticeSpace>(), &make_search<LatticeSpace>);
  check_made_like(vehicle_smoothers<LatticeSpace>(), &make_smoother<LatticeSpace>);
  for (const auto& search : vehicle_searches<LatticeSpace>()) CHECK(search.for_vehicle);
  for (const auto& search : all_searches<LatticeSpace>()) CHECK_FALSE(search.for_vehicle);
  for (const auto& smoother : vehicle_smoothers<LatticeSpace>()) CHECK(smoother.run_for_vehicle);
}

TEST_CASE("a search for vehicles takes its vehicle as options, or another one with a footprint") {
  const Scene scene = maps::array();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.5}).value();
  const Query query{.start = scene.start, .goal = scene.goals[0], .start_heading = 0.3};
  const std::vector<OptionText> texts{
      {"vehicle.min_turning_radius", "0.7"}, {"vehicle.reverse", "false"}, {"cusp_cost", "2.5"}};
  const auto search = make_search<LatticeSpace>("hybrid_astar", texts).value();
  REQUIRE(search.options.size() >= 3);
  CHECK(search.options[0].name == "vehicle.min_turning_radius");
  CHECK(std::get<double>(search.options[0].value) == 0.7);
  CHECK(std::get<bool>(search.options[1].value) == false);
  const auto smoother = make_smoother<LatticeSpace>("vehicle_shortcut").value();
  Planner by_name{search, smoother};
  const auto plan = by_name.plan(space, query).value();
  Planner by_type{HybridAStar{.vehicle = Vehicle::point(0.7), .cusp_cost = 2.5}, VehicleShortcut{}};
  const auto same = by_type.plan(space, query).value();
  CHECK(test::same_curve(plan.curve, same.curve));
  CHECK(plan.gears == same.gears);
  REQUIRE(plan.route.vehicle);
  CHECK(plan.route.vehicle->min_turning_radius == 0.7);

  const auto wide = search.for_vehicle(Vehicle::disc(0.2, 1.2, true));
  CHECK(wide.name == "hybrid_astar");
  Planner for_wide{wide, smoother};
  const auto other = for_wide.plan(space, query).value();
  REQUIRE(other.route.vehicle);
  CHECK(other.route.vehicle->min_turning_radius == 1.2);
  CHECK(other.route.vehicle->footprint.front().radius == 0.2);
  CHECK(other.route.cost >= other.route.curve.length());

  // Other smoothers keep no headings.
  Planner refused{search, make_smoother<LatticeSpace>("delta").value()};
  const auto none = refused.plan(space, query);
  REQUIRE_FALSE(none);
  CHECK(none.error().code == PlanError::invalid_option);
}

TEST_CASE("unknown names and options are refused, and values out of range by the search itself") {
  const auto unknown = make_search<LatticeSpace>("rrt_sta");
  REQUIRE_FALSE(unknown);
  CHECK(unknown.error().code == PlanError::invalid_option);
  CHECK(unknown.error().detail == "unknown name \"rrt_sta\"; did you mean rrt_star?");
  const auto far = make_smoother<LatticeSpace>("silk");
  REQUIRE_FALSE(far);
  CHECK(far.error().detail.find("unknown name \"silk\"; known: none shortcut ") == 0);
  CHECK_FALSE(make_search<LatticeSpace>("any_angle"));  // on cells alone
  const std::vector<OptionText> misspelt{{"wieght", "2"}};
  const auto option = make_search<LatticeSpace>("weighted_astar", misspelt);
  REQUIRE_FALSE(option);
  CHECK(option.error().detail == "weighted_astar: unknown option \"wieght\"; did you mean weight?");

  const Scene scene = maps::maze();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.5}).value();
  for (const char* value : {"-1", "inf", "1e300"}) {
    const std::vector<OptionText> out_of_range{{"weight", value}};
    const auto search = make_search<LatticeSpace>("weighted_astar", out_of_range).value();
    AnySearch<LatticeSpace>::Scratch scratch;
    NoObserver no_observer;
    const auto route =
        search.search(space, {.start = scene.start, .goal = scene.goals[0]}, scratch, no_observer);
    REQUIRE_FALSE(route);
    CHECK(route.error().code == PlanError::invalid_option);
  }
}

}  // namespace
