// SPDX-License-Identifier: MIT
#include "tutavia/smooth/bezier_smoother.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include "support/smoother_contract.hpp"

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

/// The largest turn where two pieces meet.
double largest_joint(const Curve& curve) {
  double largest = 0;
  for (std::size_t i = 0; i + 1 < curve.pieces().size(); ++i) {
    const auto direction = [&](std::size_t piece, double t) {
      return std::visit([&](const auto& p) { return Point(p.derivative(t)); },
                        curve.pieces()[piece]);
    };
    const Point in = direction(i, 1), out = direction(i + 1, 0);
    largest = std::fmax(largest, std::abs(std::atan2(cross(in, out), in.dot(out))));
  }
  return largest;
}

TEST_CASE("a free corner becomes one piece that takes its trim of both legs") {
  const auto space = space_with({});
  const Point right_angle[] = {{0, 0}, {4, 0}, {4, 3}};
  const auto curve =
      BezierSmoother{.trim = 1}.smooth(space, Curve::polyline(right_angle), {}).value();
  REQUIRE(curve.pieces().size() == 3);
  const auto& piece = std::get<CubicBezier>(curve.pieces()[1]);
  CHECK(piece.points[0].isApprox(Point(3, 0)));
  CHECK(piece.points[1].isApprox(Point(3 + 2.0 / 3, 0)));
  CHECK(piece.points[2].isApprox(Point(4, 1.0 / 3)));
  CHECK(piece.points[3].isApprox(Point(4, 1)));
  CHECK(largest_joint(curve) < 1e-12);
  CHECK(curve.length() < 7);

  // Half of a leg at most; where two corners share one, nothing is left of it.
  const auto shared = BezierSmoother{.trim = 50};
  const Point step[] = {{0, 0}, {2, 0}, {2, 1.1}, {5, 1.1}};
  const auto whole = shared.smooth(space, Curve::polyline(step), {}).value();
  REQUIRE(whole.pieces().size() == 4);
  CHECK(std::holds_alternative<CubicBezier>(whole.pieces()[1]));
  CHECK(std::holds_alternative<CubicBezier>(whole.pieces()[2]));
  CHECK(largest_joint(whole) < 1e-12);
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
  Curve bent;
  bent.push_back(QuadraticBezier{{Point(0, 0), Point(1, 1), Point(2, 0)}});
  CHECK(BezierSmoother{}.smooth(space, bent, {}).error().code == PlanError::invalid_input);
  CHECK(BezierSmoother{}.smooth(space, Curve{}, {}).value().empty());
}

}  // namespace
