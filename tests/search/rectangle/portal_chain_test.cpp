// SPDX-License-Identifier: MIT
#include "tutavia/search/rectangle/portal_chain.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/search/improved_rea_star.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

TEST_CASE("the shortest path by a line bends where the mirrored straight line crosses it") {
  const CellInterval row{0, 10, 2, 20, 1};
  CHECK(crossing(row, {0, 0}, {20, 20}, 5) == 10);  // straight through
  CHECK(crossing(row, {0, 0}, {20, 0}, 5) == 10);   // and back
  CHECK(crossing(row, {0, 5}, {15, 20}, 5) == 5);
  CHECK(crossing(row, {4, 0}, {4, 20}, 5) == 4);
  CHECK(crossing(row, {0, 10}, {20, 0}, 5) == 0);   // starts on the line
  CHECK(crossing(row, {0, 10}, {20, 10}, 5) == 5);  // all of it on the line: no difference
  CHECK(crossing(row, {8, 10}, {20, 10}, 5) == 8);
  const CellInterval column{1, 10, 2, 20, 1};
  CHECK(crossing(column, {0, 0}, {20, 20}, 5) == 10);
  CHECK(crossing(column, {5, 0}, {20, 15}, 5) == 5);
}

TEST_CASE("the nearest cell of a portal lies in it") {
  const CellInterval portal{0, 10, 2, 20, 1};
  CHECK(nearest_column(portal, 7.4) == 7);
  CHECK(nearest_column(portal, 7.6) == 8);
  CHECK(nearest_column(portal, -100) == 2);
  CHECK(nearest_column(portal, 1e9) == 20);
}

TEST_CASE("a segment passes a portal where it crosses its line within it, or touches it") {
  const CellInterval portal{0, 10, 4, 8, 1};
  CHECK(crosses_portal(portal, {6, 0}, {6, 20}));
  CHECK(crosses_portal(portal, {0, 0}, {12, 20}));        // at 6
  CHECK(crosses_portal(portal, {4, 0}, {4, 20}));         // at its first cell
  CHECK(crosses_portal(portal, {0, 0}, {16, 20}));        // at its last one
  CHECK_FALSE(crosses_portal(portal, {3, 0}, {3, 20}));   // past it
  CHECK_FALSE(crosses_portal(portal, {0, 0}, {17, 20}));  // just past it
  CHECK_FALSE(crosses_portal(portal, {6, 0}, {6, 9}));    // never on its line
  CHECK(crosses_portal(portal, {6, 0}, {6, 10}));         // ends on it
  CHECK(crosses_portal(portal, {0, 10}, {4, 10}));        // along its line, up to it
  CHECK_FALSE(crosses_portal(portal, {0, 10}, {3, 10}));
  CHECK(crosses_portal({1, 10, 4, 8, 1}, {0, 6}, {20, 6}));  // the same for columns
  CHECK_FALSE(crosses_portal({1, 10, 4, 8, 1}, {0, 3}, {20, 3}));
}

TEST_CASE("corners of a straight path are its ends, whatever portals it passes") {
  std::vector<CellPortal> portals;
  for (int i = 0; i < 10; ++i) portals.push_back({{0, 3 * i, 2 * i - 1, 2 * i + 1, 1}, 2 * i});
  portals.front().cells.first = portals.front().cells.last = 0;
  std::vector<Cell> corners;
  append_corners(portals, corners);
  CHECK(corners == std::vector<Cell>{{18, 27}, {0, 0}});
  portals[5].cells.last = portals[5].u = 9;  // it no longer holds (10, 15)
  portals[5].cells.first = 7;
  corners.clear();
  append_corners(portals, corners);
  CHECK(corners.size() > 2);
  CHECK(corners.front() == Cell{18, 27});
  CHECK(corners.back() == Cell{0, 0});
}

TEST_CASE("nodes that slide along portals never lengthen a path, and a funnel is the shortest") {
  const std::uint64_t seed = 914;
  Random random(seed);
  const auto upto = [&](int n) { return static_cast<int>(random.below(static_cast<unsigned>(n))); };
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    INFO("seed " << seed << ", round " << round);
    std::vector<CellPortal> portals;
    const int count = 2 + upto(12);
    for (int i = 0, line = 0; i < count; ++i, line += 1 + upto(9)) {
      const int first = upto(40), last = i == 0 || i == count - 1 ? first : first + upto(30);
      portals.push_back({{0, line, first, last, 1}, first + upto(last - first + 1)});
    }
    const auto length = [&] {
      double sum = 0;
      for (std::size_t i = 1; i < portals.size(); ++i) {
        sum += cell_distance(portals[i - 1].node(), portals[i].node());
      }
      return sum;
    };
    double before = length();
    for (int sweep = 0; sweep < 5; ++sweep) {
      slide(portals, 1);
      CHECK(length() <= before * (1 + 1e-12));
      before = length();
    }
    slide(portals);
    std::vector<Cell> corners, pulled;
    append_corners(portals, corners);
    append_pulled(portals, 0, portals.size() - 1, pulled);
    CHECK(path_length(corners) <= length() * (1 + 1e-12));
    CHECK(path_length(pulled) <= path_length(corners) * (1 + 1e-12));
    CHECK(path_length(corners) <= path_length(pulled) * 1.05);
    CHECK(corners.front() == portals.back().node());
    CHECK(corners.back() == portals.front().node());
  }
}

}  // namespace
