// SPDX-License-Identifier: MIT
#include "../../examples/drive/simulator.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "../../examples/drive/simulate.hpp"
#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/motion/path_follower.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/world/maps.hpp"

namespace {

using namespace drive_program;

/// Says the same twist at every step after some steps, whatever is in front of the robot.
struct BlindController {
  Twist twist{0.4, 0};
  int waits = 0;
  double step_limit = 0.05;
  Twist said{};
  std::vector<Pose> seen{};

  Expected<void, Failure> follow(const Curve&) { return {}; }
  DriveCommand step(const Pose& odometry, std::span<const MovingObstacle>) {
    seen.push_back(odometry);
    if (waits-- > 0) return {said, DriveStatus::blocked};
    said.v += std::clamp(twist.v - said.v, -step_limit, step_limit);
    said.omega += std::clamp(twist.omega - said.omega, -step_limit, step_limit);
    return {said, DriveStatus::driving};
  }
};

InflatedSpace simulated_room(std::vector<Obstacle> obstacles = {}) {
  return InflatedSpace::build({.bounds = {{0, 0}, {10, 10}},
                               .safety_radius = 0.3,
                               .obstacles = std::move(obstacles)})
      .value();
}

Curve simulated_path() {
  const Point points[] = {{1, 5}, {9, 5}};
  return Curve::polyline(points);
}

DriveResult blind_drive(BlindController controller, const std::vector<Encounter>& met,
                        const InflatedSpace& space = simulated_room(),
                        SimulationOptions options = {.time_limit = 12}) {
  Encounters encounters({});
  for (const Encounter& encounter : met) encounters.add(encounter);
  Simulator simulator(space, controller, encounters, options);
  return simulator.run({{1, 5}, 0}, simulated_path());
}

TEST_CASE("a robot that drives into what stands has a contact of its own, once") {
  const DriveResult result = blind_drive({}, {{.obstacle = {Disc{{3, 5.2}, 0.2}}}});
  CHECK(result.own_contacts == 1);
  CHECK(result.driven_into == 0);
  CHECK(result.min_clearance < -0.2);
  CHECK(result.limit_violations == 0);
  CHECK(blind_drive({}, {{.obstacle = {Disc{{3, 5.6}, 0.2}}}}).own_contacts == 0);
  // It is not there yet, or no longer.
  CHECK(blind_drive({}, {{.obstacle = {Disc{{3, 5}, 0.2}}, .appears = 9}}).own_contacts == 0);
  CHECK(blind_drive({}, {{.obstacle = {Disc{{3, 5}, 0.2}}, .vanishes = 3}}).own_contacts == 0);
}

TEST_CASE("a robot that drives into a wall or out of the map has a contact of its own") {
  const auto room = simulated_room({Polygon{{{4, 0}, {4.1, 0}, {4.1, 9}, {4, 9}}}});
  CHECK(blind_drive({}, {}, room).own_contacts == 1);
  CHECK(blind_drive({}, {}, simulated_room(), {.time_limit = 19}).own_contacts == 0);
  CHECK(blind_drive({}, {}, simulated_room(), {.time_limit = 24}).own_contacts == 1);
}

TEST_CASE("an obstacle drives into a robot that stands; once that moves, it is its own contact") {
  const Encounter arrives{.obstacle = {Disc{{3, 5}, 0.2}, {-0.5, 0}}};
  BlindController stands{.twist = {}};
  const DriveResult driven = blind_drive(stands, {arrives});
  CHECK(driven.own_contacts == 0);
  CHECK(driven.driven_into == 1);
  CHECK(driven.min_clearance == 1);  // of what counts
  BlindController starts{.waits = 40};
  CHECK(blind_drive(starts, {arrives}).own_contacts == 1);
  BlindController turns{.twist = {0, 0.3}};
  CHECK(blind_drive(turns, {arrives}).own_contacts == 0);
  // A robot that moves away too slowly is moving.
  BlindController away{.twist = {-0.05, 0}};
  CHECK(blind_drive(away, {arrives}).own_contacts == 1);
}

TEST_CASE("commands outside the limits are counted, those on them are not") {
  CHECK(blind_drive({.twist = {0.4, 0.3}}, {}).limit_violations == 0);
  CHECK(blind_drive({.twist = {0.41, 0}}, {}).limit_violations > 50);
  CHECK(blind_drive({.twist = {0, 0.31}}, {}).limit_violations > 50);
  CHECK(blind_drive({.twist = {-0.01, 0}}, {}).limit_violations > 50);
  CHECK(blind_drive({.twist = {0.4, 0}, .step_limit = 0.06}, {}).limit_violations == 6);
  const double nan = std::nan("");
  CHECK(blind_drive({.twist = {0.1, 0}, .said = {nan, 0}}, {}).limit_violations > 50);
}

TEST_CASE("a command takes effect after the latency, which need not be whole periods") {
  for (const double latency : {0.0, 0.04, 0.1, 0.25}) {
    CAPTURE(latency);
    const DriveResult result = blind_drive({.twist = {0.05, 0}}, {}, simulated_room(),
                                           {.control = {.latency = latency}, .time_limit = 2});
    CHECK(result.length == Approx(0.05 * (2 - latency)));
    CHECK(result.end.position.x() == Approx(1 + result.length));
  }
}

TEST_CASE("the odometry's error stays within its bounds, and uses them") {
  OdometryNoise noise(0.05, 0.02, 7);
  double farthest = 0, most_turn = 0;
  for (std::size_t i = 0; i < test::scaled(20000); ++i) {
    const Pose pose{{3, -4}, 1};
    const Pose seen = noise.disturbed(pose);
    farthest = std::max(farthest, distance(seen.position, pose.position));
    most_turn = std::max(most_turn, std::abs(seen.heading - pose.heading));
  }
  CHECK(farthest <= 0.05);
  CHECK(farthest > 0.04);
  CHECK(most_turn <= 0.02);
  CHECK(most_turn > 0.017);
  const Pose exact = OdometryNoise(0, 0, 7).disturbed({{3, -4}, 1});
  CHECK((exact.position == Point(3, -4) && exact.heading == 1));
}

/// A drive on a built-in map, with all that may go wrong.
DriveResult simulated_drive(const LatticeSpace& space, const Scene& scene, std::uint64_t seed) {
  const Point goal = scene.goals[seed % scene.goals.size()];
  const double noise = seed % 3 == 0 ? 0.0 : 0.01 * static_cast<double>(seed % 3);
  const double latency = seed % 2 == 0 ? 0.0 : 0.15;
  GlobalPlanner<LatticeSpace> planner(space, 0.1 + 3 * noise);
  const Curve path = planner.plan(scene.start, goal).value().curve;
  const ControlOptions control{.latency = latency, .position_error = noise, .heading_error = noise};
  auto follower = PathFollower<LatticeSpace>::build(space, {.control = control}).value();
  Encounters encounters({.count = 8, .seed = seed});
  return simulate(space, follower, planner, encounters, {scene.start, path.heading(0)}, path,
                  {.control = control, .seed = seed, .keeps_trace = true});
}

TEST_CASE("a path follower has no contact of its own, whatever appears", "[soak]") {
  const Scene scene = maps::maze();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = scene.resolution}).value();
  std::size_t reached = 0, driven_into = 0, closed = 0;
  const std::size_t drives = test::scaled(24);
  for (std::uint64_t seed = 0; seed < drives; ++seed) {
    CAPTURE(seed);
    const DriveResult result = simulated_drive(space, scene, seed);
    CHECK(result.own_contacts == 0);
    CHECK(result.limit_violations == 0);
    if (result.ending == Ending::reached) ++reached;
    if (result.is_connected == false) ++closed;
    driven_into += result.driven_into;
  }
  CHECK(10 * (reached + closed) >= 9 * drives);
  CHECK(driven_into > 0);  // they met obstacles
}

TEST_CASE("a drive with the same seed is the same to the last bit") {
  const Scene scene = maps::complex();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = scene.resolution}).value();
  const DriveResult first = simulated_drive(space, scene, 5);
  const DriveResult second = simulated_drive(space, scene, 5);
  REQUIRE(first.trace.size() == second.trace.size());
  for (std::size_t i = 0; i < first.trace.size(); ++i) {
    REQUIRE(first.trace[i].pose.position == second.trace[i].pose.position);
    REQUIRE(first.trace[i].clearance == second.trace[i].clearance);
  }
  CHECK(first.trace.back().pose.position !=
        simulated_drive(space, scene, 9).trace.back().pose.position);
}

TEST_CASE("a goal is cut off by what stays, and by nothing else") {
  const auto lattice =
      LatticeSpace::build(simulated_room().workspace(), {.resolution = 0.5}).value();
  const MovingObstacle wall{Polygon{{{5, -1}, {5.1, -1}, {5.1, 11}, {5, 11}}}};
  const MovingObstacle gap{Polygon{{{5, -1}, {5.1, -1}, {5.1, 9.5}, {5, 9.5}}}};
  CHECK(is_connected(lattice, {1, 5}, {9, 5}, {}) == true);
  CHECK(is_connected(lattice, {1, 5}, {9, 5}, std::vector{wall}) == false);
  CHECK(is_connected(lattice, {1, 5}, {9, 5}, std::vector{gap}) == true);
  OccupancyGrid grid = OccupancyGrid::blocked(20, 20).value();
  for (int y = 0; y < 20; ++y) grid.set_run(y, 0, 19, true);
  const auto cells =
      CellSpace::build(std::move(grid), {.resolution = 0.5, .safety_radius = 0.3}).value();
  CHECK(is_connected(cells, {1, 5}, {9, 5}, std::vector{wall}) == false);
  CHECK(is_connected(cells, {1, 5}, {9, 5}, std::vector{gap}) == true);
  GlobalPlanner<CellSpace> planner(cells);
  CHECK(planner.plan({1, 5}, {9, 5}).value().margin == 0.1);
  CHECK_FALSE(planner.plan({1, 5}, {9, 5}, std::vector{wall}));
}

TEST_CASE("obstacles appear in front of the robot, with a gap, and off the goal") {
  const InflatedSpace space = simulated_room();
  const Pose robot{{2, 5}, 0};
  std::size_t moving = 0, staying = 0;
  for (std::uint64_t seed = 0; seed < test::scaled(100); ++seed) {
    CAPTURE(seed);
    Encounters encounters(
        {.count = 3, .first_interval = 0, .least_interval = 1, .most_interval = 1, .seed = seed});
    for (double time = 0; time < 5; time += 0.5) {
      encounters.advance(time, space, robot, simulated_path());
    }
    REQUIRE(encounters.all().size() <= 3);
    for (const Encounter& e : encounters.all()) {
      const double gap = approach({.from = robot}, e.obstacle).distance - 0.3;
      CHECK((0.5 <= gap && gap <= 3));
      if (!e.obstacle.stands()) ++moving;
      CHECK(e.obstacle.velocity.norm() <= 0.2 + 1e-12);
      CHECK((e.obstacle.stands() || std::isfinite(e.vanishes)));
      if (!e.stays()) continue;
      ++staying;
      CHECK(approach({.from = {{9, 5}, 0}}, e.obstacle).distance >= 0.6);
    }
  }
  CHECK(10 * moving > 3 * test::scaled(100));
  CHECK(10 * staying > 3 * test::scaled(100));
}

}  // namespace
