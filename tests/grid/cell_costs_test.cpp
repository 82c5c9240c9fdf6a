// SPDX-License-Identifier: MIT
#include "tutavia/grid/cell_costs.hpp"

#include <cstddef>

#include "support/catch.hpp"
#include "support/random_grids.hpp"

namespace {

using namespace tutavia;

TEST_CASE("without surcharges a step costs its length", "[grid]") {
  const CellCosts costs(test::free_grid(3, 2));
  CHECK(costs.width() == 3);
  CHECK(costs.height() == 2);
  for (std::size_t step = 0; step < 3; ++step) {
    CHECK(costs.step_cost({0, 0}, step) == CellCosts::scale * detail::step_cost(step));
  }
}

TEST_CASE("a step costs 1 + c / 32 of its length, for the mean c of its two cells", "[grid]") {
  CellCosts costs(test::free_grid(3, 2));
  costs.set({0, 0}, 32);
  CHECK(costs[{0, 0}] == 32);
  CHECK(costs[{1, 0}] == 0);
  CHECK(costs.step_cost({0, 0}, 0) == CellCosts::scale * straight_cost * 3 / 2);
  CHECK(costs.step_cost({1, 0}, 4) == costs.step_cost({0, 0}, 0));  // the same backwards
  costs.set({1, 1}, 32);
  CHECK(costs.step_cost({0, 0}, 1) == CellCosts::scale * diagonal_cost * 2);
  costs.set({0, 0}, 255);
  costs.set({1, 0}, 255);
  const double largest = static_cast<double>(costs.step_cost({0, 0}, 0)) /
                         static_cast<double>(CellCosts::scale * straight_cost);
  CHECK(largest == Approx(1 + 255.0 / 32));
}

}  // namespace
