// SPDX-License-Identifier: MIT
#include "tutavia/search/informed_rrt_star.hpp"

#include "support/tree_contract.hpp"
#include "tutavia/search/rrt_star.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;

TEST_CASE("InformedRrtStar keeps the contracts of searchers and of trees", "[soak]") {
  test::tree_contract(InformedRrtStar{}, 0x9f511dbbbadba8f2);
}

TEST_CASE("samples of an ellipse lie in it and fill it evenly") {
  const detail::Ellipse ellipse({1, 2}, {4, 6}, 7);
  CHECK(ellipse.area() == Approx(3.141592653589793 * 3.5 * std::sqrt(6.0)));
  Random random(5);
  std::size_t inner = 0;
  const std::size_t count = 20000;
  // Half the axes, a quarter of the area.
  for (std::size_t i = 0; i < count; ++i) {
    const Point p = ellipse.sample(random);
    CHECK(distance(p, {1, 2}) + distance(p, {4, 6}) <= 7 + 1e-12);
    const Point along = Point(3, 4) / 5, v = p - Point(2.5, 4);
    const double u = v.dot(along) / 3.5, w = cross(along, v) / std::sqrt(6.0);
    if (u * u + w * w < 0.25) ++inner;
  }
  CHECK(static_cast<double>(inner) / static_cast<double>(count) == Approx(0.25).margin(0.01));
}

TEST_CASE("informed samples make paths shorter than uniform ones do") {
  NoObserver no_observer;
  InformedRrtStar::Scratch scratch;
  double informed = 0, uniform = 0;
  for (Scene scene : {maps::rrt_scene_1(), maps::rrt_scene_2()}) {
    scene.workspace.safety_radius = 1;
    const auto space = InflatedSpace::build(scene.workspace).value();
    Query query{.start = scene.start, .goal = scene.goals[0]};
    for (query.seed = 1; query.seed <= 10; ++query.seed) {
      informed += InformedRrtStar{}.search(space, query, scratch, no_observer)->cost;
      uniform += RrtStar{}.search(space, query, scratch, no_observer)->cost;
    }
  }
  CHECK(informed < uniform);
}

}  // namespace
