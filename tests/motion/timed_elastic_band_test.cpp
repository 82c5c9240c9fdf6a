// SPDX-License-Identifier: MIT
#include "tutavia/motion/timed_elastic_band.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;
using std::numbers::pi;

InflatedSpace band_hall(std::vector<Obstacle> obstacles = {}) {
  return InflatedSpace::build({.bounds = {{-20, -20}, {20, 20}},
                               .safety_radius = 0.3,
                               .obstacles = std::move(obstacles)})
      .value();
}

Curve straight(const Point& from, const Point& to) {
  const Point points[] = {from, to};
  return Curve::polyline(points);
}

double least_clearance(const InflatedSpace& space, const Band& band) {
  double least = std::numeric_limits<double>::infinity();
  for (const Pose& pose : band.poses) least = std::min(least, space.clearance(pose.position));
  return least;
}

TEST_CASE("a band goes around an obstacle on its way, within its limits but for a little") {
  const InflatedSpace space = band_hall({Disc{{1.5, -0.1}, 0.2}});
  const TimedElasticBand teb{.clearance = 0.5};
  Band band;
  TimedElasticBand::Scratch scratch;
  teb.lay(straight({0, 0}, {3, 0}), 0, 3, {{0, 0}, 0}, band);
  CHECK(band.poses.front().position == Point(0, 0));
  CHECK(band.poses.back().position == Point(3, 0));
  const double before = least_clearance(space, band);
  BandReport report;
  for (int i = 0; i < 5; ++i) {
    const BandTask task{.start = {0.4, 0}, .end = {}, .free_end_heading = true};
    report = teb.optimize(space, {}, task, band, scratch).value();
    CHECK(report.after.total() <= report.before.total());
  }
  CHECK(before < 0);
  CHECK(report.converged());
  CHECK(least_clearance(space, band) > 0.4);
  CHECK(band.poses.front().position == Point(0, 0));
  CHECK(band.poses.back().position == Point(3, 0));
  for (std::size_t i = 0; i < band.intervals.size(); ++i) {
    const double step = distance(band.poses[i].position, band.poses[i + 1].position);
    CHECK(step / band.intervals[i] < 0.4 * 1.1);
    CHECK(band.intervals[i] < 0.4 + 1e-9);
  }
}

TEST_CASE("the cost of a band never rises, whatever the world", "[soak]") {
  std::size_t converged = 0, bands = 0;
  for (std::uint64_t seed = 0; seed < test::scaled(150); ++seed) {
    CAPTURE(seed);
    test::WorldGenerator generator(seed);
    Random random(seed);
    Workspace workspace = generator.workspace();
    workspace.safety_radius = 0.2;
    const InflatedSpace space = InflatedSpace::build(workspace).value();
    std::vector<MovingObstacle> moving;
    for (int i = 0; i < 3; ++i) {
      moving.push_back({generator.obstacle(workspace.bounds), {random.uniform(-0.3, 0.3), 0.1}});
    }
    const TimedElasticBand teb{.clearance = 0.4};
    const Curve path = straight(generator.point(workspace), generator.point(workspace));
    Band band;
    TimedElasticBand::Scratch scratch;
    teb.lay(path, 0, std::min(path.length(), 4.0), {path.start(), random.uniform(-3, 3)}, band);
    for (int i = 0; i < 3; ++i) {
      const std::vector<Point> via{generator.point(workspace)};
      const BandTask task{.start = {random.uniform(0, 0.4), 0}, .via = via};
      const auto report = teb.optimize(space, moving, task, band, scratch).value();
      CHECK(report.after.total() <= report.before.total());
      CHECK(std::isfinite(report.after.total()));
      CHECK(report.iterations <= teb.rounds * teb.steps);
      CHECK(band.poses.front().position == path.start());
      CHECK(band.poses.size() <= teb.max_poses);
      CHECK(*std::min_element(band.intervals.begin(), band.intervals.end()) > 0);
      converged += report.converged() ? 1 : 0;
      ++bands;
    }
  }
  CHECK(converged * 5 > bands);
}

TEST_CASE("a goal behind the robot, poses that coincide and no length at all are bands too") {
  const InflatedSpace space = band_hall();
  const TimedElasticBand teb{.limits = {.max_angular_speed = 1}};
  TimedElasticBand::Scratch scratch;
  const auto improves = [&](Band band) {
    const auto report = teb.optimize(space, {}, {.end = Twist{}}, band, scratch).value();
    CHECK(report.after.total() <= report.before.total());
    for (const Pose& pose : band.poses) CHECK(pose.is_finite());
    return report.after.total() < report.before.total();
  };
  Band band;
  teb.lay(straight({0, 0}, {-2, 0}), 0, 2, {{0, 0}, 0}, band);
  CHECK(improves(band));
  teb.lay(straight({1, 1}, {1, 1}), 0, 0, {{1, 1}, 0.4}, band);
  CHECK(band.poses.size() >= 3);
  improves(band);
  const Pose here{{1, 1}, 0};
  CHECK(improves({{here, here, here, here}, {0.3, 0.3, 0.3}}));
  // The robot stands in an obstacle that appeared.
  const std::vector<MovingObstacle> upon{{Disc{{0, 0.1}, 0.4}, {}}};
  teb.lay(straight({0, 0}, {3, 0}), 0, 3, {{0, 0}, 0}, band);
  const auto report = teb.optimize(space, upon, {}, band, scratch).value();
  CHECK(report.after.total() < report.before.total());
}

TEST_CASE("intervals that collapse are pulled apart, and long ones divided") {
  const InflatedSpace space = band_hall();
  const TimedElasticBand teb;
  TimedElasticBand::Scratch scratch;
  Band band;
  teb.lay(straight({0, 0}, {3, 0}), 0, 3, {{0, 0}, 0}, band);
  for (double& interval : band.intervals) interval = 1e-9;
  const auto report = teb.optimize(space, {}, {}, band, scratch).value();
  CHECK(report.after.total() < report.before.total());
  CHECK(*std::min_element(band.intervals.begin(), band.intervals.end()) > 0.01);
  Band two{{{{0, 0}, 0}, {{2, 0}, 0}}, {5}};
  teb.resize(two);
  CHECK(two.poses.size() > 12);
  CHECK(two.duration() == Approx(5));
  for (const double interval : two.intervals) CHECK(interval <= 0.4);
}

TEST_CASE("bands that are none are refused") {
  const InflatedSpace space = band_hall();
  TimedElasticBand::Scratch scratch;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](Band band) {
    return TimedElasticBand{}.optimize(space, {}, {}, band, scratch).error().code ==
           PlanError::invalid_input;
  };
  const Pose a{{0, 0}, 0}, b{{1, 0}, 0};
  CHECK(refused({}));
  CHECK(refused({{a}, {}}));
  CHECK(refused({{a, b}, {}}));
  CHECK(refused({{a, b}, {0}}));
  CHECK(refused({{a, b}, {-1}}));
  CHECK(refused({{a, b}, {nan}}));
  CHECK(refused({{a, {{nan, 0}, 0}}, {0.3}}));
}

TEST_CASE("options of a band out of range are refused by name") {
  const auto message = [](const TimedElasticBand& teb) { return teb.validate().error().detail; };
  const auto names = [](const std::string& text, const std::string& name) {
    return text.find(name) != std::string::npos;
  };
  CHECK(names(message({.limits = {.max_speed = -1}}), "max_speed"));
  CHECK(names(message({.weights = {.clearance = -1}}), "weights"));
  CHECK(names(message({.weights = {.time = 0}}), "weights.time"));
  CHECK(names(message({.clearance = -1}), "clearance"));
  CHECK(names(message({.reference_interval = 0}), "reference_interval"));
  CHECK(names(message({.hysteresis = 0.3}), "hysteresis"));
  CHECK(names(message({.rounds = 0}), "rounds"));
  CHECK(names(message({.tolerance = -1}), "tolerance"));
  CHECK(names(message({.max_poses = 2}), "max_poses"));
}

TEST_CASE("a band that is stopped early says that it has not converged") {
  const InflatedSpace space = band_hall({Disc{{1.5, -0.1}, 0.6}});
  TimedElasticBand::Scratch scratch;
  Band band;
  const TimedElasticBand hasty{.clearance = 0.5, .rounds = 1, .steps = 1};
  hasty.lay(straight({0, 0}, {3, 0}), 0, 3, {{0, 0}, 0}, band);
  const auto report = hasty.optimize(space, {}, {}, band, scratch).value();
  CHECK_FALSE(report.converged());
  CHECK((to_string(report.end) == "iteration_limit" || to_string(report.end) == "stalled"));
}

TEST_CASE("the first twist follows the arc of the first interval") {
  const double heading = 0.4;
  const Pose from{{1, 2}, heading};
  const Pose to = moved(from, {0.3, 0.5}, 0.8);
  const Twist twist = first_twist({{from, to}, {0.8}});
  CHECK(twist.v == Approx(0.3));
  CHECK(twist.omega == Approx(0.5));
  CHECK(first_twist({{from, {from.position, heading + pi}}, {2}}).v == 0);
}

TEST_CASE("bands keep away from blocked cells") {
  OccupancyGrid grid = OccupancyGrid::blocked(8, 8).value();
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) grid.set({x, y}, x != 4 || y != 3);
  }
  const CellSpace space = CellSpace::build(grid, {.safety_radius = 0.3}).value();
  const TimedElasticBand teb{.clearance = 0.5};
  TimedElasticBand::Scratch scratch;
  Band band;
  teb.lay(straight({3, 4.2}, {6, 4.2}), 0, 3, {{3, 4.2}, 0}, band);
  double least = 9;
  for (int i = 0; i < 5; ++i) CHECK(teb.optimize(space, {}, {}, band, scratch));
  for (const Pose& pose : band.poses) least = std::min(least, space.clearance(pose.position));
  CHECK(least > 0.42);
}

}  // namespace
