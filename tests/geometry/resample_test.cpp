// SPDX-License-Identifier: MIT
#include "tutavia/geometry/resample.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using std::numbers::pi;

TEST_CASE("a polyline is sampled at fixed steps, the last one shorter", "[geometry]") {
  const Point corner[] = {{0, 0}, {1, 0}, {1, 1}};
  const std::vector<CurvePoint> states = resample(Curve::polyline(corner), 0.75);
  REQUIRE(states.size() == 4);
  CHECK(states[0].position == Point(0, 0));
  CHECK(states[1].position == Point(0.75, 0));
  CHECK(states[2].position == Point(1, 0.5));
  CHECK(states[3].position == Point(1, 1));
  CHECK((states[1].s == 0.75 && states[2].s == 1.5 && states[3].s == 2));
  CHECK((states[0].heading == 0 && states[1].heading == 0));
  CHECK((states[2].heading == Approx(pi / 2) && states[3].heading == Approx(pi / 2)));
  CHECK(resample(Curve::polyline(corner), 1)[1].heading == Approx(pi / 2));  // the later piece
}

TEST_CASE("a step longer than the curve leaves its ends, a point is one state", "[geometry]") {
  const Point line[] = {{0, 0}, {3, 4}}, point[] = {{7, -2}}, twice[] = {{1, 1}, {1, 1}, {1, 1}};
  for (const double ds : {5.0, 7.0, 1e300}) {
    const std::vector<CurvePoint> states = resample(Curve::polyline(line), ds);
    REQUIRE(states.size() == 2);
    CHECK((states[0].position == line[0] && states[1].position == line[1]));
    CHECK((states[0].s == 0 && states[1].s == 5));
  }
  REQUIRE(resample(Curve::polyline(point), 0.1).size() == 1);
  CHECK(resample(Curve::polyline(point), 0.1)[0].position == Point(7, -2));
  CHECK(resample(Curve::polyline(twice), 0.1).size() == 1);
}

TEST_CASE("rounding leaves no step of next to no length", "[geometry]") {
  for (int n = 1; n < 100; ++n) {
    CAPTURE(n);
    for (const double ds : {0.1, 0.3, 1e-3, 7.7}) {
      double length = 0;
      for (int i = 0; i < n; ++i) length += ds;
      const Point line[] = {{0, 0}, {length, 0}};
      const std::vector<CurvePoint> states = resample(Curve::polyline(line), ds);
      REQUIRE(states.size() == static_cast<std::size_t>(n) + 1);
      CHECK(states.back().s == length);
    }
  }
}

TEST_CASE("samples are the curve's own states at their arc lengths", "[geometry]") {
  const std::uint64_t seed = 1;
  Random random(seed);
  const auto next = [&] { return Point{random.uniform(-1, 1), random.uniform(-1, 1)}; };
  for (std::size_t round = 0; round < test::scaled(40); ++round) {
    INFO("seed " << seed << ", round " << round);
    Curve curve;
    Point at = next();
    for (int i = 0; i < 6; ++i) {
      const Arc arc =
          Arc::around(next(), random.uniform(0.1, 1), random.uniform(-9, 9), random.uniform(-6, 6));
      const Point b = next(), c = next();
      if (i % 3 == 0) curve.push_back(Segment{at, arc.a});
      if (i % 3 == 1) curve.push_back(QuadraticBezier{{at, b, arc.a}});
      if (i % 3 == 2) curve.push_back(CubicBezier{{at, b, c, arc.a}});
      curve.push_back(arc);
      if (i % 2 == 0) curve.push_back(Segment{arc.b, arc.b});
      at = arc.b;
    }
    const double ds = random.uniform(0.01, 0.5);
    const std::vector<CurvePoint> states = resample(curve, ds);
    CHECK(states.size() == static_cast<std::size_t>(std::ceil(curve.length() / ds)) + 1);
    CHECK(states.front().position == curve.start());
    CHECK(states.back().position == curve.end());
    CHECK(states.back().s == curve.length());
    for (std::size_t i = 0; i < states.size(); ++i) {
      const double s = std::min(static_cast<double>(i) * ds, curve.length());
      const CurvePoint expected = curve.at(s);
      CAPTURE(i, s);
      CHECK(states[i].s == s);
      CHECK((states[i].position - expected.position).norm() < 1e-11);
      CHECK(std::abs(std::remainder(states[i].heading - expected.heading, 2 * pi)) < 1e-7);
      CHECK(states[i].curvature == Approx(expected.curvature).epsilon(1e-6).margin(1e-6));
    }
  }
}

TEST_CASE("a piece that stands still at its start is sampled as well", "[geometry]") {
  Curve curve;
  curve.push_back(CubicBezier{{Point(0, 0), Point(0, 0), Point(0, 0), Point(4, 0)}});
  const std::vector<CurvePoint> states = resample(curve, 1);
  REQUIRE(states.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK((states[i].position - Point(static_cast<double>(i), 0)).norm() < 1e-11);
    CHECK(states[i].heading == 0);
  }
}

}  // namespace
