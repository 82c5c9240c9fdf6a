// SPDX-License-Identifier: MIT
#include "tutavia/smooth/clothoid_smoother.hpp"

#include <algorithm>

#include "support/exact_checker.hpp"
#include "support/homotopy.hpp"
#include "support/random_tasks.hpp"
#include "support/random_worlds.hpp"
#include "support/scale.hpp"
#include "support/similarity.hpp"
#include "support/smoother_contract.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/search/tangent_graph.hpp"
#include "tutavia/smooth/pipeline.hpp"

namespace {

using namespace tutavia;

TEST_CASE("ClothoidSmoother keeps the smoother contract") {
  test::smoother_contract(ClothoidSmoother{}, {.longest = 1.01});
  test::smoother_contract(ClothoidSmoother{.spirals = ClothoidSmoother::Spirals::cubic_beziers},
                          {.longest = 1.01});
  test::smoother_contract(Pipeline{TautString{}, ClothoidSmoother{}}, {.longest = 1.01});
}

/// A world of one obstacle, and a route around it.
InflatedSpace around(const Obstacle& obstacle, double radius = 0.5) {
  return InflatedSpace::build(
             {.bounds = {{-9, -9}, {9, 9}}, .safety_radius = radius, .obstacles = {obstacle}})
      .value();
}

template <class P>
std::size_t count(const Curve& curve) {
  return static_cast<std::size_t>(
      std::count_if(curve.pieces().begin(), curve.pieces().end(),
                    [](const Piece& piece) { return piece.holds<P>(); }));
}

void check_continuous(const Curve& curve) {
  const PathMetrics metrics = measure(curve);
  CHECK(metrics.max_joint_deflection < 1e-9);
  CHECK(metrics.max_curvature_jump < 1e-9);
}

TEST_CASE("a gentle bend becomes a pair of clothoids that comes as near as it may") {
  const auto space = around(Polygon{{{0, -1}}});
  const Curve route = Curve::polyline(std::vector<Point>{{-4, -2}, {-1, 1}, {1, 1}, {4, -2}});
  const Curve smooth = ClothoidSmoother{}.smooth(space, route, {}).value();
  const Curve string = TautString{}.smooth(space, route, {}).value();
  CHECK(smooth.pieces().size() == 4);
  CHECK(count<Clothoid>(smooth) == 2);
  check_continuous(smooth);
  const Certificate certificate = certify(space, smooth);
  CHECK(certificate.status == ProofStatus::proved);
  CHECK(certificate.upper < 0.5 * (1 + 0.1 / 50));
  CHECK(measure(smooth).max_curvature < 1 / 0.5);
  CHECK(smooth.length() > string.length());
  CHECK(smooth.length() < 1.002 * string.length());
  // The other kind of spirals.
  const Curve beziers = ClothoidSmoother{.spirals = ClothoidSmoother::Spirals::cubic_beziers}
                            .smooth(space, route, {})
                            .value();
  CHECK(count<CubicBezier>(beziers) == 2);
  check_continuous(beziers);
  CHECK(measure(beziers).max_curvature < 1 / 0.5);
  CHECK(certify(space, beziers).status == ProofStatus::proved);
}

TEST_CASE("bends that turn far become arcs between two clothoids") {
  const auto disc = around(Disc{{0, 0}, 2});
  const auto wall = around(Polygon{{{-8.5, 0}, {0, 0}}}, 0.4);
  const Point over_disc[] = {{-4, -2}, {-3, 4}, {3, 4}, {4, -2}};
  const Point round_wall[] = {{-6, -3}, {3, -3}, {3, 3}, {-6, 3}};
  for (const auto& [space, route] : {std::pair{disc, Curve::polyline(over_disc)},
                                     std::pair{wall, Curve::polyline(round_wall)}}) {
    const Curve smooth = ClothoidSmoother{}.smooth(space, route, {}).value();
    const Curve string = TautString{}.smooth(space, route, {}).value();
    CHECK(count<Clothoid>(smooth) == 2);
    CHECK(count<Arc>(smooth) >= 1);
    check_continuous(smooth);
    CHECK(certify(space, smooth).status == ProofStatus::proved);
    CHECK(measure(smooth).max_curvature <= measure(string).max_curvature);
    CHECK(smooth.length() < 1.01 * string.length());
  }
}

TEST_CASE("in a gap without room a bend keeps its arc, and the metrics tell") {
  // The way leads through a gap of little more than twice the radius, and turns in it.
  const auto space = InflatedSpace::build({.bounds = {{-9, -9}, {9, 9}},
                                           .safety_radius = 0.5,
                                           .obstacles = {Polygon{{{-9, 0}, {-0.5000001, 0}}},
                                                         Polygon{{{0.5000001, 0}, {9, 0}}}}})
                         .value();
  const Curve route = Curve::polyline(std::vector<Point>{{-6, -3}, {0, -1}, {0, 1}, {-6, 3}});
  const Curve smooth = ClothoidSmoother{}.smooth(space, route, {}).value();
  CHECK(certify(space, smooth).status == ProofStatus::proved);
  CHECK(measure(smooth).max_joint_deflection < 1e-9);
  CHECK(measure(smooth).max_curvature_jump == Approx(1 / 0.5).epsilon(1e-3));
  // With a little more room, a smaller margin fits.
  const auto wider = InflatedSpace::build({.bounds = {{-9, -9}, {9, 9}},
                                           .safety_radius = 0.5,
                                           .obstacles = {Polygon{{{-9, 0}, {-0.51, 0}}},
                                                         Polygon{{{0.51, 0}, {9, 0}}}}})
                         .value();
  check_continuous(ClothoidSmoother{}.smooth(wider, route, {}).value());
}

TEST_CASE("a minimum turning radius is kept, or smoothing fails") {
  const auto space = around(Polygon{{{0, -1}}});
  const Curve route = Curve::polyline(std::vector<Point>{{-4, -2}, {-1, 1}, {1, 1}, {4, -2}});
  const double gentle =
      1 / measure(ClothoidSmoother{}.smooth(space, route, {}).value()).max_curvature;
  double length = 0;
  for (const double radius : {0.4, 1.0, 2.0, 3.0}) {
    INFO(radius);
    const Curve smooth =
        ClothoidSmoother{.min_turning_radius = radius}.smooth(space, route, {}).value();
    CHECK(certify(space, smooth).status == ProofStatus::proved);
    CHECK(measure(smooth).max_curvature * radius <= 1 + 1e-12);
    check_continuous(smooth);
    if (radius > gentle) CHECK(smooth.length() > length);
    length = smooth.length();
  }
  const auto failed = ClothoidSmoother{.min_turning_radius = 20}.smooth(space, route, {});
  REQUIRE_FALSE(failed);
  CHECK(failed.error().code == PlanError::not_proved);
  CHECK(failed.error().detail.find("around (0") != std::string::npos);
  // A route that is straight needs none.
  const Curve straight = Curve::polyline(std::vector<Point>{{-4, 2}, {4, 2}});
  CHECK(ClothoidSmoother{.min_turning_radius = 20}.smooth(space, straight, {}).value().length() ==
        8);
}

TEST_CASE("a curve with a corner before an arc keeps no turning radius") {
  // The start lies within the circle of the arc, so that no way touches it.
  const auto space = around(Polygon{{{6, -6}}});
  Curve corner;
  corner.push_back(Segment{{1.5, 0}, {2, 0}});
  corner.push_back(Arc::around({0, 0}, 2, 0, 1.5));
  const auto refused = ClothoidSmoother{.min_turning_radius = 1}.smooth(space, corner, {});
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == PlanError::not_proved);
  CHECK(ClothoidSmoother{}.smooth(space, corner, {}).value().length() == corner.length());
  // Without the corner it is as gentle as its arc.
  Curve arc;
  arc.push_back(corner.pieces()[1]);
  CHECK(ClothoidSmoother{.min_turning_radius = 1}.smooth(space, arc, {}).value().length() ==
        arc.length());
}

/// What no smoothed string may lose: length, directions at joints, curvature.
void check_no_worse(const InflatedSpace& space, const Curve& smooth, const PathMetrics& before,
                    const PathMetrics& after) {
  CHECK(after.length <=
        before.length * (1 + 1e-12) + 0.1 * space.safety_radius() * after.turning_angle);
  // The direction of a short piece is known as well as its ends.
  double shortest = after.length;
  for (const Piece& piece : smooth.pieces()) {
    const double length = distance(start_of(piece), end_of(piece));
    if (length > 0) shortest = std::min(shortest, length);
  }
  CHECK(after.max_joint_deflection <=
        before.max_joint_deflection + 1e-9 + space.distance_error_bound() / shortest);
  if (before.max_joint_deflection < 1e-9) {
    CHECK(after.max_curvature <= before.max_curvature * (1 + 1e-9));
  }
}

/// Whether a string can be smoothed to a minimum turning radius; then the path must keep it.
bool keeps_turning_radius(const InflatedSpace& space, const Curve& string, double radius,
                          const test::ExactChecker& checker) {
  const auto wide = ClothoidSmoother{.min_turning_radius = radius}.smooth(space, string, {});
  if (!wide) {
    CHECK(wide.error().code == PlanError::not_proved);
    return false;
  }
  const PathMetrics metrics = measure(*wide);
  CHECK(metrics.max_curvature * radius <= 1 + 1e-9);
  CHECK(metrics.max_joint_deflection < 1e-6);
  REQUIRE(certify(space, *wide).status == ProofStatus::proved);
  REQUIRE(checker.check(*wide) != test::ExactVerdict::blocked);
  return true;
}

TEST_CASE("paths of continuous curvature through random worlds are proved", "[soak]") {
  const std::uint64_t seed = 60;
  test::WorldGenerator worlds(seed);
  Random random(seed);
  std::size_t paths = 0, continuous = 0, unknown = 0, gentle = 0, refused = 0, crossed = 0;
  double longest = 0, sum = 0;
  for (std::size_t round = 0; round < test::scaled(150); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto task = test::random_task(worlds);
    if (!task) continue;
    const auto space = InflatedSpace::build(task->world).value();
    const double r = space.safety_radius();
    const Curve string = TautString{}.smooth(space, Curve::polyline(task->route), {}).value();
    const test::ExactChecker checker(task->world);
    for (const ClothoidSmoother::Spirals spirals :
         {ClothoidSmoother::Spirals::clothoids, ClothoidSmoother::Spirals::cubic_beziers}) {
      const ClothoidSmoother smoother{.spirals = spirals};
      const Curve smooth = smoother.smooth(space, string, {}).value();
      REQUIRE(certify(space, smooth).status == ProofStatus::proved);
      const auto verdict = checker.check(smooth);
      REQUIRE(verdict != test::ExactVerdict::blocked);
      if (verdict == test::ExactVerdict::unknown) ++unknown;
      CHECK((smooth.start() == string.start() && smooth.end() == string.end()));
      const PathMetrics before = measure(string), after = measure(smooth);
      check_no_worse(space, smooth, before, after);
      if (!test::winds_around_nothing(task->world, smooth, string)) ++crossed;
      if (spirals == ClothoidSmoother::Spirals::cubic_beziers) continue;
      ++paths;
      const double ratio = before.length > 0 ? after.length / before.length : 1;
      sum += ratio;
      longest = std::max(longest, ratio);
      if (after.max_curvature_jump < 1e-9 / r) ++continuous;
    }
    const double radius = r * random.uniform(0.5, 3);
    ++(keeps_turning_radius(space, string, radius, checker) ? gentle : refused);
  }
  INFO(paths << " paths, " << continuous << " of continuous curvature, length over the string's "
             << sum / double(paths) << " on average and " << longest << " at most, " << crossed
             << " of another class, " << unknown
             << " undecided by the exact checker; turning radius kept by " << gentle
             << ", refused by " << refused);
  CHECK(unknown == 0);
  CHECK(continuous > paths / 2);
  CHECK(gentle > paths / 2);
  CHECK(paths > test::scaled(150) / 3);
}

TEST_CASE("the clothoid smoother says what it cannot use") {
  const auto space = around(Polygon{{{0, -1}}});
  const Curve route = Curve::polyline(std::vector<Point>{{-4, -2}, {4, 2}});
  for (const double bad : {-0.1, std::nan(""), HUGE_VAL}) {
    const auto budget = ClothoidSmoother{.clearance_budget = bad}.smooth(space, route, {});
    REQUIRE_FALSE(budget);
    CHECK(budget.error().code == PlanError::invalid_option);
    CHECK(budget.error().detail.find("clearance_budget") != std::string::npos);
    const auto radius = ClothoidSmoother{.min_turning_radius = bad}.smooth(space, route, {});
    REQUIRE_FALSE(radius);
    CHECK(radius.error().detail.find("min_turning_radius") != std::string::npos);
  }
  Curve bezier;
  bezier.push_back(QuadraticBezier{{Point(-4, 2), Point(0, 4), Point(4, 2)}});
  const auto refused = ClothoidSmoother{}.smooth(space, bezier, {});
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == PlanError::invalid_input);
  const auto blocked =
      ClothoidSmoother{}.smooth(space, Curve::polyline(std::vector<Point>{{0, -4}, {0, 4}}), {});
  REQUIRE_FALSE(blocked);
  CHECK(blocked.error().code == PlanError::invalid_input);
  // No budget: the string.
  const Curve bent = Curve::polyline(std::vector<Point>{{-4, -2}, {-1, 1}, {1, 1}, {4, -2}});
  const Curve string = TautString{}.smooth(space, bent, {}).value();
  const Curve same = ClothoidSmoother{.clearance_budget = 0}.smooth(space, bent, {}).value();
  CHECK(same.length() == Approx(string.length()).epsilon(1e-12));
}

}  // namespace
