// SPDX-License-Identifier: MIT
#include "tutavia/search/query_checks.hpp"

#include <string>

#include "tutavia/plan/query.hpp"
#include "tutavia/space/inflated_space.hpp"

#include "support/catch.hpp"

namespace {

using namespace tutavia;

TEST_CASE("a blocked start is reported before a blocked goal, with its clearance") {
  const auto space =
      InflatedSpace::build(
          {.bounds = {{0, 0}, {4, 4}}, .safety_radius = 0.5, .obstacles = {Disc{{2, 2}, 1}}})
          .value();
  const auto both = check_query(space, {.start = {2, 3.25}, .goal = {2, 2}});
  REQUIRE_FALSE(both);
  CHECK(both.error().code == PlanError::start_blocked);
  CHECK(*both.error().clearance == Approx(0.25));
  CHECK(both.error().detail.find("0.25") != std::string::npos);
  CHECK(both.error().obstacle == 0u);
  REQUIRE(both.error().nearest_safe_point);
  CHECK(both.error().nearest_safe_point->isApprox(Point(2, 3.5), 1e-9));
  const std::string point = detail::to_text(*both.error().nearest_safe_point);
  CHECK(both.error().detail.find("the nearest safe point is " + point) != std::string::npos);
  const auto goal = check_query(space, {.start = {2, 3.5}, .goal = {2, 2}});
  REQUIRE_FALSE(goal);
  CHECK(goal.error().code == PlanError::goal_blocked);
  CHECK(*goal.error().clearance == Approx(-1));
  CHECK(check_query(space, {.start = {2, 3.5}, .goal = {0, 0}}));
}

}  // namespace
