// SPDX-License-Identifier: MIT
#include "tutavia/io/svg.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/text_count.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/safe_rrt_star.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "tutavia/space/lattice_space.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;
using test::count;

TEST_CASE("a picture shows obstacles, zones of the safety radius, route, curve and marks") {
  const Scene scene = maps::complex();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.2}).value();
  Planner planner{AStar{}, DeltaSmoother{}};
  const Plan plan = planner.plan(space, {.start = scene.start, .goal = scene.goals[1]}).value();
  const std::string svg = to_svg(scene.workspace, std::span(&plan, 1),
                                 {.critical_corners = {{1, 1}, {2, 2}},
                                  .outlines = {{{1, 3}, {2, 4}}},
                                  .tree = {{{3, 3}, {4, 4}}, {{3, 3}, {3, 4}}},
                                  .rectangles = {{{3, 3}, {6, 4.5}}},
                                  .intervals = {{{3, 3}, {6, 3}}},
                                  .title = "a < b & c"});
  CHECK(count(svg, "#6fa58f") == 2);  // the tree and its legend
  CHECK(count(svg, ">outline<") == 1);
  CHECK(count(svg, "<path d=\"M216.00 646.00H416.00V546.00H216.00Z\" fill=\"#ffd84d\"") == 1);
  CHECK(count(svg, "#ffd84d") == 2);
  CHECK(count(svg, "#d4a000") == 2);
  CHECK(count(svg, "fill-rule=\"evenodd\"") == 2 * scene.workspace.obstacles.size());
  CHECK(count(svg, "stroke-width=\"40.00\"") == 1);  // 2 r = 0.6 m of 12 m on 800 pixels
  CHECK(count(svg, "stroke-dasharray") == 2);        // route and its legend
  CHECK(count(svg, "Q") > 0);                        // the arc stays a Bezier
  CHECK(count(svg, "#c1121f") == 3);                 // two corners and their legend
  CHECK(count(svg, "a &lt; b &amp; c") == 1);
  CHECK(count(svg, "<svg") == 1);
  CHECK(svg.ends_with("</svg>\n"));
  CHECK(count(svg, "nan") == 0);
}

TEST_CASE("clothoids are drawn as cubics that follow them") {
  Plan plan;
  const Clothoid clothoid = Clothoid::from({1, 1}, 0, 0, 2, 2);
  plan.curve.push_back(clothoid);
  const Workspace world{.bounds = {{0, 0}, {4, 4}}};
  const std::string svg = to_svg(world, std::span(&plan, 1), {});
  CHECK(count(svg, "C") >= 16);  // it turns by 4: eight pieces or more, drawn twice
  CHECK(count(svg, "nan") == 0);
}

TEST_CASE("arcs are drawn on the side where they lie, with y up and with y down") {
  for (const double sweep : {1.0, -1.0}) {
    for (const bool y_down : {false, true}) {
      Plan plan;
      plan.curve.push_back(Arc::around({2, 2}, 1, 0, sweep));
      const Workspace world{.bounds = {{0, 0}, {4, 4}}};
      const std::string svg = to_svg(world, std::span(&plan, 1), {.y_down = y_down});
      const bool is_clockwise = (sweep > 0) == y_down;  // as seen in the picture
      CHECK(count(svg, " 0 0 1 ") == (is_clockwise ? 4 : 0));
      CHECK(count(svg, " 0 0 0 ") == (is_clockwise ? 0 : 4));
    }
  }
}

TEST_CASE("a workspace can be drawn without a plan, holes and discs included") {
  const Workspace world{
      .bounds = {{0, 0}, {4, 2}},
      .safety_radius = 0.1,
      .obstacles = {Disc{{1, 1}, 0.5},
                    Polygon{{{2, 0}, {3, 0}, {3, 1}}, {{{2.5, 0.2}, {2.8, 0.2}, {2.8, 0.5}}}}}};
  const std::string svg = to_svg(world, {});
  CHECK(count(svg, "r=\"120.00\"") == 1);  // the disc's zone: 0.6 m at 200 pixels per metre
  CHECK(count(svg, "Z") == 4);             // two rings, drawn as zone and as obstacle
  CHECK(count(svg, "goal") == 0);
}

Plan plan_along(const std::vector<Point>& points) {
  Plan plan;
  plan.curve = plan.route.curve = Curve::polyline(points);
  return plan;
}

const Workspace room{.bounds = {{0, 0}, {8, 4}},
                     .safety_radius = 0.25,
                     .obstacles = {Polygon{{{3, 1}, {5, 1}, {5, 2}, {3, 2}}}}};

TEST_CASE("visited nodes are squares at the centres of cells, joined along a row, and else dots") {
  const SvgOptions options{.visited = {{1.5, 0.5}, {0.5, 0.5}, {3.5, 0.5}, {1.5, 0.5}, {2, 2}},
                           .cell_size = 1};
  const std::string svg = to_svg(room, {}, options);
  CHECK(count(svg, "\"M16.00 416.00H216.00V316.00H16.00ZM316.00 416.00H416.00V316.00H316.00Z\"") ==
        1);
  CHECK(count(svg, "\"M216.00 216.00h0\"") == 1);
  CHECK(count(svg, ">visited<") == 1);
  // Below all else.
  CHECK(svg.find("#b3d9f5") < svg.find("stroke-linejoin=\"round\" stroke-width=\"50.00\""));

  SvgOptions down = options;
  down.y_down = true;
  CHECK(count(to_svg(room, {}, down), "\"M16.00 16.00H216.00V116.00H16.00ZM316.00 16.00") == 1);
  CHECK(count(to_svg(room, {}, {.visited = options.visited}), "h0M") == 3);  // dots alone
  CHECK(count(to_svg(room, {}, {}), "visited") == 0);
}

TEST_CASE("the picture of a large map's search joins its cells") {
  std::vector<Point> visited;
  for (int y = 0; y < 512; ++y) {
    for (int x = 0; x < 512; ++x) visited.emplace_back(x + 0.5, y + 0.5);
  }
  const Workspace map{.bounds = {{0, 0}, {512, 512}}};
  CHECK(to_svg(map, {}, {.visited = visited, .cell_size = 1}).size() < 40000);
}

TEST_CASE(
    "both sides of a rectangle expansion have their colours, and nodes of the path are orange") {
  const Plan plan = plan_along({{0.5, 0.5}, {6.5, 0.5}, {7.5, 3.5}});
  SearchRecord record;
  record.on_rectangle({{0.5, 0.5}, {0.5, 0.5}}, {{0.5, 0.5}, {2.5, 3.5}}, SearchSide::start);
  record.on_rectangle({{7.5, 3.5}, {7.5, 3.5}}, {{5.5, 0.5}, {7.5, 3.5}}, SearchSide::goal);
  SvgOptions options{.cell_size = 1, .buffer = {{{2, 0}, {3, 3}}}};
  add_search(options, record);
  const std::string svg = to_svg(room, std::span(&plan, 1), options);
  // Whole cells, not from centre to centre.
  CHECK(count(svg, "\"M16.00 416.00H316.00V16.00H16.00Z\" fill=\"#ffd84d\"") == 1);
  CHECK(count(svg, "\"M516.00 416.00H816.00V16.00H516.00Z\" fill=\"#5cb874\"") == 1);
  CHECK(count(svg, "\"M216.00 416.00H316.00V116.00H216.00Z\" fill=\"#8fc7ec\"") == 1);
  CHECK(count(svg, "#f07d00") == 3 + 1);
  for (const std::string name : {"forward rectangle", "forward passage", "backward rectangle",
                                 "backward passage", "safety buffer", "path node"}) {
    INFO(name);
    CHECK(count(svg, ">" + name + "<") == 1);
  }
  options.y_down = true;
  const std::string down = to_svg(room, std::span(&plan, 1), options);
  CHECK(count(down, "\"M216.00 16.00H316.00V316.00H216.00Z\" fill=\"#8fc7ec\"") == 1);

  options.goal_rectangles.clear();
  options.goal_intervals.clear();
  const std::string one_sided = to_svg(room, std::span(&plan, 1), options);
  CHECK(count(one_sided, ">rectangle<") == 1);
  CHECK(count(one_sided, ">passage<") == 1);
  CHECK(count(one_sided, "#5cb874") == 0);
}

TEST_CASE("a picture of a safe tree shows its risk zones and the path before nodes are removed") {
  const Scene scene = maps::rrt_scene_1();
  const auto space = LatticeSpace::build(scene.workspace, {}).value();
  Planner planner{SafeRrtStar{.max_iterations = 800}};
  SearchRecord record{.keeps_nodes = false};
  const Query query{.start = scene.start, .goal = scene.goals[0], .seed = 5};
  const Plan plan = planner.plan(space, query, record).value();
  REQUIRE(waypoints(record.tree_path).size() > waypoints(plan.route.curve).size());
  SvgOptions options;
  add_search(options, record, plan.route.curve);
  REQUIRE(options.tree_paths.size() == 1);
  const std::string svg = to_svg(scene.workspace, std::span(&plan, 1), options);
  CHECK(count(svg, ">path of the tree, before nodes are removed<") == 1);
  CHECK(count(svg, ">risk zone, 2 m beyond<") == 1);
  CHECK(count(svg, "stroke-width=\"64.00\" opacity=\"0.6\"") ==
        1);  // twice 2 m of 50 on 800 pixels
  options.risk_zones = false;
  CHECK(count(to_svg(scene.workspace, std::span(&plan, 1), options), "risk zone") == 0);

  SvgOptions same;  // a path that is the route is not drawn twice
  add_search(same, record, record.tree_path);
  CHECK(same.tree_paths.empty());
}

TEST_CASE("safety zones can be left out") {
  CHECK(count(to_svg(room, {}, {}), "#f6d9b8") == 3);
  CHECK(count(to_svg(room, {}, {.zones = false}), "#f6d9b8") == 0);
  Workspace without_radius = room;  // nor is there one of no width
  without_radius.safety_radius = 0;
  CHECK(count(to_svg(without_radius, {}, {}), "#f6d9b8") == 0);
}

TEST_CASE("the legend names every curve with its length, in its colour and on a row of its own") {
  std::vector<Plan> plans;
  SvgOptions options;
  for (int i = 0; i < 12; ++i) {
    plans.push_back(plan_along({{0, 0}, {1 + 0.5 * i, 0}}));
    options.labels.push_back("search_" + std::to_string(i) + ", a<b>&" + std::string(1, '\x01'));
  }
  options.labels[3] = "rrt_star, " + std::string(300, 'm');
  const std::string svg = to_svg(room, plans, options);
  CHECK(count(svg, ">search_0, a&lt;b&gt;&amp; , 1.000 m<") == 1);
  CHECK(count(svg, ">search_11, a&lt;b&gt;&amp; , 6.500 m<") == 1);
  CHECK(count(svg, ">proved curve<") == 0);
  std::vector<double> rows;  // the heights of the texts of the legend, which follows the map
  for (std::size_t at = svg.find("<text"); at < svg.find(">obstacle<");) {
    rows.push_back(std::stod(svg.substr(svg.find("y=\"", at) + 3)));
    at = svg.find("<text", at + 1);
  }
  REQUIRE(rows.size() >= 12 + 5);  // the long name has several lines
  CHECK(rows.front() > 16 + 400);  // below the map
  for (std::size_t i = 1; i < rows.size(); ++i) CHECK(rows[i] - rows[i - 1] >= 15);
  for (std::size_t i = 0; i < 12; ++i) {
    INFO(i);
    const std::string line = "h26\" fill=\"none\" stroke-linejoin=\"round\" stroke=\"" +
                             detail::SvgStyle::colour(i) + "\"";
    CHECK(count(svg, line) == 1);
    for (std::size_t k = 0; k < i; ++k) {
      CHECK(detail::SvgStyle::colour(k) != detail::SvgStyle::colour(i));
    }
  }
  options.labels.clear();
  CHECK(count(to_svg(room, plans, options), ">curve 2, 1.500 m<") == 1);
  CHECK(count(to_svg(room, std::span(plans).first(1), options), ">proved curve<") == 1);
}

TEST_CASE("the profile shows clearance and curvature over arc length, and spikes at corners") {
  std::vector<Plan> plans{plan_along({{1, 3}, {4, 3}, {4, 3.5}, {7, 3.5}}), Plan{}};
  plans[1].curve.push_back(Arc::around({4, 3}, 0.5, 0, 3));
  Arc tight = Arc::around({3.51, 3.0705600040299334}, 0.005, 3, 1);
  tight.a = plans[1].curve.end();  // a rounding error away
  plans[1].curve.push_back(tight);
  const std::string svg = to_svg(room, plans, {.profile = true});
  CHECK(count(svg, ">clearance [m]<") == 1);
  CHECK(count(svg, ">curvature [1/m]<") == 1);
  CHECK(count(svg, ">arc length [m]<") == 1);
  CHECK(count(svg, ">dashed: safety radius, 0.25 m<") == 1);
  CHECK(count(svg, ">corners: spikes to the top; clipped, up to 200 1/m<") == 1);
  // The lines of each curve in its colour: two plots, and a spike at each corner.
  const std::string thin = "\" stroke-width=\"1.6\"";
  CHECK(count(svg, detail::SvgStyle::colour(0) + thin) == 2 + 2);
  CHECK(count(svg, detail::SvgStyle::colour(1) + thin) >= 2);
  CHECK(count(svg, "nan") == 0);
  CHECK(count(svg, "inf") == 0);
  CHECK(count(to_svg(room, plans, {}), "curvature") == 0);

  // A smooth curve without obstacles has neither; without plans there are no plots.
  const Workspace empty{.bounds = {{0, 0}, {8, 4}}};
  const Plan straight = plan_along({{1, 1}, {7, 1}});
  const std::string bare = to_svg(empty, std::span(&straight, 1), {.profile = true});
  CHECK(count(bare, "corners") + count(bare, "clipped") + count(bare, "nan") == 0);
  CHECK(count(bare, "inf") == 0);
  CHECK(count(to_svg(room, {}, {.profile = true}), "clearance") == 0);
}

TEST_CASE("a profile of curves without length and of an invalid workspace holds no NaN") {
  Workspace invalid = room;
  invalid.safety_radius = -1;
  const Plan point = plan_along({{1, 1}, {1, 1}});
  for (const Workspace& world : {room, invalid}) {
    for (const Plan& plan : {point, Plan{}}) {
      const std::string svg = to_svg(world, std::span(&plan, 1), {.profile = true});
      CHECK(count(svg, "nan") == 0);
      CHECK(count(svg, "inf") == 0);
      CHECK(count(svg, ">clearance [m]<") == 1);
    }
  }
}

/// A vehicle of two discs that drives ahead, back on an arc, and ahead again.
Plan shunting_plan() {
  VehiclePath path;
  path.push_back(Segment{{1, 3}, {4, 3}}, Gear::forward);
  path.push_back(Arc::around({4, 4}, 1, -std::numbers::pi / 2, -1), Gear::reverse);
  path.push_back(Segment{path.curve.end(), path.curve.end() + Point(0.5, -0.5)}, Gear::forward);
  Plan plan;
  plan.curve = plan.route.curve = path.curve;
  plan.gears = plan.route.gears = path.gears;
  plan.route.vehicle = Vehicle{1, true, {{{0, 0}, 0.25}, {{0.25, 0}, 0.25}}};
  return plan;
}

TEST_CASE("a vehicle's path is dashed in reverse, with footprints on the way and headings") {
  const Plan plan = shunting_plan();
  const std::string svg = to_svg(room, std::span(&plan, 1));
  const std::string curve = "stroke=\"#0072b2\" stroke-width=\"3\"";
  CHECK(count(svg, curve + " stroke-dasharray=\"8 5\"") == 1 + 1);  // and in the legend
  CHECK(count(svg, curve + "/>") == 2 + 1);
  CHECK(count(svg, "M116.00 116.00L416.00 116.00\" fill=\"none\" stroke-linejoin=\"round\" " +
                       curve + "/>") == 1);
  CHECK(count(svg, "stroke-width=\"0.9\" stroke-opacity=\"0.45\"") == 11 + 1);
  CHECK(svg.find("stroke-opacity=\"0.45\"") < svg.find(curve));  // below the path
  CHECK(count(svg, "M116.00 116.00L142.00 116.00") == 2);        // the arrow and its border
  for (const std::string part : {">in reverse<", ">footprint<", ">heading<"}) {
    INFO(part);
    CHECK(count(svg, part) == 1);
  }
  CHECK(count(svg, "nan") == 0);
  const std::string bare = to_svg(room, std::span(&plan, 1), {.footprints = false});
  CHECK(count(bare, ">footprint<") + count(bare, "stroke-opacity=\"0.45\"") == 0);
  CHECK(count(bare, ">heading<") == 1);

  // Without gears it is a curve as any other; without a radius there is no footprint to draw.
  Plan point = plan;
  point.gears.clear();
  const std::string plain = to_svg(room, std::span(&point, 1));
  CHECK(count(plain, "reverse") + count(plain, "footprint") + count(plain, "heading") == 0);
  point = plan;
  point.route.vehicle = Vehicle::point(1);
  CHECK(count(to_svg(room, std::span(&point, 1)), "footprint") == 0);
}

TEST_CASE("arrows of headings turn with the picture's y axis") {
  Plan plan = shunting_plan();
  plan.curve = Curve{};
  plan.curve.push_back(Segment{{4, 1}, {4, 3}});
  plan.gears = {Gear::forward};
  CHECK(count(to_svg(room, std::span(&plan, 1)), "M416.00 316.00L416.00 290.00M") == 2);
  CHECK(count(to_svg(room, std::span(&plan, 1), {.y_down = true}),
              "M416.00 116.00L416.00 142.00M") == 2);
}

TEST_CASE("the profile of a vehicle has its footprint's clearance, and no corners at cusps") {
  const Workspace wall{.bounds = {{0, 0}, {8, 4}},
                       .safety_radius = 0.25,
                       .obstacles = {Polygon{{{0, 3.5}, {8, 3.5}, {8, 4}, {0, 4}}}}};
  Plan plan;
  plan.curve.push_back(Segment{{1, 1.5}, {4, 1.5}});
  plan.curve.push_back(Segment{{4, 1.5}, {2, 1.5}});
  plan.gears = {Gear::forward, Gear::reverse};
  plan.route.vehicle = Vehicle{1, true, {{{0.5, 0.25}, 0.75}, {{0, 0}, 0.1}}};
  const std::string svg = to_svg(wall, std::span(&plan, 1), {.profile = true});
  CHECK(count(svg, "corners") == 0);
  // Two plots, and no spike.
  CHECK(count(svg, "stroke=\"#0072b2\" stroke-width=\"1.6\"") == 2);
  // 2 - 0.25 - 0.75 = 1 m throughout: the axis ends there, and that of the curvature at 1, too.
  CHECK(count(svg, "text-anchor=\"end\">1<") == 2);
  CHECK(count(svg, "text-anchor=\"end\">1.5<") == 0);
  plan.gears.clear();
  CHECK(count(to_svg(wall, std::span(&plan, 1), {.profile = true}), "text-anchor=\"end\">1.5<") ==
        1);
}

TEST_CASE("goals without a plan are marked, and notes stand below the legend") {
  const std::string svg = to_svg(
      room, {}, {.starts = {{1, 1}}, .goals = {{7, 3}}, .notes = {"astar: no plan (unreachable)"}});
  CHECK(count(svg, "<circle cx=\"116.00\" cy=\"316.00\" r=\"7.00\" fill=\"#ffffff\"") == 1);
  CHECK(count(svg, "<circle cx=\"716.00\" cy=\"116.00\" r=\"7.00\" fill=\"#7a8794\"") == 1);
  CHECK(count(svg, ">start<") + count(svg, ">goal<") == 2);
  CHECK(svg.find("astar: no plan (unreachable)") > svg.find(">goal<"));
}

}  // namespace
