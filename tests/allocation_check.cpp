// SPDX-License-Identifier: MIT
/// \file
/// Counts allocations: a program of its own, because it replaces operator new.

#include <cstdio>
#include <cstdlib>
#include <new>
#include <vector>

#include "tutavia/certify/certify.hpp"
#include "tutavia/motion/local_planner.hpp"
#include "tutavia/motion/path_follower.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/bidirectional_astar.hpp"
#include "tutavia/search/canonical_astar.hpp"
#include "tutavia/search/dijkstra.hpp"
#include "tutavia/search/jps.hpp"
#include "tutavia/search/penalty_astar.hpp"
#include "tutavia/search/weighted_astar.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/space/lattice_space.hpp"
#include "tutavia/world/maps.hpp"

namespace {

std::size_t allocations = 0;

void* allocate(std::size_t size, std::size_t alignment) {
  ++allocations;
  void* memory = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

// Inlined into a destructor, it looks to g++ as if free met memory of operator new.
[[gnu::noinline]] void release(void* memory) noexcept { std::free(memory); }

}  // namespace

void* operator new(std::size_t size) { return allocate(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }

namespace {

using namespace tutavia;

int failures = 0;

/// Says what was wrong; a run without failures says nothing.
void require(bool holds, const char* what, const char* why) {
  if (holds) return;
  std::fprintf(stderr, "%s: %s\n", what, why);
  ++failures;
}

void expect(const char* what, std::size_t counted, std::size_t allowed) {
  if (counted <= allowed) return;
  std::fprintf(stderr, "%s: %zu allocations, %zu allowed\n", what, counted, allowed);
  ++failures;
}

template <class A>
void check_search(const char* what, const LatticeSpace& space, const Scene& scene) {
  typename A::Scratch scratch;
  NoObserver no_observer;
  const Query query{.start = scene.start, .goal = scene.goals[0]};
  std::size_t cold = allocations;
  (void)A{}.search(space, query, scratch, no_observer);
  cold = allocations - cold;
  std::size_t warm = allocations;
  const auto route = A{}.search(space, query, scratch, no_observer);
  warm = allocations - warm;
  require(route.has_value(), what, "no route");
  if (!route) return;
  require(cold > warm, what, "the first query allocates no more than the second");
  expect(what, warm, 2);  // the route's pieces and their lengths

  const std::size_t before = allocations;
  const Certificate certificate = certify(space, route->curve);
  require(certificate.status == ProofStatus::proved, what, "a route that is not proved");
  expect("certificate", allocations - before, 0);
}

/// A robot on a path of 36 m with bends, among 20 obstacles beside it: some move along it, and all
/// leave it room.
struct Hall {
  Hall() {
    for (int i = 0; i < 20; ++i) {
      const double x = -18 + 1.9 * i, y = i % 2 == 0 ? 2.6 : -2.6;
      const Polygon box{{{x, y}, {x + 0.4, y}, {x + 0.4, y + 0.3}, {x, y + 0.3}}};
      const Obstacle shape = i % 3 == 0 ? Obstacle(box) : Obstacle(Disc{{x, y}, 0.3});
      obstacles.push_back({shape, {i % 4 == 0 ? 0.05 : 0, 0}});
    }
  }

  InflatedSpace space =
      InflatedSpace::build({.bounds = {{-30, -10}, {30, 10}},
                            .safety_radius = 0.3,
                            .obstacles = {Disc{{-10, -1.2}, 0.2}, Disc{{0, 1.2}, 0.2}}})
          .value();
  std::vector<Point> corners{{-18, 0}, {-9, 0.5}, {0, -0.5}, {9, 0.5}, {18, 0}};
  std::vector<MovingObstacle> obstacles;
  Pose pose{{-18, 0}, 0};

  /// One period.
  void pass(const Twist& twist) {
    pose = moved(pose, twist, 0.1);
    for (MovingObstacle& o : obstacles) {
      const Point by = 0.1 * o.velocity;
      if (Disc* disc = std::get_if<Disc>(&o.shape)) disc->center += by;
      if (Polygon* polygon = std::get_if<Polygon>(&o.shape)) {
        for (Point& p : polygon->outer) p += by;
      }
    }
  }
};

/// How many allocations a drive to the end of the path takes, without those of the first second and
/// of steps that search detours.
template <class C>
std::size_t allocations_of_drive(const char* what, C& controller) {
  Hall hall;
  (void)controller.follow(Curve::polyline(hall.corners));
  std::size_t counted = 0, steps = 0;
  bool arrived = false;
  for (int i = 0; i < 2000 && !arrived; ++i) {
    const std::size_t before = allocations;
    const DriveCommand command = controller.step(hall.pose, hall.obstacles);
    bool counts = i >= 10;
    if constexpr (requires { controller.report(); }) {
      counts = counts && !controller.report().searched;
    }
    if (counts) {
      counted += allocations - before;
      ++steps;
    }
    arrived = command.status == DriveStatus::arrived;
    hall.pass(command.twist);
  }
  require(arrived, what, "did not arrive");
  require(steps > 500, what, "few steps");
  return counted;
}

/// Memory grows in the first drive with what is near; the second one needs no more.
template <class C>
void check_controller(const char* what, C controller, std::size_t allowed_at_first) {
  expect(what, allocations_of_drive(what, controller), allowed_at_first);
  expect(what, allocations_of_drive(what, controller), 0);
}

void check_gate() {
  Hall hall;
  auto gate = MotionGate<InflatedSpace>::build(hall.space, {.latency = 0.15}).value();
  const std::size_t before = allocations;
  double driven = 0;
  for (int i = 0; i < 400; ++i) {
    const DriveCommand command =
        gate.command(hall.pose, {0.4, i % 40 < 20 ? 0.1 : -0.1}, hall.obstacles);
    driven += 0.1 * command.twist.v;
    hall.pass(command.twist);
  }
  expect("gate", allocations - before, 0);
  require(driven > 1, "gate", "does not drive");
}

void check_band() {
  const Hall hall;
  const TimedElasticBand teb;
  TimedElasticBand::Scratch scratch;
  const Curve path = Curve::polyline(hall.corners);
  Band band;
  std::size_t counted = 0;
  for (int i = 0; i < 120; ++i) {
    const std::size_t before = allocations;
    const double from = 0.5 * (i % 60);
    teb.lay(path, from, from + 3, {path.point(from), 0}, band);
    const auto report = teb.optimize(hall.space, hall.obstacles, {.end = Twist{}}, band, scratch);
    require(report.has_value(), "band", "refused");
    // The first half meets all obstacles that there are.
    if (i >= 60) counted += allocations - before;
  }
  expect("band", counted, 0);
}

void check_controllers() {
  const Hall hall;
  check_controller("local planner", LocalPlanner<InflatedSpace>::build(hall.space).value(), 20);
  check_controller("path follower", PathFollower<InflatedSpace>::build(hall.space).value(), 0);
  check_gate();
  check_band();
}

}  // namespace

int main() {
  for (const Scene& scene : {maps::array(), maps::complex(), maps::maze()}) {
    const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.2}).value();
    check_search<AStar>("A*, second query", space, scene);
    check_search<Dijkstra>("Dijkstra, second query", space, scene);
    check_search<WeightedAStar>("weighted A*, second query", space, scene);
    check_search<CanonicalAStar>("canonical A*, second query", space, scene);
    check_search<BidirectionalAStar>("bidirectional A*, second query", space, scene);
    check_search<PenaltyAStar>("penalty A*, second query", space, scene);
    check_search<Jps>("JPS, second query", space, scene);
  }
  check_controllers();
  return failures == 0 ? 0 : 1;
}
