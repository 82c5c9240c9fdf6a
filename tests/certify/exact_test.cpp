// SPDX-License-Identifier: MIT
/// \file
/// Paths and certificates before an exact judge. TUTAVIA_TEST_SCALE makes these a soak.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "support/catch.hpp"
#include "support/exact_checker.hpp"
#include "support/random_worlds.hpp"
#include "support/reference_distance.hpp"
#include "support/registry.hpp"
#include "support/scale.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/space/lattice_space.hpp"

namespace {

using namespace tutavia;
using test::ExactVerdict;

TEST_CASE("no path of a random world comes below the safety radius", "[soak]") {
  const std::uint64_t seed = 100;
  test::WorldGenerator worlds(seed);
  const auto smoothers = all_smoothers<LatticeSpace>();
  std::size_t worlds_with_plan = 0, paths = 0, touching = 0;
  const std::size_t rounds = test::scaled(100);
  for (std::size_t round = 0; round < rounds; ++round) {
    INFO("seed " << seed << ", round " << round);
    const Workspace world = worlds.workspace();
    const auto space =
        LatticeSpace::build(world, {.resolution = world.bounds.width() / 32}).value();
    const test::ExactChecker checker(world);
    Query query{.start = worlds.point(world), .goal = worlds.point(world)};
    // A third of the starts is where the answer is hardest: at the very edge of free space.
    if (round % 3 == 0) query.start = nearest_free_point(space, query.start).value_or(query.start);
    bool found = false;
    for (const auto& smoother : smoothers) {
      Planner planner(AStar{}, smoother);
      const auto plan = planner.plan(space, query);
      if (!plan) continue;
      found = true;
      ++paths;
      INFO("smoother " << smoother.name);
      REQUIRE(plan->certificate.status == ProofStatus::proved);
      CHECK_FALSE(plan->fell_back);  // what a smoother makes is proved without the planner's help
      const ExactVerdict verdict = checker.check(plan->curve);
      CHECK(verdict != ExactVerdict::blocked);
      if (verdict == ExactVerdict::unknown) ++touching;
    }
    if (found) ++worlds_with_plan;
  }
  CAPTURE(rounds, worlds_with_plan, paths, touching);
  CHECK(paths == worlds_with_plan * smoothers.size());
  CHECK(worlds_with_plan > rounds / 4);
  CHECK(touching == 0);
}

/// The least distance between a piece and an obstacle, to about 1e-15 relative, by sampling and
/// golden-section search.
double least_distance(const Workspace& world, const Piece& piece) {
  const auto at = [&](double t) {
    const Point p = piece.visit([&](const auto& any) -> Point { return any.point(t); });
    return static_cast<double>(test::reference_clearance(world, p));
  };
  constexpr int samples = 200;
  int best = 0;
  for (int i = 0; i <= samples; ++i) {
    if (at(double(i) / samples) < at(double(best) / samples)) best = i;
  }
  double low = std::max(0, best - 1) / double(samples);
  double high = std::min(samples, best + 1) / double(samples);
  for (int i = 0; i < 60; ++i) {
    const double a = low + 0.382 * (high - low), b = low + 0.618 * (high - low);
    (at(a) < at(b) ? high : low) = at(a) < at(b) ? b : a;
  }
  return std::min({at(0), at(1), at(0.5 * (low + high))});
}

/// A point of a square of this size.
Point random_point(Random& random, double scale) {
  const double x = random.uniform(0, scale);
  return {x, random.uniform(0, scale)};
}

/// A disc, a wall or a triangle, in bounds that matter to no piece near it.
Workspace world_of_one_obstacle(Random& random, double scale) {
  const auto point = [&] { return random_point(random, scale); };
  Workspace world{.bounds = {{-scale, -scale}, {3 * scale, 3 * scale}}};
  switch (random.below(3)) {
    case 0:
      world.obstacles.emplace_back(Disc{point(), random.uniform(0, 0.1 * scale)});
      break;
    case 1:
      world.obstacles.emplace_back(Polygon{{point(), point()}});
      break;
    default:
      world.obstacles.emplace_back(Polygon{{point(), point(), point()}});
  }
  return world;
}

/// A segment, a Bezier piece of either degree, a clothoid or an arc, by its kind from 0 to 4.
Piece random_piece(Random& random, std::size_t kind, double scale) {
  const auto point = [&] { return random_point(random, scale); };
  switch (kind) {
    case 0:
      return Segment{point(), point()};
    case 1:
      return QuadraticBezier{{point(), point(), point()}};
    case 2:
      return CubicBezier{{point(), point(), point(), point()}};
    case 3:
      return Clothoid::from(point(), random.uniform(-4, 4), random.uniform(-8, 8) / scale,
                            random.uniform(-16, 16) / (scale * scale), random.uniform(0, scale));
    default:
      return Arc::around(point(), random.uniform(0, 0.5 * scale), random.uniform(-4, 4),
                         random.uniform(-6, 6));
  }
}

TEST_CASE("no verdict on a piece next to the safety radius is wrong", "[soak]") {
  const std::uint64_t seed = 200;
  Random random(seed);
  const std::size_t rounds = test::scaled(1000);
  constexpr int decades = 12;
  std::array<std::size_t, decades> pieces{}, evaluations{}, undecided{};
  std::size_t wrong = 0, unknown = 0;
  for (std::size_t round = 0; round < rounds; ++round) {
    INFO("seed " << seed << ", round " << round);
    const double scale = round % 5 == 0 ? 1e3 : 10;
    Workspace world = world_of_one_obstacle(random, scale);
    const Piece piece = random_piece(random, round % 5, scale);
    const double distance = least_distance(world, piece);
    if (!(distance > 0.01 * scale)) continue;
    const int decade = static_cast<int>(random.below(decades));
    const double gap = std::pow(10.0, -1 - decade) * random.uniform(0.5, 1);
    world.safety_radius = distance * (random.below(2) == 0 ? 1 - gap : 1 + gap);
    const auto space = InflatedSpace::build(world).value();
    const PieceProof proof =
        piece.visit([&](const auto& p) { return prove_distance(space, p, world.safety_radius); });
    const ExactVerdict verdict = test::ExactChecker(world).check(piece);
    const auto i = static_cast<std::size_t>(decade);
    ++pieces[i];
    evaluations[i] += proof.evaluations;
    if (proof.status == ProofStatus::undecided) ++undecided[i];
    if (verdict == ExactVerdict::unknown) ++unknown;
    const bool is_wrong =
        (proof.status == ProofStatus::proved && verdict == ExactVerdict::blocked) ||
        (proof.status == ProofStatus::violated && verdict == ExactVerdict::free);
    if (is_wrong) ++wrong;
    CHECK_FALSE(is_wrong);
  }
  // By the decade of the gap between the safety radius and the clearance.
  CAPTURE(rounds, wrong, unknown, pieces, evaluations, undecided);
  CHECK(std::accumulate(pieces.begin(), pieces.end(), std::size_t{0}) > rounds / 2);
  CHECK(wrong == 0);
  CHECK(unknown == 0);
}

TEST_CASE("at safety radius 0 paths may touch simple polygons, and never enter them") {
  const std::uint64_t seed = 300;
  test::WorldGenerator worlds(seed);
  std::size_t free_segments = 0, blocked_segments = 0, stricter = 0;
  for (std::size_t round = 0; round < test::scaled(400); ++round) {
    INFO("seed " << seed << ", round " << round);
    Workspace world = worlds.workspace();
    world.safety_radius = 0;
    const auto space = InflatedSpace::build(world).value();
    const test::ExactChecker checker(world);
    for (int i = 0; i < 10; ++i) {
      const Segment segment{worlds.point(world), worlds.point(world)};
      const ExactVerdict verdict = checker.check(Piece(segment));
      const bool free = space.segment_free(segment.a, segment.b);
      if (free) CHECK(verdict == ExactVerdict::free);
      if (!free && verdict == ExactVerdict::free) ++stricter;  // walls without area block as well
      ++(free ? free_segments : blocked_segments);
    }
  }
  CHECK(free_segments > 100);
  CHECK(blocked_segments > 100);
  CHECK(stricter < free_segments);

  const auto square = InflatedSpace::build({.bounds = {{0, 0}, {10, 10}},
                                            .obstacles = {Polygon{{{2, 2}, {4, 2}, {4, 4}, {2, 4}}},
                                                          Polygon{{{6, 0}, {6, 5}}}}})
                          .value();
  CHECK(square.segment_free({0, 2}, {5, 2}));        // along an edge
  CHECK(square.segment_free({2, 3}, {0, 3}));        // from an edge
  CHECK(square.segment_free({1, 3}, {3, 5}));        // past the corner (2, 4)
  CHECK_FALSE(square.segment_free({2, 3}, {4, 3}));  // through, from edge to edge
  CHECK_FALSE(square.segment_free({2, 2}, {4, 4}));  // the diagonal
  CHECK_FALSE(square.segment_free({1, 1}, {5, 5}));
  CHECK(square.is_free({2, 2}));
  CHECK_FALSE(square.is_free({3, 3}));
  CHECK_FALSE(square.segment_free({5, 3}, {7, 3}));  // a wall without area
  CHECK_FALSE(square.is_free({6, 3}));
}

}  // namespace
