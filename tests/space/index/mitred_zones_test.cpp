// SPDX-License-Identifier: MIT
#include "tutavia/space/index/mitred_zones.hpp"

#include "support/catch.hpp"

namespace {

using namespace tutavia;
using detail::MitredZones;

Workspace with(const Obstacle& obstacle) {
  return {.bounds = {{-10, -10}, {10, 10}}, .safety_radius = 0.5, .obstacles = {obstacle}};
}

bool enters(const MitredZones& zones, const Point& p) { return zones.enters(p, p); }

TEST_CASE("the tip of a square's corner is part of its zone, whichever way the ring runs") {
  for (const Ring& ring :
       {Ring{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{0, 0}, {0, 2}, {2, 2}, {2, 0}}}) {
    const MitredZones zones(with(Polygon{ring}));
    CHECK(enters(zones, {2.45, 2.45}));  // 0.64 from the corner: outside the round zone
    CHECK(enters(zones, {-0.45, -0.45}));
    CHECK_FALSE(enters(zones, {2.5, 2.5}));  // the tip itself
    CHECK_FALSE(enters(zones, {2.5, 2.2}));  // on the boundary
    CHECK_FALSE(enters(zones, {2.55, 2.2}));
    CHECK_FALSE(enters(zones, {2.4, 1}));  // beside an edge, where zones are not mitred
  }
}

TEST_CASE("segments enter a tip, pass it, and may touch it") {
  const MitredZones zones(with(Polygon{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}}));
  CHECK(zones.enters({2, 2.7}, {2.7, 2}));    // across the tip
  CHECK_FALSE(zones.enters({2, 3}, {3, 2}));  // through the tip's point
  CHECK_FALSE(zones.enters({2, 3.1}, {3.1, 2}));
  CHECK_FALSE(zones.enters({2.5, 5}, {2.5, 2}));  // along its side
  CHECK(zones.enters({2.4, 5}, {2.4, 2.45}));
  CHECK_FALSE(zones.enters({2.4, 5}, {2.4, 2.5}));  // ends on its side
}

TEST_CASE("concave vertices, discs and needles have no tips; holes have them inside") {
  const MitredZones l_shape(with(Polygon{{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}}));
  CHECK_FALSE(enters(l_shape, {1.45, 1.45}));
  CHECK(enters(l_shape, {4.45, 1.45}));
  CHECK_FALSE(enters(MitredZones(with(Disc{{0, 0}, 1})), {1.2, 1.2}));
  const MitredZones needle(with(Polygon{{{0, 0}, {-5, 0.5}, {-5, -0.5}}}));
  CHECK_FALSE(enters(needle, {0.6, 0}));  // the tip would be 10 radii away
  CHECK(enters(needle, {-5.4, 0.9}));
  const Polygon frame{{{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}, {{{-4, -4}, {4, -4}, {4, 4}, {-4, 4}}}};
  const MitredZones hole(with(frame));
  CHECK(enters(hole, {5.4, 5.4}));
  CHECK_FALSE(enters(hole, {3.6, 3.6}));  // concave from inside
}

}  // namespace
