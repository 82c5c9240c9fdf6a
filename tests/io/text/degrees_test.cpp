// SPDX-License-Identifier: MIT
#include "tutavia/io/text/degrees.hpp"

#include <string>
#include <vector>

#include "support/catch.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;

bool looks_like_degrees(const std::vector<Point>& points) {
  detail::DegreeCheck check;
  for (const Point& p : points) check.add(p);
  return check.looks_like_degrees();
}

TEST_CASE("streets in degrees are told from rooms in metres") {
  CHECK(looks_like_degrees({{8.54, 47.37}, {8.5412, 47.3711}}));
  CHECK(looks_like_degrees({{37.3778, -122.0419}, {37.3779, -122.0418}}));  // latitude first
  CHECK(looks_like_degrees({{-0.6167, 0.25105}, {-0.6129, 0.25103}}));
  CHECK_FALSE(looks_like_degrees({}));
  CHECK_FALSE(looks_like_degrees({{8.5412, 47.3711}}));                   // a single point
  CHECK_FALSE(looks_like_degrees({{8.541, 47.371}, {8.542, 47.372}}));    // millimetres
  CHECK_FALSE(looks_like_degrees({{0.1234, 0.2}, {0.9, 0.3333}}));        // round the origin
  CHECK_FALSE(looks_like_degrees({{8.5412, 47.3711}, {10.1, 49.2}}));     // too wide
  CHECK_FALSE(looks_like_degrees({{181.5412, 7.3711}, {181.6, 7.3}}));    // no longitude
  CHECK_FALSE(looks_like_degrees({{91.5412, 97.3711}, {91.6, 97.3}}));    // no latitude
  CHECK_FALSE(looks_like_degrees({{1. / 3, 2. / 3}, {7. / 3, 5. / 3}}));  // computed metres
}

TEST_CASE("no built-in map looks like degrees, and a scene in degrees is warned of once") {
  for (Scene scene :
       {maps::array(), maps::complex(), maps::maze(), maps::rrt_scene_1(), maps::rrt_scene_2()}) {
    std::vector<std::string> warnings;
    detail::warn_of_degrees(scene, warnings);
    CHECK(warnings.empty());
  }
  Scene scene;
  scene.start = {8.5401, 47.3701};
  scene.goals = {{8.5402, 47.3702}};
  std::vector<std::string> warnings;
  detail::warn_of_degrees(scene, warnings);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find("project them first") != std::string::npos);
  scene.workspace.obstacles.emplace_back(Disc{{0, 0}, 1});
  warnings.clear();
  detail::warn_of_degrees(scene, warnings);
  CHECK(warnings.empty());
}

}  // namespace
