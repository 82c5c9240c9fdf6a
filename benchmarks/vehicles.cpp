// SPDX-License-Identifier: MIT
/// \file
/// Paths of vehicles: HybridAStar beside OMPL's RRT-Connect over Reeds-Shepp drives with the same
/// proof of every motion, and beside an exhaustive search of fine states.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <limits>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "program.hpp"
#include "tutavia/certify/certify_vehicle.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/geometry/reeds_shepp.hpp"
#include "tutavia/search/hybrid_astar.hpp"
#include "tutavia/smooth/continuous_curvature.hpp"
#include "tutavia/smooth/vehicle_shortcut.hpp"
#include "tutavia/space/inflated_space.hpp"

#ifdef TUTAVIA_WITH_OMPL
#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>
#endif

namespace {

using namespace tutavia;
using bench::Clock;
using bench::micros_since;
using bench::UsageError;

constexpr double pi = std::numbers::pi;

struct Arguments {
  std::vector<std::string> tables{"peers", "share", "parking", "continuous"};
  std::size_t scenes = 20, worlds = 200, rounds = 3;
  std::uint64_t seed = 1;
  double time_limit = 10;
};

/// A vehicle with a pose to leave and one to reach.
struct VehicleTask {
  InflatedSpace space;
  Vehicle vehicle;
  Pose start, goal;

  Query query() const {
    return {.start = start.position,
            .goal = goal.position,
            .start_heading = start.heading,
            .goal_heading = goal.heading};
  }
};

Polygon rectangle(double x0, double y0, double x1, double y1) {
  return Polygon{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

/// Whether the footprint is free where it stands.
bool stands_free(const InflatedSpace& space, const Vehicle& vehicle, const Pose& pose) {
  const Arc there = detail::turn_from(pose, {Steering::left, 0}, 1);
  return space.bounds().contains(pose.position) &&
         detail::FootprintTest(vehicle).is_free(space, there, Gear::forward);
}

Pose free_pose(Random& random, const InflatedSpace& space, const Vehicle& vehicle) {
  const Box& b = space.bounds();
  while (true) {
    const Pose pose{{random.uniform(b.min.x(), b.max.x()), random.uniform(b.min.y(), b.max.y())},
                    random.uniform(-pi, pi)};
    if (stands_free(space, vehicle, pose)) return pose;
  }
}

/// `count` triangles to octagons of random sizes in a square.
Workspace polygon_yard(Random& random, double side, std::size_t count, double smallest,
                       double largest) {
  Workspace world{.bounds = {{0, 0}, {side, side}}};
  while (world.obstacles.size() < count) {
    const Point centre{random.uniform(0, side), random.uniform(0, side)};
    const double radius = random.uniform(smallest, largest);
    std::vector<double> angles(3 + random.below(6));
    for (double& angle : angles) angle = random.uniform(0, 2 * pi);
    std::sort(angles.begin(), angles.end());
    Polygon polygon;
    for (const double angle : angles) {
      polygon.outer.push_back(
          {centre.x() + radius * std::cos(angle), centre.y() + radius * std::sin(angle)});
    }
    world.obstacles.emplace_back(std::move(polygon));
  }
  return world;
}

VehicleTask in_yard(const Vehicle& vehicle, Workspace world, Random& random) {
  auto space = bench::value_or_throw(InflatedSpace::build(std::move(world)));
  const Pose start = free_pose(random, space, vehicle);
  Pose goal = free_pose(random, space, vehicle);
  while (distance(start.position, goal.position) < space.bounds().width() / 2) {
    goal = free_pose(random, space, vehicle);
  }
  return {std::move(space), vehicle, start, goal};
}

const Vehicle& car() {
  static const Vehicle value = Vehicle::car(4.5, 1.8, 2.7, 5);
  return value;
}

/// A street of bays 2.6 m wide, all taken but one; the car comes along the street.
VehicleTask bay(Random& random) {
  Workspace world{.bounds = {{-20, -8}, {20, 8}}};
  world.obstacles = {rectangle(-20, -6, -1.3, -0.8), rectangle(1.3, -6, 20, -0.8),
                     rectangle(-20, -6.4, 20, -6.1), rectangle(-20, 6, 20, 6.5)};
  const bool backwards = random.below(2) == 0;
  const Pose goal = backwards ? Pose{{0, -4.6}, pi / 2} : Pose{{0, -2.2}, -pi / 2};
  const Pose start{{random.uniform(-14, 10), random.uniform(1.5, 3.5)}, random.uniform(-0.3, 0.3)};
  return {bench::value_or_throw(InflatedSpace::build(std::move(world))), car(), start, goal};
}

/// A gap of 6 m between cars along the kerb.
VehicleTask gap(Random& random) {
  Workspace world{.bounds = {{-20, -8}, {20, 8}}};
  world.obstacles = {rectangle(-20, -1.9, -3, -0.1), rectangle(3, -1.9, 20, -0.1),
                     rectangle(-20, -2.4, 20, -2.2), rectangle(-20, 6, 20, 6.5)};
  const Pose start{{random.uniform(-14, 10), random.uniform(1.5, 3.5)}, random.uniform(-0.3, 0.3)};
  return {bench::value_or_throw(InflatedSpace::build(std::move(world))),
          car(),
          start,
          {{-1.35, -1}, 0}};
}

using MakeTask = VehicleTask (*)(Random&);
struct Family {
  std::string_view name;
  MakeTask make;
};
/// Time to the first path and its length [m]; infinite without one.
struct FirstPath {
  double micros = 0;
  double length = std::numeric_limits<double>::infinity();
};

FirstPath search_ours(const VehicleTask& task, HybridAStar::Scratch& scratch) {
  NoObserver no_observer;
  const HybridAStar search{.vehicle = task.vehicle};
  const auto start = Clock::now();
  const auto route = search.search(task.space, task.query(), scratch, no_observer);
  FirstPath result{micros_since(start)};
  if (route) result.length = route->curve.length();
  return result;
}

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

constexpr Family families[] = {
    {"point, R = 3 m, 60 x 60 m, 40 polygons",
     [](Random& random) {
       Workspace world = polygon_yard(random, 60, 40, 1.5, 5);
       world.safety_radius = 0.4;
       return in_yard(Vehicle::point(3, true), std::move(world), random);
     }},
    {"car, R = 5 m, 60 x 60 m, 20 polygons",
     [](Random& random) { return in_yard(car(), polygon_yard(random, 60, 20, 1.5, 5), random); }},
    {"car into a bay or a gap",
     [](Random& random) { return random.below(2) == 0 ? bay(random) : gap(random); }},
};

#ifdef TUTAVIA_WITH_OMPL

namespace ob = ompl::base;

/// Motions are Reeds-Shepp drives, proved for the whole footprint.
class ProvedMotions : public ob::MotionValidator {
 public:
  ProvedMotions(const ob::SpaceInformationPtr& information, const VehicleTask& task)
      : ob::MotionValidator(information), task_(task), footprint_(task.vehicle) {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    const double radius = task_.vehicle.min_turning_radius;
    return footprint_.is_free(task_.space, reeds_shepp_path(pose(from), pose(to), radius));
  }
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& last) const override {
    last.second = 0;
    return checkMotion(from, to);
  }
  static Pose pose(const ob::State* state) {
    const auto* s = state->as<ob::SE2StateSpace::StateType>();
    return {{s->getX(), s->getY()}, s->getYaw()};
  }

 private:
  const VehicleTask& task_;
  mutable detail::FootprintTest footprint_;
};

FirstPath search_ompl(const VehicleTask& task, double time_limit) {
  const auto space = std::make_shared<ob::ReedsSheppStateSpace>(task.vehicle.min_turning_radius);
  ob::RealVectorBounds bounds(2);
  const Box& box = task.space.bounds();
  for (unsigned i = 0; i < 2; ++i) {
    bounds.setLow(i, box.min[i]);
    bounds.setHigh(i, box.max[i]);
  }
  space->setBounds(bounds);
  const auto information = std::make_shared<ob::SpaceInformation>(space);
  information->setStateValidityChecker([&](const ob::State* state) {
    return stands_free(task.space, task.vehicle, ProvedMotions::pose(state));
  });
  information->setMotionValidator(std::make_shared<ProvedMotions>(information, task));
  information->setup();
  const auto definition = std::make_shared<ob::ProblemDefinition>(information);
  ob::ScopedState<ob::SE2StateSpace> start(space), goal(space);
  const auto set = [](auto& state, const Pose& pose) {
    state->setXY(pose.position.x(), pose.position.y());
    state->setYaw(pose.heading);
  };
  set(start, task.start);
  set(goal, task.goal);
  definition->setStartAndGoalStates(start, goal);
  ompl::geometric::RRTConnect planner(information);
  planner.setProblemDefinition(definition);
  planner.setup();
  const auto begin = Clock::now();
  const bool solved = planner.ob::Planner::solve(time_limit) == ob::PlannerStatus::EXACT_SOLUTION;
  FirstPath result{micros_since(begin)};
  if (solved) result.length = definition->getSolutionPath()->length();
  return result;
}

void compare_with_peer(const Arguments& args) {
  ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
  ompl::RNG::setSeed(args.seed);
  std::puts("HybridAStar / OMPL RRT-Connect over Reeds-Shepp, medians of scenes that both solve");
  std::puts("| scenes | solved | OMPL solved | ms | OMPL ms | time ratio | length ratio |");
  std::puts("|---|---|---|---|---|---|---|");
  std::vector<double> all_times, all_lengths;
  for (const Family& family : families) {
    Random random(args.seed);
    HybridAStar::Scratch scratch;
    std::size_t ours_solved = 0, theirs_solved = 0;
    std::vector<double> ours_ms, theirs_ms, times, lengths;
    for (std::size_t i = 0; i < args.scenes; ++i) {
      const VehicleTask task = family.make(random);
      FirstPath ours, theirs;
      std::vector<double> ours_rounds, theirs_rounds, their_lengths;
      for (std::size_t round = 0; round < args.rounds; ++round) {
        ours = search_ours(task, scratch);
        theirs = search_ompl(task, args.time_limit);
        ours_rounds.push_back(ours.micros);
        theirs_rounds.push_back(theirs.micros);
        their_lengths.push_back(theirs.length);
      }
      ours_ms.push_back(median(ours_rounds) / 1000);
      theirs_ms.push_back(median(theirs_rounds) / 1000);
      theirs.length = median(their_lengths);
      if (std::isfinite(ours.length)) ++ours_solved;
      if (std::isfinite(theirs.length)) ++theirs_solved;
      if (!std::isfinite(ours.length) || !std::isfinite(theirs.length)) continue;
      times.push_back(ours_ms.back() / theirs_ms.back());
      lengths.push_back(ours.length / theirs.length);
    }
    std::printf("| %s | %zu of %zu | %zu | %.2f | %.2f | %.3f | %.3f |\n", family.name.data(),
                ours_solved, args.scenes, theirs_solved, median(ours_ms), median(theirs_ms),
                median(times), median(lengths));
    all_times.insert(all_times.end(), times.begin(), times.end());
    all_lengths.insert(all_lengths.end(), lengths.begin(), lengths.end());
  }
  std::printf("| all | | | | | %.3f | %.3f |\n", median(all_times), median(all_lengths));
}

#endif

/// Whether a breadth-first search over fine states reaches the goal: 64 headings, moves of a tenth
/// of the turning radius, and drives to the goal from every state near it.
bool exhaustive_search(const VehicleTask& task) {
  constexpr int headings = 64;
  const double step = 2 * pi / headings, radius = task.vehicle.min_turning_radius;
  const double length = radius * step, cell = length / std::numbers::sqrt2;
  detail::FootprintTest footprint(task.vehicle);
  struct State {
    Point position;
    int heading;
  };
  std::deque<State> open{{task.start.position, 0}};
  std::set<std::tuple<int, int, int>> seen;
  const auto is_new = [&](const State& s) {
    const Point offset = s.position - task.start.position;
    return seen
        .emplace(static_cast<int>(std::floor(offset.x() / cell + 0.5)),
                 static_cast<int>(std::floor(offset.y() / cell + 0.5)), s.heading)
        .second;
  };
  is_new(open.front());
  while (!open.empty()) {
    const State s = open.front();
    open.pop_front();
    const Pose pose{s.position, task.start.heading + s.heading * step};
    if (distance(s.position, task.goal.position) < 6 * radius) {
      bool reached = false;
      for_each_reeds_shepp_word(pose, task.goal, radius, [&](const SteeringWord& word) {
        reached =
            reached || footprint.is_free(task.space, vehicle_path(word, pose, task.goal, radius));
      });
      if (reached) return true;
    }
    for (const double way : {length, -length}) {
      for (const int side : {-1, 0, 1}) {
        const Gear gear = detail::gear_of(way);
        VehiclePath move;
        State next = s;
        if (side == 0) {
          next.position = detail::offset_along(
              s.position, way, Point{std::cos(pose.heading), std::sin(pose.heading)});
          move.push_back(Segment{s.position, next.position}, gear);
        } else {
          const Arc arc =
              detail::turn_from(pose, {static_cast<Steering>(side), way / radius}, radius);
          next.position = arc.b;
          next.heading = (s.heading + (way > 0 ? 1 : -1) * side + headings) % headings;
          move.push_back(arc, gear);
        }
        if (!task.space.bounds().contains(next.position) || !footprint.is_free(task.space, move)) {
          continue;
        }
        if (is_new(next)) open.push_back(next);
      }
    }
  }
  return false;
}

/// Small worlds: how many of those that the exhaustive search solves are solved.
void share_solved(const Arguments& args) {
  Random random(args.seed);
  HybridAStar::Scratch scratch;
  std::size_t both = 0, missed = 0, more = 0, neither = 0;
  for (std::size_t i = 0; i < args.worlds; ++i) {
    Workspace world = polygon_yard(random, 12, 8 + random.below(8), 0.5, 2);
    world.safety_radius = 0.1;
    const Vehicle vehicle =
        i % 2 == 0 ? Vehicle::disc(0.3, 1.2, true) : Vehicle::car(1.6, 0.8, 1, 1.2, true, 0.08);
    const VehicleTask task = in_yard(vehicle, std::move(world), random);
    const bool ours = std::isfinite(search_ours(task, scratch).length);
    const bool exists = exhaustive_search(task);
    (ours ? (exists ? both : more) : (exists ? missed : neither)) += 1;
    if (!ours && exists) std::printf("missed: world %zu\n", i);
  }
  const double share = both + missed > 0
                           ? 100.0 * static_cast<double>(both) / static_cast<double>(both + missed)
                           : 100.0;
  std::printf(
      "%zu worlds, half a disc and half a car: an exhaustive search solves %zu, of which "
      "%.2f %% are solved; %zu more are solved, %zu by neither\n",
      args.worlds, both + missed, share, more, neither);
}

/// The plans of parking: search, shortcut and proof.
void park(const Arguments& args) {
  std::puts("| parking | search ms | shortcut ms | length m | cusps | clearance m |");
  std::puts("|---|---|---|---|---|---|");
  for (const auto& [name, make] :
       {Family{"into a gap of 6 m", &gap}, Family{"into a bay of 2.6 m", &bay}}) {
    Random random(args.seed);
    VehicleTask task = make(random);
    task.start = {{-8, 1.5}, 0};
    HybridAStar::Scratch scratch;
    NoObserver no_observer;
    const HybridAStar search{.vehicle = task.vehicle};
    std::vector<double> search_ms, shortcut_ms;
    VehiclePath path;
    for (std::size_t round = 0; round < args.rounds; ++round) {
      auto start = Clock::now();
      const auto route =
          bench::value_or_throw(search.search(task.space, task.query(), scratch, no_observer));
      search_ms.push_back(micros_since(start) / 1000);
      start = Clock::now();
      path = bench::value_or_throw(
          VehicleShortcut{}.smooth(task.space, task.vehicle, {route.curve, route.gears}, {}));
      shortcut_ms.push_back(micros_since(start) / 1000);
    }
    const VehicleCertificate proof = certify(task.space, task.vehicle, path);
    std::printf("| %s | %.1f | %.1f | %.2f | %zu | %.3f (%s) |\n", name.data(), median(search_ms),
                median(shortcut_ms), path.length(), path.cusps().size(), proof.clearance.lower,
                to_string(proof.status).data());
  }
}

/// Paths of continuous curvature, at full lock within a turning radius, beside shortcuts.
void make_continuous(const Arguments& args) {
  std::puts("| scenes | routes | made continuous | ms | shortcut ms | length ratio | cusp ratio |");
  std::puts("|---|---|---|---|---|---|---|");
  for (const Family& family : families) {
    Random random(args.seed);
    HybridAStar::Scratch scratch;
    NoObserver no_observer;
    std::size_t routes = 0, cusps = 0, shortcut_cusps = 0;
    std::vector<double> times, shortcut_times, lengths;
    for (std::size_t i = 0; i < args.scenes; ++i) {
      const VehicleTask task = family.make(random);
      const HybridAStar search{.vehicle = task.vehicle};
      const auto route = search.search(task.space, task.query(), scratch, no_observer);
      if (!route) continue;
      ++routes;
      const VehiclePath path{route->curve, route->gears};
      auto start = Clock::now();
      const auto shortcut =
          bench::value_or_throw(VehicleShortcut{}.smooth(task.space, task.vehicle, path, {}));
      shortcut_times.push_back(micros_since(start) / 1000);
      start = Clock::now();
      const auto continuous = ContinuousCurvature{}.smooth(task.space, task.vehicle, path, {});
      times.push_back(micros_since(start) / 1000);
      if (!continuous) continue;
      if (certify(task.space, task.vehicle, *continuous).status != ProofStatus::proved) {
        throw std::runtime_error("a path of continuous curvature is not proved");
      }
      lengths.push_back(continuous->length() / shortcut.length());
      cusps += continuous->cusps().size();
      shortcut_cusps += shortcut.cusps().size();
    }
    std::printf("| %s | %zu | %zu | %.1f | %.1f | %.3f | %zu / %zu |\n", family.name.data(), routes,
                lengths.size(), median(times), median(shortcut_times), median(lengths), cusps,
                shortcut_cusps);
  }
}

int run(const Arguments& args) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  for (const std::string& table : args.tables) {
    if (table == "share") {
      share_solved(args);
    } else if (table == "parking") {
      park(args);
    } else if (table == "continuous") {
      make_continuous(args);
    } else {
#ifdef TUTAVIA_WITH_OMPL
      compare_with_peer(args);
#else
      std::puts("built without OMPL (libompl-dev): nothing to compare with");
#endif
    }
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments args;
  CLI::App app("Paths of vehicles beside OMPL's and an exhaustive search",
               "tutavia-bench-vehicles");
  app.add_option("--tables", args.tables, "peers, share, parking, continuous; a comma list")
      ->delimiter(',')
      ->check(CLI::IsMember({"peers", "share", "parking", "continuous"}));
  app.add_option("--scenes", args.scenes, "Of each of three kinds")->capture_default_str();
  app.add_option("--worlds", args.worlds, "For the share that is solved")->capture_default_str();
  app.add_option("--rounds", args.rounds, "Of which medians are taken")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--seed", args.seed, "Of scenes and worlds")->capture_default_str();
  app.add_option("--time-limit", args.time_limit, "Of OMPL [s]")->capture_default_str();
  return bench::run_program(app, argc, argv, [&] { return run(args); });
}
