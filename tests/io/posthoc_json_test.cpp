// SPDX-License-Identifier: MIT
#include "tutavia/io/posthoc_json.hpp"

#include <cstddef>
#include <string>

#include "support/catch.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/smooth/clothoid_smoother.hpp"
#include "tutavia/space/lattice_space.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;
using PosthocJson = nlohmann::ordered_json;

std::size_t count_events(const PosthocJson& trace, const std::string& type) {
  std::size_t n = 0;
  for (const PosthocJson& event : trace["events"]) n += event["type"] == type ? 1 : 0;
  return n;
}

TEST_CASE("a trace for Posthoc has what its schema requires, and every event of the search") {
  const Scene scene = maps::maze();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.2}).value();
  Planner planner{AStar{}, ClothoidSmoother{}};
  SearchRecord record;
  const auto plan =
      planner.plan(space, {.start = scene.start, .goal = scene.goals[0]}, record).value();
  const PosthocJson trace =
      posthoc_trace(scene.workspace, scene.start, scene.goals[0], record, &plan);
  CHECK(trace["version"] == "1.4.0");
  REQUIRE(trace["views"]["main"].is_array());
  for (const PosthocJson& view : trace["views"]["main"]) CHECK(view["$"].is_string());
  REQUIRE(trace["events"].is_array());
  for (const PosthocJson& event : trace["events"]) CHECK(event["type"].is_string());
  CHECK(count_events(trace, "obstacle") == scene.workspace.obstacles.size());
  CHECK(count_events(trace, "expanding") == plan.stats.expanded);
  CHECK(count_events(trace, "generating") == plan.stats.generated);
  CHECK(count_events(trace, "source") == 1);
  CHECK(count_events(trace, "curve") == 1);
  const PosthocJson& curve = trace["events"].back()["points"];
  CHECK(curve.front()["x"] == scene.start.x());
  CHECK(curve.front()["y"] == -scene.start.y());  // y points down
}

TEST_CASE("a trace for Posthoc is cut at its limit, and says so") {
  SearchRecord record;
  for (int i = 0; i < 10; ++i) record.expanded({i, 0});
  Workspace workspace;
  workspace.obstacles = {Disc{{1, 2}, 0.5}};
  const PosthocJson trace =
      posthoc_trace(workspace, {0, 0}, {9, 0}, record, nullptr, {.max_events = 4, .y_down = true});
  CHECK(count_events(trace, "expanding") == 4);
  CHECK(count_events(trace, "cut") == 1);
  CHECK(trace["events"].back()["left_out"] == 6);
  CHECK(trace["events"].front()["y"] == 2);
  CHECK(count_events(trace, "curve") == 0);
}

}  // namespace
