// SPDX-License-Identifier: MIT
#include "tutavia/search/tree/point_buckets.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;
using Neighbour = PointBuckets::Neighbour;

std::vector<PointBuckets::Index> numbers(std::vector<Neighbour> neighbours) {
  std::sort(neighbours.begin(), neighbours.end());
  std::vector<PointBuckets::Index> result;
  for (const Neighbour& neighbour : neighbours) result.push_back(neighbour.index);
  return result;
}

/// All points by distance from p, then by number.
std::vector<Neighbour> by_distance(const PointBuckets& index, const Point& p) {
  std::vector<Neighbour> all;
  for (PointBuckets::Index i = 0; i < index.size(); ++i) {
    const double dx = index[i].x() - p.x(), dy = index[i].y() - p.y();
    all.push_back({dx * dx + dy * dy, i});
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Points of one kind of world: spread evenly, in a clump, or on a coarse lattice, where ties
/// abound.
class Points {
 public:
  Points(std::uint64_t seed, const Box& bounds, std::uint64_t kind)
      : random_(seed), bounds_(bounds), kind_(kind) {}

  Point operator()() {
    double u = random_.uniform(), v = random_.uniform();
    if (kind_ == 1) u = 0.3 + u / 50, v = 0.6 + v / 200;
    if (kind_ == 2) u = std::floor(8 * u) / 8, v = std::floor(8 * v) / 8;
    return {bounds_.min.x() + u * bounds_.width(), bounds_.min.y() + v * bounds_.height()};
  }

 private:
  Random random_;
  Box bounds_;
  std::uint64_t kind_;
};

TEST_CASE("a point index answers as looking at every point does, while points are added",
          "[soak]") {
  const std::vector<Box> worlds{{{0, 0}, {50, 50}},
                                {{-3, 7}, {97, 8}},
                                {{1e4, -2e4}, {1e4 + 16, -2e4 + 16}},
                                {{2, 1}, {2, 9}},
                                {{5, 5}, {5, 5}}};
  PointBuckets index;
  std::vector<Neighbour> found;
  for (std::uint64_t seed = 1; seed <= test::scaled(5); ++seed) {
    for (std::size_t world = 0; world < worlds.size(); ++world) {
      for (std::uint64_t kind = 0; kind < 3; ++kind) {
        INFO("seed " << seed << ", world " << world << ", kind " << kind);
        const Box& bounds = worlds[world];
        Points points(seed, bounds, kind), queries(seed + 1000, bounds, kind == 1 ? 0 : kind);
        Random random(seed);
        index.reset(bounds);
        for (std::size_t count = 1; count <= 300; ++count) {
          const Point added = points();
          CHECK(index.add(added) == count - 1);
          CHECK(index[static_cast<PointBuckets::Index>(count - 1)] == added);
          if (count > 20 && count % 23 != 0) continue;
          const Point p = queries();
          const auto all = by_distance(index, p);
          CHECK(index.nearest(p) == all[0].index);
          const std::size_t k = 1 + random.below(40);
          index.k_nearest(p, k, found);
          CHECK(numbers(found) ==
                numbers({all.begin(),
                         all.begin() + static_cast<std::ptrdiff_t>(std::min(k, all.size()))}));
          const double reach = random.uniform() * (bounds.width() + bounds.height()) / 4;
          index.within(p, reach, found);
          const auto end = std::find_if(all.begin(), all.end(), [&](const Neighbour& neighbour) {
            return neighbour.squared_distance > reach * reach;
          });
          CHECK(numbers(found) == numbers({all.begin(), end}));
        }
      }
    }
  }
}

TEST_CASE("of equally near points the first is the nearest, and the first ones are the k nearest") {
  PointBuckets index;
  index.reset({{0, 0}, {4, 4}});
  for (const Point& p : {Point{3, 2}, Point{2, 3}, Point{1, 2}, Point{2, 1}}) index.add(p);
  CHECK(index.nearest({2, 2}) == 0);
  std::vector<Neighbour> found;
  index.k_nearest({2, 2}, 2, found);
  CHECK(numbers(found) == std::vector<PointBuckets::Index>{0, 1});
}

}  // namespace
