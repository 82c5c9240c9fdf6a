// SPDX-License-Identifier: MIT
#include "tutavia/grid/bitboard/places.hpp"

#include <cstddef>

#include "support/catch.hpp"
#include "tutavia/grid/bitboard/transposed.hpp"
#include "tutavia/grid/movement.hpp"
#include "tutavia/grid/occupancy_grid.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

TEST_CASE("a place is the index of a cell in its grid and in the transpose", "[grid]") {
  for (const int width : {1, 62, 63, 130}) {
    for (const int height : {1, 62, 63, 130}) {
      CAPTURE(width, height);
      const OccupancyGrid grid = OccupancyGrid::blocked(width, height).value();
      const OccupancyGrid transpose = transposed(grid);
      const Places places(grid);
      CHECK(places.row_stride() == grid.stride());
      CHECK(places.column_stride() == transpose.stride());
      for (const Cell cell : {Cell{0, 0}, Cell{width - 1, 0}, Cell{width - 1, height - 1}}) {
        const Place place = places.of(cell);
        CHECK(place.in_rows() == grid.index(cell));
        CHECK(place.in_columns() == transpose.index({cell.y, cell.x}));
        for (std::size_t step = 0; step < steps.size(); ++step) {
          for (const int count : {-1, 0, 1}) {
            const Cell to{cell.x + count * steps[step].x, cell.y + count * steps[step].y};
            const Place advanced = places.advanced(place, step, count);
            CHECK(advanced.index == places.of(to).index);
          }
          CHECK(place.in_rows() + places.per_step(step) == places.of(cell + steps[step]).in_rows());
        }
      }
    }
  }
}

}  // namespace
