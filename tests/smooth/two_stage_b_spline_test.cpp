// SPDX-License-Identifier: MIT
#include "tutavia/smooth/two_stage_b_spline.hpp"

#include <cmath>
#include <limits>

#include "support/smoother_contract.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;

TEST_CASE("TwoStageBSpline keeps the smoother contract") {
  test::smoother_contract(TwoStageBSpline{}, {.longest = 3});
  test::smoother_contract(TwoStageBSpline{.d0 = 0});  // nothing pushes
  test::smoother_contract(TwoStageBSpline{.a = 0.1, .b = 0.1, .d0 = 4, .passes = 3},
                          {.longest = 31});
}

/// A grid drawn as text, the first line at the top.
CellSpace cells(const std::vector<std::string>& rows, MovementRule movement) {
  const int height = static_cast<int>(rows.size()), width = static_cast<int>(rows[0].size());
  OccupancyGrid grid = OccupancyGrid::blocked(width, height).value();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto row = static_cast<std::size_t>(height - 1 - y);
      grid.set({x, y}, rows[row][static_cast<std::size_t>(x)] == '.');
    }
  }
  return CellSpace::build(std::move(grid), {.movement = movement}).value();
}

Curve route_through(const CellSpace& space, const std::vector<Cell>& nodes) {
  std::vector<Point> points;
  for (const Cell cell : nodes) points.push_back(space.frame().point(cell));
  return Curve::polyline(points);
}

TEST_CASE("stage 1 leads a diagonal step past a blocked cell through the free one beside it") {
  const auto space = cells({".....",  //
                            ".#...",  //
                            ".....",  //
                            "....."},
                           MovementRule::allow);
  // From beside the block to above it, past its corner.
  const Curve input = route_through(space, {{0, 2}, {1, 3}, {2, 3}});
  REQUIRE(space.segment_free(space.frame().point({0, 2}), space.frame().point({1, 3})));
  const Curve output = TwoStageBSpline{.d0 = 0}.smooth(space, input, {}).value();
  // The spline is drawn towards (0, 3), away from the blocked cell (1, 2).
  const Point corner{1, 3};
  CHECK(output.nearest(corner).distance > 0.1);
  CHECK(input.nearest(corner).distance < 1e-12);
  CHECK(certify(space, output).status == ProofStatus::proved);
}

TEST_CASE("stage 2 moves nodes away from blocked cells by the mean of the printed function") {
  const auto space = cells({".........",  //
                            "....#....",  //
                            "........."},
                           MovementRule::no_cut);
  const Curve input = route_through(space, {{0, 0}, {8, 0}});  // nine nodes
  const TwoStageBSpline once{.d0 = 1.2};  // only the cell straight above (4, 0) is that close
  // A push straight down would leave the bounds at 0.54: a half of it still stays inside.
  const Curve output = once.smooth(space, input, {}).value();
  const double push = 1 / (0.5 + 0.5 * std::exp(1.0));
  const double lowest = output.nearest({4.5, -10}).position.y();
  CHECK(lowest < 0.5);
  CHECK(lowest >= 0.5 - push / 2);
  CHECK(lowest == Approx(0.5 - push / 2 * 2 / 3));  // (P1 + 4 P2 + P3) / 6 of the control points
  CHECK(output.length() > input.length());
  CHECK(output.length() <= input.length() + 2 * push);
}

TEST_CASE("where the spline meets an obstacle, further control points draw it to the legs") {
  const auto space = cells({"......",  //
                            "####..",  //
                            "......"},
                           MovementRule::no_cut);
  const Curve input = route_through(
      space, {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {4, 1}, {4, 2}, {3, 2}, {2, 2}});
  const Curve output = TwoStageBSpline{.d0 = 0}.smooth(space, input, {}).value();
  CHECK(certify(space, output).status == ProofStatus::proved);
  CHECK(output.length() <= input.length());
  CHECK(output.nearest({4, 1.5}).distance > 0);
}

TEST_CASE("two-stage options without meaning are refused by name") {
  const auto space = cells({"..."}, MovementRule::no_cut);
  const Curve input = route_through(space, {{0, 0}, {1, 0}, {2, 0}});
  const auto refusal = [&](const TwoStageBSpline& smoother) {
    const auto result = smoother.smooth(space, input, {});
    REQUIRE_FALSE(result);
    CHECK(result.error().code == PlanError::invalid_option);
    return result.error().detail;
  };
  CHECK(refusal({.a = -1}).find("a ") == 0);
  CHECK(refusal({.b = std::nan("")}).find("b ") == 0);
  CHECK(refusal({.a = 0, .b = 0}).find("a and b ") == 0);
  CHECK(refusal({.c = std::numeric_limits<double>::infinity()}).find("c ") == 0);
  CHECK(refusal({.d0 = 101}).find("d0 ") == 0);
  CHECK(refusal({.passes = -1}).find("passes ") == 0);
}

}  // namespace
