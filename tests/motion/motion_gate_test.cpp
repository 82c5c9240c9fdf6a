// SPDX-License-Identifier: MIT
#include "tutavia/motion/motion_gate.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;
using Gate = MotionGate<InflatedSpace>;

InflatedSpace empty_hall(double radius = 0.3) {
  return InflatedSpace::build({.bounds = {{-50, -50}, {50, 50}}, .safety_radius = radius}).value();
}

/// The robot's own motion under commands that arrive late, and what its odometry says.
struct GateRobot {
  Pose pose;
  std::deque<Twist> under_way;  // issued, not yet in effect
  Twist present{};

  /// One period; `visit(pose, time, twist)` sees the robot on the way.
  template <class Visit>
  void drive(const ControlOptions& options, const Twist& command, Visit visit) {
    under_way.push_back(command);
    const double late =
        options.latency - std::floor(options.latency / options.period) * options.period;
    const auto whole = static_cast<std::size_t>(std::floor(options.latency / options.period));
    part(0, late, visit);
    if (under_way.size() > whole) {
      present = under_way.front();
      under_way.pop_front();
    }
    part(late, options.period - late, visit);
  }

 private:
  template <class Visit>
  void part(double begin, double time, Visit& visit) {
    for (int i = 1; i <= 12; ++i) {
      visit(moved(pose, present, time * i / 12), begin + time * i / 12, present);
    }
    pose = moved(pose, present, time);
  }
};

double distance_from(const std::vector<MovingObstacle>& observed, const Point& p, double time) {
  Workspace workspace{.bounds = {p, p}};
  for (const MovingObstacle& o : observed) workspace.obstacles.push_back(at_time(o, time));
  return InflatedSpace::build(workspace).value().clearance(p);
}

/// Drives through a random world by whatever twists come to mind.
void drive_at_random(std::uint64_t seed, const ControlOptions& options, double& driven) {
  CAPTURE(seed, options.latency, options.position_error);
  test::WorldGenerator generator(seed);
  Random random(seed);
  Workspace workspace = generator.workspace();
  workspace.safety_radius = random.uniform(0.05, 0.4);
  const InflatedSpace space = InflatedSpace::build(workspace).value();
  GateRobot robot{{generator.point(workspace), random.uniform(-4, 4)}, {}, {}};
  const double error = options.position_error, turn = options.heading_error;
  std::vector<MovingObstacle> observed;
  for (int i = 0; i < 4; ++i) {
    const Obstacle shape = generator.obstacle(workspace.bounds);
    const double speed = i == 0 ? 0 : 0.3;
    observed.push_back({shape, {random.uniform(-speed, speed), random.uniform(-speed, speed)}});
  }
  const double radius = workspace.safety_radius;
  const double tiny = 1e-9 * (1 + space.largest_coordinate());
  if (space.clearance(robot.pose.position) < radius + 4 * error + 0.01) return;
  if (distance_from(observed, robot.pose.position, 0) < radius + 0.6) return;
  auto gate = Gate::build(space, options).value();
  Twist last;
  for (int k = 0; k < 100; ++k) {
    Pose odometry = robot.pose;
    const double angle = random.uniform(-4, 4);
    odometry.position += error * random.uniform() * Point(std::cos(angle), std::sin(angle));
    odometry.heading += turn * random.uniform(-1, 1);
    const Twist wanted{random.uniform(-0.1, 0.6), k % 20 < 10 ? random.uniform(-0.4, 0.4) : 0};
    const DriveCommand command = gate.command(odometry, wanted, observed);
    CHECK(command.status != DriveStatus::emergency);
    const DriveLimits& limits = options.limits;
    CHECK(command.twist.v <= limits.max_speed);
    CHECK(command.twist.v >= -limits.max_backward_speed);
    CHECK(std::abs(command.twist.omega) <= limits.max_angular_speed);
    CHECK(std::abs(command.twist.v - last.v) <=
          limits.max_acceleration * options.period * (1 + 1e-9));
    CHECK(std::abs(command.twist.omega - last.omega) <=
          limits.max_angular_acceleration * options.period * (1 + 1e-9));
    last = command.twist;
    robot.drive(options, command.twist, [&](const Pose& pose, double time, const Twist& twist) {
      if (twist.v == 0) return;
      CHECK(space.clearance(pose.position) >= radius - tiny);
      CHECK(distance_from(observed, pose.position, time) >= radius - tiny);
      driven += std::abs(twist.v) * options.period / 24;
    });
    for (MovingObstacle& o : observed) o.shape = at_time(o, options.period);
  }
}

TEST_CASE("a robot behind the gate touches nothing while it moves", "[soak]") {
  const DriveLimits limits{.max_backward_speed = 0.1, .max_angular_speed = 0.6};
  double driven = 0;
  const std::uint64_t worlds = test::scaled(120);
  for (std::uint64_t seed = 0; seed < worlds; ++seed) {
    drive_at_random(seed, {.limits = limits, .latency = 0.05 * double(seed % 6)}, driven);
  }
  CHECK(driven > 0.1 * double(worlds));
}

TEST_CASE("noise within its bounds does not bring a robot behind the gate to touch", "[soak]") {
  double driven = 0;
  const std::uint64_t worlds = test::scaled(120);
  for (std::uint64_t seed = 0; seed < worlds; ++seed) {
    const ControlOptions options{
        .latency = seed % 2 == 0 ? 0 : 0.12, .position_error = 0.02, .heading_error = 0.03};
    drive_at_random(1000 + seed, options, driven);
  }
  CHECK(driven > 0.1 * double(worlds));
}

TEST_CASE("a robot stops before a wall, and the command says where and when") {
  Workspace workspace{.bounds = {{-5, -5}, {5, 5}}, .safety_radius = 0.3};
  workspace.obstacles.push_back(Polygon{{{2, -3}, {3, -3}, {3, 3}, {2, 3}}});
  const InflatedSpace space = InflatedSpace::build(workspace).value();
  auto gate = Gate::build(space, {}).value();
  Pose pose{{0, 0}, 0};
  DriveCommand command;
  double slowed = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 100; ++k) {
    command = gate.command(pose, {0.4, 0}, {});
    if (command.status != DriveStatus::driving) slowed = std::min(slowed, pose.position.x());
    if (command.status == DriveStatus::slowed || command.status == DriveStatus::stopping) {
      CHECK(command.blocker.kind == Blocker::Kind::map);
      CHECK(command.blocker.obstacle == 0);
      CHECK(command.blocker.point.x() >= 1.6);
      CHECK(command.blocker.time > 0);
      CHECK(command.blocker.time < 3);
    }
    pose = moved(pose, command.twist, 0.1);
  }
  CHECK(command.status == DriveStatus::blocked);
  CHECK(command.twist.is_zero());
  CHECK(gate.stands());
  CHECK(slowed < 1.6);
  // A tenth of the speed is as slow as it goes.
  CHECK(pose.position.x() > 1.64);
  CHECK(pose.position.x() <= 1.7);
}

TEST_CASE("an obstacle that appears within the stopping distance is an emergency") {
  const InflatedSpace hall = empty_hall();
  auto gate = Gate::build(hall, {}).value();
  Pose pose{{0, 0}, 0};
  for (int k = 0; k < 20; ++k) pose = moved(pose, gate.command(pose, {0.4, 0}, {}).twist, 0.1);
  CHECK(gate.last().v > 0.39);
  const std::vector<MovingObstacle> sudden{{Disc{pose.position + Point(0.45, 0), 0.1}, {}}};
  int periods = 0;
  while (!gate.last().is_zero()) {
    const DriveCommand command = gate.command(pose, {0.4, 0}, sudden);
    if (!command.twist.is_zero()) {
      CHECK(command.status == DriveStatus::emergency);
      CHECK(command.blocker.kind == Blocker::Kind::observed);
      CHECK(command.blocker.obstacle == 0);
    }
    pose = moved(pose, command.twist, 0.1);
    REQUIRE(++periods < 20);
  }
  CHECK(periods == 8);  // 0.4 m/s at 0.5 m/s^2
  CHECK(gate.command(pose, {0.4, 0}, sudden).status == DriveStatus::blocked);
}

TEST_CASE("an obstacle that appears where commands under way lead is an emergency") {
  const InflatedSpace hall = empty_hall(0.1);
  const ControlOptions options{.limits = {.max_speed = 2, .max_acceleration = 2}, .latency = 0.5};
  auto gate = Gate::build(hall, options).value();
  const Pose pose{{0, 0}, 0};
  for (int k = 0; k < 20; ++k) gate.command(pose, {2, 0}, {});
  // The robot drives a metre before a command takes effect, and would have passed by then.
  const std::vector<MovingObstacle> sudden{{Disc{{0.5, 0}, 0.05}, {}}};
  const DriveCommand command = gate.command(pose, {2, 0}, sudden);
  CHECK(command.status == DriveStatus::emergency);
  CHECK(command.twist.v < 2);
  CHECK(command.blocker.kind == Blocker::Kind::observed);
  CHECK(command.blocker.time > 0.1);
  CHECK(command.blocker.time < 0.3);
  CHECK_FALSE(gate.check(pose, {0, 0.1}, 1, sudden).proved);
  CHECK(gate.check(pose, {0, 0.1}, 1, {}).proved);
}

TEST_CASE("bounds do not hide an obstacle from an emergency") {
  const InflatedSpace small =
      InflatedSpace::build({.bounds = {{-5, -5}, {5, 5}}, .safety_radius = 0.3}).value();
  auto gate = Gate::build(small, {}).value();
  Pose pose{{3, 0}, 0};
  for (int k = 0; k < 20; ++k) pose = moved(pose, gate.command(pose, {0.4, 0}, {}).twist, 0.1);
  const std::vector<MovingObstacle> sudden{{Disc{{5.44, 0}, 0.1}, {}}};
  CHECK(gate.command({{4.99, 0}, 0}, {0.4, 0}, {}).blocker.kind == Blocker::Kind::bounds);
  const DriveCommand command = gate.command({{4.99, 0}, 0}, {0.4, 0}, sudden);
  CHECK(command.status == DriveStatus::emergency);
  CHECK(command.blocker.kind == Blocker::Kind::observed);
}

TEST_CASE("a robot creeps where only a slow command is proved") {
  const InflatedSpace hall = empty_hall();
  auto gate = Gate::build(hall, {}).value();
  const std::vector<MovingObstacle> near{{Disc{{0.4135, 0}, 0.1}, {}}};
  const DriveCommand command = gate.command({{0, 0}, 0}, {0.4, 0}, near);
  CHECK(command.status == DriveStatus::slowed);
  CHECK(command.twist.v > 0.03);
  CHECK(command.twist.v < 0.05);
}

TEST_CASE("no motion beyond the limits is proved") {
  const InflatedSpace hall = empty_hall();
  const auto gate = Gate::build(hall, {}).value();
  const Pose pose{{0, 0}, 0};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(gate.check(pose, {0.4, 0}, 3, {}).proved);
  CHECK_FALSE(gate.check(pose, {0.4, 0}, 0, {}).proved);
  CHECK_FALSE(gate.check(pose, {0.4, 0}, -5, {}).proved);
  CHECK_FALSE(gate.check(pose, {0.5, 0}, 3, {}).proved);
  CHECK_FALSE(gate.check(pose, {0.4, 1}, 3, {}).proved);
  CHECK_FALSE(gate.check(pose, {nan, 0}, 3, {}).proved);
  CHECK_FALSE(gate.check(pose, {0, nan}, 3, {}).proved);
}

TEST_CASE("a robot on which an obstacle stands may turn, and drives on when that has gone") {
  const InflatedSpace hall = empty_hall();
  auto gate = Gate::build(hall, {}).value();
  const Pose pose{{1, 1}, 0};
  const std::vector<MovingObstacle> upon{{Disc{{1.1, 1}, 0.4}, {}}};
  CHECK(gate.command(pose, {0.3, 0}, upon).status == DriveStatus::blocked);
  const DriveCommand turn = gate.command(pose, {0, 0.3}, upon);
  CHECK(turn.status == DriveStatus::driving);
  CHECK(turn.twist.omega > 0);
  CHECK(turn.twist.v == 0);
  gate.reset();
  CHECK(gate.command(pose, {0.3, 0}, {}).status == DriveStatus::driving);
}

TEST_CASE("input that is not a number makes the robot brake") {
  const InflatedSpace hall = empty_hall();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<MovingObstacle> fine, broken{{Disc{{nan, 0}, 0.1}, {}}},
      rushing{{Disc{{9, 9}, 0.1}, {0, nan}}}, none{{Polygon{}, {}}};
  const auto braking = [&](const Pose& odometry, const Twist& wanted,
                           const std::vector<MovingObstacle>& observed) {
    auto gate = Gate::build(hall, {}).value();
    Pose pose{{0, 0}, 0};
    for (int k = 0; k < 10; ++k) pose = moved(pose, gate.command(pose, {0.4, 0}, {}).twist, 0.1);
    const double before = gate.last().v;
    const DriveCommand command = gate.command(odometry, wanted, observed);
    CHECK(command.twist.v < before);
    return command.status;
  };
  const Pose origin{{0, 0}, 0};
  CHECK(braking({{nan, 0}, 0}, {0.4, 0}, fine) == DriveStatus::invalid_input);
  CHECK(braking({{0, 0}, nan}, {0.4, 0}, fine) == DriveStatus::invalid_input);
  CHECK(braking(origin, {0.4, 0}, broken) == DriveStatus::invalid_input);
  CHECK(braking(origin, {0.4, 0}, rushing) == DriveStatus::invalid_input);
  CHECK(braking(origin, {0.4, 0}, none) == DriveStatus::invalid_input);
  CHECK(braking(origin, {nan, 0}, fine) == DriveStatus::invalid_input);
}

TEST_CASE("options of control out of range are refused by name") {
  const InflatedSpace hall = empty_hall();
  const auto message = [&](const ControlOptions& options) {
    return Gate::build(hall, options).error().detail;
  };
  const auto names = [](const std::string& text, const std::string& name) {
    return text.find(name) != std::string::npos;
  };
  CHECK(names(message({.limits = {.max_speed = 0}}), "max_speed"));
  CHECK(names(message({.limits = {.max_backward_speed = -1}}), "max_backward_speed"));
  CHECK(names(message({.limits = {.max_angular_acceleration = -1}}), "max_angular_acceleration"));
  CHECK(names(message({.limits = {.max_acceleration = 1e-9}}), "max_acceleration"));
  CHECK(names(message({.limits = {.max_backward_speed = 1e12}}), "max_acceleration"));
  CHECK(names(message({.period = 0}), "period"));
  CHECK(names(message({.latency = -1}), "latency"));
  CHECK(names(message({.latency = 100}), "latency"));
  CHECK(names(message({.position_error = -1}), "position_error"));
  CHECK(names(message({.heading_error = std::nan("")}), "heading_error"));
  CHECK(names(message({.hold = 0}), "hold"));
  CHECK(names(message({.hold = 1001}), "hold"));
}

TEST_CASE("a robot keeps its arc where the limits bind") {
  const InflatedSpace hall = empty_hall();
  auto gate = Gate::build(hall, {}).value();
  Pose pose{{0, 0}, 0};
  for (int k = 0; k < 60; ++k) {
    const Twist twist = gate.command(pose, {0.4, 0.6}, {}).twist;
    if (twist.v > 0) CHECK(twist.omega / twist.v == Approx(1.5).epsilon(1e-3));
    pose = moved(pose, twist, 0.1);
  }
  // 0.3 rad/s allows 0.2 m/s on this arc.
  CHECK(gate.last().v == Approx(0.2).epsilon(1e-3));
  CHECK(gate.last().omega == Approx(0.3));
}

TEST_CASE("the gate holds among cells") {
  OccupancyGrid grid = OccupancyGrid::blocked(12, 12).value();
  for (int y = 0; y < 12; ++y) {
    for (int x = 0; x < 12; ++x) grid.set({x, y}, x != 8);
  }
  const CellSpace space = CellSpace::build(grid, {.safety_radius = 0.4}).value();
  auto gate = MotionGate<CellSpace>::build(space, {}).value();
  Pose pose{{4, 4}, 0.2};
  for (int k = 0; k < 200; ++k) {
    pose = moved(pose, gate.command(pose, {0.4, 0}, {}).twist, 0.1);
    CHECK(space.clearance(pose.position) >= 0.4);
  }
  CHECK(space.clearance(pose.position) < 0.5);
  CHECK(gate.last().is_zero());
}

}  // namespace
