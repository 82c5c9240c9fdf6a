// SPDX-License-Identifier: MIT
#include "tutavia/certify/revalidate.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/exact_checker.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/smooth/bezier_smoother.hpp"
#include "tutavia/smooth/clothoid_smoother.hpp"
#include "tutavia/smooth/taut_string.hpp"
#include "tutavia/space/lattice_space.hpp"
#include "tutavia/world/changed_boxes.hpp"

namespace {

using namespace tutavia;
using test::ExactVerdict;

/// A room of 10 x 4 m with discs above and below its middle line, and the way through it.
Workspace room_with_discs() {
  return {.bounds = {{0, 0}, {10, 4}},
          .safety_radius = 0.3,
          .obstacles = {Disc{{2, 3}, 0.5}, Disc{{5, 0.9}, 0.5}, Disc{{8, 3.2}, 0.5}}};
}
Curve way_through_room() {
  const std::vector<Point> points{{0.5, 2}, {2, 2}, {4, 2}, {6, 2}, {8, 2}, {9.5, 2}};
  return Curve::polyline(points);
}
InflatedSpace built(const Workspace& world) { return InflatedSpace::build(world).value(); }

/// Revalidates the way through a room that changes.
Revalidation after_change(const Workspace& before, const Workspace& after) {
  const Certificate old = certify(built(before), way_through_room());
  return revalidate(built(after), way_through_room(), old, changed_boxes(before, after));
}

std::optional<Curve> random_curve(const Workspace& world, test::WorldGenerator& worlds) {
  const auto space = LatticeSpace::build(world, {.resolution = world.bounds.width() / 32}).value();
  const Query query{.start = worlds.point(world), .goal = worlds.point(world)};
  const auto curve_of = [&](auto planner) -> std::optional<Curve> {
    auto plan = planner.plan(space, query);
    if (!plan) return std::nullopt;
    return plan->curve;
  };
  switch (worlds.random().below(4)) {
    case 0:
      return curve_of(Planner{AStar{}, NoSmoothing{}});
    case 1:
      return curve_of(Planner{AStar{}, TautString{}});
    case 2:
      return curve_of(Planner{AStar{}, BezierSmoother{}});
    default:
      return curve_of(Planner{AStar{}, ClothoidSmoother{}});
  }
}

/// Adds, removes or moves one obstacle, a third of the time to a point of the curve's box.
void change_world(Workspace& world, test::WorldGenerator& worlds) {
  Random& random = worlds.random();
  const std::uint64_t kind = world.obstacles.empty() ? 0 : random.below(3);
  if (kind > 0) {
    world.obstacles.erase(world.obstacles.begin() +
                          static_cast<std::ptrdiff_t>(random.below(world.obstacles.size())));
  }
  if (kind == 1) return;
  Obstacle drawn = worlds.obstacle(world.bounds);
  if (random.below(3) == 0) drawn = Disc{worlds.point(world), 0.02 * world.bounds.width()};
  const auto where = random.below(world.obstacles.size() + 1);
  world.obstacles.insert(world.obstacles.begin() + static_cast<std::ptrdiff_t>(where), drawn);
}

/// The pieces that are not proved in a space, each on its own.
std::vector<std::size_t> unproved_pieces(const InflatedSpace& space, const Curve& curve) {
  std::vector<std::size_t> failed;
  for (std::size_t i = 0; i < curve.pieces().size(); ++i) {
    const bool proved =
        curve.pieces()[i].visit([&](const auto& piece) { return is_proved_free(space, piece); });
    if (!proved) failed.push_back(i);
  }
  return failed;
}

/// Compares a revalidation with a certificate from scratch.
void check_against_certify(const InflatedSpace& after, const Curve& curve,
                           const Revalidation& found) {
  const Certificate whole = certify(after, curve);
  const Certificate& c = found.certificate;
  REQUIRE(c.status == whole.status);
  CHECK(found.failed == unproved_pieces(after, curve));
  CHECK(c.distance_error_bound == whole.distance_error_bound);
  CHECK(c.lower <= whole.upper);
  CHECK(c.upper >= whole.lower);
  if (c.status != ProofStatus::proved) {
    CHECK(c.piece == whole.piece);
    CHECK(c.lower == whole.lower);
    return;
  }
  CHECK(c.lower >= after.safety_radius());
  if (!std::isfinite(whole.upper)) {
    CHECK(c.lower == whole.lower);
    return;
  }
  CHECK(c.upper - c.lower <= std::max(1e-6, 8 * c.distance_error_bound));
  // The witness lies on the curve, and attains the upper bound.
  const Point p = curve.pieces()[c.piece].visit(
      [&](const auto& piece) -> Point { return piece.point(c.parameter); });
  CHECK(p == c.point);
  CHECK(after.clearance(p) == Approx(c.upper).margin(1e-6));
  REQUIRE(c.obstacle < after.workspace().obstacles.size());
  Workspace nearest = after.workspace();
  nearest.obstacles = {nearest.obstacles[c.obstacle]};
  CHECK(built(nearest).clearance(p) == Approx(c.upper).margin(1e-6));
}

TEST_CASE("a revalidation agrees with a proof from scratch in random worlds") {
  const std::uint64_t seed = 4100;
  test::WorldGenerator worlds(seed);
  std::size_t proved = 0, violated = 0, pieces = 0, again = 0, evaluations = 0, from_scratch = 0;
  for (std::size_t round = 0; round < test::scaled(600); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Workspace world = worlds.workspace();
    const auto curve = random_curve(world, worlds);
    if (!curve) continue;
    Workspace changed = world;
    change_world(changed, worlds);
    const Certificate before = certify(built(world), *curve);
    REQUIRE(before.status == ProofStatus::proved);
    const InflatedSpace after = built(changed);
    const Revalidation found = revalidate(after, *curve, before, changed_boxes(world, changed));
    check_against_certify(after, *curve, found);
    const ExactVerdict verdict = test::ExactChecker(changed).check(*curve);
    if (found.certificate.status == ProofStatus::proved) {
      ++proved;
      CHECK(verdict != ExactVerdict::blocked);
    } else if (found.certificate.status == ProofStatus::violated) {
      ++violated;
      CHECK(verdict != ExactVerdict::free);
    }
    CHECK(found.proved_again <= curve->pieces().size());
    pieces += curve->pieces().size();
    again += found.proved_again;
    evaluations += found.certificate.evaluations;
    from_scratch += certify(after, *curve).evaluations;
  }
  CAPTURE(proved, violated, pieces, again, evaluations, from_scratch);
  CHECK(proved > test::scaled(150));
  CHECK(violated > test::scaled(30));
  CHECK(3 * again < pieces);
  CHECK(2 * evaluations < from_scratch);
}

TEST_CASE("a curve is not proved again without a change, nor for a change far away") {
  const Workspace room = room_with_discs();
  const Certificate before = certify(built(room), way_through_room());
  REQUIRE(before.status == ProofStatus::proved);
  const Revalidation same = after_change(room, room);
  CHECK(same.certificate.status == ProofStatus::proved);
  CHECK(same.certificate.evaluations == 0);
  CHECK(same.proved_again == 0);
  CHECK(same.certificate.lower == before.lower);
  CHECK(same.certificate.upper == before.upper);
  CHECK(same.certificate.point == before.point);

  Workspace far = room;
  far.obstacles.insert(far.obstacles.begin(), Disc{{0.2, 0.2}, 0.1});
  const Revalidation found = after_change(room, far);
  CHECK(found.proved_again == 0);
  CHECK(found.certificate.evaluations == 1);
  CHECK(found.certificate.upper == Approx(before.upper).margin(1e-12));
  CHECK(found.certificate.obstacle == before.obstacle + 1);  // numbered as in the new space
}

TEST_CASE("only pieces next to a change are proved again, and those that fail are listed") {
  const Workspace room = room_with_discs();
  Workspace changed = room;
  changed.obstacles.push_back(Disc{{5, 2}, 0.1});
  changed.obstacles.push_back(Disc{{8.8, 1.9}, 0.1});
  const Revalidation found = after_change(room, changed);
  CHECK(found.certificate.status == ProofStatus::violated);
  CHECK(found.failed == std::vector<std::size_t>{2, 4});
  CHECK(found.proved_again == 2);
  CHECK(found.certificate.piece == 2);
  CHECK(found.certificate.upper < room.safety_radius);
  CHECK(found.certificate.lower == -std::numeric_limits<double>::infinity());
}

TEST_CASE("the interval grows when the nearest obstacle vanishes, and shrinks when one comes") {
  const Workspace room = room_with_discs();  // the clearances are 0.5, 0.6 and 0.7 m
  Workspace changed = room;
  changed.obstacles.erase(changed.obstacles.begin());
  Revalidation found = after_change(room, changed);
  CHECK(found.certificate.status == ProofStatus::proved);
  CHECK(found.certificate.lower == Approx(0.6).margin(1e-6));
  CHECK(found.certificate.upper == Approx(0.6).margin(1e-6));
  CHECK(found.certificate.obstacle == 0);

  changed = room;
  changed.obstacles.push_back(Disc{{7, 1.4}, 0.2});
  found = after_change(room, changed);
  CHECK(found.certificate.upper == Approx(0.4).margin(1e-6));
  CHECK(found.certificate.lower == Approx(0.4).margin(1e-6));
  CHECK(found.certificate.piece == 3);

  changed.obstacles.clear();
  found = after_change(room, changed);
  CHECK(found.certificate.lower == std::numeric_limits<double>::infinity());
  CHECK(found.certificate.upper == std::numeric_limits<double>::infinity());
  const Certificate open = found.certificate;
  found = revalidate(built(room), way_through_room(), open, changed_boxes(changed, room));
  CHECK(found.certificate.lower == Approx(0.5).margin(1e-6));
  CHECK(found.certificate.upper == Approx(0.5).margin(1e-6));
}

TEST_CASE("everything is proved again where the conditions of the proofs have changed") {
  const Workspace room = room_with_discs();
  const std::size_t pieces = way_through_room().pieces().size();
  Workspace changed = room;
  changed.safety_radius = 0.55;
  Revalidation found = after_change(room, changed);
  CHECK(found.proved_again == pieces);
  CHECK(found.certificate.status == ProofStatus::violated);
  changed.safety_radius = 0.45;  // less than the proved clearance
  found = after_change(room, changed);
  CHECK(found.proved_again == 0);
  CHECK(found.certificate.status == ProofStatus::proved);

  changed = room;
  changed.bounds.max.x() = 9;
  found = after_change(room, changed);
  CHECK(found.failed == std::vector<std::size_t>{4});
  changed = room;
  changed.bounds.max.x() = 2000;  // rounding grows with coordinates
  found = after_change(room, changed);
  CHECK(found.proved_again == pieces);
  CHECK(found.certificate.status == ProofStatus::proved);

  const Certificate undecided;
  found = revalidate(built(room), way_through_room(), undecided, {});
  CHECK(found.proved_again == pieces);
  CHECK(found.certificate.lower == Approx(0.5).margin(1e-6));
}

TEST_CASE("a revalidation that is cancelled is undecided, and so is an empty curve") {
  const Workspace room = room_with_discs();
  const InflatedSpace space = built(room);
  const Certificate before = certify(space, way_through_room());
  std::stop_source source;
  source.request_stop();
  const std::vector<Box> everywhere{room.bounds};
  Revalidation found =
      revalidate(space, way_through_room(), before, everywhere, Budget{.stop = source.get_token()});
  CHECK(found.certificate.status == ProofStatus::undecided);
  CHECK(found.failed.size() == way_through_room().pieces().size());
  CHECK(found.certificate.evaluations == 0);
  found = revalidate(space, way_through_room(), before, everywhere);
  CHECK(found.certificate.status == ProofStatus::proved);
  CHECK(found.failed.empty());
  CHECK(revalidate(space, Curve(), before, everywhere).certificate.status ==
        ProofStatus::undecided);
}

}  // namespace
