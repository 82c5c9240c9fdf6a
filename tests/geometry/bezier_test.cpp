// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/geometry/bezier.hpp"

namespace {

using namespace tutavia;

template <class Piece>
Piece any_piece(Random& random, double reach) {
  Piece piece;
  for (Point& p : piece.points) p = {random.uniform(-reach, reach), random.uniform(-reach, reach)};
  return piece;
}

/// By Bernstein polynomials in long double.
template <class Piece>
std::array<long double, 2> bernstein(const Piece& piece, long double t) {
  constexpr std::size_t degree = std::tuple_size_v<decltype(piece.points)> - 1;
  std::array<long double, 2> sum{};
  for (std::size_t i = 0; i <= degree; ++i) {
    long double weight = (i == 0 || i == degree) ? 1 : static_cast<long double>(degree);
    for (std::size_t k = 0; k < i; ++k) weight *= t;
    for (std::size_t k = i; k < degree; ++k) weight *= 1 - t;
    sum[0] += weight * piece.points[i].x();
    sum[1] += weight * piece.points[i].y();
  }
  return sum;
}

TEMPLATE_TEST_CASE("a Bezier piece runs from its first to its last control point", "[geometry]",
                   QuadraticBezier, CubicBezier) {
  const std::uint64_t seed = 1;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    const double reach = std::pow(10, static_cast<double>(round % 4) * 3);
    const auto piece = any_piece<TestType>(random, reach);
    INFO("round " << round << " reach " << reach);
    CHECK(piece.point(0) == piece.start());
    CHECK(piece.point(1) == piece.end());
    const double t = random.uniform();
    const auto expected = bernstein(piece, t);
    const Point error{static_cast<double>(piece.point(t).x() - expected[0]),
                      static_cast<double>(piece.point(t).y() - expected[1])};
    CHECK(detail::max_magnitude(error) <= 12 * 0x1p-53 * piece.box().largest_coordinate());
    CHECK(piece.box().inflated(1e-15 * reach).contains(piece.point(t)));
  }
}

TEST_CASE("folds and hairpins have their full length") {
  const auto fold = [](double x) {
    return QuadraticBezier{{Point(0, 0), Point(1, 0), Point(x, 0)}};
  };
  // Out to 1 / (2 - x) and back to x.
  for (const double x : {-0.02, 0.0189, 0.5, -3.0, 1e-9}) {
    CHECK(fold(x).length() == Approx(2 / (2 - x) - x).epsilon(1e-12));
  }
  for (const double x : {-0.0122, -0.3, 0.7}) {
    const QuadraticBezier hairpin{{Point(0, 0), Point(1, 1e-4), Point(x, 0)}};
    double polyline = 0;
    constexpr int chords = 1000000;
    for (int i = 0; i < chords; ++i) {
      polyline += (hairpin.point((i + 1.0) / chords) - hairpin.point((i + 0.0) / chords)).norm();
    }
    CHECK(hairpin.length() == Approx(polyline).epsilon(1e-7));
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(std::isnan(QuadraticBezier{{Point(0, 0), Point(nan, 0), Point(1, 1)}}.length()));
}

TEMPLATE_TEST_CASE("the halves of a Bezier piece trace the same points", "[geometry]",
                   QuadraticBezier, CubicBezier) {
  const std::uint64_t seed = 2;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    const auto piece = any_piece<TestType>(random, 1);
    const auto [left, right] = piece.halves();
    INFO("round " << round);
    CHECK(left.start() == piece.start());
    CHECK(right.end() == piece.end());
    CHECK(left.end() == right.start());
    const double t = random.uniform();
    CHECK((left.point(t) - piece.point(t / 2)).norm() < 1e-14);
    CHECK((right.point(t) - piece.point((1 + t) / 2)).norm() < 1e-14);
    CHECK(left.length() + right.length() == Approx(piece.length()).epsilon(1e-12));
    CHECK(piece.length_to(0.5) == Approx(left.length()).epsilon(1e-12));
  }
}

TEMPLATE_TEST_CASE("the derivatives of a Bezier piece agree with finite differences", "[geometry]",
                   QuadraticBezier, CubicBezier) {
  const std::uint64_t seed = 3;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(100); ++round) {
    const auto piece = any_piece<TestType>(random, 1);
    const auto& p = piece.points;
    const bool cubic = p.size() == 4;
    // The third derivative is constant, so the error of a central difference is known exactly.
    const Point third =
        cubic ? Point(6 * (p[p.size() - 1] - 3 * p[2] + 3 * p[1] - p[0])) : Point(0, 0);
    const double t = random.uniform(), h = 0x1p-8;
    const Point before = piece.point(t - h), at = piece.point(t), after = piece.point(t + h);
    INFO("round " << round << " t " << t);
    CHECK((piece.derivative(t) - ((after - before) / (2 * h) - h * h / 6 * third)).norm() < 1e-12);
    CHECK((piece.second_derivative(t) - (after - 2 * at + before) / (h * h)).norm() < 1e-9);
  }
}

TEMPLATE_TEST_CASE("deviation bounds the distance from the chord, and a quadratic attains it",
                   "[geometry]", QuadraticBezier, CubicBezier) {
  const std::uint64_t seed = 4;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    const auto piece = any_piece<TestType>(random, 1);
    double largest = 0;
    for (int i = 0; i <= 64; ++i) {
      const double t = i / 64.0;
      const Point chord = (1 - t) * piece.start() + t * piece.end();
      largest = std::max(largest, (piece.point(t) - chord).norm());
    }
    INFO("round " << round);
    CHECK(largest <= piece.deviation() + 1e-15);
    if (piece.points.size() == 3) CHECK(largest == Approx(piece.deviation()).epsilon(1e-13));
  }
}

TEST_CASE("deviation is 0 for evenly spaced control points and known for simple arches",
          "[geometry]") {
  CHECK(QuadraticBezier{{Point(1, 1), Point(2, 4), Point(3, 7)}}.deviation() == 0);
  CHECK(CubicBezier{{Point(0, 0), Point(3, 4), Point(6, 8), Point(9, 12)}}.deviation() == 0);
  CHECK(QuadraticBezier{{Point(0, 0), Point(1, 2), Point(2, 0)}}.deviation() == 1);
  CHECK(CubicBezier{{Point(0, 0), Point(1, 4), Point(2, 4), Point(3, 0)}}.deviation() == 3);
}

TEMPLATE_TEST_CASE("the length of a Bezier piece is the limit of ever finer polylines",
                   "[geometry]", QuadraticBezier, CubicBezier) {
  const std::uint64_t seed = 5;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(20); ++round) {
    const auto piece = any_piece<TestType>(random, 1);
    const double to = round % 2 == 0 ? 1 : random.uniform();
    const auto polyline = [&](int chords) {
      double sum = 0;
      for (int i = 0; i < chords; ++i) {
        sum += (piece.point(to * (i + 1) / chords) - piece.point(to * i / chords)).norm();
      }
      return sum;
    };
    const double coarse = polyline(2000), fine = polyline(4000);
    INFO("round " << round << " to " << to);
    CHECK(fine <= piece.length_to(to) * (1 + 1e-12));
    CHECK(piece.length_to(to) <= fine + 2 * std::abs(fine - coarse) + 1e-12);
  }
}

TEST_CASE("lengths known in closed form come out to 1e-12", "[geometry]") {
  const double expected = (2 * std::sqrt(5.0) + std::asinh(2.0)) / 4;  // y = x^2 from 0 to 1
  const QuadraticBezier parabola{{Point(0, 0), Point(0.5, 0), Point(1, 1)}};
  CHECK(parabola.length() == Approx(expected).epsilon(1e-12));
  // The same curve with its degree raised, a million metres away and a thousand times as large.
  const Point far(1e6, -1e6);
  const CubicBezier raised{{far, Point(far + Point(1000 / 3.0, 0)),
                            Point(far + Point(2000 / 3.0, 1000 / 3.0)),
                            Point(far + Point(1000, 1000))}};
  CHECK(raised.length() == Approx(1000 * expected).epsilon(1e-11));
  const CubicBezier straight{{Point(0, 0), Point(3, 4), Point(6, 8), Point(9, 12)}};
  CHECK(straight.length() == Approx(15).epsilon(1e-14));
  CHECK(straight.length_to(0.3) == Approx(4.5).epsilon(1e-14));
  const QuadraticBezier there_and_back{{Point(0, 0), Point(1, 0), Point(0, 0)}};
  CHECK(there_and_back.length() == Approx(1).epsilon(1e-14));
  CHECK(QuadraticBezier{{Point(7, 7), Point(7, 7), Point(7, 7)}}.length() == 0);
}

TEST_CASE("directions skip control points that coincide with an end", "[geometry]") {
  const Point a(1, 1), b(3, 2);
  const CubicBezier doubled{{a, a, b, b}};
  CHECK(doubled.start_direction() == Point(2, 1));
  CHECK(doubled.end_direction() == Point(2, 1));
  const CubicBezier late{{a, a, a, b}}, early{{a, b, b, b}},
      plain{{a, Point(2, 5), Point(4, 4), b}};
  CHECK(late.start_direction() == Point(2, 1));
  CHECK(early.end_direction() == Point(2, 1));
  CHECK(plain.start_direction() == Point(1, 4));
  CHECK(plain.end_direction() == Point(-1, -2));
  CHECK(QuadraticBezier{{a, a, a}}.start_direction() == Point(0, 0));
  CHECK(QuadraticBezier{{a, a, a}}.end_direction() == Point(0, 0));
}

TEST_CASE("the box of a Bezier piece is that of its control points", "[geometry]") {
  const CubicBezier piece{{Point(0, 0), Point(-4, 7), Point(9, -3), Point(2, 2)}};
  CHECK(piece.box().min == Point(-4, -3));
  CHECK(piece.box().max == Point(9, 7));
}

TEST_CASE("a piece is finite when all of its control points are", "[geometry]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  QuadraticBezier piece{{Point(0, 0), Point(1, 0), Point(0, 1)}};
  CHECK(piece.is_finite());
  for (Point& p : piece.points) {
    const Point before = p;
    p.y() = nan;
    CHECK_FALSE(piece.is_finite());
    p = before;
  }
}

TEMPLATE_TEST_CASE("parts of a Bezier piece and its reverse have exact ends and the same points",
                   "[geometry]", QuadraticBezier, CubicBezier) {
  const std::uint64_t seed = 6;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto piece = any_piece<TestType>(random, 1);
    const double from = random.uniform(), to = random.uniform(from, 1), t = random.uniform();
    const auto part = piece.part(from, to);
    CHECK(part.start() == piece.point(from));
    CHECK(part.end() == piece.point(to));
    CHECK((part.point(t) - piece.point(from + t * (to - from))).norm() < 2e-15);
    CHECK((part.derivative(t) - (to - from) * piece.derivative(from + t * (to - from))).norm() <
          2e-14);
    CHECK(piece.part(0, to).start() == piece.start());
    CHECK(piece.part(from, 1).end() == piece.end());
    CHECK(piece.part(0, to).end() == piece.part(to, 1).start());
    CHECK(piece.part(0, 1).points == piece.points);
    CHECK(piece.part(0, to).length() + piece.part(to, 1).length() ==
          Approx(piece.length()).epsilon(1e-12));
    for (const double end : {0.0, t, 1.0}) {
      const auto point = piece.part(end, end);
      for (const Point& p : point.points) CHECK(p == piece.point(end));
    }
    CHECK(piece.reversed().start() == piece.end());
    CHECK(piece.reversed().end() == piece.start());
    CHECK((piece.reversed().point(t) - piece.point(1 - t)).norm() < 1e-15);
  }
}

TEMPLATE_TEST_CASE("the nearest point of a Bezier piece is as near as any sample", "[geometry]",
                   QuadraticBezier, CubicBezier) {
  const std::uint64_t seed = 7;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    INFO("seed " << seed << ", round " << round);
    auto piece = any_piece<TestType>(random, 1);
    const Point shift = round % 3 == 0 ? Point(4e6, -6e5) : Point(0, 0);
    for (Point& q : piece.points) q += shift;
    Point p = shift + Point(random.uniform(-1, 1), random.uniform(-1, 1));
    if (round % 4 == 1) p = piece.point(random.uniform());
    const double rounding = 1e-14 + 1e-15 * detail::max_magnitude(shift);
    const double t = piece.nearest_parameter(p), found = distance(p, piece.point(t));
    CHECK((t >= 0 && t <= 1));
    double sampled = 10;
    for (int i = 0; i <= 5000; ++i) sampled = std::min(sampled, distance(p, piece.point(i / 5e3)));
    CHECK(found <= sampled + rounding);
    CHECK(found >= sampled - 1e-3);  // no faster than 10
    if (round % 4 == 1) CHECK(found <= rounding);
    // Inside, the way to the piece is perpendicular to it.
    if (t > 0 && t < 1 && shift.isZero()) {
      CHECK(std::abs((piece.point(t) - p).dot(piece.derivative(t))) < 1e-12);
    }
  }
}

TEST_CASE("of several nearest points of a Bezier piece the first counts", "[geometry]") {
  const CubicBezier arch{{Point(-1, 0), Point(-1, 4), Point(1, 4), Point(1, 0)}};
  const double first = arch.nearest_parameter({0, 1});  // both flanks are as near
  CHECK((first > 0 && first < 0.4));
  CHECK(arch.reversed().nearest_parameter({0, 1}) == Approx(first).epsilon(1e-9));
  CHECK(arch.nearest_parameter({0, -1}) == 0);
  CHECK(arch.nearest_parameter({-2, -1}) == 0);
  CHECK(arch.nearest_parameter({2, -1}) == 1);
  CHECK(arch.nearest_parameter({0, 9}) == Approx(0.5));
  const CubicBezier loop{{Point(0, 0), Point(4, 4), Point(-4, 4), Point(0, 0)}};
  CHECK(loop.nearest_parameter({0, 0}) == 0);
  const CubicBezier crossing{{Point(-1, 0), Point(3, 3), Point(-3, 3), Point(1, 0)}};
  const double t = 0.5 - std::sqrt(0.15);  // x = 0 there, and again at 1 - t
  CHECK(crossing.nearest_parameter({0, crossing.point(t).y()}) == Approx(t).epsilon(1e-12));
  CHECK(QuadraticBezier{{Point(2, 2), Point(2, 2), Point(2, 2)}}.nearest_parameter({0, 0}) == 0);
  const CubicBezier straight{{Point(0, 0), Point(1, 0), Point(2, 0), Point(3, 0)}};
  CHECK(straight.nearest_parameter({1.5, 7}) == Approx(0.5));
}

TEST_CASE("a point as far from all of a Bezier piece has a nearest one all the same") {
  // Nearly a circle: the closer the sweep is to 0, the less the distance from the centre varies.
  for (const double sweep : {1.5, 0.5, 0.1}) {
    INFO("sweep " << sweep);
    const double k = 4.0 / 3 * std::tan(sweep / 4);
    const auto on = [](double angle) { return Point(std::cos(angle), std::sin(angle)); };
    const CubicBezier arc{{on(0), Point(on(0) + k * detail::perpendicular(on(0))),
                           Point(on(sweep) - k * detail::perpendicular(on(sweep))), on(sweep)}};
    CHECK(distance({0, 0}, arc.point(arc.nearest_parameter({0, 0}))) == Approx(1).epsilon(1e-11));
  }
}

}  // namespace
