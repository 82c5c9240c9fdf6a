// SPDX-License-Identifier: MIT
// The steps between cells, and the links of points to them.
#include "tutavia/space/cell_space.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include "support/catch.hpp"
#include "support/cell_oracle.hpp"
#include "support/random_cells.hpp"
#include "support/scale.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::test;

TEST_CASE("every step between free cells is a free segment, under every movement rule") {
  std::size_t checked = 0;
  on_random_cells({.seed = 9, .rounds = scaled(300)}, [&](const CellTrial& t) {
    const Rational limit = squared_radius(t.space);
    const OccupancyGrid& grid = t.space.grid();
    for (int y = 0; y < t.map.height(); ++y) {
      for (int x = 0; x < t.map.width(); ++x) {
        if (!grid.is_free(Cell{x, y})) continue;
        for (std::size_t step = 0; step < steps.size(); ++step) {
          if (!grid.can_step({x, y}, step, t.space.movement())) continue;
          const Cell to = Cell{x, y} + steps[step];
          const Place a{4 * x + 2, 4 * y + 2}, b{4 * to.x + 2, 4 * to.y + 2};
          if (!t.squares.is_free(a, b, limit) ||
              !t.space.segment_free(t.space.frame().point({x, y}), t.space.frame().point(to))) {
            FAIL_CHECK("cell (" << x << ", " << y << "), step " << step << ", rule "
                                << static_cast<int>(t.space.movement()) << ", radius "
                                << t.space.safety_radius() / t.space.frame().resolution
                                << " cells");
          }
          ++checked;
        }
      }
    }
  });
  CHECK(checked > scaled(2000));
}

TEST_CASE("a point is joined to the cells around it that it reaches by free segments") {
  std::size_t joined = 0, refused = 0, far = 0;
  on_random_cells({.seed = 11, .rounds = scaled(300)}, [&](const CellTrial& t) {
    const Rational limit = squared_radius(t.space);
    for (int i = 0; i < 10; ++i) {
      const Place at = t.squares.random_place(t.random);
      const EndpointLinks links = t.space.links(point_at(t.space, at));
      std::map<std::pair<int, int>, double> expected;
      for (int y = 0; y < t.map.height(); ++y) {
        for (int x = 0; x < t.map.width(); ++x) {
          const Place centre{4 * x + 2, 4 * y + 2};
          const std::int64_t dx = centre.x - at.x, dy = centre.y - at.y;
          const std::int64_t square = dx * dx + dy * dy;
          if (square > 32 || !t.space.grid().is_free(Cell{x, y})) continue;
          if (!t.squares.is_free(at, centre, limit)) {
            ++refused;
            continue;
          }
          expected[{x, y}] =
              std::sqrt(static_cast<double>(square)) * t.space.frame().resolution / 4;
        }
      }
      for (const auto& [cell, length] : expected) {  // a cell's own centre needs no other
        if (length != 0) continue;
        expected = {{cell, 0}};
        break;
      }
      if (expected.empty()) {  // cells farther away, if any
        for (const EndpointLink& link : links) {
          const Cell d = link.cell - *links.centre();
          const Place centre{4 * link.cell.x + 2, 4 * link.cell.y + 2};
          CHECK(std::max(std::abs(d.x), std::abs(d.y)) <= 1);
          CHECK(t.squares.is_free(at, centre, limit));
        }
        far += links.size();
        continue;
      }
      bool right = links.size() == expected.size() && !links.centre();
      for (const EndpointLink& link : links) {
        const auto entry = expected.find({link.cell.x, link.cell.y});
        right = right && entry != expected.end() &&
                std::abs(entry->second - link.length) <= t.space.distance_error_bound();
      }
      if (!right) FAIL_CHECK("quarter (" << at.x << ", " << at.y << ")");
      joined += links.size();
    }
  });
  CHECK(joined > scaled(1000));
  CHECK(refused > scaled(100));
  CHECK(far > scaled(10));
}

TEST_CASE("a point outside the grid has no links") {
  const auto space = CellSpace::build(draw({"...", "...", "..."})).value();
  CHECK(space.links({-0.1, 1.5}).empty());
  CHECK(space.links({1.5, 3.1}).empty());
  CHECK(space.links({1e300, -1e300}).empty());
  CHECK(space.links({2147483647.5, 1.5}).empty());
  CHECK(space.links({quiet_nan, 1.5}).empty());
  CHECK(space.links({infinity, 1.5}).empty());
}

}  // namespace
