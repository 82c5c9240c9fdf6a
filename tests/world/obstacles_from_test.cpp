// SPDX-License-Identifier: MIT
#include "tutavia/world/obstacles_from.hpp"

#include <variant>

#include "support/catch.hpp"

namespace {

using namespace tutavia;

TEST_CASE("an area becomes the obstacles of a workspace") {
  Workspace workspace{.bounds = {{0, 0}, {9, 9}}, .safety_radius = 0.5};
  workspace.obstacles =
      obstacles_from(std::vector<Polygon>{{{{1, 1}, {2, 1}, {2, 2}}}, {{{5, 5}, {6, 5}, {6, 6}}}});
  REQUIRE(workspace.obstacles.size() == 2);
  CHECK(std::get<Polygon>(workspace.obstacles[1]).outer == Ring{{5, 5}, {6, 5}, {6, 6}});
  CHECK(validate(workspace));
  CHECK(obstacles_from(std::vector<Polygon>{}).empty());
}

}  // namespace
