// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "support/catch.hpp"
#include "support/random_worlds.hpp"
#include "support/reference_distance.hpp"
#include "support/scale.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/smooth/concepts.hpp"
#include "tutavia/space/lattice_space.hpp"

/// \file
/// What every smoother must do; one line in a test file instantiates it.

namespace tutavia::test {

/// Smooths one proved curve and checks everything that holds for any smoother. `longest` bounds the
/// result's length as a multiple of the input's.
template <class A>
void check_smoothed(const A& smoother, const LatticeSpace& space, const Curve& input,
                    double longest) {
  const auto output = smoother.smooth(space, input, Budget{});
  REQUIRE(output);
  CHECK(output->start() == input.start());
  CHECK(output->end() == input.end());
  CHECK(output->length() <= longest * input.length() * (1 + 1e-12));
  CHECK(certify(space, *output).status == ProofStatus::proved);
  CHECK(sampled_clearance(space.workspace(), *output) >=
        space.safety_radius() - 1e-12 * space.magnitude());
  const auto again = smoother.smooth(space, input, Budget{});
  REQUIRE(again);
  CHECK(same_curve(*output, *again));
}

template <class A>
void smoother_contract(const A& smoother, double longest = 1) {
  static_assert(Smoother<A, LatticeSpace>);

  const Scene& scene = open_scene();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.1}).value();
  for (const std::size_t count : {1u, 2u, 3u, 4u}) {
    const Point corners[] = {{0.5, 2}, {0.5, 3.8}, {3.5, 3.8}, {3.5, 2}};
    INFO("polyline of " << count << " points");
    check_smoothed(smoother, space, Curve::polyline(std::span(corners, count)), longest);
  }

  std::stop_source source;
  source.request_stop();
  const auto route = search_once(AStar{}, space, {.start = scene.start, .goal = scene.goals[0]});
  REQUIRE(route);
  const auto cancelled = smoother.smooth(space, route->curve, Budget{.stop = source.get_token()});
  CHECK((cancelled || cancelled.error().code == PlanError::cancelled));

  const std::uint64_t seed = 30;
  WorldGenerator worlds(seed);
  for (std::size_t round = 0; round < scaled(60); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Workspace world = worlds.workspace();
    const auto random_space =
        LatticeSpace::build(world, {.resolution = world.bounds.width() / 40}).value();
    const auto random_route = search_once(
        AStar{}, random_space, {.start = worlds.point(world), .goal = worlds.point(world)});
    if (random_route) check_smoothed(smoother, random_space, random_route->curve, longest);
  }
}

}  // namespace tutavia::test
