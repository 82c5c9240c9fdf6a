// SPDX-License-Identifier: MIT
/// \file
/// All smoothers on routes that no search finds, and on very long ones.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/exact_checker.hpp"
#include "support/random_tasks.hpp"
#include "support/random_worlds.hpp"
#include "support/registry.hpp"
#include "support/scale.hpp"
#include "tutavia/certify/certify.hpp"

namespace {

using namespace tutavia;

/// Routes along one that is free: cut short, with points repeated, run to and fro.
std::vector<std::pair<std::string, std::vector<Point>>> spoiled(const std::vector<Point>& route) {
  std::vector<std::pair<std::string, std::vector<Point>>> routes;
  for (const std::size_t count : {1u, 2u, 3u}) {
    routes.emplace_back(
        std::to_string(count) + " points",
        std::vector<Point>(route.begin(),
                           route.begin() + std::ptrdiff_t(std::min(count, route.size()))));
  }
  std::vector<Point> repeated, to_and_fro;
  for (std::size_t i = 0; i < route.size(); ++i) {
    for (std::size_t k = 0; k <= i % 3; ++k) repeated.push_back(route[i]);
    to_and_fro.push_back(route[i]);
    if (i % 2 == 1) {
      to_and_fro.push_back(route[i - 1]);
      to_and_fro.push_back(route[i]);
    }
  }
  routes.emplace_back("repeated points", repeated);
  routes.emplace_back("to and fro", to_and_fro);
  std::vector<Point> home = route;
  home.insert(home.end(), route.rbegin(), route.rend());
  routes.emplace_back("there and back", home);
  return routes;
}

TEST_CASE("smoothers take routes of few points, repeated points and reversals", "[soak]") {
  const std::uint64_t seed = 420;
  test::WorldGenerator worlds(seed);
  const auto smoothers = all_smoothers<LatticeSpace>();
  std::size_t curves = 0;
  for (std::size_t round = 0; round < test::scaled(20); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto task = test::random_task(worlds);
    if (!task) continue;
    const auto space =
        LatticeSpace::build(task->world, {.resolution = task->world.bounds.width() / 40}).value();
    const test::ExactChecker checker(task->world);
    for (const auto& [kind, route] : spoiled(task->route)) {
      const Curve input = Curve::polyline(route);
      for (const auto& smoother : smoothers) {
        INFO(smoother.name << ", " << kind);
        const auto output = smoother.smooth(space, input, {});
        REQUIRE(output);
        ++curves;
        CHECK(output->start() == route.front());
        CHECK(output->end() == route.back());
        CHECK(certify(space, *output).status == ProofStatus::proved);
        CHECK(checker.check(*output) == test::ExactVerdict::free);
        const double longest = smoother.name == "two_stage_b_spline" ? 3
                               : smoother.name == "clothoid"         ? 1.1
                                                                     : 1;
        CHECK(output->length() <= longest * input.length() * (1 + 1e-12));
      }
    }
  }
  CHECK(curves > test::scaled(20) * smoothers.size());
}

TEST_CASE("smoothers take routes of ten thousand points") {
  const auto space =
      LatticeSpace::build({.bounds = {{-3, -3}, {3, 3}},
                           .safety_radius = 0.1,
                           .obstacles = {Disc{{0, 0}, 1}, Polygon{{{1.5, 1.5}, {2, 2}}}}},
                          {.resolution = 0.1})
          .value();
  std::vector<Point> spiral, crowd;
  Random random(421);
  for (int i = 0; i < 10000; ++i) {
    const double angle = 0.01 * i, radius = 1.15 + 2e-5 * i;
    spiral.push_back(radius * Point(std::cos(angle), std::sin(angle)));
    crowd.push_back(Point(-2, -2) + Point(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)));
  }
  for (const auto& route : {spiral, crowd}) {
    const Curve input = Curve::polyline(route);
    for (const auto& smoother : all_smoothers<LatticeSpace>()) {
      INFO(smoother.name);
      const auto output = smoother.smooth(space, input, {});
      REQUIRE(output);
      CHECK(output->start() == route.front());
      CHECK(output->end() == route.back());
      CHECK(certify(space, *output).status == ProofStatus::proved);
    }
  }
}

TEST_CASE("a run along a wall is proved as a whole where its steps, rounded, are not") {
  // The wall's edge and the run have the same two ends; its grid nodes do not lie on it in doubles.
  const Point a{-9 * 0.1, -17 * 0.1}, b{-1 * 0.1, -9 * 0.1};
  const auto space = LatticeSpace::build({.bounds = {{-5, -5}, {5, 5}},
                                          .safety_radius = 0,
                                          .obstacles = {Polygon{{a, {b.x(), a.y()}, b}}}},
                                         {.resolution = 0.1})
                         .value();
  std::size_t inputs = 0;
  for (const double aside : {0.3, 0.35, 0.4, 0.45}) {
    const Point points[] = {a, b, b + Point(0, aside), b + Point(-0.3, aside + 0.15)};
    const Curve input = Curve::polyline(points);
    if (certify(space, input).status != ProofStatus::proved) continue;
    ++inputs;
    for (const auto& smoother : all_smoothers<LatticeSpace>()) {
      INFO(smoother.name << ", " << aside);
      const auto output = smoother.smooth(space, input, {});
      REQUIRE(output);
      CHECK(certify(space, *output).status == ProofStatus::proved);
    }
    const DeltaSmoother as_printed{.join = DeltaSmoother::Join::paper};
    const auto output = as_printed.smooth(space, input, {});
    REQUIRE(output);
    CHECK(certify(space, *output).status == ProofStatus::proved);
  }
  CHECK(inputs == 4);
}

}  // namespace
