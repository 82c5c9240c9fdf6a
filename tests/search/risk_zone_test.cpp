// SPDX-License-Identifier: MIT
#include "tutavia/search/risk_zone.hpp"

#include <cmath>
#include <cstdint>

#include "support/catch.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;

/// A wall below y = 0 in a world of 20 x 10 m, to keep 0.5 m from.
InflatedSpace wall() {
  return InflatedSpace::build({.bounds = {{0, 0}, {20, 10}},
                               .safety_radius = 0.5,
                               .obstacles = {Polygon{{{-50, -2}, {70, -2}, {70, 0}, {-50, 0}}}}})
      .value();
}

TEST_CASE("the risk falls evenly from the safety radius to the zone's rim") {
  const auto space = wall();
  const RiskZone zone{.width = 2};
  CHECK(zone.risk(space, {3, 0.5}) == Approx(1));
  CHECK(zone.risk(space, {3, 1.0}) == Approx(0.75));
  CHECK(zone.risk(space, {3, 2.0}) == Approx(0.25));
  CHECK(zone.risk(space, {3, 2.5}) == 0);
  CHECK(zone.risk(space, {3, 9}) == 0);
  CHECK(zone.is_outside(space, {3, 2.5}, {9, 9}));
  CHECK_FALSE(zone.is_outside(space, {3, 2.4}, {9, 9}));
}

TEST_CASE("integrals of the risk in closed form: along a wall, away from it, and in and out") {
  const auto space = wall();
  const RiskZone zone{.width = 2, .weight = 3};
  const auto along = zone.integral(space, {2, 1}, {6, 1});
  CHECK(along.value == Approx(4 * 0.75).margin(along.error + 1e-12));
  CHECK(along.error <= 0.01 * 4);
  CHECK(zone.cost(space, {2, 1}, {6, 1}) == 4 + 3 * along.value);
  const auto away = zone.integral(space, {2, 0.5}, {2, 2.5});
  CHECK(away.value == Approx(1).epsilon(1e-12));
  CHECK(away.error < 1e-12);
  CHECK(zone.integral(space, {2, 3}, {9, 4}).value == 0);
  CHECK(zone.integral(space, {2, 3}, {9, 4}).error == 0);
  CHECK(zone.integral(space, {2, 1}, {2, 1}).value == 0);
  // Down to the safety radius and out of the zone again.
  const auto dip = zone.integral(space, {0, 4}, {3.5, 0.5});
  const double slant = std::sqrt(2.0);
  CHECK(dip.value == Approx(slant * 1).margin(dip.error + 1e-12));
  const RiskZone none{.width = 2, .weight = 0};
  CHECK(none.cost(space, {2, 1}, {6, 1}) == 4);
}

TEST_CASE("along curves the risk and the length in the zone add up") {
  const auto space = wall();
  const RiskZone zone{.width = 2};
  const Point points[] = {{1, 4}, {1, 1}, {5, 1}, {5, 4}};
  const Curve curve = Curve::polyline(points);
  const auto risk = zone.integral(space, curve);
  const double slope = 1.5 * 0.75 / 2;  // from the rim to risk 3/4
  CHECK(risk.value == Approx(2 * slope + 4 * 0.75).margin(risk.error + 1e-12));
  CHECK(risk.error <= 0.01 * curve.length());
  const auto inside = zone.length_inside(space, curve);
  CHECK(inside.value == Approx(1.5 + 4 + 1.5).margin(inside.error + 1e-12));
  CHECK(inside.error < 1e-3 * curve.length());
  CHECK(zone.integral(space, Curve()).value == 0);
  CHECK(zone.length_inside(space, Curve()).value == 0);
}

TEST_CASE("integrals of the risk are as near as they say, in random worlds", "[soak]") {
  const std::uint64_t seed = 610;
  test::WorldGenerator worlds(seed);
  std::size_t ways = 0;
  for (std::size_t round = 0; round < test::scaled(60); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Workspace world = worlds.workspace();
    const auto space = InflatedSpace::build(world).value();
    const RiskZone zone{.width = world.bounds.width() / 10, .tolerance = 0.02};
    for (int i = 0; i < 10; ++i) {
      const Point p = worlds.point(world), q = worlds.point(world);
      if (!space.segment_free(p, q) || p == q) continue;
      ++ways;
      const double length = distance(p, q);
      const auto found = zone.integral(space, p, q);
      double sum = 0;
      const int parts = 4000;
      for (int k = 0; k < parts; ++k)
        sum += zone.risk(space, detail::lerp(p, q, (k + 0.5) / parts));
      // The midpoint rule is off by less than length^2 / (4 parts width).
      const double coarse = length * length / (4 * parts * zone.width);
      CHECK(std::abs(found.value - sum * length / parts) <= found.error + coarse + 1e-9 * length);
      CHECK(found.error <= 0.02 * length * (1 + 1e-9));
      CHECK(zone.integral(space, q, p).value ==
            Approx(found.value).margin(2 * found.error + 1e-9 * length));
    }
  }
  CHECK(ways > test::scaled(60));
}

TEST_CASE("zones without meaning are refused") {
  for (const double bad : {-1.0, HUGE_VAL, std::nan("")}) {
    CHECK(RiskZone{.width = bad}.check().error().code == PlanError::invalid_option);
    CHECK(RiskZone{.weight = bad}.check().error().detail.find("weight") != std::string::npos);
  }
  CHECK_FALSE(RiskZone{.width = 0}.check());
  CHECK_FALSE(RiskZone{.tolerance = 0}.check());
  CHECK(RiskZone{.weight = 0}.check());
}

}  // namespace
