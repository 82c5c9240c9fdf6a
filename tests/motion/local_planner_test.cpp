// SPDX-License-Identifier: MIT
#include "tutavia/motion/local_planner.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "../../examples/drive/simulator.hpp"
#include "support/catch.hpp"
#include "support/reference_distance.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/tangent_graph.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/world/maps.hpp"

/// \file
/// What users of teb_local_planner reported, each as a test that says which status answers it; and
/// drives before a judge that knows nothing of the planner.

namespace {

using namespace tutavia;

constexpr double local_radius = 0.3;

Polygon local_box(double x0, double y0, double x1, double y1) {
  return Polygon{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

InflatedSpace local_room(std::vector<Obstacle> obstacles = {}, Box bounds = {{0, 0}, {10, 10}}) {
  return InflatedSpace::build(
             {.bounds = bounds, .safety_radius = local_radius, .obstacles = std::move(obstacles)})
      .value();
}

Curve local_path(const std::vector<Point>& points) { return Curve::polyline(points); }

/// A planner on a path. The space must outlive it.
LocalPlanner<InflatedSpace> planner_on(const InflatedSpace& space, const std::vector<Point>& path) {
  auto planner = LocalPlanner<InflatedSpace>::build(space).value();
  REQUIRE(planner.follow(local_path(path)));
  return planner;
}

/// A robot that follows its commands exactly and at once, and checks that it touches nothing.
struct LocalDrive {
  const InflatedSpace& space;
  Pose pose{};
  std::vector<MovingObstacle> observed{};
  std::vector<Pose> poses{};
  std::vector<DriveCommand> commands{};

  const DriveCommand& last() const { return commands.back(); }
  double time() const { return 0.1 * static_cast<double>(commands.size()); }

  void step(LocalPlanner<InflatedSpace>& planner) {
    poses.push_back(pose);
    commands.push_back(planner.step(pose, observed));
    if (last().twist.v != 0) check_clearance();
    pose = moved(pose, last().twist, 0.1);
    for (MovingObstacle& o : observed) o.shape = at_time(o, 0.1);
  }
  /// Steps until the robot stands with this status, or for `most` seconds.
  bool comes_to(LocalPlanner<InflatedSpace>& planner, DriveStatus status, double most) {
    for (const double end = time() + most; time() < end;) {
      step(planner);
      if (last().status == status && last().twist.is_zero()) return true;
    }
    return false;
  }
  bool arrives(LocalPlanner<InflatedSpace>& planner, double most) {
    return comes_to(planner, DriveStatus::arrived, most);
  }

 private:
  /// Of the motion of this period, by brute force.
  void check_clearance() const {
    for (const double time : {0.05, 0.1}) {
      Workspace world = space.workspace();
      for (const MovingObstacle& o : observed) world.obstacles.push_back(at_time(o, time));
      const Point p = moved(pose, last().twist, time).position;
      REQUIRE(static_cast<double>(test::reference_clearance(world, p)) >= local_radius - 1e-9);
    }
  }
};

// teb_local_planner 7, 58 and 314: bands through obstacles.

TEST_CASE("a local planner stops before an obstacle across the way, and names it") {
  const InflatedSpace space = local_room({}, {{0, 0}, {10, 4}});
  auto planner = planner_on(space, {{1, 2}, {9, 2}});
  LocalDrive drive{space, {{1, 2}, 0}};
  drive.observed = {{Disc{{1, 0.5}, 0.1}}, {local_box(6, -1, 6.2, 5)}};
  REQUIRE(drive.comes_to(planner, DriveStatus::blocked, 60));
  CHECK(drive.last().blocker.kind == Blocker::Kind::observed);
  CHECK(drive.last().blocker.obstacle == 1);
  CHECK(drive.last().blocker.time > 0);
  CHECK(drive.last().blocker.point.x() > 5.5);
  CHECK(drive.last().blocker.point.x() < 6);
  REQUIRE(planner.report().failure);
  CHECK(planner.report().failure->code == PlanError::unreachable);
  // It stays there.
  const Point stop = drive.pose.position;
  CHECK_FALSE(drive.arrives(planner, 20));
  CHECK(distance(drive.pose.position, stop) < 0.2);
}

TEST_CASE("a local planner brakes for an obstacle that appears just ahead, and says so") {
  const InflatedSpace space = local_room({}, {{0, 0}, {10, 4}});
  auto planner = planner_on(space, {{1, 2}, {9, 2}});
  LocalDrive drive{space, {{1, 2}, 0}};
  for (int i = 0; i < 40; ++i) drive.step(planner);
  REQUIRE(drive.last().twist.v > 0.35);
  // Beyond the stopping distance of 0.18 m, and across the whole corridor.
  const double x = drive.pose.position.x() + local_radius + 0.25;
  drive.observed = {{local_box(x, -1, x + 0.2, 5)}};
  drive.step(planner);
  CHECK(drive.last().status == DriveStatus::stopping);
  CHECK(drive.last().blocker.kind == Blocker::Kind::observed);
  CHECK(drive.last().blocker.obstacle == 0);
  REQUIRE(drive.comes_to(planner, DriveStatus::blocked, 2));
  CHECK(drive.last().blocker.kind == Blocker::Kind::observed);
}

TEST_CASE("a local planner drives around an obstacle on its path") {
  const InflatedSpace space = local_room();
  auto planner = planner_on(space, {{1, 5}, {9, 5}});
  LocalDrive drive{space, {{1, 5}, 0}};
  drive.observed = {{Disc{{5, 5.1}, 0.4}}};
  REQUIRE(drive.arrives(planner, 60));
  CHECK(distance(drive.pose.position, Point(9, 5)) <= planner.options().goal_tolerance + 0.05);
  // The shorter way passes below.
  const auto lowest = std::min_element(
      drive.poses.begin(), drive.poses.end(),
      [](const Pose& a, const Pose& b) { return a.position.y() < b.position.y(); });
  CHECK(lowest->position.y() < 4.5);
}

// Issue 6: the robot oscillates where the start lies inside the penalty zone.

TEST_CASE("a local planner that starts close to a wall drives off without oscillating") {
  const InflatedSpace space = local_room({local_box(0, 0, 10, 0.5)});
  for (const double gap : {0.001, 0.01, 0.05, 0.1}) {
    CAPTURE(gap);
    const double y = 0.5 + local_radius + gap;
    auto planner = planner_on(space, {{1, y}, {2, y}, {4, 1.5}, {8, 1.5}});
    REQUIRE(gap < planner.options().band.clearance - local_radius);
    LocalDrive drive{space, {{1, y}, 0}};
    REQUIRE(drive.arrives(planner, 60));
    std::size_t changes = 0;
    double before = 0;
    for (const DriveCommand& command : drive.commands) {
      const double omega = std::abs(command.twist.omega) > 0.02 ? command.twist.omega : 0;
      if (omega == 0) continue;
      if (omega * before < 0) ++changes;
      before = omega;
    }
    CHECK(changes <= 4);
  }
}

// Issues 3, 12 and 22: "trajectory is not feasible", without a reason.

/// Obstacles of all sorts between a robot at (1, 5) and (9, 5).
std::vector<MovingObstacle> local_obstacles(std::uint64_t seed) {
  Random random(seed);
  std::vector<MovingObstacle> result;
  for (int i = 0; i < 7; ++i) {
    const Point center{random.uniform(2.5, 9.5), random.uniform(2, 8)};
    const double size = random.uniform(0.1, 0.5);
    const double speed = i % 2 == 0 ? 0 : 0.2;
    const Point velocity{random.uniform(-speed, speed), random.uniform(-speed, speed)};
    const Obstacle disc = Disc{center, size};
    const Obstacle box =
        local_box(center.x() - size, center.y() - 0.1, center.x() + 0.1, center.y() + size);
    result.push_back({i % 3 == 0 ? disc : box, velocity});
  }
  return result;
}

TEST_CASE("a local planner says of every command below its wish why", "[soak]") {
  const InflatedSpace space = local_room({}, {{0, 1}, {10, 9}});
  std::size_t braking = 0, blocked = 0, arrived = 0;
  const std::size_t drives = test::scaled(20);
  for (std::uint64_t seed = 0; seed < drives; ++seed) {
    CAPTURE(seed);
    auto planner = planner_on(space, {{1, 5}, {9, 5}});
    LocalDrive drive{space, {{1, 5}, 0}, local_obstacles(seed)};
    if (drive.arrives(planner, 60)) ++arrived;
    for (const DriveCommand& command : drive.commands) {
      const DriveStatus status = command.status;
      if (status == DriveStatus::driving || status == DriveStatus::arrived) continue;
      CAPTURE(to_string(status));
      CHECK(status != DriveStatus::invalid_input);
      CHECK(command.blocker.kind != Blocker::Kind::none);
      CHECK(command.blocker.time >= 0);
      CHECK(command.blocker.time < 60);
      if (command.blocker.kind == Blocker::Kind::observed) CHECK(command.blocker.obstacle < 7);
      ++(status == DriveStatus::blocked ? blocked : braking);
    }
  }
  CHECK((braking > 0 || drives < 20));  // few drives may meet neither
  CHECK((blocked > 0 || drives < 20));
  CHECK(10 * arrived >= 8 * drives);
}

// Issue 61: nothing says whether the optimiser converged.

TEST_CASE("a local planner reports how its band's optimisation ended") {
  const InflatedSpace space = local_room();
  auto planner = planner_on(space, {{1, 5}, {9, 5}});
  LocalDrive drive{space, {{1, 5}, 0}};
  std::size_t converged = 0;
  for (int i = 0; i < 50; ++i) {
    drive.step(planner);
    const BandReport& band = planner.report().band;
    CHECK(band.after.total() <= band.before.total());
    CHECK(band.converged() == (band.end == BandEnd::converged));
    if (band.converged()) ++converged;
  }
  CHECK(converged > 30);
  CHECK(planner.report().candidates == 1);
  CHECK(planner.report().band_us > 0);
  LocalPlannerOptions options;
  options.band.rounds = options.band.steps = 1;
  auto hasty = LocalPlanner<InflatedSpace>::build(space, options).value();
  REQUIRE(hasty.follow(local_path({{1, 5}, {9, 5}})));
  hasty.step({{1, 5.3}, 0.5}, {});
  CHECK_FALSE(hasty.report().band.converged());
}

// Issue 314: stuck in one homotopy class while another is open.

TEST_CASE("a local planner takes the other side when the way on one side closes") {
  // A pillar of the map between two gaps; the path leads through the upper one.
  const InflatedSpace space = local_room({local_box(4.5, 3, 5.5, 7)});
  auto planner = planner_on(space, {{1, 5}, {4, 7.6}, {6, 7.6}, {9, 5}});
  LocalDrive drive{space, {{1, 5}, 0.7}};
  for (int i = 0; i < 60; ++i) drive.step(planner);
  drive.observed = {{local_box(4.8, 7, 5, 10)}};
  for (int i = 0; i < 30; ++i) drive.step(planner);
  CHECK(planner.report().searched + planner.report().candidates > 0);
  CHECK(planner.path().nearest({5, 2.5}).distance < 0.5);
  REQUIRE(drive.arrives(planner, 90));
  CHECK(std::any_of(drive.poses.begin(), drive.poses.end(),
                    [](const Pose& p) { return p.position.y() < 2.8; }));
}

TEST_CASE("a local planner leaves a way that closes behind a bend, whichever side is open") {
  // Two doors in a wall: the path leads through one of them.
  const InflatedSpace space = local_room(
      {local_box(4.9, 0, 5.1, 2), local_box(4.9, 4, 5.1, 6), local_box(4.9, 8, 5.1, 10)});
  for (const double door : {3.0, 7.0}) {
    CAPTURE(door);
    auto planner = planner_on(space, {{1, 5}, {4, door}, {6, door}, {9, 5}});
    LocalDrive drive{space, {{1, 5}, door < 5 ? -0.6 : 0.6}};
    for (int i = 0; i < 50; ++i) drive.step(planner);
    drive.observed = {{local_box(4.8, door - 0.9, 5.2, door + 0.9)}};
    REQUIRE(drive.arrives(planner, 120));
    CHECK(std::any_of(drive.poses.begin(), drive.poses.end(), [&](const Pose& p) {
      return distance(p.position, Point(5, 10 - door)) < 0.8;
    }));
  }
}

TEST_CASE("a local planner turns around to a goal behind the robot") {
  const InflatedSpace space = local_room();
  auto planner = planner_on(space, {{5, 5}, {2, 5}});
  LocalDrive drive{space, {{5, 5}, 0.1}};
  REQUIRE(drive.arrives(planner, 60));
  CHECK(drive.commands.front().twist.v == 0);
  CHECK(drive.commands.front().twist.omega > 0);
  CHECK(drive.commands.front().status == DriveStatus::driving);
  for (const Pose& pose : drive.poses) CHECK(pose.position.x() < 5.2);
}

TEST_CASE("a local planner on a path of no length has arrived") {
  const InflatedSpace space = local_room();
  for (const auto& path : {std::vector<Point>{{5, 5}}, std::vector<Point>{{5, 5}, {5, 5}}}) {
    auto planner = LocalPlanner<InflatedSpace>::build(space).value();
    const Curve curve = local_path(path);
    if (!planner.follow(curve)) {
      CHECK(curve.empty());
      continue;
    }
    LocalDrive drive{space, {{5, 5.05}, 0}};
    drive.step(planner);
    CHECK(drive.last().status == DriveStatus::arrived);
    LocalDrive off{space, {{5, 6}, 0}};
    REQUIRE(planner.follow(curve));
    CHECK(off.arrives(planner, 60));
  }
}

TEST_CASE("a local planner in an obstacle that appears upon it waits, and drives on later") {
  const InflatedSpace space = local_room();
  auto planner = planner_on(space, {{1, 5}, {9, 5}});
  LocalDrive drive{space, {{1, 5}, 0}};
  drive.observed = {{Disc{{1.2, 5}, 0.4}}};
  for (int i = 0; i < 100; ++i) {
    drive.step(planner);
    REQUIRE(drive.last().twist.v == 0);
    CHECK((drive.last().status == DriveStatus::blocked ||
           drive.last().status == DriveStatus::driving));  // turns
  }
  CHECK(drive.last().status == DriveStatus::blocked);
  CHECK(drive.last().blocker.kind == Blocker::Kind::observed);
  CHECK(drive.last().blocker.obstacle == 0);
  REQUIRE(planner.report().failure);
  CHECK(planner.report().failure->code == PlanError::start_blocked);
  drive.observed.clear();
  REQUIRE(drive.arrives(planner, 60));
  CHECK_FALSE(planner.report().failure);
}

TEST_CASE("a local planner brakes within its limits while the odometry is not a number") {
  const InflatedSpace space = local_room();
  auto planner = planner_on(space, {{1, 5}, {9, 5}});
  LocalDrive drive{space, {{1, 5}, 0}};
  for (int i = 0; i < 40; ++i) drive.step(planner);
  double speed = drive.last().twist.v;
  REQUIRE(speed > 0.35);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 15; ++i) {
    const Pose broken{{i % 2 == 0 ? nan : 5, 5}, i % 2 == 0 ? 0 : nan};
    const DriveCommand command = planner.step(broken, {});
    CHECK(command.status == DriveStatus::invalid_input);
    CHECK(command.twist.v <= speed);
    CHECK(command.twist.v >= speed - 0.05 - 1e-9);
    speed = command.twist.v;
    drive.pose = moved(drive.pose, command.twist, 0.1);
  }
  CHECK(speed == 0);
  CHECK(drive.arrives(planner, 60));
}

TEST_CASE("a local planner drives on when an obstacle vanishes") {
  const InflatedSpace space = local_room({}, {{0, 0}, {10, 4}});
  auto planner = planner_on(space, {{1, 2}, {9, 2}});
  LocalDrive drive{space, {{1, 2}, 0}};
  drive.observed = {{local_box(4, -1, 4.2, 5)}};
  REQUIRE(drive.comes_to(planner, DriveStatus::blocked, 60));
  for (int i = 0; i < 400; ++i) drive.step(planner);  // longer than its patience
  REQUIRE(drive.last().twist.is_zero());
  drive.observed.clear();
  const double time = drive.time();
  REQUIRE(drive.arrives(planner, 60));
  CHECK(drive.time() - time < 30);
}

TEST_CASE("a local planner keeps its old path where a new one is refused, and takes a new one") {
  const InflatedSpace space = local_room();
  auto planner = LocalPlanner<InflatedSpace>::build(space).value();
  CHECK(planner.step({{1, 5}, 0}, {}).status == DriveStatus::blocked);
  CHECK(planner.follow({}).error().code == PlanError::invalid_input);
  REQUIRE(planner.follow(local_path({{1, 5}, {9, 5}})));
  LocalDrive drive{space, {{1, 5}, 0}};
  for (int i = 0; i < 60; ++i) drive.step(planner);
  CHECK(planner.follow({}).error().code == PlanError::invalid_input);
  for (int i = 0; i < 10; ++i) drive.step(planner);
  REQUIRE(drive.last().twist.v > 0.35);
  REQUIRE(planner.follow(local_path({drive.pose.position, {5, 7}, {2, 9}})));
  REQUIRE(drive.arrives(planner, 60));
  CHECK(distance(drive.pose.position, Point(2, 9)) < 0.15);
}

TEST_CASE("a local planner names an option that is out of range") {
  const InflatedSpace space = local_room();
  const auto names = [&](const LocalPlannerOptions& options, const std::string& name) {
    const auto planner = LocalPlanner<InflatedSpace>::build(space, options);
    return !planner && planner.error().code == PlanError::invalid_option &&
           planner.error().detail.find(name) != std::string::npos;
  };
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(names({.control = {.period = 0}}, "period"));
  CHECK(names({.control = {.limits = {.max_speed = -1}}}, "max_speed"));
  CHECK(names({.band = {.rounds = 0}}, "rounds"));
  CHECK(names({.band = {.clearance = std::nan("")}}, "clearance"));
  CHECK(names({.horizon = 0}, "horizon"));
  CHECK(names({.horizon = infinity}, "horizon"));
  CHECK(names({.margin = -1}, "margin"));
  CHECK(names({.window = 0}, "window"));
  CHECK(names({.window = infinity}, "window"));
  CHECK(names({.goal_tolerance = 0}, "goal_tolerance"));
  CHECK(names({.switch_gain = -1}, "switch_gain"));
  CHECK(names({.turn_first = 0}, "turn_first"));
  CHECK(names({.search_interval = 0}, "search_interval"));
  for (double LocalPlannerOptions::*const option :
       {&LocalPlannerOptions::horizon, &LocalPlannerOptions::margin, &LocalPlannerOptions::window,
        &LocalPlannerOptions::goal_tolerance, &LocalPlannerOptions::switch_gain,
        &LocalPlannerOptions::turn_first}) {
    LocalPlannerOptions options;
    options.*option = std::nan("");
    CHECK_FALSE(LocalPlanner<InflatedSpace>::build(space, options));
  }
}

// Drives before the judge of examples/drive, with latency and noise.

/// The room between the robot and obstacles that a path must leave.
double local_margin(std::uint64_t seed) { return 0.1 + 0.03 * static_cast<double>(seed % 3); }

template <class S>
drive_program::DriveResult judged_drive(const S& space, const Curve& path, std::uint64_t seed) {
  const double noise = 0.01 * static_cast<double>(seed % 3);
  const double latency = seed % 2 == 0 ? 0.0 : 0.15;
  const ControlOptions control{.latency = latency, .position_error = noise, .heading_error = noise};
  auto planner = LocalPlanner<S>::build(space, {.control = control}).value();
  drive_program::Encounters encounters({.count = 8, .seed = seed});
  drive_program::Simulator simulator(
      space, planner, encounters,
      {.control = control, .time_limit = 240, .seed = seed, .keeps_trace = true});
  drive_program::DriveResult result = simulator.run({path.start(), path.heading(0)}, path);
  if (planner.report().failure) result.reason = to_string(planner.report().failure->code);
  return result;
}

/// Whether the robot came to the end of its path. A robot that does not must have a reason.
bool reaches_without_fault(const drive_program::DriveResult& result) {
  CHECK(result.own_contacts == 0);
  CHECK(result.limit_violations == 0);
  if (result.ending == drive_program::Ending::reached) return true;
  CHECK(result.reason == "unreachable");  // what stays may close the path
  return false;
}

/// A path through the maze that leaves a margin.
Curve maze_path(std::uint64_t seed) {
  Scene scene = maps::maze();
  scene.workspace.safety_radius += local_margin(seed);
  const auto space = InflatedSpace::build(scene.workspace).value();
  Planner planner{TangentGraph{}};
  return planner.plan(space, {.start = scene.start, .goal = scene.goals[seed % scene.goals.size()]})
      .value()
      .curve;
}

TEST_CASE("a local planner in the maze has no contact of its own, whatever appears", "[soak]") {
  const auto space = InflatedSpace::build(maps::maze().workspace).value();
  std::size_t reached = 0;
  double driven = 0;
  const std::size_t drives = test::scaled(5);
  for (std::uint64_t seed = 0; seed < drives; ++seed) {
    CAPTURE(seed);
    const auto result = judged_drive(space, maze_path(seed), seed);
    if (reaches_without_fault(result)) ++reached;
    driven += result.length;
    for (const drive_program::TraceRow& row : result.trace) {
      if (row.status == DriveStatus::arrived) CHECK(row.twist.is_zero());
    }
  }
  CHECK(10 * reached >= 6 * drives);
  CHECK(driven > 10 * static_cast<double>(drives));
}

CellSpace local_cells() {
  OccupancyGrid grid = OccupancyGrid::blocked(40, 30).value();
  for (int y = 1; y < 29; ++y) {
    for (int x = 1; x < 39; ++x) {
      const bool in_wall = (x == 13 && y < 20) || (x == 26 && y > 9);
      grid.set({x, y}, !in_wall);
    }
  }
  return CellSpace::build(std::move(grid), {.resolution = 0.25, .safety_radius = local_radius})
      .value();
}

TEST_CASE("a local planner among cells has no contact of its own, whatever appears", "[soak]") {
  const CellSpace space = local_cells();
  std::size_t reached = 0;
  const std::size_t drives = test::scaled(5);
  for (std::uint64_t seed = 0; seed < drives; ++seed) {
    CAPTURE(seed);
    const auto wide = space.with_safety_radius(local_radius + local_margin(seed)).value();
    Planner planner{TangentGraph{}};
    const auto plan = planner.plan(wide, {.start = {1.5, 1.5}, .goal = {8.5, 6}}).value();
    const auto result = judged_drive(space, plan.curve, seed);
    if (reaches_without_fault(result)) ++reached;
  }
  CHECK(10 * reached >= 6 * drives);
}

TEST_CASE("a local planner's drive is the same to the last bit when it is repeated") {
  const auto space = InflatedSpace::build(maps::maze().workspace).value();
  const Curve path = maze_path(5);
  const auto first = judged_drive(space, path, 5), second = judged_drive(space, path, 5);
  CHECK(first.trace.size() > 300);
  REQUIRE(first.trace.size() == second.trace.size());
  for (std::size_t i = 0; i < first.trace.size(); ++i) {
    const drive_program::TraceRow &a = first.trace[i], &b = second.trace[i];
    REQUIRE(a.status == b.status);
    REQUIRE((a.twist.v == b.twist.v && a.twist.omega == b.twist.omega));
    REQUIRE((a.pose.position == b.pose.position && a.pose.heading == b.pose.heading));
  }
}

TEST_CASE("a local planner refuses paths that nothing can follow") {
  const auto space =
      InflatedSpace::build({.bounds = {{0, 0}, {9, 9}}, .safety_radius = 0.3}).value();
  auto planner = LocalPlanner<InflatedSpace>::build(space).value();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](const Point& end) {
    const Point points[] = {{1, 1}, end};
    const auto followed = planner.follow(Curve::polyline(points));
    return !followed && followed.error().code == PlanError::invalid_input;
  };
  CHECK(refused({nan, 1}));
  CHECK(refused({1e15, 1}));
  CHECK_FALSE(refused({5, 1}));
}

TEST_CASE("a robot before a slot that is too narrow says so, and searches on") {
  Workspace workspace{.bounds = {{0, 0}, {12, 4}}, .safety_radius = 0.3};
  workspace.obstacles.push_back(Polygon{{{6, 0}, {6.2, 0}, {6.2, 1.71}, {6, 1.71}}});
  workspace.obstacles.push_back(Polygon{{{6, 2.29}, {6.2, 2.29}, {6.2, 4}, {6, 4}}});
  const auto space = InflatedSpace::build(workspace).value();
  auto planner = LocalPlanner<InflatedSpace>::build(space).value();
  const Point points[] = {{1, 2}, {11, 2}};
  REQUIRE(planner.follow(Curve::polyline(points)));
  Pose pose{{1, 2}, 0};
  DriveCommand command;
  int late_searches = 0;
  for (int k = 0; k < 1200; ++k) {
    command = planner.step(pose, {});
    pose = moved(pose, command.twist, 0.1);
    if (k > 900 && planner.report().searched) ++late_searches;
  }
  CHECK(command.status == DriveStatus::blocked);
  CHECK(command.blocker.kind == Blocker::Kind::map);
  CHECK(planner.report().failure.has_value());
  CHECK(late_searches > 3);
  CHECK(space.clearance(pose.position) >= 0.3);
}

}  // namespace
