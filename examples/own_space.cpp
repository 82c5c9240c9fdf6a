// SPDX-License-Identifier: MIT
// Your own space: a round hall with a pillar, and a grid for every search on grids.

#include <algorithm>
#include <cmath>
#include <iostream>
#include <tutavia/tutavia.hpp>

using namespace tutavia;

/// Models FreeSpace, LinkedSpace and GridSpace, without a map or a workspace.
class RoundHall {
 public:
  RoundHall() : grid_(OccupancyGrid::blocked(41, 41).value()) {
    for (int y = 0; y < 41; ++y) {
      for (int x = 0; x < 41; ++x) {
        // This clearance makes every step safe, see GridBuilder.
        const double clearance = clearance_at(frame_.point({x, y}));
        grid_.set({x, y}, clearance >= std::sqrt(radius * radius + 0.5 * 0.25 * 0.25));
      }
    }
  }

  // FreeSpace: proofs for points and segments.
  const Box& bounds() const { return bounds_; }
  bool is_free(const Point& p) const { return clearance_at(p) >= radius; }
  bool segment_free(const Point& p, const Point& q) const {
    // The hall is convex, so its ends suffice; the pillar needs the distance of the whole segment.
    const Segment segment{p, q};
    return is_free(p) && is_free(q) && distance(Point(0, 0), segment) >= 1 + radius;
  }

  // LinkedSpace: the segments that join a point to the grid.
  const Frame& frame() const { return frame_; }
  EndpointLinks links(const Point& p) const {
    EndpointLinks links;
    const Cell nearest = frame_.nearest_cell(p);
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell cell = nearest + Cell{dx, dy};
        if (!grid_.is_free(cell) || !segment_free(p, frame_.point(cell))) continue;
        links.push_back({cell, distance(p, frame_.point(cell))});
      }
    }
    return links;
  }

  // GridSpace: the grid and its movement rule.
  const OccupancyGrid& grid() const { return grid_; }
  MovementRule movement() const { return MovementRule::no_cut; }

 private:
  static constexpr double radius = 0.2;  // of the robot [m]

  static double clearance_at(const Point& p) { return std::min(5 - p.norm(), p.norm() - 1); }

  Box bounds_{{-5, -5}, {5, 5}};
  Frame frame_{.origin = {-5, -5}, .resolution = 0.25};
  OccupancyGrid grid_;
};

int main() {
  static_assert(FreeSpace<RoundHall> && LinkedSpace<RoundHall> && GridSpace<RoundHall>);
  const RoundHall hall;
  AStar::Scratch scratch;
  NoObserver observer;
  const auto route =
      AStar{}.search(hall, {.start = {-4, 0.1}, .goal = {4, 0.2}}, scratch, observer);
  if (!route) {
    std::cerr << route.error() << '\n';
    return 1;
  }
  std::cout << route->curve.length() << " m round the pillar\n";
}
