// SPDX-License-Identifier: MIT
#include "tutavia/smooth/no_smoothing.hpp"

#include "support/smoother_contract.hpp"

namespace {

using namespace tutavia;

TEST_CASE("NoSmoothing keeps the smoother contract and changes nothing") {
  test::smoother_contract(NoSmoothing{}, {.budget = test::BudgetUse::ignored});
  const Point points[] = {{1, 2}, {3, 4}, {5, 4}};
  const Curve curve = Curve::polyline(points);
  CHECK(test::same_curve(NoSmoothing{}.smooth(0, curve, Budget{}).value(), curve));
}

}  // namespace
