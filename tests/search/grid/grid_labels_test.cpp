// SPDX-License-Identifier: MIT
#include "tutavia/search/grid/grid_labels.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

bool improve(const GridLabels::View& labels, std::size_t cell, Cost g, std::size_t step) {
  return labels.improve(cell, labels.words().word(g, step));
}

// What a path over all cells of the largest grid costs.
constexpr std::uint64_t largest =
    (std::uint64_t{1} << 32) * static_cast<std::uint64_t>(diagonal_cost);

TEST_CASE("grid labels are what a map would hold, over more queries than their counter has",
          "[search]") {
  const std::uint64_t seed = 1;
  Random random(seed);
  GridLabels labels;
  std::size_t wrong = 0;
  std::size_t size = 40;
  for (std::size_t query = 0; query < test::scaled(20000); ++query) {
    if (query % 5000 == 4999) size += 20;                  // another, larger grid
    const std::size_t cells = query % 7 == 0 ? 10 : size;  // and a smaller one in between
    const GridLabels::View view = labels.reset(cells);
    std::map<std::size_t, std::pair<Cost, std::size_t>> model;
    const std::uint64_t range = random.below(2) == 0 ? 20 : largest;
    for (std::size_t i = random.below(30); i > 0; --i) {
      const std::size_t cell = random.below(cells);
      const auto g = static_cast<Cost>(random.below(range + 1));
      const std::size_t step = random.below(no_step + 1);
      const auto known = model.find(cell);
      const bool better = known == model.end() || g < known->second.first;
      if (improve(view, cell, g, step) != better) ++wrong;
      if (better) model[cell] = {g, step};
    }
    for (std::size_t cell = 0; cell < cells; ++cell) {
      const auto known = model.find(cell);
      if (view.reached(cell) != (known != model.end())) ++wrong;
      if (known == model.end()) continue;
      if (view.g(cell) != known->second.first || view.arrival(cell) != known->second.second) {
        ++wrong;
      }
    }
    if (wrong > 0) {
      FAIL("seed " << seed << ", query " << query << ": " << wrong << " labels differ");
    }
  }
}

TEST_CASE("the labels of the query begun last can be read later", "[search]") {
  GridLabels labels;
  improve(labels.reset(4), 2, 30, 1);
  improve(labels.reset(4), 3, 50, 5);
  const GridLabels::View view = labels.view();
  CHECK(view.reached(3));
  CHECK(view.g(3) == 50);
  CHECK(view.arrival(3) == 5);
  CHECK_FALSE(view.reached(2));
}

TEST_CASE("one label is kept for 8191 queries and none is seen in a later one", "[search]") {
  GridLabels labels;
  for (int query = 0; query < 8191 * 2 + 10; ++query) {
    const GridLabels::View view = labels.reset(3);
    if (view.reached(0) || view.reached(1) || view.reached(2)) FAIL("query " << query);
    // The best label there is, in every query: a stale one would win.
    if (!improve(view, 1, 0, no_step) || improve(view, 1, 0, 0)) FAIL("query " << query);
    if (!view.reached(1) || view.g(1) != 0 || view.arrival(1) != no_step) FAIL("query " << query);
  }
}

TEST_CASE("the dearest path there is has a label, and any better one beats it", "[search]") {
  GridLabels labels;
  for (int query = 0; query < 3; ++query) {
    const GridLabels::View view = labels.reset(1);
    const auto dearest = static_cast<Cost>(largest);
    for (const Cost g : {dearest, dearest - 1, Cost{1} << 40, Cost{1}, Cost{0}}) {
      CAPTURE(query, g);
      CHECK(improve(view, 0, g, 7));
      CHECK_FALSE(improve(view, 0, g, 0));
      CHECK(view.reached(0));
      CHECK(view.g(0) == g);
      CHECK(view.arrival(0) == 7);
    }
  }
}

}  // namespace
