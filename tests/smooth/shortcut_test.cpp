// SPDX-License-Identifier: MIT
#include "tutavia/smooth/shortcut.hpp"

#include "support/smoother_contract.hpp"

namespace {

using namespace tutavia;

TEST_CASE("Shortcut keeps the smoother contract") { test::smoother_contract(Shortcut{}); }

TEST_CASE("in the open, shortcuts leave one straight line") {
  const auto space = InflatedSpace::build({.bounds = {{0, 0}, {9, 9}}, .safety_radius = 1}).value();
  std::vector<Point> points;
  for (int i = 0; i < 40; ++i) points.emplace_back(0.2 * i, i % 2 == 0 ? 1 : 2);
  const auto result = Shortcut{}.smooth(space, Curve::polyline(points), Budget{}).value();
  REQUIRE(result.pieces().size() == 1);
  CHECK(result.length() == (points.back() - points.front()).norm());
}

TEST_CASE("shortcuts look along n joints about n log n times") {
  struct CountingSpace : InflatedSpace {
    mutable std::size_t looks = 0;
    bool segment_free(const Point& p, const Point& q) const {
      ++looks;
      return InflatedSpace::segment_free(p, q);
    }
  };
  const CountingSpace space{
      InflatedSpace::build(
          {.bounds = {{-2, -2}, {2, 2}}, .safety_radius = 0.1, .obstacles = {Disc{{0, 0}, 1}}})
          .value()};
  std::vector<Point> points;
  for (int i = 0; i <= 2000; ++i) {
    points.emplace_back(1.2 * std::cos(i * 0.0015), 1.2 * std::sin(i * 0.0015));
  }
  const Curve input = Curve::polyline(points);
  const auto result = Shortcut{}.smooth(space, input, Budget{}).value();
  CHECK(result.pieces().size() < 10);
  // Every segment of the input is tested once, before shortcuts are looked for.
  CHECK(space.looks - input.pieces().size() < 400);
}

TEST_CASE("a curved piece gives way to its chord only where the chord is free") {
  const auto space =
      InflatedSpace::build(
          {.bounds = {{-9, -9}, {9, 9}}, .safety_radius = 0.5, .obstacles = {Disc{{0, 0}, 1}}})
          .value();
  Curve round;
  round.push_back(QuadraticBezier{{Point(-3, 0), Point(0, 5), Point(3, 0)}});
  CHECK(Shortcut{}.smooth(space, round, Budget{}).value().length() == round.length());
  Curve free;
  free.push_back(QuadraticBezier{{Point(-3, 4), Point(0, 9), Point(3, 4)}});
  CHECK(Shortcut{}.smooth(space, free, Budget{}).value().length() == 6);
}

}  // namespace
