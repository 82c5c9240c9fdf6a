// SPDX-License-Identifier: MIT
#include "tutavia/geometry/tangent/funnel.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;
using Portals = std::vector<std::pair<Point, Point>>;

double length(const std::vector<Point>& path) {
  double sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i) sum += distance(path[i - 1], path[i]);
  return sum;
}

TEST_CASE("through no portals, and through wide ones, the path is straight") {
  CHECK(detail::funnel_path({}, {0, 0}, {5, 5}) == std::vector<Point>{{0, 0}, {5, 5}});
  const Portals wide{{{1, -9}, {1, 9}}, {{2, -9}, {2, 9}}, {{3, -9}, {3, 9}}};
  CHECK(detail::funnel_path(wide, {0, 0}, {4, 1}) == std::vector<Point>{{0, 0}, {4, 1}});
}

TEST_CASE("the path bends at the ends of portals that it cannot avoid, left and right") {
  const Portals up{{{1, 2}, {1, 9}}};
  CHECK(detail::funnel_path(up, {0, 0}, {2, 0}) == std::vector<Point>{{0, 0}, {1, 2}, {2, 0}});
  const Portals zigzag{{{1, 2}, {1, 9}}, {{2, -9}, {2, -2}}, {{3, 2}, {3, 9}}};
  CHECK(detail::funnel_path(zigzag, {0, 0}, {4, 0}) ==
        std::vector<Point>{{0, 0}, {1, 2}, {2, -2}, {3, 2}, {4, 0}});
}

TEST_CASE("a path that only touches the end of a portal does not stop there") {
  const Portals touched{{{1, 1}, {1, 9}}, {{2, 2}, {2, 9}}};
  CHECK(length(detail::funnel_path(touched, {0, 0}, {3, 3})) == Approx(length({{0, 0}, {3, 3}})));
}

/// The length of the shortest path through portals at x = 1, 2, ... by relaxation: it bends at ends
/// of portals alone.
double shortest(const Portals& portals, const Point& start, const Point& goal) {
  std::vector<std::vector<Point>> layers{{start}};
  for (const auto& [right, left] : portals) layers.push_back({right, left});
  layers.push_back({goal});
  const auto is_open = [&](std::size_t from, const Point& a, std::size_t to, const Point& b) {
    for (std::size_t i = from + 1; i < to; ++i) {
      const auto& [right, left] = portals[i - 1];
      const double share = (right.x() - a.x()) / (b.x() - a.x());
      const double y = a.y() + share * (b.y() - a.y());
      if (y < right.y() - 1e-12 || y > left.y() + 1e-12) return false;
    }
    return true;
  };
  std::vector<std::vector<double>> best;
  for (std::size_t to = 0; to < layers.size(); ++to) {
    best.emplace_back(layers[to].size(), to == 0 ? 0.0 : std::numeric_limits<double>::infinity());
    for (std::size_t from = 0; from < to; ++from) {
      for (std::size_t i = 0; i < layers[from].size(); ++i) {
        for (std::size_t k = 0; k < layers[to].size(); ++k) {
          const Point &a = layers[from][i], &b = layers[to][k];
          if (is_open(from, a, to, b)) {
            best[to][k] = std::min(best[to][k], best[from][i] + distance(a, b));
          }
        }
      }
    }
  }
  return best.back()[0];
}

TEST_CASE("the path through random portals is the shortest that relaxation finds") {
  const std::uint64_t seed = 32;
  Random random(seed);
  std::size_t bends = 0;
  for (std::size_t round = 0; round < test::scaled(500); ++round) {
    INFO("seed " << seed << ", round " << round);
    Portals portals;
    const std::size_t count = random.below(12);
    for (std::size_t i = 0; i < count; ++i) {
      const double x = 1 + static_cast<double>(i), low = random.uniform(-3, 3);
      portals.push_back({{x, low}, {x, low + random.uniform(0, 3)}});
    }
    const Point start(0, random.uniform(-3, 3));
    const Point goal(1 + static_cast<double>(count), random.uniform(-3, 3));
    const auto path = detail::funnel_path(portals, start, goal);
    CHECK(path.front() == start);
    CHECK(path.back() == goal);
    CHECK(length(path) == Approx(shortest(portals, start, goal)).epsilon(1e-12));
    bends += path.size() - 2;
  }
  CHECK(bends > test::scaled(500));
}

}  // namespace
