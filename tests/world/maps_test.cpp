// SPDX-License-Identifier: MIT
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "support/catch.hpp"
#include "tutavia/geometry/predicates.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;

struct Published {
  Scene scene;
  std::string name;
  std::size_t obstacles;
  double side;  // of the square bounds [m]
};

std::vector<Published> all_maps() {
  return {{maps::array(), "array", 16, 16},
          {maps::complex(), "complex", 4, 12},
          {maps::maze(), "maze", 6, 16}};
}

/// Whether `p` is a place of free space, from its definition.
bool is_free(const Workspace& workspace, const Point& p) {
  if (!workspace.bounds.contains(p)) return false;
  for (const Obstacle& obstacle : workspace.obstacles) {
    const Polygon& polygon = std::get<Polygon>(obstacle);
    bool clear = !contains(polygon, p);
    detail::for_each_edge(polygon.outer, [&](const Point& a, const Point& b) {
      clear = clear && detail::compare_distance(p, a, b, workspace.safety_radius, 0) >= 0;
    });
    if (!clear) return false;
  }
  return true;
}

TEST_CASE("the maps of the paper have their published size, spacing and obstacles", "[world]") {
  for (const auto& [scene, name, obstacles, side] : all_maps()) {
    CAPTURE(name);
    CHECK(scene.name == name);
    CHECK(validate(scene.workspace).has_value());
    CHECK(scene.workspace.obstacles.size() == obstacles);
    CHECK(scene.workspace.bounds.min == Point(0, 0));
    CHECK(scene.workspace.bounds.max == Point(side, side));
    CHECK(scene.workspace.safety_radius == 0.3);
    CHECK(scene.resolution == 0.2);
    CHECK(scene.goals.size() == 4);
  }
}

TEST_CASE("start and goals of every map lie in free space, apart from each other", "[world]") {
  for (const auto& [scene, name, obstacles, side] : all_maps()) {
    CAPTURE(name);
    CHECK(is_free(scene.workspace, scene.start));
    for (std::size_t i = 0; i < scene.goals.size(); ++i) {
      CAPTURE(i);
      CHECK(is_free(scene.workspace, scene.goals[i]));
      CHECK(scene.goals[i] != scene.start);
      for (std::size_t j = 0; j < i; ++j) CHECK(scene.goals[i] != scene.goals[j]);
    }
  }
}

TEST_CASE("the obstacles of every map are simple counterclockwise polygons in its bounds",
          "[world]") {
  for (const auto& [scene, name, obstacles, side] : all_maps()) {
    CAPTURE(name);
    for (const Obstacle& obstacle : scene.workspace.obstacles) {
      const Polygon& polygon = std::get<Polygon>(obstacle);
      const Ring& ring = polygon.outer;
      CHECK(polygon.holes.empty());
      CHECK(detail::signed_area_twice(ring) > 0);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        CHECK(scene.workspace.bounds.contains(ring[i]));
        // Convex and with area: every corner turns left.
        CHECK(orientation(ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]) == 1);
      }
    }
  }
}

TEST_CASE("the ellipse of the complex map has its corners on an ellipse", "[world]") {
  const Scene scene = maps::complex();
  const Ring& ring = std::get<Polygon>(scene.workspace.obstacles[0]).outer;
  CHECK(ring.size() == 24);
  for (const Point& p : ring) {
    const double x = (p.x() - 1.9) / 1.5, y = (p.y() - 2.7) / 0.5;
    CHECK(x * x + y * y == Approx(1).epsilon(1e-12));
  }
}

TEST_CASE("the scenes of the sampling paper go from corner to corner, free with room for a robot",
          "[world]") {
  for (Scene scene : {maps::rrt_scene_1(), maps::rrt_scene_2()}) {
    CAPTURE(scene.name);
    CHECK(validate(scene.workspace).has_value());
    CHECK(scene.workspace.safety_radius == 0);
    CHECK(scene.workspace.bounds.max == Point(50, 50));
    CHECK(scene.workspace.obstacles.size() == (scene.name == "rrt_scene_1" ? 5 : 6));
    CHECK(scene.start == Point(0, 0));
    CHECK(scene.goals == std::vector<Point>{{50, 50}});
    CHECK(scene.resolution == 0.5);
    double area = 0;  // of the rectangles
    for (const Obstacle& obstacle : scene.workspace.obstacles) {
      if (const Polygon* polygon = std::get_if<Polygon>(&obstacle)) {
        CHECK(detail::signed_area_twice(polygon->outer) > 0);
        area += detail::signed_area_twice(polygon->outer) / 2;
      } else {
        CHECK(std::get<Disc>(obstacle).radius == 5);
      }
    }
    CHECK(area == (scene.name == "rrt_scene_1" ? 80 + 160 + 96 + 128 : 96 + 72 + 84 + 96));
  }
}

}  // namespace
