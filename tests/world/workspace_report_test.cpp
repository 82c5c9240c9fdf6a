// SPDX-License-Identifier: MIT
#include "tutavia/world/workspace_report.hpp"

#include <sstream>

#include "support/catch.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;

TEST_CASE("a tidy workspace has an empty report") {
  for (const Scene& scene : {maps::array(), maps::complex(), maps::maze()}) {
    CHECK(inspect(scene.workspace).empty());
  }
}

TEST_CASE("everything unusual is counted or named") {
  Workspace world{.bounds = {{0, 0}, {9, 9}}};
  world.obstacles.emplace_back(Polygon{{{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 0}}});  // repeated
  world.obstacles.emplace_back(Polygon{{{0, 0}, {0, 1}, {1, 0}}});                  // clockwise
  world.obstacles.emplace_back(Polygon{{{0, 0}, {3, 3}, {1, 1}}});                  // flat
  world.obstacles.emplace_back(Polygon{{{2, 2}}});                                  // a point
  world.obstacles.emplace_back(Polygon{{{0, 0}, {4, 4}, {4, 0}, {0, 4}}});          // a bow tie
  world.obstacles.emplace_back(Disc{{3, 3}, 0});
  const WorkspaceReport report = inspect(world);
  CHECK(report.repeated_points == 1);
  CHECK(report.clockwise_rings == 1);
  CHECK(report.without_area == std::vector<std::size_t>{2, 3});
  CHECK(report.self_crossing == std::vector<std::size_t>{4});
  std::ostringstream text;
  text << report;
  CHECK(text.str() ==
        "1 repeated points removed, 1 clockwise rings accepted, 2 obstacles without area kept as "
        "segments or points, 1 self-crossing obstacles read conservatively");
}

TEST_CASE("simple polygons are told from those that touch themselves") {
  const Ring square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  CHECK(is_simple({square}));
  CHECK(is_simple({square, {{{1, 1}, {2, 1}, {2, 2}}}}));
  CHECK(is_simple({{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 4}}}));  // collinear, repeated
  CHECK_FALSE(is_simple({square, {{{0, 1}, {2, 1}, {2, 2}}}}));          // a hole on the edge
  CHECK_FALSE(is_simple({{{0, 0}, {4, 0}, {4, 4}, {2, 0}}}));            // a corner on an edge
  CHECK_FALSE(is_simple({{{0, 0}, {4, 0}, {6, 0}, {4, 0}, {4, 4}}}));    // a spike
  CHECK_FALSE(is_simple({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}));
  CHECK_FALSE(is_simple({{{0, 0}, {1, 0}}}));
  CHECK_FALSE(is_simple({{{0, 0}, {2, 2}, {4, 4}}}));
  CHECK_FALSE(is_simple({{}}));
}

}  // namespace
