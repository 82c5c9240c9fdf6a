// SPDX-License-Identifier: MIT
#include "tutavia/space/index/passing_radius.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

InflatedSpace with_radius(double radius) {
  return InflatedSpace::build({.bounds = {{0, 0}, {10, 10}},
                               .safety_radius = radius,
                               .obstacles = {Disc{{5, 5}, 1}}})
      .value();
}

TEST_CASE("at safety radius 0 paths bend at vertices themselves, and pass discs at a distance") {
  const InflatedSpace space = with_radius(0);
  CHECK(detail::passing_radius(space, 0) == 0);
  CHECK(detail::passing_radius(space, 1) > 1);
  CHECK(detail::passing_radius(space, 1) < 1 + 1e-12);
}

TEST_CASE("else they pass by the safety radius more, and a little for rounding") {
  const InflatedSpace space = with_radius(0.5);
  for (const double radius : {0.0, 1.0}) {
    CHECK(detail::passing_radius(space, radius) > radius + 0.5);
    CHECK(detail::passing_radius(space, radius) < radius + 0.5 + 1e-12);
  }
}

TEST_CASE("a point at the passing radius is free, also by rounded coordinates") {
  const InflatedSpace space = with_radius(0.5);
  const double r = detail::passing_radius(space, 1);
  for (int i = 0; i < 360; ++i) {
    const double angle = i * 0.0174532925;
    CHECK(space.is_free(Point(5, 5) + r * Point(std::cos(angle), std::sin(angle))));
  }
  CHECK_FALSE(space.is_free({5 + 1.5 - 1e-12, 5}));
}

}  // namespace
