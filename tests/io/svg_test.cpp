// SPDX-License-Identifier: MIT
#include "tutavia/io/svg.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "support/catch.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "tutavia/space/lattice_space.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t i = text.find(part); i != std::string::npos; i = text.find(part, i + 1)) ++n;
  return n;
}

TEST_CASE("a picture shows obstacles, zones of the safety radius, route, curve and marks") {
  const Scene scene = maps::complex();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.2}).value();
  Planner planner{AStar{}, DeltaSmoother{}};
  const Plan plan = planner.plan(space, {.start = scene.start, .goal = scene.goals[1]}).value();
  const std::string svg = to_svg(scene.workspace, std::span(&plan, 1),
                                 {.critical_corners = {{1, 1}, {2, 2}},
                                  .tree = {{{3, 3}, {4, 4}}, {{3, 3}, {3, 4}}},
                                  .rectangles = {{{3, 3}, {6, 4.5}}},
                                  .intervals = {{{3, 3}, {6, 3}}},
                                  .title = "a < b & c"});
  CHECK(count(svg, "#9cc3b5") == 2);  // the tree and its legend
  CHECK(count(svg, "<path d=\"M216.00 646.00H416.00V546.00H216.00Z\" fill=\"#7fb2d9\"") == 1);
  CHECK(count(svg, "#7fb2d9") == 2);
  CHECK(count(svg, "#b8478a") == 2);
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

}  // namespace
