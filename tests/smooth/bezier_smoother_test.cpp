// SPDX-License-Identifier: MIT
#include "tutavia/smooth/bezier_smoother.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "support/random_tasks.hpp"
#include "support/smoother_contract.hpp"
#include "tutavia/certify/certify.hpp"

namespace {

using namespace tutavia;

TEST_CASE("BezierSmoother keeps the smoother contract") {
  test::smoother_contract(BezierSmoother{});
  test::smoother_contract(BezierSmoother{.trim = 100, .fullness = 1});
}

InflatedSpace space_with(std::vector<Obstacle> obstacles) {
  return InflatedSpace::build({.bounds = {{-9, -9}, {9, 9}},
                               .safety_radius = 0.5,
                               .obstacles = std::move(obstacles)})
      .value();
}

TEST_CASE("a free corner becomes one piece that takes its trim of both legs") {
  const auto space = space_with({});
  const Point right_angle[] = {{0, 0}, {4, 0}, {4, 3}};
  const auto curve =
      BezierSmoother{.trim = 1}.smooth(space, Curve::polyline(right_angle), {}).value();
  REQUIRE(curve.pieces().size() == 3);
  const auto& piece = *curve.pieces()[1].get_if<CubicBezier>();
  CHECK(piece.points[0].isApprox(Point(3, 0)));
  CHECK(piece.points[1].isApprox(Point(3 + 2.0 / 3, 0)));
  CHECK(piece.points[2].isApprox(Point(4, 1.0 / 3)));
  CHECK(piece.points[3].isApprox(Point(4, 1)));
  CHECK(test::largest_corner(curve) < 1e-12);
  CHECK(curve.length() < 7);

  // Half of a leg at most; where two corners share one, nothing is left of it.
  const auto shared = BezierSmoother{.trim = 50};
  const Point step[] = {{0, 0}, {2, 0}, {2, 1.1}, {5, 1.1}};
  const auto whole = shared.smooth(space, Curve::polyline(step), {}).value();
  REQUIRE(whole.pieces().size() == 4);
  CHECK(whole.pieces()[1].holds<CubicBezier>());
  CHECK(whole.pieces()[2].holds<CubicBezier>());
  CHECK(test::largest_corner(whole) < 1e-12);
}

TEST_CASE("near an obstacle a corner takes less, and stays where nothing fits") {
  const Point right_angle[] = {{0, 0}, {4, 0}, {4, 4}};
  const Curve input = Curve::polyline(right_angle);
  // On the inner side of the corner: the piece for half the legs would cut its zone.
  const auto near = space_with({Disc{{3, 1}, 0.25}});
  const auto trimmed = BezierSmoother{.trim = 2}.smooth(near, input, {}).value();
  REQUIRE(trimmed.pieces().size() == 3);
  CHECK(end_of(trimmed.pieces()[0]).x() == Approx(3));

  // A slight turn around a post that both legs all but touch.
  const double turn = 2e-3, reach = 0.5 / std::cos(turn / 2) * (1 + 1e-9);
  const auto close =
      space_with({Disc{{-reach * std::sin(turn / 2), reach * std::cos(turn / 2)}, 0}});
  const Point slight[] = {{-4, 0}, {0, 0}, {4 * std::cos(turn), 4 * std::sin(turn)}};
  const Curve bend = Curve::polyline(slight);
  REQUIRE(certify(close, bend).status == ProofStatus::proved);
  CHECK(test::same_curve(BezierSmoother{}.smooth(close, bend, {}).value(), bend));
}

TEST_CASE("straight joints and reversals stay, bad options are refused") {
  const auto space = space_with({});
  const Point there_and_back[] = {{0, 0}, {1, 0}, {3, 0}, {1, 0}};
  const Curve input = Curve::polyline(there_and_back);
  CHECK(test::same_curve(BezierSmoother{}.smooth(space, input, {}).value(), input));
  for (const BezierSmoother& bad :
       {BezierSmoother{.trim = -1}, BezierSmoother{.trim = std::nan("")},
        BezierSmoother{.fullness = 0}, BezierSmoother{.fullness = 1.1}}) {
    CHECK(bad.smooth(space, input, {}).error().code == PlanError::invalid_option);
  }
  CHECK(BezierSmoother{}.smooth(space, Curve{}, {}).value().empty());
  const auto blocked = space_with({Disc{{2, 0.2}, 0}});
  const auto refused = BezierSmoother{}.smooth(blocked, input, {});
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == PlanError::invalid_input);
  CHECK(refused.error().detail.find("segment 1 ") == 0);
}

TEST_CASE("corners between curved pieces are rounded as well") {
  const auto space = space_with({});
  Curve input;
  input.push_back(Segment{{-4, 0}, {0, 0}});
  input.push_back(QuadraticBezier{{Point(0, 0), Point(1, 1), Point(2, 0)}});
  input.push_back(Arc::around({2, 1}, 1, -std::numbers::pi / 2, 2));
  input.push_back(CubicBezier{{input.end(), Point(0, 3), Point(-1, 4), Point(-3, 3)}});
  REQUIRE(test::largest_corner(input) > 0.5);
  for (const double trim : {0.1, 1.0, 50.0}) {
    const auto curve = BezierSmoother{.trim = trim}.smooth(space, input, {}).value();
    CHECK(test::largest_corner(curve) < 1e-9);
    CHECK(curve.start() == input.start());
    CHECK(curve.end() == input.end());
    CHECK(curve.length() < input.length());
    CHECK(curve.length() > 0.7 * input.length());
  }
}

}  // namespace
