// SPDX-License-Identifier: MIT
/// \file
/// Searches by sampling: beside OMPL's on the same scenes with the same exact test of segments, how
/// near they come to the shortest path, and the method of the RRT* paper stage by stage.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "program.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/io/moving_ai.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/informed_rrt_star.hpp"
#include "tutavia/search/rrt.hpp"
#include "tutavia/search/rrt_connect.hpp"
#include "tutavia/search/rrt_star.hpp"
#include "tutavia/search/safe_rrt_star.hpp"
#include "tutavia/search/tangent_graph.hpp"
#include "tutavia/smooth/b_spline_smoother.hpp"
#include "tutavia/smooth/redundant_node_removal.hpp"
#include "tutavia/smooth/shortcut.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/world/maps.hpp"

#ifdef TUTAVIA_WITH_OMPL
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>
#endif

namespace {

using namespace tutavia;
using bench::Clock;
using bench::micros_since;
using bench::UsageError;
using bench::value_or_throw;

struct Arguments {
  std::vector<std::string> tables{"peers", "convergence", "paper"};
  std::size_t seeds = 20, paper_seeds = 50;
  std::uint32_t iterations = 3000;
};

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

/// Times and lengths of one planner, seed by seed.
struct Runs {
  std::vector<double> micros, lengths;
  std::size_t failed = 0;

  void add(double time, double length) {
    micros.push_back(time);
    lengths.push_back(length);
  }
};

/// How many routes were not proved: none should be.
std::size_t unproved = 0;

template <class A, class S>
std::optional<Route> run(const A& algorithm, const S& space, const Query& query, Runs& runs) {
  typename A::Scratch scratch;
  NoObserver no_observer;
  const auto begin = Clock::now();
  auto route = algorithm.search(space, query, scratch, no_observer);
  const double time = micros_since(begin);
  if (!route) {
    ++runs.failed;
    return std::nullopt;
  }
  if (certify(space, route->curve).status != ProofStatus::proved) ++unproved;
  runs.add(time, route->curve.length());
  return std::move(*route);
}

/// A scene of the RRT* paper for a robot of 1 m.
Scene robot_scene(Scene scene) {
  scene.workspace.safety_radius = 1;
  return scene;
}

#ifdef TUTAVIA_WITH_OMPL

namespace ob = ompl::base;
namespace og = ompl::geometric;

Point point_of(const ob::State* state) {
  const auto* values = state->as<ob::RealVectorStateSpace::StateType>();
  return {(*values)[0], (*values)[1]};
}

/// The library's exact test, for OMPL.
template <class S>
class ExactMotions : public ob::MotionValidator {
 public:
  ExactMotions(const ob::SpaceInformationPtr& information, const S& space)
      : ob::MotionValidator(information), space_(space) {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    return space_.segment_free(point_of(from), point_of(to));
  }
  bool checkMotion(const ob::State*, const ob::State*,
                   std::pair<ob::State*, double>&) const override {
    throw UsageError{"a planner asks how far a motion is free"};
  }

 private:
  const S& space_;
};

/// One query, put to OMPL; motions are tested exactly, or at points 1 % of the extent apart, which
/// is OMPL's default.
template <class S>
class Peer {
 public:
  Peer(const S& space, const Query& query, bool exact)
      : space_(std::make_shared<ob::RealVectorStateSpace>(2)) {
    ob::RealVectorBounds bounds(2);
    for (unsigned axis = 0; axis < 2; ++axis) {
      bounds.setLow(axis, space.bounds().min[axis]);
      bounds.setHigh(axis, space.bounds().max[axis]);
    }
    space_->setBounds(bounds);
    information_ = std::make_shared<ob::SpaceInformation>(space_);
    information_->setStateValidityChecker(
        [&space](const ob::State* state) { return space.is_free(point_of(state)); });
    if (exact) {
      information_->setMotionValidator(std::make_shared<ExactMotions<S>>(information_, space));
    }
    information_->setup();
    problem_ = std::make_shared<ob::ProblemDefinition>(information_);
    ob::ScopedState<ob::RealVectorStateSpace> start(space_), goal(space_);
    for (unsigned axis = 0; axis < 2; ++axis) {
      start[axis] = query.start[axis];
      goal[axis] = query.goal[axis];
    }
    problem_->setStartAndGoalStates(start, goal);
    problem_->setOptimizationObjective(
        std::make_shared<ob::PathLengthOptimizationObjective>(information_));
  }

  template <class P>
  std::shared_ptr<P> planner() const {
    auto planner = std::make_shared<P>(information_);
    planner->setProblemDefinition(problem_);
    return planner;
  }

  /// The path after so many iterations at most, or none.
  og::PathGeometric* solve(ob::Planner& planner, std::uint32_t iterations, Runs& runs) const {
    planner.setup();
    std::uint32_t done = 0;
    const ob::PlannerTerminationCondition end([&] { return done++ >= iterations; });
    const auto begin = Clock::now();
    planner.solve(end);
    const double time = micros_since(begin);
    if (!problem_->hasExactSolution()) {
      ++runs.failed;
      return nullptr;
    }
    auto* path = problem_->getSolutionPath()->as<og::PathGeometric>();
    runs.add(time, path->length());
    return path;
  }

  const ob::SpaceInformationPtr& information() const { return information_; }

 private:
  std::shared_ptr<ob::RealVectorStateSpace> space_;
  ob::SpaceInformationPtr information_;
  ob::ProblemDefinitionPtr problem_;
};

void print_peers(const char* label, const Runs& own, const Runs& peer) {
  std::printf("  %-42s %9.0f / %9.0f us = %.3f   length %.4f / %.4f = %.4f   failed %zu / %zu\n",
              label, median(own.micros), median(peer.micros),
              median(own.micros) / median(peer.micros), median(own.lengths), median(peer.lengths),
              median(own.lengths) / median(peer.lengths), own.failed, peer.failed);
  std::fflush(stdout);
}

/// Both planners with every seed, one after the other.
template <class A, class P, class S, class Configure>
void compare(const char* label, const A& algorithm, const S& space, Query query,
             const Arguments& args, std::uint32_t iterations, const Configure& configure) {
  Runs own, other;
  for (query.seed = 1; query.seed <= args.seeds; ++query.seed) {
    run(algorithm, space, query, own);
    const Peer<S> peer(space, query, true);
    const auto planner = peer.template planner<P>();
    configure(*planner);
    peer.solve(*planner, iterations, other);
  }
  print_peers(label, own, other);
}

/// What becomes of the same paths: redundant nodes and shortcuts here, simplifyMax there.
template <class S>
void compare_simplifiers(const S& space, Query query, const Arguments& args) {
  Runs own, other, ignored;
  for (query.seed = 1; query.seed <= args.seeds; ++query.seed) {
    const auto route = run(Rrt{}, space, query, ignored);
    if (!route) continue;
    auto begin = Clock::now();
    const Curve pruned = value_or_throw(RedundantNodeRemoval{}.smooth(space, route->curve, {}));
    const Curve shorter = value_or_throw(Shortcut{}.smooth(space, pruned, {}));
    own.add(micros_since(begin), shorter.length());
    const Peer<S> peer(space, query, true);
    og::PathGeometric path(peer.information());
    for (const Point& p : waypoints(route->curve)) {
      ob::ScopedState<ob::RealVectorStateSpace> state(peer.information()->getStateSpace());
      state[0] = p.x(), state[1] = p.y();
      path.append(state.get());
    }
    og::PathSimplifier simplifier(peer.information());
    begin = Clock::now();
    simplifier.simplifyMax(path);
    other.add(micros_since(begin), path.length());
  }
  print_peers("simplifying a path of RRT", own, other);
}

/// How many of OMPL's own simplified paths leave free space, by its default test of motions.
template <class S>
void count_violations(const S& space, Query query, const Arguments& args) {
  std::size_t paths = 0, violated = 0;
  Runs ignored;
  for (std::size_t i = 0; i < args.seeds; ++i) {
    const Peer<S> peer(space, query, false);
    const auto planner = peer.template planner<og::RRT>();
    og::PathGeometric* path = peer.solve(*planner, 100000, ignored);
    if (path == nullptr) continue;
    og::PathSimplifier(peer.information()).simplifyMax(*path);
    ++paths;
    bool free = true;
    for (std::size_t k = 1; k < path->getStateCount(); ++k) {
      free = free && space.segment_free(point_of(path->getState(static_cast<unsigned>(k - 1))),
                                        point_of(path->getState(static_cast<unsigned>(k))));
    }
    if (!free) ++violated;
  }
  std::printf(
      "  RRT and simplifyMax of OMPL with its default test of motions: %zu of %zu paths "
      "leave free space\n",
      violated, paths);
}

template <class S>
void compare_on(const std::string& name, const S& space, const Query& query,
                const Arguments& args) {
  const double step = detail::default_step(space.bounds()), wide = 5 * step;
  std::printf("%s: steps of %g m (wide: %g m), N = %u, %zu seeds; tutavia / OMPL, medians\n",
              name.c_str(), step, wide, args.iterations, args.seeds);
  const std::uint32_t n = args.iterations;
  compare<RrtStar, og::RRTstar>("RRT*, radius rule, factor 1.1",
                                {.max_iterations = n, .neighbours = Neighbours::radius}, space,
                                query, args, n, [&](og::RRTstar& peer) {
                                  peer.setRange(step);
                                  peer.setKNearest(false);
                                  peer.setRewireFactor(1.1);
                                });
  // OMPL's k is 2^d e (1 + 1/d) ln n times its factor, twice over in the plane: 8 times the book's.
  compare<RrtStar, og::RRTstar>("RRT*, k = 1.1 e 1.5 ln n, wide steps",
                                {.step = wide, .max_iterations = n}, space, query, args, n,
                                [&](og::RRTstar& peer) {
                                  peer.setRange(wide);
                                  peer.setRewireFactor(1.1 / 8);
                                });
  compare<RrtStar, og::RRTstar>("RRT*, defaults (OMPL: k = 8.8 e 1.5 ln n)", {.max_iterations = n},
                                space, query, args, n, [](og::RRTstar&) {});
  compare<Rrt, og::RRT>("RRT", {.max_iterations = 100000}, space, query, args, 100000,
                        [&](og::RRT& peer) { peer.setRange(step); });
  compare<RrtConnect, og::RRTConnect>("RRT-Connect", {.max_iterations = 100000}, space, query, args,
                                      100000, [&](og::RRTConnect& peer) { peer.setRange(step); });
  compare_simplifiers(space, query, args);
  count_violations(space, query, args);
}

void compare_all(const Arguments& args) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  ompl::RNG::setSeed(1);
  for (const Scene& scene :
       {robot_scene(maps::rrt_scene_1()), robot_scene(maps::rrt_scene_2()), maps::array()}) {
    compare_on(scene.name, value_or_throw(InflatedSpace::build(scene.workspace)),
               {.start = scene.start, .goal = scene.goals.back()}, args);
  }
  const char* folder = std::getenv("TUTAVIA_MOVINGAI_DIR");
  if (folder == nullptr) {
    std::puts("arena2 is left out: TUTAVIA_MOVINGAI_DIR is not set");
    return;
  }
  const auto cells = value_or_throw(read_moving_ai_map(std::string(folder) + "/arena2.map"));
  compare_on("arena2", value_or_throw(CellSpace::build(cells, {.safety_radius = 0.4})),
             {.start = {100.5, 162.5}, .goal = {227.5, 163.5}}, args);
}

#else

void compare_all(const Arguments&) {
  std::puts("built without OMPL (libompl-dev): nothing to compare with");
}

#endif

template <class A>
void print_convergence(const char* label, const Arguments& args, const InflatedSpace& space,
                       Query query, double optimum, A algorithm) {
  std::printf("  %-26s", label);
  for (const std::uint32_t iterations : {1000u, 3000u, 10000u, 30000u}) {
    algorithm.max_iterations = iterations;
    Runs runs;
    for (query.seed = 1; query.seed <= args.seeds; ++query.seed) {
      run(algorithm, space, query, runs);
    }
    std::printf("  %.4f (%.1f ms)", median(runs.lengths) / optimum, median(runs.micros) / 1000);
    std::fflush(stdout);
  }
  std::puts("");
}

void show_convergence(const Arguments& args) {
  std::printf(
      "length / shortest path (and time) after 1,000, 3,000, 10,000, 30,000 iterations, "
      "medians over %zu seeds\n",
      args.seeds);
  for (const Scene& scene : {robot_scene(maps::rrt_scene_1()), robot_scene(maps::rrt_scene_2())}) {
    const auto space = value_or_throw(InflatedSpace::build(scene.workspace));
    const Query query{.start = scene.start, .goal = scene.goals[0]};
    TangentGraph::Scratch scratch;
    NoObserver no_observer;
    const double optimum =
        value_or_throw(TangentGraph{}.search(space, query, scratch, no_observer)).cost;
    std::printf("%s, robot of 1 m: %.4f m\n", scene.name.c_str(), optimum);
    print_convergence("RRT*, k nearest", args, space, query, optimum, RrtStar{});
    print_convergence("RRT*, radius", args, space, query, optimum,
                      RrtStar{.neighbours = Neighbours::radius});
    print_convergence("Informed RRT*, k nearest", args, space, query, optimum, InformedRrtStar{});
    print_convergence("Informed RRT*, radius", args, space, query, optimum,
                      InformedRrtStar{.neighbours = Neighbours::radius});
  }
}

/// One row of the RRT* paper's tables: a search, and a smoother after it.
template <class A, class Smooth>
void print_stage(const char* label, const Arguments& args, const Scene& scene, const A& algorithm,
                 const Smooth& smoother) {
  const auto space = value_or_throw(InflatedSpace::build(scene.workspace));
  const RiskZone zone = SafeRrtStar{}.zone(space);
  Planner planner{algorithm, smoother};
  Query query{.start = scene.start, .goal = scene.goals[0]};
  Runs runs;
  std::vector<double> grey, clearance, turning;
  std::size_t fell_back = 0;
  for (query.seed = 1; query.seed <= args.paper_seeds; ++query.seed) {
    const auto plan = planner.plan(space, query);
    if (!plan) {
      ++runs.failed;
      continue;
    }
    runs.add(plan->stats.search_us + plan->stats.smooth_us, plan->metrics.length);
    grey.push_back(zone.length_inside(space, plan->curve).value);
    clearance.push_back(plan->certificate.lower);
    turning.push_back(plan->metrics.turning_angle);
    if (plan->fell_back) ++fell_back;
  }
  std::printf(
      "  %-44s %8.3f ms %9.3f m %8.3f m in grey, clearance %.3f m, turning %.2f rad, "
      "%zu fell back, %zu failed\n",
      label, median(runs.micros) / 1000, median(runs.lengths), median(grey), median(clearance),
      median(turning), fell_back, runs.failed);
  std::fflush(stdout);
}

void show_paper(const Arguments& args) {
  std::printf(
      "the RRT* paper's tables 1 and 2: a point, risk zones of 2 m, N = %u, medians over "
      "%zu seeds\n",
      args.iterations, args.paper_seeds);
  const std::uint32_t n = args.iterations;
  for (const Scene& scene : {maps::rrt_scene_1(), maps::rrt_scene_2()}) {
    std::printf("%s\n", scene.name.c_str());
    print_stage("RRT", args, scene, Rrt{.max_iterations = n}, NoSmoothing{});
    print_stage("RRT*", args, scene, RrtStar{.max_iterations = n}, NoSmoothing{});
    print_stage("RRT* outside risk zones", args, scene,
                SafeRrtStar{.max_iterations = n, .prune = false}, NoSmoothing{});
    print_stage("improved: and redundant nodes removed", args, scene,
                SafeRrtStar{.max_iterations = n}, NoSmoothing{});
    print_stage("proposed: and a cubic B-spline", args, scene, SafeRrtStar{.max_iterations = n},
                BSplineSmoother{.prune = false});
  }
}

int run(const Arguments& args) {
  for (const std::string& table : args.tables) {
    if (table == "peers") compare_all(args);
    if (table == "convergence") show_convergence(args);
    if (table == "paper") show_paper(args);
  }
  if (unproved > 0) std::printf("%zu routes were not proved\n", unproved);
  return unproved > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments args;
  CLI::App app("Searches by sampling, beside OMPL's and the shortest path",
               "tutavia-bench-sampling");
  app.add_option("--tables", args.tables, "peers, convergence, paper")
      ->delimiter(',')
      ->check(CLI::IsMember({"peers", "convergence", "paper"}));
  app.add_option("--seeds", args.seeds, "Per planner and scene")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--paper-seeds", args.paper_seeds, "Per row of the paper's tables")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--iterations", args.iterations, "N")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  return bench::run_program(app, argc, argv, [&] { return run(args); });
}
