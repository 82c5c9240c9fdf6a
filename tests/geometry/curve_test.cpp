// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/geometry/curve.hpp"

namespace {

using namespace tutavia;

const double pi = std::acos(-1.0);

Curve polyline(const std::vector<Point>& points) { return Curve::polyline(points); }

/// Straight, quadratic and cubic pieces in turn.
Curve any_curve(Random& random) {
  const auto next = [&] { return Point{random.uniform(-1, 1), random.uniform(-1, 1)}; };
  Curve curve;
  Point at = next();
  for (int i = 0; i < 6; ++i) {
    const Point b = next(), c = next(), d = next();
    if (i % 3 == 0) curve.push_back(Segment{at, d});
    if (i % 3 == 1) curve.push_back(QuadraticBezier{{at, b, d}});
    if (i % 3 == 2) curve.push_back(CubicBezier{{at, b, c, d}});
    at = d;
  }
  return curve;
}

TEST_CASE("a polyline is addressed by arc length, the later piece at a joint", "[geometry]") {
  const Curve curve = polyline({{0, 0}, {3, 4}, {3, 10}});
  CHECK(curve.length() == 11);
  CHECK(curve.pieces().size() == 2);
  CHECK(curve.point(0) == Point(0, 0));
  CHECK(curve.point(2.5).isApprox(Point(1.5, 2)));
  CHECK(curve.point(5) == Point(3, 4));
  CHECK(curve.point(11) == Point(3, 10));
  CHECK(curve.heading(4.999) == Approx(std::atan2(4, 3)));
  CHECK(curve.heading(5) == Approx(pi / 2));
  CHECK(curve.heading(11) == Approx(pi / 2));
  CHECK(curve.locate(5).first == 1);
  CHECK(curve.locate(5).second == 0);
  CHECK(curve.locate(11).first == 1);
  CHECK(curve.locate(11).second == 1);
}

TEST_CASE("places before the start and after the end are clamped", "[geometry]") {
  const Curve curve = polyline({{1, 1}, {4, 5}});
  CHECK(curve.at(-3).position == Point(1, 1));
  CHECK(curve.at(-3).s == 0);
  CHECK(curve.at(99).position == Point(4, 5));
  CHECK(curve.at(99).s == 5);
  CHECK(curve.at(2).s == 2);
}

TEST_CASE("a curve of one point has length 0 and a single state", "[geometry]") {
  const Curve curve = polyline({{7, -2}});
  CHECK_FALSE(curve.empty());
  CHECK(curve.length() == 0);
  CHECK((curve.start() == Point(7, -2) && curve.end() == Point(7, -2)));
  CHECK(curve.point(0) == Point(7, -2));
  CHECK(curve.point(1) == Point(7, -2));
  CHECK(curve.heading(0) == 0);
  CHECK(curve.curvature(0) == 0);
  REQUIRE(curve.sample(0.1).size() == 1);
  CHECK(curve.sample(0.1)[0].position == Point(7, -2));
  CHECK(Curve().empty());
  CHECK(Curve().length() == 0);
  CHECK(polyline({}).empty());
}

TEST_CASE("pieces of no length are passed over", "[geometry]") {
  const Curve curve = polyline({{0, 0}, {0, 0}, {0, 2}, {0, 2}, {2, 2}});
  CHECK(curve.length() == 4);
  CHECK(curve.heading(0) == Approx(pi / 2));
  CHECK(curve.heading(2) == 0);
  CHECK(curve.point(3) == Point(1, 2));
  CHECK(curve.locate(2).first == 3);
}

TEST_CASE("heading and curvature follow the parabola y = x^2", "[geometry]") {
  Curve curve;
  curve.push_back(QuadraticBezier{{Point(-1, 1), Point(0, -1), Point(1, 1)}});
  const double half = (2 * std::sqrt(5.0) + std::asinh(2.0)) / 4;
  CHECK(curve.length() == Approx(2 * half).epsilon(1e-12));
  CHECK(curve.point(half).norm() < 1e-12);
  CHECK(curve.curvature(half) == Approx(2).epsilon(1e-9));
  for (int i = 0; i <= 20; ++i) {
    CAPTURE(i);
    const CurvePoint at = curve.at(curve.length() * i / 20);
    const double x = at.position.x();
    const double arc = (2 * x * std::sqrt(1 + 4 * x * x) + std::asinh(2 * x)) / 4;
    CHECK(at.position.y() == Approx(x * x).margin(1e-14));
    CHECK(at.s == Approx(half + arc).margin(1e-11));
    CHECK(at.heading == Approx(std::atan(2 * x)).margin(1e-12));
    CHECK(at.curvature == Approx(2 / std::pow(1 + 4 * x * x, 1.5)).epsilon(1e-12));
  }
  Curve mirrored;
  mirrored.push_back(QuadraticBezier{{Point(-1, -1), Point(0, 1), Point(1, -1)}});
  CHECK(mirrored.curvature(half) == Approx(-2).epsilon(1e-9));
}

TEST_CASE("where control points coincide the heading is that of the limit", "[geometry]") {
  Curve curve;
  curve.push_back(CubicBezier{{Point(0, 0), Point(0, 0), Point(1, 1), Point(1, 1)}});
  CHECK(curve.heading(0) == Approx(pi / 4));
  CHECK(curve.heading(curve.length()) == Approx(pi / 4));
  CHECK(curve.curvature(0) == 0);
  CHECK(curve.length() == Approx(std::sqrt(2.0)).epsilon(1e-12));
  CHECK((curve.point(curve.length() / 2) - Point(0.5, 0.5)).norm() < 1e-12);
}

TEST_CASE("locate() inverts the arc length of every piece", "[geometry]") {
  const std::uint64_t seed = 1;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(30); ++round) {
    const Curve curve = any_curve(random);
    double before = 0;
    for (std::size_t i = 0; i < curve.pieces().size(); ++i) {
      const auto length_to = [&](double t) {
        return std::visit([&](const auto& piece) { return piece.length_to(t); }, curve.pieces()[i]);
      };
      const double t = random.uniform(), s = before + length_to(t);
      const auto found = curve.locate(s);
      const double parameter = found.second;
      INFO("round " << round << " piece " << i << " t " << t);
      CHECK(found.first == i);
      CHECK(std::abs(before + length_to(parameter) - s) <= 1e-11 * curve.length());
      const Point expected =
          std::visit([&](const auto& p) { return Point(p.point(parameter)); }, curve.pieces()[i]);
      CHECK(curve.point(s) == expected);
      before += length_to(1);
    }
    CHECK(curve.length() == Approx(before).epsilon(1e-13));
    CHECK(curve.point(0) == curve.start());
    CHECK(curve.point(curve.length()) == curve.end());
  }
}

TEST_CASE("samples lie at equal steps no longer than asked, both ends included", "[geometry]") {
  const std::uint64_t seed = 2;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(20); ++round) {
    const Curve curve = any_curve(random);
    const double step = random.uniform(0.05, 2);
    const std::vector<CurvePoint> states = curve.sample(step);
    INFO("round " << round << " step " << step);
    REQUIRE(states.size() >= 2);
    CHECK(states.size() == static_cast<std::size_t>(std::ceil(curve.length() / step)) + 1);
    CHECK(states.front().position == curve.start());
    CHECK(states.back().position == curve.end());
    CHECK(states.back().s == curve.length());
    for (std::size_t i = 1; i < states.size(); ++i) {
      const double gap = states[i].s - states[i - 1].s;
      CHECK(gap <= step * (1 + 1e-14));
      CHECK(gap == Approx(curve.length() / static_cast<double>(states.size() - 1)).epsilon(1e-9));
      CHECK((states[i].position - states[i - 1].position).norm() <= gap * (1 + 1e-9));
    }
  }
  CHECK(polyline({{0, 0}, {1, 0}}).sample(0.25).size() == 5);
  CHECK(polyline({{0, 0}, {1, 0}}).sample(7).size() == 2);
}

TEST_CASE("a curve that ends in a standstill keeps its last heading") {
  const Point points[] = {{0, 0}, {0, 1}, {0, 1}};
  CHECK(Curve::polyline(points).heading(1) == Approx(std::acos(-1) / 2));
}

}  // namespace
