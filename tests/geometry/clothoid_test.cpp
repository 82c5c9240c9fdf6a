// SPDX-License-Identifier: MIT
#include "tutavia/geometry/clothoid.hpp"

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <numbers>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/geometry/curve.hpp"

namespace {

using namespace tutavia;
using std::numbers::pi;

/// Turning by up to 12 rad or so, with and without an inflection.
Clothoid any_clothoid(Random& random, double scale = 1) {
  return Clothoid::from({scale * random.uniform(-4, 4), scale * random.uniform(-4, 4)},
                        random.uniform(-9, 9), random.uniform(-3, 3) / scale,
                        random.uniform(-2, 2) / (scale * scale), scale * random.uniform(0.01, 3));
}

/// The place at parameter t, by the power series of the direction in fifty digits.
std::array<double, 2> reference(const Clothoid& c, double t) {
  using F = boost::multiprecision::cpp_bin_float_50;
  const F length = F(t) * F(c.arc_length);
  F re = 1, im = 0, re_before = 0, im_before = 0, x = 0, y = 0;
  for (int n = 0; n < 600; ++n) {
    x += re / (n + 1), y += im / (n + 1);
    const F u = c.start_curvature * length * re + c.sharpness * length * length * re_before;
    const F v = c.start_curvature * length * im + c.sharpness * length * length * im_before;
    re_before = re, im_before = im;
    re = -v / (n + 1), im = u / (n + 1);
  }
  const F cosine = cos(F(c.start_heading)), sine = sin(F(c.start_heading));
  return {static_cast<double>(F(c.a.x()) + length * (x * cosine - y * sine)),
          static_cast<double>(F(c.a.y()) + length * (x * sine + y * cosine))};
}

TEST_CASE("the places of a clothoid are those of its integral within the error it states") {
  const std::uint64_t seed = 1;
  Random random(seed);
  double worst = 0;
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Clothoid c = any_clothoid(random, round % 3 == 0 ? 1e-3 : round % 3 == 1 ? 1 : 1e4);
    const double t = random.uniform();
    for (const double at : {t, 1.0}) {
      const auto [x, y] = reference(c, at);
      const double error = distance(c.point(at), {x, y});
      CHECK(error <= c.rounding());
      worst = std::max(worst, error / c.rounding());
    }
    CHECK(c.evaluation_error() == c.rounding());
  }
  CHECK(worst > 0.01);  // a bound that says something
}

TEST_CASE("a clothoid of no sharpness is an arc, and one of no curvature is straight") {
  const Clothoid circle = Clothoid::from({1, 2}, pi / 2, 0.5, 0, 2 * pi);
  CHECK(circle.end().isApprox(Point(-3, 2)));
  CHECK(circle.point(0.5).isApprox(Point(-1, 4)));
  CHECK(heading(circle.end_direction()) == Approx(-pi / 2));
  CHECK(curvature(circle, 0.3) == Approx(0.5));
  const Clothoid straight = Clothoid::from({1, 2}, 0, 0, 0, 5);
  CHECK(straight.point(0.3).isApprox(Point(2.5, 2)));
  CHECK(straight.deviation() == 0);
  // The classical spiral: the place where it has turned by a right angle (Abramowitz and Stegun
  // 1964, table 7.7: C(1) = 0.7798934, S(1) = 0.4382591).
  const Clothoid cornu = Clothoid::from({0, 0}, 0, 0, pi, 1);
  CHECK(cornu.end().x() == Approx(0.7798934).epsilon(2e-7));
  CHECK(cornu.end().y() == Approx(0.4382591).epsilon(2e-7));
}

TEST_CASE("a clothoid's directions, curvature and bounds are those of its points") {
  const std::uint64_t seed = 2;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Clothoid c = any_clothoid(random);
    const double t = random.uniform(0.01, 0.99), h = 1e-5;
    const Point slope = (c.point(t + h) - c.point(t - h)) / (2 * h);
    CHECK((slope - c.derivative(t)).norm() < 1e-6 * (1 + c.arc_length));
    const Point bend = (c.derivative(t + h) - c.derivative(t - h)) / (2 * h);
    CHECK((bend - c.second_derivative(t)).norm() < 1e-5 * (1 + bend.norm()));
    CHECK(curvature(c, t) == Approx(c.curvature_at(t)).margin(1e-12));
    CHECK(std::abs(c.curvature_at(t)) <= max_curvature(c) * (1 + 1e-15));
    CHECK(std::remainder(heading(c.derivative(t)) - c.start_heading - c.turn_to(t), 2 * pi) ==
          Approx(0).margin(1e-12));
    for (int i = 0; i <= 50; ++i) {
      const Point p = c.point(i / 50.0);
      CHECK(c.box().inflated(1e-14).contains(p));
      CHECK(distance(p, detail::lerp(c.a, c.b, i / 50.0)) <= c.deviation() + 1e-14);
    }
  }
}

TEST_CASE("parts of a clothoid and its reverse have exact ends and the same points") {
  const std::uint64_t seed = 3;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    INFO("seed " << seed << ", round " << round);
    Clothoid c = any_clothoid(random);
    c.b += Point(1e-12, 0);  // the end may be off the curve
    const double from = random.uniform(), to = random.uniform(from, 1), t = random.uniform();
    const Clothoid part = c.part(from, to), back = c.reversed();
    CHECK(part.a == c.point(from));
    CHECK(part.b == c.point(to));
    CHECK((part.point(t) - c.point(from + t * (to - from))).norm() < 1e-12);
    CHECK(part.curvature_at(t) == Approx(c.curvature_at(from + t * (to - from))).margin(1e-12));
    CHECK((back.a == c.b && back.b == c.a));
    CHECK((back.point(t) - c.point(1 - t)).norm() < 2e-12);
    CHECK(back.curvature_at(t) == Approx(-c.curvature_at(1 - t)).margin(1e-12));
    CHECK(back.start_direction().isApprox(-c.end_direction()));
    const auto [left, right] = c.halves();
    CHECK(left.b == right.a);
    CHECK((left.a == c.a && right.b == c.b));
  }
}

TEST_CASE("the nearest point of a clothoid is as near as any sample") {
  const std::uint64_t seed = 4;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Clothoid c = any_clothoid(random);
    const Point p{random.uniform(-4, 4), random.uniform(-4, 4)};
    const double t = c.nearest_parameter(p);
    CHECK((t >= 0 && t <= 1));
    double sampled = 100;
    for (int i = 0; i <= 2000; ++i) sampled = std::min(sampled, distance(p, c.point(i / 2000.0)));
    CHECK(distance(p, c.point(t)) <= sampled + 1e-10);
    CHECK(distance(p, c.point(t)) >= sampled - c.arc_length / 4000);
  }
}

TEST_CASE("the nearest point of a circle to its centre is found soon") {
  std::size_t places = 0;
  for (const double sharpness : {0.0, 1e-12, 1e-9, 1e-6}) {
    for (int i = 0; i < 50; ++i, ++places) {
      const Clothoid c = Clothoid::from({1, 0}, pi / 2, 1, sharpness, 3);
      const Point p = c.point(c.nearest_parameter({0, 0}));
      CHECK(p.norm() <= c.end().norm() + 4e-6);
      CHECK(p.norm() == Approx(1).epsilon(4e-6));
    }
  }
  CHECK(places == 200);  // two minutes and more, if every part were halved to the last
}

TEST_CASE("numbers that make no clothoid are not finite") {
  CHECK(Clothoid::from({0, 0}, 0, 2, 0, 32).is_finite());
  CHECK_FALSE(Clothoid::from({0, 0}, 0, 2, 0, 33).is_finite());
  CHECK_FALSE(Clothoid::from({0, 0}, 0, 1e300, 1e300, 1e300).is_finite());
  CHECK_FALSE(Clothoid::from({0, 0}, std::nan(""), 0, 0, 1).is_finite());
  CHECK_FALSE(Clothoid::from({0, 0}, 0, 0, 0, INFINITY).is_finite());
  CHECK_FALSE(Clothoid::from({NAN, 0}, 0, 0, 0, 1).is_finite());
  CHECK_FALSE(Clothoid::from({0, 0}, 0, 100, 0, -3).is_finite());  // turns by 300
}

TEST_CASE("a clothoid in a curve is addressed by its arc length") {
  Curve curve;
  const Clothoid in = Clothoid::from({0, 0}, 0, 0, 0.5, 2);
  curve.push_back(in);
  curve.push_back(in.reversed().reversed().part(1, 1));
  CHECK(curve.length() == 2);
  CHECK(curve.at(1).curvature == Approx(0.5));
  CHECK(curve.at(1).heading == Approx(0.25));
  const auto [first, second] = curve.split(1);
  CHECK(first.end() == second.start());
  CHECK(first.length() == Approx(1));
  CHECK(curve.nearest(curve.point(1.3)).s == Approx(1.3));
}

}  // namespace
