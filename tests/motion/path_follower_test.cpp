// SPDX-License-Identifier: MIT
#include "tutavia/motion/path_follower.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "support/archetypes.hpp"
#include "support/catch.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;
using std::numbers::pi;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

InflatedSpace follower_room(std::vector<Obstacle> obstacles = {}) {
  return InflatedSpace::build({.bounds = {{0, 0}, {10, 10}},
                               .safety_radius = 0.3,
                               .obstacles = std::move(obstacles)})
      .value();
}

Curve follower_path(const std::vector<Point>& points) { return Curve::polyline(points); }

/// A robot that follows its commands exactly and at once.
struct FollowedDrive {
  Pose pose{};
  std::vector<Pose> poses{};
  std::vector<DriveCommand> commands{};

  template <class S>
  void step(PathFollower<S>& follower, const std::vector<MovingObstacle>& observed = {}) {
    poses.push_back(pose);
    commands.push_back(follower.step(pose, observed));
    pose = moved(pose, commands.back().twist, 0.1);
  }
  /// Steps until the robot has arrived, or `most` times.
  template <class S>
  bool arrives(PathFollower<S>& follower, int most,
               const std::vector<MovingObstacle>& observed = {}) {
    for (int i = 0; i < most; ++i) {
      step(follower, observed);
      if (commands.back().status == DriveStatus::arrived) return true;
    }
    return false;
  }
};

double farthest_from(const Curve& path, const std::vector<Pose>& poses) {
  double most = 0;
  for (const Pose& pose : poses) most = std::max(most, path.nearest(pose.position).distance);
  return most;
}

TEST_CASE("a follower drives to the end of a straight path and stands there") {
  const InflatedSpace space = follower_room();
  auto follower = PathFollower<InflatedSpace>::build(space).value();
  REQUIRE(follower.follow(follower_path({{1, 1}, {9, 1}})));
  FollowedDrive drive{{{1, 1}, 0}};
  REQUIRE(drive.arrives(follower, 400));
  CHECK(distance(drive.pose.position, Point(9, 1)) < 0.05);
  CHECK(drive.commands.back().twist.is_zero());
  // 8 m at 0.4 m/s, and one second for both ramps.
  CHECK(static_cast<double>(drive.commands.size()) * 0.1 < 25);
  CHECK(farthest_from(follower.path(), drive.poses) < 1e-9);
  for (const DriveCommand& command : drive.commands) {
    CHECK((command.status == DriveStatus::driving || command.status == DriveStatus::arrived));
  }
}

TEST_CASE("a follower keeps near a path with bends") {
  const InflatedSpace space = follower_room();
  auto follower = PathFollower<InflatedSpace>::build(space).value();
  Curve path;
  const Arc left = Arc::around({3, 3}, 1.5, -pi / 2, pi);
  path.push_back(Segment{{1, 1.5}, left.start()});
  path.push_back(left);
  const Arc right = Arc::around({3, 6}, 1.5, -pi / 2, -pi);
  path.push_back(Segment{left.end(), right.start()});
  path.push_back(right);
  path.push_back(Segment{right.end(), {7, 7.5}});
  REQUIRE(follower.follow(path));
  FollowedDrive drive{{{1, 1.5}, 0}};
  REQUIRE(drive.arrives(follower, 900));
  CHECK(farthest_from(path, drive.poses) < 0.12);
}

TEST_CASE("a follower whose path leads back turns on the spot first") {
  const InflatedSpace space = follower_room();
  auto follower = PathFollower<InflatedSpace>::build(space).value();
  REQUIRE(follower.follow(follower_path({{5, 5}, {1, 5}})));
  FollowedDrive drive{{{5, 5}, 0.1}};
  REQUIRE(drive.arrives(follower, 600));
  CHECK(drive.commands.front().twist.v == 0);
  CHECK(drive.commands.front().twist.omega > 0);
  CHECK(farthest_from(follower.path(), drive.poses) < 0.05);
}

TEST_CASE("a follower stops before an obstacle on its path, and goes on when it is gone") {
  const InflatedSpace space = follower_room();
  auto follower = PathFollower<InflatedSpace>::build(space).value();
  REQUIRE(follower.follow(follower_path({{1, 1}, {9, 1}})));
  FollowedDrive drive{{{1, 1}, 0}};
  const std::vector<MovingObstacle> observed{{Disc{{5, 1}, 0.4}}};
  CHECK_FALSE(drive.arrives(follower, 300, observed));
  CHECK(drive.commands.back().status == DriveStatus::blocked);
  CHECK(drive.commands.back().blocker.kind == Blocker::Kind::observed);
  CHECK(drive.commands.back().blocker.obstacle == 0);
  const double gap = distance(drive.pose.position, Point(5, 1)) - 0.4 - 0.3;
  CHECK(gap >= 0);
  CHECK(gap < 0.1);
  CHECK(drive.arrives(follower, 300));
}

TEST_CASE("a follower never goes through a wall, wherever its path leads") {
  const InflatedSpace space = follower_room({Polygon{{{5, 0}, {5.2, 0}, {5.2, 6}, {5, 6}}}});
  auto follower = PathFollower<InflatedSpace>::build(space).value();
  REQUIRE(follower.follow(follower_path({{1, 1}, {9, 1}})));
  FollowedDrive drive{{{1, 1}, 0}};
  CHECK_FALSE(drive.arrives(follower, 300));
  CHECK(drive.commands.back().status == DriveStatus::blocked);
  CHECK(drive.commands.back().blocker.kind == Blocker::Kind::map);
  for (const Pose& pose : drive.poses) CHECK(space.clearance(pose.position) >= 0.3);
}

TEST_CASE("a follower brakes within its limits where the odometry is not a number") {
  const InflatedSpace space = follower_room();
  auto follower = PathFollower<InflatedSpace>::build(space).value();
  REQUIRE(follower.follow(follower_path({{1, 1}, {9, 1}})));
  FollowedDrive drive{{{1, 1}, 0}};
  for (int i = 0; i < 30; ++i) drive.step(follower);
  double speed = drive.commands.back().twist.v;
  REQUIRE(speed > 0.39);
  for (const Pose& odometry : {Pose{{nan, 1}, 0}, Pose{{1, 1}, nan}}) {
    for (int i = 0; i < 6; ++i) {
      const DriveCommand command = follower.step(odometry, {});
      CHECK(command.status == DriveStatus::invalid_input);
      CHECK(command.twist.v <= speed);
      CHECK(command.twist.v >= speed - 0.05 - 1e-9);
      speed = command.twist.v;
      drive.pose = moved(drive.pose, command.twist, 0.1);
    }
  }
  CHECK(speed == 0);
  CHECK(drive.arrives(follower, 400));
}

TEST_CASE("a follower keeps its limits of speed and acceleration") {
  const InflatedSpace space = follower_room();
  const PathFollowerOptions options{
      .control = {.limits = {.max_speed = 0.8, .max_angular_speed = 0.6}}};
  auto follower = PathFollower<InflatedSpace>::build(space, options).value();
  REQUIRE(follower.follow(follower_path({{1, 1}, {8, 1}, {8, 8}, {2, 2}, {2, 8}})));
  FollowedDrive drive{{{1, 1}, 2}};
  REQUIRE(drive.arrives(follower, 2000));
  Twist before{};
  for (const DriveCommand& command : drive.commands) {
    const Twist& twist = command.twist;
    REQUIRE((0 <= twist.v && twist.v <= 0.8 && std::abs(twist.omega) <= 0.6));
    REQUIRE(std::abs(twist.v - before.v) <= 0.05 + 1e-12);
    REQUIRE(std::abs(twist.omega - before.omega) <= 0.05 + 1e-12);
    before = twist;
  }
}

TEST_CASE("a follower stays on its part of a path that crosses itself") {
  const InflatedSpace space = follower_room();
  auto follower = PathFollower<InflatedSpace>::build(space).value();
  REQUIRE(follower.follow(follower_path({{1, 5}, {9, 5}, {5, 9}, {5, 1}})));
  FollowedDrive drive{{{1, 5}, 0}};
  double progress = 0;
  for (int i = 0; i < 3000 && follower.progress() < follower.path().length() - 0.1; ++i) {
    drive.step(follower);
    REQUIRE(follower.progress() >= progress - 0.1);
    REQUIRE(follower.progress() <= progress + 0.5);
    progress = follower.progress();
  }
  CHECK(drive.arrives(follower, 100));
}

TEST_CASE("a follower without a path stands, and takes none that is empty or not finite") {
  const InflatedSpace space = follower_room();
  auto follower = PathFollower<InflatedSpace>::build(space).value();
  const DriveCommand command = follower.step({{1, 1}, 0}, {});
  CHECK(command.twist.is_zero());
  CHECK(command.status == DriveStatus::blocked);
  CHECK(follower.follow({}).error().code == PlanError::invalid_input);
  const auto refused = follower.follow(follower_path({{1, 1}, {2, 1}, {nan, 1}}));
  REQUIRE_FALSE(refused);
  CHECK(refused.error().detail == "pieces[1] is not finite");
}

TEST_CASE("a follower needs of a space its clearance alone") {
  const test::ClearanceArchetype space;
  auto follower = PathFollower<test::ClearanceArchetype>::build(space).value();
  REQUIRE(follower.follow(follower_path({{1, 1}, {3, 2}})));
  FollowedDrive drive{{{1, 1}, 0}};
  CHECK(drive.arrives(follower, 300));
}

TEST_CASE("a follower names an option that is out of range") {
  const InflatedSpace space = follower_room();
  const auto names = [&](const PathFollowerOptions& options, const std::string& name) {
    const auto follower = PathFollower<InflatedSpace>::build(space, options);
    return !follower && follower.error().code == PlanError::invalid_option &&
           follower.error().detail.find(name) != std::string::npos;
  };
  CHECK(names({.control = {.period = 0}}, "period"));
  CHECK(names({.control = {.limits = {.max_speed = -1}}}, "max_speed"));
  CHECK(names({.lookahead_time = nan}, "lookahead_time"));
  CHECK(names({.min_lookahead = 0}, "min_lookahead"));
  CHECK(names({.max_lookahead = 0.1}, "max_lookahead"));
  CHECK(names({.max_lateral_acceleration = 0}, "max_lateral_acceleration"));
  CHECK(names({.slow_gap = -1}, "slow_gap"));
  CHECK(names({.slowest = 0}, "slowest"));
  CHECK(names({.turn_until = 1}, "turn_from"));
  CHECK(names({.tolerance = 0}, "tolerance"));
}

}  // namespace
