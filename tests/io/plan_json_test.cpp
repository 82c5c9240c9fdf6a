// SPDX-License-Identifier: MIT
#include "tutavia/io/plan_json.hpp"

#include <cstdint>
#include <limits>
#include <string>

#include "support/catch.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "tutavia/space/lattice_space.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace tutavia;
using Json = nlohmann::json;

ResultHeader header_of(const Scene& scene, const Point& goal) {
  return {"astar", "delta", scene.start, goal, scene.workspace.safety_radius};
}

TEST_CASE("a plan's numbers read back to the same doubles") {
  const Scene scene = maps::complex();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.2}).value();
  Planner planner{AStar{}, DeltaSmoother{}};
  const Plan plan = planner.plan(space, {.start = scene.start, .goal = scene.goals[1]}).value();
  const auto file =
      result_file(Json::array({result_to_json(header_of(scene, scene.goals[1]), plan)}));
  const Json json = Json::parse(file.dump());
  CHECK(json["tutavia"] == 1);
  const Json& result = json["results"][0];
  CHECK(result["status"] == "success");
  CHECK(result["fell_back"] == false);
  CHECK(result["start"] == Json{scene.start.x(), scene.start.y()});
  CHECK(result["metrics"]["length"].get<double>() == plan.metrics.length);
  CHECK(result["metrics"]["max_joint_deflection"].get<double>() ==
        plan.metrics.max_joint_deflection);
  CHECK(result["certificate"]["status"] == "proved");
  CHECK(result["certificate"]["lower"].get<double>() == plan.certificate.lower);
  REQUIRE(result["curve"].size() == plan.curve.pieces().size());
  std::size_t beziers = 0;
  for (std::size_t i = 0; i < result["curve"].size(); ++i) {
    const Json& piece = result["curve"][i];
    const Point start = start_of(plan.curve.pieces()[i]);
    CHECK(piece["points"][0][0].get<double>() == start.x());
    CHECK(piece["points"][0][1].get<double>() == start.y());
    if (piece["type"] == "bezier") {
      ++beziers;
      CHECK(piece["points"].size() == 3);
    } else {
      CHECK(piece["type"] == "line");
      CHECK(piece["points"].size() == 2);
    }
  }
  CHECK(beziers > 0);
  CHECK(result["route"].size() == plan.route.curve.pieces().size());
  for (const char* key :
       {"turning_points", "turning_angle", "interior_angle_sum", "max_joint_deflection",
        "max_curvature", "max_curvature_jump", "min_clearance"}) {
    CHECK(result["metrics"].contains(key));
  }
  for (const char* key :
       {"expanded", "generated", "search_us", "smooth_us", "certify_us", "seed"}) {
    CHECK(result["stats"].contains(key));
  }
  CHECK_FALSE(result["stats"].contains("distinct"));
  Plan counted = plan;
  counted.stats.distinct = 7;
  CHECK(Json::parse(result_to_json({}, counted).dump())["stats"]["distinct"] == 7);
}

TEST_CASE("arcs and clothoids are written with all their numbers") {
  Plan plan;
  const Arc arc = Arc::around({1, 2}, 3, 0.5, -1);
  const Clothoid clothoid = Clothoid::from({1, 2}, 0.3, 0.4, -0.5, 0.6);
  plan.curve.push_back(arc);
  Plan other;
  other.curve.push_back(clothoid);
  const Json a = Json::parse(result_to_json({}, plan).dump())["curve"][0];
  CHECK(a["type"] == "arc");
  CHECK(a["center"] == Json{1.0, 2.0});
  CHECK(a["radius"] == 3);
  CHECK(a["start_angle"] == 0.5);
  CHECK(a["sweep"] == -1);
  const Json c = Json::parse(result_to_json({}, other).dump())["curve"][0];
  CHECK(c["type"] == "clothoid");
  CHECK(c["points"][1] == Json{clothoid.b.x(), clothoid.b.y()});
  CHECK(c["start"] == Json{1.0, 2.0});
  CHECK(c["heading"] == 0.3);
  CHECK(c["curvature"] == 0.4);
  CHECK(c["sharpness"] == -0.5);
  CHECK(c["length"] == 0.6);
}

TEST_CASE("the path of a vehicle has the vehicle, its gears, its headings and its cusps") {
  Plan plan;
  plan.curve.push_back(Segment{{1, 2}, {4, 2}});
  plan.curve.push_back(Segment{{4, 2}, {3, 2}});
  CHECK_FALSE(Json::parse(result_to_json({}, plan).dump()).contains("vehicle"));
  CHECK_FALSE(Json::parse(result_to_json({}, plan).dump()).contains("gears"));
  plan.gears = {Gear::forward, Gear::reverse};
  plan.route.vehicle = Vehicle{1.0 / 3, true, {{{0.1, -0.2}, 0.7}, {{1, 0}, 0.5}}};
  const Json json = Json::parse(result_to_json({}, plan).dump());
  CHECK(json["gears"] == Json{"forward", "reverse"});
  CHECK(json["start_heading"] == 0.0);
  CHECK(json["goal_heading"] == 0.0);
  CHECK(json["cusps"] == Json::array({3.0}));
  const Json& vehicle = json["vehicle"];
  CHECK(vehicle["min_turning_radius"].get<double>() == 1.0 / 3);
  CHECK(vehicle["reverse"] == true);
  CHECK(vehicle["footprint"] == Json::array({Json{{"offset", {0.1, -0.2}}, {"radius", 0.7}},
                                             Json{{"offset", {1.0, 0.0}}, {"radius", 0.5}}}));
}

TEST_CASE("the optimum and the mean clearance are written where they are known") {
  Plan plan;
  plan.metrics.length = 15;
  const auto written = [&](std::optional<double> optimum) {
    return Json::parse(result_to_json({}, plan, optimum).dump());
  };
  CHECK_FALSE(written({}).contains("optimum"));
  CHECK_FALSE(written({})["metrics"].contains("mean_clearance"));
  plan.metrics.mean_clearance = 1.25;
  CHECK(written({})["metrics"]["mean_clearance"] == 1.25);
  CHECK(written(12)["optimum"] == Json{{"length", 12.0}, {"ratio", 1.25}});
  plan.metrics.length = 0;
  CHECK(written(0)["optimum"] == Json{{"length", 0.0}, {"ratio", 1.0}});
}

TEST_CASE("a failure is written with its code, its detail and the clearance") {
  const Scene scene = maps::maze();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.2}).value();
  Planner planner{AStar{}, DeltaSmoother{}};
  const auto plan = planner.plan(space, {.start = scene.start, .goal = {9, 3}});
  REQUIRE_FALSE(plan);
  const Json json = Json::parse(result_to_json(header_of(scene, {9, 3}), plan.error()).dump());
  CHECK(json["status"] == "goal_blocked");
  CHECK(json["clearance"].get<double>() == Approx(-0.2));
  CHECK_FALSE(json.contains("curve"));
  CHECK_FALSE(json["detail"].get<std::string>().empty());
}

TEST_CASE("where there are no obstacles the clearance is null") {
  const auto space =
      LatticeSpace::build({.bounds = {{0, 0}, {4, 4}}, .safety_radius = 0.1}, {.resolution = 0.5})
          .value();
  Planner planner{AStar{}};
  const Plan plan = planner.plan(space, {.start = {1, 1}, .goal = {3, 3}}).value();
  const Json json = Json::parse(result_to_json(ResultHeader{}, plan).dump());
  CHECK(json["certificate"]["lower"].is_null());
  CHECK(json["certificate"]["status"] == "proved");
}

TEST_CASE("options are written as what they are") {
  ResultHeader header;
  header.search_options = {{"none", {}},
                           {"on", true},
                           {"least", std::int64_t{-3}},
                           {"most", std::numeric_limits<std::uint64_t>::max()},
                           {"third", 1.0 / 3},
                           {"bound", std::numeric_limits<double>::infinity()},
                           {"kind", std::string("octile")}};
  header.smoother_options = {{{"trim", 1.5}}};
  const Json one = Json::parse(result_to_json(header, Failure{}).dump())["options"];
  CHECK(one["search"]["none"].is_null());
  CHECK(one["search"]["on"] == true);
  CHECK(one["search"]["least"].get<int>() == -3);
  CHECK(one["search"]["most"].get<std::uint64_t>() == std::numeric_limits<std::uint64_t>::max());
  CHECK(one["search"]["third"].get<double>() == 1.0 / 3);
  CHECK(one["search"]["bound"].is_null());
  CHECK(one["search"]["kind"] == "octile");
  CHECK(one["smoother"] == Json{{"trim", 1.5}});
  header.smoother_options.push_back({});
  const Json two = Json::parse(result_to_json(header, Plan{}).dump())["options"];
  CHECK(two["smoother"] == Json::array({Json{{"trim", 1.5}}, Json::object()}));
  const Json without = Json::parse(result_to_json(ResultHeader{}, Plan{}).dump())["options"];
  CHECK(without == Json{{"search", Json::object()}, {"smoother", Json::object()}});
}

}  // namespace
