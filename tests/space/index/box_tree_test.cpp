// SPDX-License-Identifier: MIT
#include "tutavia/space/index/box_tree.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

std::vector<std::uint32_t> found(const BoxTree& tree, const Box& box) {
  std::vector<std::uint32_t> numbers;
  tree.for_each_in(box, [&](std::uint32_t number) { numbers.push_back(number); });
  return numbers;
}

bool meet(const Box& a, const Box& b) {
  return a.min.x() <= b.max.x() && b.min.x() <= a.max.x() && a.min.y() <= b.max.y() &&
         b.min.y() <= a.max.y();
}

/// Boxes whose corners often share coordinates.
Box random_box(Random& random, double size, const Point& origin, bool on_lattice) {
  const auto draw = [&](double high) {
    return on_lattice ? high * 0.125 * static_cast<double>(random.below(9))
                      : random.uniform(0, high);
  };
  const Point low = origin + size * Point{draw(1), draw(1)};
  return {low, low + size * Point{draw(0.25), draw(0.25)}};
}

TEST_CASE("a box tree finds every box that meets a box, and hardly any other") {
  const std::uint64_t seed = 20261128;
  Random random(seed);
  std::size_t met = 0, beside = 0;
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    INFO("seed " << seed << ", round " << round);
    const double size = round % 3 == 0 ? 1e-3 : round % 3 == 1 ? 10 : 1e6;
    const Point origin = round % 2 == 0 ? Point{0, 0} : Point{5e5, -4.8e6};
    const bool on_lattice = round % 5 == 0;
    std::vector<BoxTree::Entry> entries(random.below(round % 10 == 0 ? 2000 : 90));
    for (std::uint32_t i = 0; i < entries.size(); ++i) {
      entries[i] = {random_box(random, size, origin, on_lattice), 7 * i};
    }
    const BoxTree tree(entries);
    for (int k = 0; k < 20; ++k) {
      const Box box = random_box(random, size, origin, on_lattice);
      std::vector<std::uint32_t> numbers = found(tree, box);
      std::sort(numbers.begin(), numbers.end());
      CHECK(std::adjacent_find(numbers.begin(), numbers.end()) == numbers.end());
      for (const auto& [entry, number] : entries) {
        const bool is_found = std::binary_search(numbers.begin(), numbers.end(), number);
        const bool meets = meet(entry, box);
        if (meets && !is_found) FAIL("box " << number << " was missed");
        if (is_found && !meets && !meet(entry, box.inflated(1e-6 * size))) {
          FAIL("box " << number << " is far away");
        }
        met += meets;
        beside += is_found && !meets;
      }
    }
  }
  CHECK(met > test::scaled(10'000));
  CHECK(beside * 1000 < met);
}

TEST_CASE("a box tree answers for boxes that are points, equal, huge, or nowhere") {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Box everywhere{{-infinity, -infinity}, {infinity, infinity}};
  CHECK(found(BoxTree{}, everywhere).empty());
  CHECK(found(BoxTree(std::vector<BoxTree::Entry>{}), everywhere).empty());

  const BoxTree point({{Box{{3, 4}, {3, 4}}, 9}});
  CHECK(found(point, {{3, 4}, {3, 4}}) == std::vector<std::uint32_t>{9});
  CHECK(found(point, everywhere) == std::vector<std::uint32_t>{9});
  CHECK(found(point, {{3.5, 0}, {9, 9}}).empty());
  CHECK(found(point, {{nan, nan}, {nan, nan}}).empty());
  CHECK(found(point, Box{}).empty());

  std::vector<BoxTree::Entry> equal, spread;
  for (std::uint32_t i = 0; i < 600; ++i) {
    equal.emplace_back(Box{{1, 1}, {2, 2}}, i);
    const double x = (i % 2 == 0 ? 1 : -1) * std::ldexp(1.0, static_cast<int>(i % 400));
    spread.emplace_back(Box{{x, x}, {x, x}}, i);
  }
  std::vector<std::uint32_t> all(600);
  for (std::uint32_t i = 0; i < 600; ++i) all[i] = i;
  CHECK(found(BoxTree(equal), {{2, 2}, {3, 3}}) == all);  // in the order given
  auto numbers = found(BoxTree(spread), {{-0x1p400, -0x1p400}, {0x1p400, 0x1p400}});
  std::sort(numbers.begin(), numbers.end());
  CHECK(numbers == all);
}

TEST_CASE("the order of a box tree's answers does not depend on the order of its boxes") {
  Random random(3);
  std::vector<BoxTree::Entry> entries;
  for (std::uint32_t i = 0; i < 777; ++i) {
    entries.emplace_back(random_box(random, 10, {0, 0}, true), i);
  }
  const std::vector<std::uint32_t> order = found(BoxTree(entries), {{0, 0}, {20, 20}});
  CHECK(order.size() == 777);
  std::reverse(entries.begin(), entries.end());
  CHECK(found(BoxTree(entries), {{0, 0}, {20, 20}}) == order);
}

}  // namespace
