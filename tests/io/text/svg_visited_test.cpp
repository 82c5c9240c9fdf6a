// SPDX-License-Identifier: MIT
#include "tutavia/io/text/svg_visited.hpp"

#include "support/catch.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

TEST_CASE("the centres of cells are known up to rounding") {
  const CellCentres centres{{-1, 2}, 0.1};
  CHECK(centres.cell_at({-0.95, 2.05}) == Point(0, 0));
  CHECK(centres.cell_at({-1 + 0.1 * 7.5, 2 + 0.1 * 3.5}) == Point(7, 3));
  CHECK_FALSE(centres.cell_at({-1, 2}));
  CHECK_FALSE(centres.cell_at({-0.95, 2.06}));
  CHECK_FALSE(CellCentres{{0, 0}, 0}.cell_at({0.5, 0.5}));
}

TEST_CASE("runs of visited cells end with the row") {
  const SvgPaths paths{{{0, 0}, {3, 2}}, 10, {0, 0}, true};
  const std::vector<Point> all{{0.5, 0.5}, {1.5, 0.5}, {2.5, 0.5}, {0.5, 1.5}, {2.5, 1.5}};
  const VisitedNodes visited(all, {{0, 0}, 1});
  CHECK(visited.squares(paths) ==
        "M0.00 0.00H30.00V10.00H0.00ZM0.00 10.00H10.00V20.00H0.00ZM20.00 10.00H30.00V20.00H20.00Z");
  CHECK(visited.dots(paths).empty());
  const VisitedNodes dots({{1, 1}, {1, 1}, {2, 1}}, {{0, 0}, 0});
  CHECK(dots.squares(paths).empty());
  CHECK(dots.dots(paths) == "M10.00 10.00h0M20.00 10.00h0");
}

}  // namespace
