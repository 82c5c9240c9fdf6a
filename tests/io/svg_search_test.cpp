// SPDX-License-Identifier: MIT
#include "tutavia/io/svg_search.hpp"

#include <cstddef>
#include <set>
#include <string>
#include <utility>

#include "support/catch.hpp"
#include "support/text_count.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/smooth/clothoid_smoother.hpp"
#include "tutavia/space/lattice_space.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;
using test::count;

struct Drawn {
  Scene scene = maps::maze();
  SearchRecord record{};
  Plan plan{};
};

template <class Search>
Drawn drawn_with(Search search) {
  Drawn drawn;
  const auto space = LatticeSpace::build(drawn.scene.workspace, {.resolution = 0.2}).value();
  Planner planner{search, ClothoidSmoother{}};
  drawn.plan =
      planner.plan(space, {.start = drawn.scene.start, .goal = drawn.scene.goals[0]}, drawn.record)
          .value();
  return drawn;
}

TEST_CASE("the parts of a search hold each visited node once, in the order of the search") {
  const Drawn drawn = drawn_with(AStar{});
  const auto parts = detail::search_parts(drawn.record, 7);
  REQUIRE(parts.size() == 7);
  SvgOptions all;
  add_search(all, drawn.record);
  std::size_t visited = 0;
  for (const SvgOptions& part : parts) {
    CHECK_FALSE(part.visited.empty());
    visited += part.visited.size();
  }
  std::set<std::pair<double, double>> different;
  for (const Point& p : all.visited) different.emplace(p.x(), p.y());
  CHECK(visited == different.size());
  CHECK(parts.front().visited.front() == all.visited.front());
}

TEST_CASE("an animated picture shows search, route, curve and robot one after the other") {
  const Drawn drawn = drawn_with(AStar{});
  const std::string svg =
      to_animated_svg(drawn.scene.workspace, drawn.plan, drawn.record, {.cell_size = 0.2});
  CHECK(count(svg, "<svg") == 1);
  CHECK(svg.ends_with("</svg>\n"));
  CHECK(count(svg, "<g") == count(svg, "</g>"));
  CHECK(count(svg, "<animateMotion") == 1);
  CHECK(count(svg, "attributeName=\"stroke-dasharray\"") == 1);
  // A group for each part of the search, below the zones and above, the route and the curve.
  CHECK(count(svg, "attributeName=\"opacity\"") == 2 * 48 + 2);
  CHECK(count(svg, "repeatCount=\"indefinite\"") == 2 * 48 + 2 + 2);
  CHECK(count(svg, "script") == 0);
  CHECK(count(svg, "nan") == 0);
  CHECK(count(svg, ">visited<") == 1);  // in the legend
}

TEST_CASE("steps are panels: the growing search, and its result in the last") {
  Drawn drawn = drawn_with(AStar{});
  drawn.record = {};
  for (int i = 0; i < 9; ++i) drawn.record.edge({2, 1}, {3, 1 + 0.1 * i});
  const std::string svg =
      to_svg_steps(drawn.scene.workspace, drawn.plan, drawn.record, 4, {.width = 300});
  CHECK(count(svg, "<svg") == 1 + 2 * 4);
  CHECK(count(svg, "</svg>") == 1 + 2 * 4);
  CHECK(count(svg, "#6fa58f") == 3);                             // the tree
  CHECK(count(svg, std::string(detail::SvgStyle::route)) == 1);  // in the last panel
  CHECK(count(svg, "obstacle<") == 0);                           // no legends
  SvgOptions options;
  add_search(options, drawn.record);
  // The edges of the third panel are those of the whole search.
  const std::size_t tree = svg.rfind("#6fa58f");
  const std::size_t path = svg.rfind("<path d=", tree);
  CHECK(count(svg.substr(path, tree - path), "M") == options.tree.size());
}

TEST_CASE("a search without events is drawn, too") {
  Drawn drawn = drawn_with(AStar{});
  drawn.record = {};
  const std::string svg = to_animated_svg(drawn.scene.workspace, drawn.plan, drawn.record);
  CHECK(count(svg, "<animateMotion") == 1);
  CHECK(count(to_svg_steps(drawn.scene.workspace, drawn.plan, drawn.record, 2), "</svg>") == 5);
}

}  // namespace
