// SPDX-License-Identifier: MIT
// Plans among cells, to the exact checker.
#include "tutavia/space/cell_space.hpp"

#include <cstddef>
#include <cstdint>
#include <variant>

#include "support/catch.hpp"
#include "support/cell_oracle.hpp"
#include "support/cell_world.hpp"
#include "support/exact_checker.hpp"
#include "support/random_cells.hpp"
#include "support/scale.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "tutavia/smooth/shortcut.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::test;

/// The exact verdict on each piece among the obstacles near it; the others cannot matter.
ExactVerdict exact_verdict(const Workspace& world, const Curve& curve) {
  ExactVerdict verdict = ExactVerdict::free;
  for (const Piece& piece : curve.pieces()) {
    Box box = piece.visit([](const auto& any) { return any.box(); });
    box = box.inflated(1.001 * world.safety_radius + 1e-6 * world.bounds.width());
    Workspace near = world;
    std::erase_if(near.obstacles, [&](const Obstacle& obstacle) {
      const Ring& ring = std::get<Polygon>(obstacle).outer;  // a rectangle
      return ring[0].x() > box.max.x() || ring[2].x() < box.min.x() || ring[0].y() > box.max.y() ||
             ring[2].y() < box.min.y();
    });
    const ExactVerdict one = ExactChecker(near).check(piece);
    if (one == ExactVerdict::blocked) return one;
    if (one == ExactVerdict::unknown) verdict = one;
  }
  return verdict;
}

template <class Smooth>
void check_plans(const Smooth& smoother, std::uint64_t seed, std::size_t rounds) {
  Planner planner(AStar{}, smoother);
  std::size_t plans = 0, at_contact = 0, unknown = 0;
  INFO(Smooth::name);
  on_random_cells({.seed = seed, .rounds = rounds, .at_contact_every = 3}, [&](const CellTrial& t) {
    const CellSpace& space = t.space;
    const Squares& squares = t.squares;
    const Workspace world = world_of_cells(space);
    const Rational limit = squared_radius(space);
    for (int i = 0; i < 4; ++i) {
      const Place from = squares.random_place(t.random), to = squares.random_place(t.random);
      if (!squares.is_free(from, from, limit) || !squares.is_free(to, to, limit)) continue;
      const Point start = point_at(space, from), goal = point_at(space, to);
      const auto plan = planner.plan(space, {.start = start, .goal = goal});
      if (!plan) {
        if (plan.error().code == PlanError::not_proved) FAIL_CHECK("a route that is not proved");
        continue;
      }
      INFO("from " << start.transpose() << " to " << goal.transpose());
      ++plans;
      if (space.safety_radius() == 0) ++at_contact;
      CHECK(plan->curve.start() == start);
      CHECK(plan->curve.end() == goal);
      CHECK(plan->certificate.status == ProofStatus::proved);
      CHECK(plan->certificate.lower >= space.safety_radius());
      const ExactVerdict verdict = exact_verdict(world, plan->curve);
      CHECK(verdict != ExactVerdict::blocked);
      if (verdict == ExactVerdict::unknown) ++unknown;
    }
  });
  CHECK(plans > rounds / 2);
  CHECK(at_contact > rounds / 8);
  CHECK(unknown == 0);
}

TEST_CASE("plans among cells are proved and free to the exact checker") {
  check_plans(NoSmoothing{}, 12, scaled(250));
}

TEST_CASE("plans among cells with shortcuts are proved and free to the exact checker") {
  check_plans(Shortcut{}, 13, scaled(250));
}

TEST_CASE("plans among cells with smooth corners are proved and free to the exact checker") {
  check_plans(DeltaSmoother{}, 14, scaled(250));
}

}  // namespace
