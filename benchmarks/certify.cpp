// SPDX-License-Identifier: MIT
/// \file
/// What a proof costs: segments and clear cubics against the safety radius, beside testing 101
/// samples with the same index.
///
/// Worlds: 100 x 100 m with n convex polygons of 4 to 8 vertices on circles of radius 4 to 9 m
/// (n = 16) or 0.5 to 1.4 m (n = 1000); safety radius 0.5 or 0.2 m; random pieces 5 m long that are
/// free.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;

constexpr std::uint64_t seed = 1;

InflatedSpace make_space(std::size_t polygons) {
  Random random(seed);
  const bool few = polygons <= 16;
  Workspace world{.bounds = {{0, 0}, {100, 100}}, .safety_radius = few ? 0.5 : 0.2};
  for (std::size_t i = 0; i < polygons; ++i) {
    const Point centre{random.uniform(0, 100), random.uniform(0, 100)};
    const double radius = few ? random.uniform(4, 9) : random.uniform(0.5, 1.4);
    std::vector<double> angles(4 + random.below(5));
    for (double& angle : angles) angle = random.uniform(0, 2 * std::numbers::pi);
    std::sort(angles.begin(), angles.end());
    Ring ring;
    for (const double a : angles) ring.push_back(centre + radius * Point(std::cos(a), std::sin(a)));
    world.obstacles.emplace_back(Polygon{std::move(ring)});
  }
  return InflatedSpace::build(world).value();
}

template <class P>
P random_piece(Random& random) {
  const Point start{random.uniform(5, 95), random.uniform(5, 95)};
  const double heading = random.uniform(0, 2 * std::numbers::pi);
  const Point along = 5 * Point(std::cos(heading), std::sin(heading));
  if constexpr (std::is_same_v<P, Segment>) {
    return {start, start + along};
  } else {
    const Point aside = random.uniform(-0.3, 0.3) * detail::perpendicular(along);
    return {{start, start + along / 3 + aside, start + 2 * along / 3 + aside, start + along}};
  }
}

/// Pieces that keep the safety radius.
template <class P>
std::vector<P> free_pieces(const InflatedSpace& space) {
  Random random(seed + 1);
  std::vector<P> pieces;
  while (pieces.size() < 1024) {
    const P piece = random_piece<P>(random);
    if (is_proved_free(space, piece)) pieces.push_back(piece);
  }
  return pieces;
}

template <class P>
void prove(benchmark::State& state) {
  const InflatedSpace space = make_space(static_cast<std::size_t>(state.range(0)));
  const std::vector<P> pieces = free_pieces<P>(space);
  std::size_t i = 0, evaluations = 0;
  for (auto _ : state) {
    const PieceProof proof = prove_distance(space, pieces[i++ % 1024], space.safety_radius());
    benchmark::DoNotOptimize(proof);
    evaluations += proof.evaluations;
  }
  state.counters["evaluations"] =
      benchmark::Counter(static_cast<double>(evaluations), benchmark::Counter::kAvgIterations);
}

template <class P>
void sample_101(benchmark::State& state) {
  const InflatedSpace space = make_space(static_cast<std::size_t>(state.range(0)));
  const std::vector<P> pieces = free_pieces<P>(space);
  std::size_t i = 0;
  for (auto _ : state) {
    const P& piece = pieces[i++ % 1024];
    bool free = true;
    for (int k = 0; k <= 100; ++k) free = free && space.is_free(piece.point(k / 100.0));
    benchmark::DoNotOptimize(free);
  }
}

BENCHMARK(prove<Segment>)->Arg(16)->Arg(1000);
BENCHMARK(sample_101<Segment>)->Arg(16)->Arg(1000);
BENCHMARK(prove<CubicBezier>)->Arg(16)->Arg(1000);
BENCHMARK(sample_101<CubicBezier>)->Arg(16)->Arg(1000);

}  // namespace

BENCHMARK_MAIN();
