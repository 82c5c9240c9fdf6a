// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "contact.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/pose.hpp"
#include "tutavia/space/concepts.hpp"
#include "tutavia/world/moving_obstacle.hpp"

/// \file
/// Encounters: obstacles that appear in front of a robot.

namespace drive_program {

using namespace tutavia;

/// An obstacle that appears, keeps its velocity, and may vanish.
struct Encounter {
  MovingObstacle obstacle{};                                  ///< where it is when it appears
  double appears = 0;                                         ///< [s]
  double vanishes = std::numeric_limits<double>::infinity();  ///< [s]

  bool is_present(double time) const { return appears <= time && time < vanishes; }
  bool stays() const { return obstacle.stands() && std::isinf(vanishes); }
  MovingObstacle at(double time) const {
    return {at_time(obstacle, time - appears), obstacle.velocity};
  }
};

/// Which obstacles appear, and how often.
struct EncounterOptions {
  std::size_t count = 0;      ///< obstacles in all
  double first_interval = 1;  ///< until the first one appears [s]
  double least_interval = 2;  ///< between two [s]
  double most_interval = 6;   ///< between two [s]
  double least_gap = 0.5;     ///< from the robot's edge when it appears [m]
  double most_gap = 3;        ///< [m]
  double least_size = 0.15;   ///< radius [m]
  double most_size = 0.5;     ///< radius [m]
  double most_speed = 0.2;    ///< towards the robot [m/s]
  double gap_at_goal = 0.3;   ///< at least, between the robot at the goal and what stays [m]
  double off_path = 0.6;      ///< at most, from the path to the obstacle's centre [m]
  std::uint64_t seed = 0;
};

/// Lets obstacles appear in front of a robot, near its path: discs and small polygons. A third
/// stays for good, a third moves towards the robot for some time, and a third stands and vanishes.
/// None that stays for good blocks the goal itself.
class Encounters {
 public:
  explicit Encounters(const EncounterOptions& options)
      : options_(options), random_(options.seed), next_(options.first_interval) {}

  const std::vector<Encounter>& all() const { return all_; }

  /// Adds an obstacle by hand.
  void add(Encounter encounter) { all_.push_back(std::move(encounter)); }

  /// Lets an obstacle appear, if it is time.
  template <ClearanceSpace S>
  void advance(double time, const S& map, const Pose& robot, const Curve& path) {
    if (appeared_ == options_.count || time < next_) return;
    for (int attempt = 0; attempt < 40; ++attempt) {
      Encounter encounter = draw(time, robot, path);
      if (!fits(encounter, map, robot, path.end())) continue;
      all_.push_back(std::move(encounter));
      ++appeared_;
      break;
    }
    next_ = time + random_.uniform(options_.least_interval, options_.most_interval);
  }

  /// The obstacles that are there at a time, into `present`.
  void observe(double time, std::vector<MovingObstacle>& present) const {
    present.clear();
    for (const Encounter& e : all_) {
      if (e.is_present(time)) present.push_back(e.at(time));
    }
  }

 private:
  Encounter draw(double time, const Pose& robot, const Curve& path) {
    const double ahead =
        path.nearest(robot.position).s + random_.uniform(options_.least_gap, options_.most_gap + 1);
    const CurvePoint on_path = path.at(std::min(ahead, path.length()));
    const double aside = random_.uniform(-options_.off_path, options_.off_path);
    const Point center{on_path.position.x() - aside * std::sin(on_path.heading),
                       on_path.position.y() + aside * std::cos(on_path.heading)};
    const double size = random_.uniform(options_.least_size, options_.most_size);
    Encounter encounter{.appears = time};
    encounter.obstacle.shape = shape(center, size);
    const std::uint64_t kind = random_.below(3);
    if (kind == 0) return encounter;
    encounter.vanishes = time + random_.uniform(5, 20);
    if (kind == 1) {
      const Point towards = robot.position - center;
      const double speed = random_.uniform(0.25, 1) * options_.most_speed;
      encounter.obstacle.velocity = speed / towards.norm() * towards;
    }
    return encounter;
  }

  Obstacle shape(const Point& center, double size) {
    if (random_.below(3) != 0) return Disc{center, size};
    const auto corners = static_cast<int>(3 + random_.below(3));
    const double turn = random_.uniform(0, 2 * std::numbers::pi);
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
      const double angle = turn + 2 * std::numbers::pi * i / corners;
      polygon.outer.emplace_back(center.x() + size * std::cos(angle),
                                 center.y() + size * std::sin(angle));
    }
    return polygon;
  }

  /// Whether an obstacle appears on the floor, in front of the robot and off the goal.
  template <ClearanceSpace S>
  bool fits(const Encounter& encounter, const S& map, const Pose& robot, const Point& goal) const {
    const auto gap_at = [&](const Point& p) {
      return approach({.from = {p, 0}}, encounter.obstacle).distance - map.safety_radius();
    };
    const Box box = tutavia::detail::box_of(encounter.obstacle.shape);
    const Point center = 0.5 * (box.min + box.max), to = center - robot.position;
    const bool in_front = to.x() * std::cos(robot.heading) + to.y() * std::sin(robot.heading) > 0;
    const double gap = gap_at(robot.position);
    return map.bounds().contains(center) && map.clearance(center) > 0 && in_front &&
           gap >= options_.least_gap && gap <= options_.most_gap &&
           (!encounter.stays() || gap_at(goal) >= options_.gap_at_goal);
  }

  EncounterOptions options_;
  Random random_;
  double next_;
  std::size_t appeared_ = 0;
  std::vector<Encounter> all_{};
};

}  // namespace drive_program
