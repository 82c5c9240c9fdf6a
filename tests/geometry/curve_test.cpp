// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/geometry/curve.hpp"

namespace {

using namespace tutavia;

using std::numbers::pi;

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
        return curve.pieces()[i].visit([&](const auto& piece) { return piece.length_to(t); });
      };
      const double t = random.uniform(), s = before + length_to(t);
      const auto found = curve.locate(s);
      const double parameter = found.second;
      INFO("round " << round << " piece " << i << " t " << t);
      CHECK(found.first == i);
      CHECK(std::abs(before + length_to(parameter) - s) <= 1e-11 * curve.length());
      const Point expected =
          curve.pieces()[i].visit([&](const auto& p) { return Point(p.point(parameter)); });
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

/// Straight, quadratic, cubic and circular pieces in turn.
Curve any_curve_with_arcs(Random& random) {
  Curve curve = any_curve(random);
  for (int i = 0; i < 2; ++i) {
    const Point offset{random.uniform(-1, 1), random.uniform(-1, 1)};
    const double radius = offset.norm(), from = heading(offset), sweep = random.uniform(-6, 6);
    Arc arc = Arc::around(curve.end() - offset, radius, from, sweep);
    arc.a = curve.end();
    curve.push_back(arc);
  }
  return curve;
}

TEST_CASE("the halves of a split curve meet in one point and trace the same points", "[geometry]") {
  const std::uint64_t seed = 3;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(40); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Curve curve = any_curve_with_arcs(random);
    const double s = random.uniform(0, curve.length());
    const auto [first, second] = curve.split(s);
    CHECK(first.start() == curve.start());
    CHECK(first.end() == second.start());
    CHECK(second.end() == curve.end());
    CHECK((first.end() - curve.point(s)).norm() < 1e-11);
    CHECK(first.length() == Approx(s).margin(1e-10));
    CHECK(second.length() == Approx(curve.length() - s).margin(1e-10));
    const double before = random.uniform(0, s), behind = random.uniform(s, curve.length());
    CHECK((first.point(before) - curve.point(before)).norm() < 1e-9);
    CHECK((second.point(behind - s) - curve.point(behind)).norm() < 1e-9);
  }
}

TEST_CASE("split at an end or a joint a curve keeps its pieces whole", "[geometry]") {
  const Curve curve = polyline({{0, 0}, {3, 4}, {3, 10}});
  for (const double s : {0.0, -1.0, 1e-13}) {
    const auto [point, rest] = curve.split(s);
    CHECK((point.length() == 0 && point.pieces().size() == 1));
    CHECK(point.start() == Point(0, 0));
    CHECK((rest.length() == 11 && rest.pieces().size() == 2));
  }
  for (const double s : {11.0, 99.0, 11 - 1e-12}) {
    const auto [rest, point] = curve.split(s);
    CHECK((point.length() == 0 && point.pieces().size() == 1));
    CHECK(point.start() == Point(3, 10));
    CHECK((rest.length() == 11 && rest.pieces().size() == 2));
  }
  for (const double s : {5.0, 5 - 1e-13, 5 + 1e-13}) {
    const auto [first, second] = curve.split(s);
    CHECK((first.pieces().size() == 1 && second.pieces().size() == 1));
    CHECK(second.start() == Point(3, 4));
  }
  const auto [a, b] = polyline({{7, -2}}).split(0);
  CHECK((a.start() == Point(7, -2) && a.end() == b.start() && b.end() == Point(7, -2)));
}

TEST_CASE("a reversed curve visits the same points the other way round", "[geometry]") {
  const std::uint64_t seed = 4;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(20); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Curve curve = any_curve_with_arcs(random), back = curve.reversed();
    const double s = random.uniform(0, curve.length());
    CHECK((back.start() == curve.end() && back.end() == curve.start()));
    CHECK(back.length() == Approx(curve.length()).epsilon(1e-12));
    CHECK((back.point(curve.length() - s) - curve.point(s)).norm() < 1e-9);
    CHECK(std::abs(std::remainder(back.heading(curve.length() - s) - curve.heading(s) - pi,
                                  2 * pi)) < 1e-5);
    CHECK(back.reversed().pieces().size() == curve.pieces().size());
  }
  CHECK(Curve().reversed().empty());
}

TEST_CASE("joints are the start and the end of every piece", "[geometry]") {
  const std::vector<Point> points{{0, 0}, {3, 4}, {3, 4}, {3, 10}};
  CHECK(waypoints(polyline(points)) == points);
  CHECK(waypoints(Curve()).empty());
}

TEST_CASE("the nearest point of a curve is as near as any sample", "[geometry]") {
  const std::uint64_t seed = 5;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(40); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Curve curve = any_curve_with_arcs(random);
    const Point p{random.uniform(-2, 2), random.uniform(-2, 2)};
    const Curve::Nearest found = curve.nearest(p);
    double sampled = 100;
    for (const CurvePoint& at : curve.sample(0.01)) {
      sampled = std::min(sampled, distance(p, at.position));
    }
    CHECK(found.distance <= sampled + 1e-11);
    CHECK(found.distance >= sampled - 0.006);
    CHECK(found.distance == distance(p, found.position));
    CHECK((found.s >= 0 && found.s <= curve.length()));
    CHECK((curve.point(found.s) - found.position).norm() < 1e-10);
    const double s = random.uniform(0, curve.length());
    CHECK(curve.nearest(curve.point(s)).distance < 1e-11);
  }
}

TEST_CASE("of several nearest points of a curve the first counts", "[geometry]") {
  const Curve square = polyline({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}});
  CHECK(square.nearest({1, 1}).s == 1);
  CHECK(square.nearest({1, 1}).distance == 1);
  CHECK(square.nearest({3, 3}).s == 4);  // a joint
  CHECK(square.nearest({-1, -1}).s == 0);
  CHECK(square.nearest({-1, -1}).position == Point(0, 0));
  CHECK(square.nearest({1.5, 5}).position == Point(1.5, 2));
  CHECK(square.nearest({1.5, 5}).s == 4.5);
  CHECK(polyline({{7, -2}}).nearest({4, 2}).distance == 5);
}

/// The largest curvature of a piece among samples, taken ever closer around every peak.
double sampled_curvature(const CubicBezier& piece) {
  const int count = 2000, closer = 40;
  double largest = 0;
  const auto at = [&](double t) {
    return std::abs(tutavia::curvature(piece, std::clamp(t, 0.0, 1.0)));
  };
  for (int i = 0; i <= count; ++i) {
    double peak = static_cast<double>(i) / count, step = 1.0 / count;
    if (at(peak) < at(peak - step) || at(peak) < at(peak + step)) continue;
    for (int round = 0; round < 5; ++round, step /= closer / 2) {
      const double middle = peak;
      for (int k = -closer; k <= closer; ++k) {
        const double t = middle + step * k / closer;
        if (at(t) > at(peak)) peak = t;
      }
    }
    largest = std::max(largest, at(peak));
  }
  return largest;
}

TEST_CASE("the largest curvature of a cubic piece is that of its closest sample", "[geometry]") {
  const std::uint64_t seed = 6;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    INFO("seed " << seed << ", round " << round);
    CubicBezier piece;
    for (Point& p : piece.points) p = {random.uniform(0, 4), random.uniform(0, 4)};
    if (round % 5 == 1) piece.points[2] = detail::lerp(piece.points[3], piece.points[0], 0.3);
    if (round % 5 == 2) {  // a parabola
      const Point middle = piece.points[1];
      piece.points[1] = detail::lerp(piece.points[0], middle, 2.0 / 3);
      piece.points[2] = detail::lerp(piece.points[3], middle, 2.0 / 3);
    }
    const double scale = std::pow(10, random.uniform(-12, 12));
    if (round % 5 == 3) {
      for (Point& p : piece.points) p *= scale;
    }
    const double sampled = sampled_curvature(piece), found = max_curvature(piece);
    CHECK(found >= sampled * (1 - 1e-9));
    CHECK(found == Approx(sampled).epsilon(1e-6));
    CHECK(max_curvature(piece.reversed()) == Approx(found).epsilon(1e-9));
    CHECK(max_curvature(Piece{piece}) == found);
  }
}

TEST_CASE("the largest curvature grows as a cubic piece nears a cusp", "[geometry]") {
  for (const double miss : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10}) {
    CAPTURE(miss);
    // At t = 1/2 it is slowest, 3/2 miss, and its acceleration is 6 across.
    const CubicBezier piece{{Point(0, 0), Point(1 + miss, 1), Point(-miss, 1), Point(1, 0)}};
    const double speed = 1.5 * miss;
    CHECK(max_curvature(piece) >= (1 - 1e-12) * std::abs(curvature(piece, 0.5)));
    CHECK(max_curvature(piece) == Approx(6 / (speed * speed)).epsilon(1e-5));
  }
}

TEST_CASE("at a cusp the curvature is infinite, on straight pieces it is 0", "[geometry]") {
  const double infinity = std::numeric_limits<double>::infinity();
  const CubicBezier cusp{{Point(0, 0), Point(1, 1), Point(0, 1), Point(1, 0)}};
  CHECK(max_curvature(cusp) == infinity);
  CHECK(max_curvature(CubicBezier{{Point(0, 0), Point(0, 0), Point(1, 1), Point(2, 0)}}) ==
        infinity);
  CHECK(max_curvature(CubicBezier{{Point(0, 0), Point(1, 3), Point(3, 9), Point(-1, -3)}}) == 0);
  CHECK(max_curvature(CubicBezier{{Point(1, 1), Point(1, 1), Point(1, 1), Point(1, 1)}}) == 0);
  CHECK(max_curvature(QuadraticBezier{{Point(0, 0), Point(3, 1), Point(1.5, 0.5)}}) == 0);
  CHECK(max_curvature(QuadraticBezier{{Point(0.1, 0.7), Point(0.1, 0.7), Point(0.3, 2)}}) == 0);
  CHECK(max_curvature(Segment{{0, 0}, {1, 1}}) == 0);
  CHECK(max_curvature(Arc::around({3, 3}, 0.5, 1, -2)) == 2);
  CHECK(max_curvature(Arc::around({3, 3}, 0, 1, -2)) == 0);
  const double nan = std::nan("");
  CHECK_FALSE(std::isnan(
      max_curvature(CubicBezier{{Point(0, 0), Point(nan, 1), Point(0, 1), Point(1, 0)}})));
}

}  // namespace
