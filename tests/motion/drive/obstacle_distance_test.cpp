// SPDX-License-Identifier: MIT
#include "tutavia/motion/drive/obstacle_distance.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "support/catch.hpp"
#include "support/random_worlds.hpp"
#include "support/reference_distance.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;

double reference_gap(const Point& p, const Obstacle& obstacle) {
  const Workspace world{.bounds = {p, p}, .obstacles = {obstacle}};
  return static_cast<double>(test::reference_clearance(world, p));
}

/// The least distance of many points of a piece from an obstacle, in long doubles.
template <class P>
double sampled_distance(const P& piece, const Obstacle& obstacle, int samples) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= samples; ++i) {
    least = std::min(least, reference_gap(piece.point(static_cast<double>(i) / samples), obstacle));
  }
  return least;
}

template <class P>
void check_distance(const P& piece, const Obstacle& obstacle, std::size_t& apart) {
  constexpr int samples = 256;
  const detail::ClosestApproach found = detail::distance_to(piece, obstacle);
  const double sampled = sampled_distance(piece, obstacle, samples);
  const double spacing = piece.length() / samples;
  // Samples are never nearer than the nearest point, nor much farther.
  if (found.distance > 0) {
    CHECK(sampled >= found.distance - 1e-9);
    CHECK(sampled <= found.distance + spacing + 1e-9);
    CHECK(reference_gap(piece.point(found.parameter), obstacle) ==
          Approx(found.distance).margin(1e-7));
    ++apart;
  } else {
    CHECK(sampled <= spacing);
  }
  const double magnitude = 100;
  CHECK(detail::distance_below(piece, obstacle, magnitude).distance < found.distance);
  CHECK(detail::distance_below(piece, obstacle, magnitude).distance > found.distance - 1e-9);
}

TEST_CASE("distances of segments, arcs and points from obstacles are those of their samples") {
  std::size_t apart = 0, pieces = 0;
  for (std::uint64_t seed = 0; seed < test::scaled(60); ++seed) {
    CAPTURE(seed);
    test::WorldGenerator generator(seed);
    Random random(seed);
    const Workspace workspace = generator.workspace();
    const Obstacle obstacle = generator.obstacle(workspace.bounds);
    const Point a = generator.point(workspace), b = generator.point(workspace);
    check_distance(Segment{a, b}, obstacle, apart);
    check_distance(Segment{a, a}, obstacle, apart);
    const double radius = random.uniform(0.1, 3);
    check_distance(Arc::around(b, radius, random.uniform(-3, 3), random.uniform(-6, 6)), obstacle,
                   apart);
    pieces += 3;
  }
  CHECK(5 * apart > pieces);
  CHECK(apart < pieces);  // some met
}

TEST_CASE("a piece inside an obstacle has no distance from it, but has one in its hole") {
  const Polygon frame{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{{2, 2}, {2, 8}, {8, 8}, {8, 2}}}};
  const Segment in_frame{{1, 1}, {9, 1}}, in_hole{{4, 5}, {6, 5}}, through{{1, 5}, {5, 5}};
  CHECK(detail::distance_to(in_frame, frame).distance == Approx(-1));
  CHECK(detail::distance_to(in_hole, frame).distance == Approx(2));
  CHECK(detail::distance_to(through, frame).distance == Approx(0).margin(1e-12));
  const Disc disc{{5, 5}, 3};
  CHECK(detail::distance_to(in_hole, disc).distance == Approx(-3));
  CHECK(detail::distance_to(Segment{{9, 5}, {9, 5}}, disc).distance == Approx(1));
}

TEST_CASE("obstacles whose numbers allow no distances are told apart") {
  const auto is_valid = [](const Obstacle& shape, const Point& velocity = {0, 0}) {
    return detail::is_valid_obstacle({shape, velocity});
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Ring ring{{0, 0}, {1, 0}, {0, 1}};
  CHECK(is_valid(Disc{{1, 2}, 0}));
  CHECK(is_valid(Polygon{ring}));
  CHECK(is_valid(Polygon{ring, {ring}}, {0.1, -5}));
  CHECK_FALSE(is_valid(Disc{{1, 2}, -0.1}));
  CHECK_FALSE(is_valid(Disc{{1, nan}, 1}));
  CHECK_FALSE(is_valid(Disc{{1, 2}, nan}));
  CHECK_FALSE(is_valid(Disc{{1e300, 2}, 1}));
  CHECK_FALSE(is_valid(Disc{{1, 2}, 1}, {nan, 0}));
  CHECK_FALSE(is_valid(Polygon{}));
  CHECK_FALSE(is_valid(Polygon{{{0, 0}, {nan, 0}, {0, 1}}}));
  CHECK_FALSE(is_valid(Polygon{ring, {{}}}));
  CHECK_FALSE(is_valid(Polygon{ring, {{{0, 0}, {0, nan}}}}));
}

}  // namespace
