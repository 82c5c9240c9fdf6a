// SPDX-License-Identifier: MIT
#include "tutavia/search/grid/label_map.hpp"

#include <cstddef>
#include <cstdint>
#include <map>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/grid/bitboard/successors.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

struct Way {
  Cost g;
  std::size_t arrival;
  std::uint32_t parent;
};

bool improve(LabelMap& labels, std::uint32_t cell, Cost g, std::size_t arrival,
             std::uint32_t parent) {
  return labels.improve(cell, labels.words().word(g, arrival), parent);
}
Cost g(LabelMap& labels, std::uint32_t cell) { return labels.words().g(labels[cell].word); }
std::size_t arrival(LabelMap& labels, std::uint32_t cell) {
  return LabelWords::arrival(labels[cell].word);
}
std::uint32_t parent(LabelMap& labels, std::uint32_t cell) { return labels[cell].parent; }

TEST_CASE("jump labels are what a map would hold, and those of earlier queries never count",
          "[search]") {
  const std::uint64_t seed = 1;
  Random random(seed);
  LabelMap labels;
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    INFO("seed " << seed << ", round " << round);
    std::map<std::uint32_t, Way> model;
    // Few cells or many, next to one another, a grid's stride apart, or far from one another.
    const std::uint64_t cells = std::uint64_t{1} << random.below(13);
    const std::uint64_t spacing[] = {1, 64, 1024, 65536, 1048573};
    const std::uint64_t stride = spacing[random.below(std::size(spacing))];
    // The labels of a grid of few cells stand by cell, those of a large one in a hash map.
    labels.reset(static_cast<std::size_t>(stride * cells));
    REQUIRE(labels.size() == 0);
    const std::size_t count = random.below(round % 20 == 0 ? 20000 : 800);
    const std::uint64_t range = random.below(2) == 0 ? 50 : std::uint64_t{1} << 46;
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto cell = static_cast<std::uint32_t>(stride * random.below(cells));
      const Way way{static_cast<Cost>(random.below(range)), random.below(no_step + 1),
                    static_cast<std::uint32_t>(random())};
      const auto known = model.find(cell);
      const bool better = known == model.end() || way.g < known->second.g;
      if (improve(labels, cell, way.g, way.arrival, way.parent) != better) ++wrong;
      if (better) model[cell] = way;
      const Way& best = model[cell];
      if (g(labels, cell) != best.g || parent(labels, cell) != best.parent) ++wrong;
    }
    for (const auto& [cell, way] : model) {
      if (g(labels, cell) != way.g || arrival(labels, cell) != way.arrival ||
          parent(labels, cell) != way.parent) {
        ++wrong;
      }
    }
    CHECK(wrong == 0);
    CHECK(labels.size() == model.size());
    CHECK(labels.memory() >= model.size() * sizeof(LabelMap::Label));
  }
}

TEST_CASE("jump labels grow with what is noted, and keep their memory", "[search]") {
  constexpr std::size_t cells = std::size_t{1} << 24;
  LabelMap labels;
  labels.reset(cells);
  improve(labels, 1, 1, 1, 1);
  const std::size_t small = labels.memory();
  for (std::uint32_t cell = 0; cell < 100000; ++cell) {
    improve(labels, cell, 2 * Cost{cell} + 1, 3, cell / 2);
  }
  CHECK(labels.size() == 100000);
  const std::size_t large = labels.memory();
  CHECK(large > small);
  CHECK(large <= 4 * 100000 * sizeof(LabelMap::Label));
  std::size_t wrong = 0;
  for (std::uint32_t cell = 0; cell < 100000; ++cell) {
    const Cost expected = cell == 1 ? 1 : 2 * Cost{cell} + 1;
    if (g(labels, cell) != expected || parent(labels, cell) != (cell == 1 ? 1 : cell / 2)) ++wrong;
  }
  CHECK(wrong == 0);
  labels.reset(cells);
  CHECK(labels.memory() == large);
  CHECK(improve(labels, 5, 1000000, 1, 5));  // worse than before, but that was another query
  CHECK(g(labels, 5) == 1000000);
  CHECK(labels.size() == 1);
}

TEST_CASE("many labels of a small grid move to an array by cell, few of the next query back",
          "[search]") {
  constexpr std::uint32_t cells = 200000;
  LabelMap labels;
  const auto label_all = [&](std::uint32_t count, Cost cost) {
    labels.reset(cells);
    std::size_t wrong = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t cell = i * 7919u % cells;
      if (!improve(labels, cell, cost + i, i % 8, i) || improve(labels, cell, cost + i, 8, 0)) {
        ++wrong;
      }
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t cell = i * 7919u % cells;
      if (g(labels, cell) != cost + i || arrival(labels, cell) != i % 8) ++wrong;
    }
    CHECK(wrong == 0);
    CHECK(labels.size() == count);
  };
  label_all(1000, 5);
  const std::size_t few = labels.memory();
  label_all(100000, 4);  // on the way from the map to the array
  const std::size_t many = labels.memory();
  CHECK(many >= few + cells * sizeof(LabelMap::Label));
  label_all(50000, 3);  // in the array from the first
  label_all(10, 2);     // in the array, but too few to stay there
  label_all(1000, 1);   // in the map
  label_all(100000, 6);
  CHECK(labels.memory() == many);
  // A larger grid does not fit the array.
  labels.reset(2 * cells);
  CHECK(improve(labels, 2 * cells - 1, 9, 0, 3));
  CHECK(parent(labels, 2 * cells - 1) == 3);
}

TEST_CASE("no jump label lives on, over more queries than are counted", "[search]") {
  LabelMap labels;
  for (std::uint32_t query = 0; query < 3 * 8192; ++query) {
    labels.reset(16384);
    // The best labels there are, of cells that come again in some later query.
    for (const std::uint32_t cell : {query % 7, 100 + query % 8191, 9000u}) {
      if (!improve(labels, cell, 0, no_step, query) || improve(labels, cell, 0, 0, 0) ||
          parent(labels, cell) != query || arrival(labels, cell) != no_step) {
        FAIL("query " << query << ", cell " << cell);
      }
    }
    if (labels.size() != 3) FAIL("query " << query);
  }
}

TEST_CASE("of equal ways to a cell the first is kept", "[search]") {
  LabelMap labels;
  labels.reset(100);
  CHECK(improve(labels, 9, 100, 2, 8));
  CHECK_FALSE(improve(labels, 9, 100, 4, 10));
  CHECK_FALSE(improve(labels, 9, 101, 4, 10));
  CHECK(arrival(labels, 9) == 2);
  CHECK(improve(labels, 9, 99, 6, 11));
  CHECK(arrival(labels, 9) == 6);
  CHECK(parent(labels, 9) == 11);
  CHECK(labels.size() == 1);
}

}  // namespace
