// SPDX-License-Identifier: MIT
#include "tutavia/geometry/arc.hpp"

#include <cmath>
#include <numbers>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/geometry/curve.hpp"

namespace {

using namespace tutavia;
using std::numbers::pi;

TEST_CASE("an arc runs from its first to its last point at a constant distance from its centre") {
  const Arc arc = Arc::around({1, 2}, 3, pi / 2, -pi);
  CHECK(arc.start().isApprox(Point(1, 5)));
  CHECK(arc.end().isApprox(Point(1, -1)));
  CHECK(arc.point(0.5).isApprox(Point(4, 2)));
  CHECK(arc.length() == Approx(3 * pi));
  CHECK(arc.length_to(0.25) == Approx(0.75 * pi));
  CHECK(curvature(arc, 0.3) == Approx(-1.0 / 3));
  CHECK(heading(arc.start_direction()) == Approx(0).margin(1e-15));
  CHECK(std::abs(heading(arc.end_direction())) == Approx(pi));
  CHECK(arc.box().min.isApprox(Point(1, -1)));
  CHECK(arc.box().max.isApprox(Point(4, 5)));
  CHECK(arc.evaluation_error() < 2e-14);
}

TEST_CASE("the box of an arc is as small as its points allow") {
  const std::uint64_t seed = 1;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Arc arc =
        Arc::around({random.uniform(-5, 5), random.uniform(-5, 5)}, random.uniform(0.1, 3),
                    random.uniform(-9, 9), random.uniform(-2 * pi, 2 * pi));
    Box sampled;
    for (int i = 0; i <= 20000; ++i) sampled.include(arc.point(i / 20000.0));
    CHECK((arc.box().min - sampled.min).cwiseAbs().maxCoeff() < 1e-6);
    CHECK((arc.box().max - sampled.max).cwiseAbs().maxCoeff() < 1e-6);
    CHECK(arc.box().inflated(1e-14).contains(sampled));
  }
}

TEST_CASE("an arc approaches a segment as closely as samples of both do") {
  const std::uint64_t seed = 2;
  Random random(seed);
  const auto point = [&] { return Point{random.uniform(-4, 4), random.uniform(-4, 4)}; };
  for (std::size_t round = 0; round < test::scaled(400); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Arc arc = Arc::around(point(), random.uniform(0, 3), random.uniform(-9, 9),
                                random.uniform(-2 * pi, 2 * pi));
    const Point a = point();
    const Segment segment{a, round % 7 == 0 ? a : point()};
    const detail::ClosestApproach found = detail::closest_approach(arc, segment);
    double sampled = distance(arc.a, segment);
    for (int i = 1; i <= 5000; ++i) {
      sampled = std::min(sampled, distance(arc.point(i / 5000.0), segment));
    }
    CHECK(found.distance <= sampled + 1e-13);
    CHECK(found.distance >= sampled - arc.length() / 5000);
    CHECK(distance(arc.point(found.parameter), segment) == Approx(found.distance).margin(1e-12));
  }
}

TEST_CASE("ends off the circle count as evaluation error") {
  Arc arc = Arc::around({0, 0}, 1, 0, pi / 2);
  arc.b += Point(0, 1e-3);
  CHECK(arc.evaluation_error() >= 1e-3);
  CHECK(arc.point(1) == arc.b);
}

TEST_CASE("numbers that make no arc are not finite") {
  CHECK(Arc::around({0, 0}, 1, 0, 2 * pi).is_finite());
  CHECK_FALSE(Arc::around({0, 0}, 1, 0, 7).is_finite());
  CHECK_FALSE(Arc::around({0, 0}, 1, std::nan(""), 1).is_finite());
  CHECK_FALSE(Arc::around({0, 0}, INFINITY, 0, 1).is_finite());
}

Arc any_arc(Random& random) {
  return Arc::around({random.uniform(-4, 4), random.uniform(-4, 4)}, random.uniform(0.1, 3),
                     random.uniform(-9, 9), random.uniform(-2 * pi, 2 * pi));
}

TEST_CASE("parts of an arc and its reverse have exact ends and the same points") {
  const std::uint64_t seed = 3;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    INFO("seed " << seed << ", round " << round);
    Arc arc = any_arc(random);
    arc.b += Point(1e-9, 0);  // ends may be off the circle
    const double from = random.uniform(), to = random.uniform(from, 1), t = random.uniform();
    const Arc part = arc.part(from, to), whole = arc.part(0, 1), back = arc.reversed();
    CHECK(part.a == arc.point(from));
    CHECK(part.b == arc.point(to));
    CHECK((part.point(t) - arc.point(from + t * (to - from))).norm() < 1e-13);
    CHECK(part.length() == Approx((to - from) * arc.length()));
    CHECK((whole.a == arc.a && whole.b == arc.b && whole.sweep == arc.sweep));
    CHECK(arc.part(0, to).a == arc.a);
    CHECK(arc.part(from, 1).b == arc.b);
    CHECK(arc.part(0, to).b == arc.part(to, 1).a);
    CHECK(arc.part(0, 0).b == arc.a);
    CHECK(arc.part(1, 1).a == arc.b);
    CHECK(part.is_finite());
    CHECK((back.a == arc.b && back.b == arc.a));
    CHECK((back.point(t) - arc.point(1 - t)).norm() < 1e-13);
    CHECK(back.start_direction().isApprox(-arc.end_direction()));
  }
}

TEST_CASE("the nearest point of an arc is as near as any sample") {
  const std::uint64_t seed = 4;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Arc arc = any_arc(random);
    const Point p{random.uniform(-4, 4), random.uniform(-4, 4)};
    const double t = arc.nearest_parameter(p);
    CHECK((t >= 0 && t <= 1));
    double sampled = 100;
    for (int i = 0; i <= 5000; ++i) sampled = std::min(sampled, distance(p, arc.point(i / 5000.0)));
    CHECK(distance(p, arc.point(t)) <= sampled + 1e-14);
    CHECK(distance(p, arc.point(t)) >= sampled - arc.length() / 10000);
  }
  const Arc half = Arc::around({0, 0}, 2, 0, pi);
  CHECK(half.nearest_parameter({0, 0}) == 0);
  CHECK(half.nearest_parameter({0, 5}) == Approx(0.5));
  CHECK(half.nearest_parameter({0, -1}) == 0);  // both ends are as near
  CHECK(half.nearest_parameter({-1, -1}) == 1);
}

}  // namespace
