// SPDX-License-Identifier: MIT
#include "tutavia/smooth/homotopy_refine.hpp"

#include <cstdio>

#include "support/homotopy.hpp"
#include "support/random_tasks.hpp"
#include "support/smoother_contract.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/smooth/pipeline.hpp"
#include "tutavia/smooth/taut_string.hpp"

namespace {

using namespace tutavia;

TEST_CASE("HomotopyRefine keeps the smoother contract") {
  test::smoother_contract(HomotopyRefine{});
  test::smoother_contract(Pipeline{TautString{}, HomotopyRefine{}});
}

TEST_CASE("a way round the long side of an obstacle goes over to the short one") {
  const auto space =
      InflatedSpace::build({.bounds = {{-9, -9}, {9, 9}},
                            .safety_radius = 0.5,
                            .obstacles = {Polygon{{{-1, -1}, {1, -1}, {1, 4}, {-1, 4}}}}})
          .value();
  const Point over[] = {{-4, 0}, {-4, 6}, {4, 6}, {4, 0}};
  const Curve route = Curve::polyline(over);
  const Curve string = TautString{}.smooth(space, route, {}).value();
  const Curve shorter = HomotopyRefine{}.smooth(space, string, {}).value();
  CHECK(shorter.length() < 0.9 * string.length());
  CHECK_FALSE(test::winds_around_nothing(space.workspace(), shorter, string));
  CHECK(certify(space, shorter).status == ProofStatus::proved);
  // Nothing is shorter than the shortest; too few expansions leave all as it was.
  CHECK(test::same_curve(HomotopyRefine{}.smooth(space, shorter, {}).value(), shorter));
  const HomotopyRefine hasty{.max_expansions = 1};
  CHECK(test::same_curve(hasty.smooth(space, string, {}).value(), string));
  const auto blocked =
      HomotopyRefine{}.smooth(space, Curve::polyline(std::vector<Point>{{-4, 0}, {4, 0}}), {});
  REQUIRE_FALSE(blocked);
  CHECK(blocked.error().code == PlanError::invalid_input);
}

}  // namespace
