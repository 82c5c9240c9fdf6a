// SPDX-License-Identifier: MIT
#include "tutavia/world/moving_obstacle.hpp"

#include <variant>

#include "support/catch.hpp"

namespace {

using namespace tutavia;

TEST_CASE("a moving obstacle keeps its shape and moves with its velocity") {
  const MovingObstacle disc{Disc{{1, 2}, 0.5}, {0.5, -1}};
  CHECK_FALSE(disc.stands());
  const Disc later = std::get<Disc>(at_time(disc, 2));
  CHECK(later.center == Point(2, 0));
  CHECK(later.radius == 0.5);
  const MovingObstacle frame{Polygon{{{0, 0}, {4, 0}, {4, 4}}, {{{2, 1}, {3, 1}, {3, 2}}}},
                             {-1, 0}};
  const Polygon moved_frame = std::get<Polygon>(at_time(frame, 3));
  CHECK(moved_frame.outer == Ring{{-3, 0}, {1, 0}, {1, 4}});
  REQUIRE(moved_frame.holes.size() == 1);
  CHECK(moved_frame.holes[0] == Ring{{-1, 1}, {0, 1}, {0, 2}});
  CHECK(MovingObstacle{Disc{{1, 2}, 0.5}}.stands());
  CHECK(MovingObstacle{Disc{{1, 2}, 0.5}, {}}.stands());
  CHECK(MovingObstacle{Disc{{1, 2}, 0.5}, Point(1, 2)}.velocity == Point(1, 2));
}

}  // namespace
