// SPDX-License-Identifier: MIT
#include "tutavia/search/jump_labels.hpp"

#include <cstddef>
#include <cstdint>
#include <map>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/grid/successors.hpp"

namespace {

using namespace tutavia;

struct Way {
  Cost g;
  std::size_t arrival;
  std::uint32_t parent;
};

TEST_CASE("jump labels are what a map would hold, and those of earlier queries never count",
          "[search]") {
  const std::uint64_t seed = 1;
  Random random(seed);
  JumpLabels labels;
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    INFO("seed " << seed << ", round " << round);
    labels.begin();
    REQUIRE(labels.size() == 0);
    std::map<std::uint32_t, Way> model;
    // Few cells or many, next to one another, a grid's stride apart, or far from one another.
    const std::uint64_t cells = std::uint64_t{1} << random.below(13);
    const std::uint64_t spacing[] = {1, 64, 1024, 65536, 1048573};
    const std::uint64_t stride = spacing[random.below(std::size(spacing))];
    const std::size_t count = random.below(round % 20 == 0 ? 20000 : 800);
    const std::uint64_t range = random.below(2) == 0 ? 50 : std::uint64_t{1} << 46;
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto cell = static_cast<std::uint32_t>(stride * random.below(cells));
      const Way way{static_cast<Cost>(random.below(range)), random.below(no_step + 1),
                    static_cast<std::uint32_t>(random())};
      const auto known = model.find(cell);
      const bool better = known == model.end() || way.g < known->second.g;
      if (labels.improve(cell, way.g, way.arrival, way.parent) != better) ++wrong;
      if (better) model[cell] = way;
      const Way& best = model[cell];
      if (labels.g(cell) != best.g || labels.parent(cell) != best.parent) ++wrong;
    }
    for (const auto& [cell, way] : model) {
      if (labels.g(cell) != way.g || labels.arrival(cell) != way.arrival ||
          labels.parent(cell) != way.parent) {
        ++wrong;
      }
    }
    CHECK(wrong == 0);
    CHECK(labels.size() == model.size());
    CHECK(labels.memory() >= model.size() * sizeof(JumpLabels::Label));
  }
}

TEST_CASE("jump labels grow with what is noted, and keep their memory", "[search]") {
  JumpLabels labels;
  labels.begin();
  labels.improve(1, 1, 1, 1);
  const std::size_t small = labels.memory();
  for (std::uint32_t cell = 0; cell < 100000; ++cell) {
    labels.improve(cell, 2 * Cost{cell} + 1, 3, cell / 2);
  }
  CHECK(labels.size() == 100000);
  const std::size_t large = labels.memory();
  CHECK(large > small);
  CHECK(large <= 4 * 100000 * sizeof(JumpLabels::Label));
  std::size_t wrong = 0;
  for (std::uint32_t cell = 0; cell < 100000; ++cell) {
    const Cost g = cell == 1 ? 1 : 2 * Cost{cell} + 1;
    if (labels.g(cell) != g || labels.parent(cell) != (cell == 1 ? 1 : cell / 2)) ++wrong;
  }
  CHECK(wrong == 0);
  labels.begin();
  CHECK(labels.memory() == large);
  CHECK(labels.improve(5, 1000000, 1, 5));  // worse than before, but that was another query
  CHECK(labels.g(5) == 1000000);
  CHECK(labels.size() == 1);
}

TEST_CASE("no jump label lives on, over more queries than are counted", "[search]") {
  JumpLabels labels;
  for (std::uint32_t query = 0; query < 3 * 8192; ++query) {
    labels.begin();
    // The best labels there are, of cells that come again in some later query.
    for (const std::uint32_t cell : {query % 7, 100 + query % 8191, 9000u}) {
      if (!labels.improve(cell, 0, no_step, query) || labels.improve(cell, 0, 0, 0) ||
          labels.parent(cell) != query || labels.arrival(cell) != no_step) {
        FAIL("query " << query << ", cell " << cell);
      }
    }
    if (labels.size() != 3) FAIL("query " << query);
  }
}

TEST_CASE("of equal ways to a cell the first is kept", "[search]") {
  JumpLabels labels;
  labels.begin();
  CHECK(labels.improve(9, 100, 2, 8));
  CHECK_FALSE(labels.improve(9, 100, 4, 10));
  CHECK_FALSE(labels.improve(9, 101, 4, 10));
  CHECK(labels.arrival(9) == 2);
  CHECK(labels.improve(9, 99, 6, 11));
  CHECK(labels.arrival(9) == 6);
  CHECK(labels.parent(9) == 11);
  CHECK(labels.size() == 1);
}

}  // namespace
