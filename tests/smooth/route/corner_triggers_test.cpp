// SPDX-License-Identifier: MIT
#include "tutavia/smooth/route/corner_triggers.hpp"

#include <vector>

#include "support/catch.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

/// Posts at safety radius 0.5.
InflatedSpace posts(const std::vector<Point>& centres) {
  Workspace workspace{.bounds = {{-20, -20}, {20, 20}}, .safety_radius = 0.5, .obstacles = {}};
  for (const Point& p : centres) workspace.obstacles.emplace_back(Disc{p, 0});
  return InflatedSpace::build(workspace).value();
}

TEST_CASE("the trigger of a corner is the nearest node at which the path turns") {
  const auto space = posts({{0, 0}});
  // The node nearest to the post, (0, 0.6), lies on a straight run.
  const std::vector<Point> nodes{{-0.6, 0.6}, {-0.3, 0.6}, {0, 0.6}, {0.3, 0.6}, {0.6, 0.3}};
  const auto triggers = find_triggers(space, nodes, 0.3, 0);
  REQUIRE(triggers.size() == 1);
  CHECK(triggers[0].node == 3);
  CHECK(triggers[0].distance == Approx(std::sqrt(0.45) - 0.5));
  CHECK(triggers[0].corner == Point(0, 0));
  CHECK(find_triggers(space, nodes, 0.17, 0).empty());  // the turn is 0.1708 from the zone
}

TEST_CASE("a straight path and one that turns straight back have no triggers") {
  const auto space = posts({{0, 0}});
  CHECK(find_triggers(space, {{-1, 0.6}, {0, 0.6}, {1, 0.6}}, 0.3, 0).empty());
  CHECK(find_triggers(space, {{-1, 0.6}, {0, 0.6}, {-1, 0.6}}, 0.3, 0).empty());
  CHECK(find_triggers(space, {{0, 0.6}}, 0.3, 0).empty());
  // Lattice nodes are rounded: 3 * 0.2 is not 0.6.
  CHECK(find_triggers(space, {{1 * 0.2, 0.6}, {2 * 0.2, 3 * 0.2}, {3 * 0.2, 0.6}}, 0.3, 0).empty());
}

TEST_CASE("a node has one trigger, for the nearest of its corners; of two nodes the first wins") {
  const auto space = posts({{0, 0}, {0, 1.3}});
  const std::vector<Point> between{{-0.5, 0.6}, {0, 0.64}, {0.5, 0.6}};
  const auto triggers = find_triggers(space, between, 0.3, 0);
  REQUIRE(triggers.size() == 1);
  CHECK(triggers[0].corner == Point(0, 0));

  const std::vector<Point> symmetric{{-1, 0}, {-0.5, 0.5}, {0.5, 0.5}, {1, 0}};
  const auto first = find_triggers(posts({{0, 0}}), symmetric, 0.3, 0);
  REQUIRE(first.size() == 1);
  CHECK(first[0].node == 1);
}

}  // namespace
