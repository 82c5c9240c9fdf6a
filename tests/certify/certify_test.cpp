// SPDX-License-Identifier: MIT
#include "tutavia/certify/certify.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/random_worlds.hpp"
#include "support/reference_distance.hpp"
#include "support/scale.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;

InflatedSpace disc_space(double r) {
  return InflatedSpace::build(
             {.bounds = {{-10, -10}, {10, 10}}, .safety_radius = r, .obstacles = {Disc{{0, 0}, 1}}})
      .value();
}

Curve curve_of(const Piece& piece) {
  Curve curve;
  curve.push_back(piece);
  return curve;
}

TEST_CASE("the interval holds the true clearance of a curve, and is as narrow as asked") {
  const auto space = disc_space(0.5);
  // The parabola x = 4 - 8 t, y = 2 - 4 t + 4 t^2 has its apex at (0, 1.5 - ...): y(1/2) = 1.
  const QuadraticBezier arch{{Point(4, 4), Point(0, 0.5), Point(-4, 4)}};
  const double apex = arch.point(0.5).y();  // 2.25, and the nearest point to the disc
  const Certificate c = certify(space, curve_of(arch));
  CHECK(c.status == ProofStatus::proved);
  CHECK(c.lower <= apex - 1);
  CHECK(c.upper >= apex - 1);
  CHECK(c.upper - c.lower <= 1e-6);
  CHECK(c.parameter == Approx(0.5).margin(1e-2));
  CHECK(c.obstacle == 0);
  CHECK((c.point - arch.point(c.parameter)).norm() == 0);
}

TEST_CASE("a curve that only looks safe at samples is refused, with a witness") {
  // A flat arc that dips 1e-9 below the safety distance between coarse samples.
  const double r = 0.5;
  const auto space = disc_space(r);
  const double low = 1 + r - 1e-9;
  const QuadraticBezier arc{{Point(-1, low + 1), Point(0, low - 1), Point(1, low + 1)}};
  const Certificate c = certify(space, curve_of(arc));
  CHECK(c.status == ProofStatus::violated);
  CHECK(c.obstacle == 0);
  CHECK(c.upper < r);
  CHECK(test::reference_clearance(space.workspace(), c.point) < r);

  const QuadraticBezier safe{
      {Point(-1, low + 1 + 2e-9), Point(0, low - 1 + 2e-9), Point(1, low + 1 + 2e-9)}};
  CHECK(certify(space, curve_of(safe)).status == ProofStatus::proved);
}

/// A space whose distances are 0.01 m too low, and which says so.
class Blurred {
 public:
  explicit Blurred(InflatedSpace space) : space_(std::move(space)) {}

  bool is_free(const Point& p) const { return space_.is_free(p); }
  bool segment_free(const Point& p, const Point& q) const { return space_.segment_free(p, q); }
  const Box& bounds() const { return space_.bounds(); }
  double clearance(const Point& p) const { return space_.clearance(p) - error; }
  template <class P>
  NearestObstacle nearest(const P& piece, double cap) const {
    NearestObstacle found = space_.nearest(piece, cap + error);
    found.distance -= error;
    return found;
  }
  bool is_inside(const Point& p) const { return space_.is_inside(p); }
  double safety_radius() const { return space_.safety_radius(); }
  double distance_error_bound() const { return 1.001 * error; }
  double largest_coordinate() const { return space_.largest_coordinate(); }

 private:
  static constexpr double error = 0.01;

  InflatedSpace space_;
};

TEST_CASE("a space may be less exact than rounding: the interval and the verdicts allow for it") {
  const Blurred space(disc_space(0.5));
  const auto check = [&](double distance_to_disc) {
    const double y = 1 + distance_to_disc;
    const Piece pieces[] = {Segment{{-3, y}, {3, y}}, Arc::around({0, y + 1}, 1, -2, 1),
                            QuadraticBezier{{Point(-2, y + 1), Point(0, y - 1), Point(2, y + 1)}}};
    for (const Piece& piece : pieces) {
      const Certificate c = certify(space, curve_of(piece));
      if (distance_to_disc < 0.47) CHECK(c.status == ProofStatus::violated);
      if (distance_to_disc < 0.5) CHECK(c.status != ProofStatus::proved);
      if (distance_to_disc > 0.5) CHECK(c.status != ProofStatus::violated);
      if (c.status != ProofStatus::proved) continue;
      CHECK(c.lower <= distance_to_disc);
      CHECK(c.upper >= distance_to_disc);
    }
  };
  for (const double d : {0.46, 0.495, 0.501, 0.505, 0.509, 0.515, 0.53, 2.0}) check(d);
}

TEST_CASE("no verdict is wrong on random pieces in random worlds") {
  const std::uint64_t seed = 5;
  test::WorldGenerator worlds(seed);
  std::size_t proved = 0, violated = 0, undecided = 0;
  for (std::size_t round = 0; round < test::scaled(600); ++round) {
    INFO("seed " << seed << ", round " << round);
    const Workspace world = worlds.workspace();
    const auto space = InflatedSpace::build(world).value();
    const Point p = worlds.point(world);
    const double size = world.bounds.width() / 8;
    const auto near = [&](const Point& q) {
      return Point{q.x() + worlds.random().uniform(-size, size),
                   q.y() + worlds.random().uniform(-size, size)};
    };
    const Point q = near(p), s = near(q);
    const double bend = worlds.random().uniform(-4, 4) / size;
    const Piece piece = round % 4 == 0   ? Piece(Segment{p, q})
                        : round % 4 == 1 ? Piece(QuadraticBezier{{p, q, s}})
                        : round % 4 == 2
                            ? Piece(CubicBezier{{p, q, s, near(s)}})
                            : Piece(Clothoid::from(p, heading(s - p), bend, -bend / size, size));
    const Curve curve = curve_of(piece);
    const Certificate c = certify(space, curve);
    const auto sampled = test::sampled_clearance(world, curve, 100);
    if (c.status == ProofStatus::proved) {
      ++proved;
      CHECK(sampled >= world.safety_radius - space.distance_error_bound());
      CHECK(c.lower >= world.safety_radius);
      CHECK(c.lower <= static_cast<double>(sampled) + space.distance_error_bound());
      if (std::isfinite(c.upper)) {
        CHECK(std::abs(static_cast<double>(test::reference_clearance(world, c.point)) - c.upper) <=
              1e-6 + 4 * space.distance_error_bound());
      }
      for (int i = 0; i <= 100; ++i) {
        CHECK(world.bounds.inflated(space.distance_error_bound())
                  .contains(curve.point(curve.length() * i / 100)));
      }
    } else if (c.status == ProofStatus::violated) {
      ++violated;
      const bool outside = !world.bounds.contains(c.point);
      const bool close = test::reference_clearance(world, c.point) <
                         world.safety_radius + static_cast<double>(space.distance_error_bound());
      CHECK((outside || close));
    } else {
      ++undecided;
    }
  }
  CHECK(proved > test::scaled(600) / 20);
  CHECK(violated > test::scaled(600) / 20);
  CHECK(undecided < test::scaled(600) / 20);
}

TEST_CASE("proved means inside the bounds as well") {
  const auto space = disc_space(0.5);
  const Point corner[] = {{5, 5}, {10, 10}, {10, 5}};
  CHECK(certify(space, Curve::polyline(corner)).status == ProofStatus::proved);
  const QuadraticBezier bulge{{Point(9, 3), Point(11.5, 5), Point(9, 7)}};  // apex at x = 10.25
  const Certificate c = certify(space, curve_of(bulge));
  CHECK(c.status == ProofStatus::violated);
  CHECK(c.point.x() > 10);
  const QuadraticBezier inside{{Point(9, 3), Point(10.9, 5), Point(9, 7)}};  // hull out, curve in
  CHECK(certify(space, curve_of(inside)).status == ProofStatus::proved);
}

TEST_CASE("a curve swallowed by an obstacle is violated, though it meets no edge") {
  const auto space = InflatedSpace::build({.bounds = {{0, 0}, {100, 100}},
                                           .safety_radius = 0.5,
                                           .obstacles = {Polygon{{{0, 0}, {100, 0}, {50, 100}}}}})
                         .value();
  const Point line[] = {{45, 30}, {55, 30}};
  CHECK(certify(space, Curve::polyline(line)).status == ProofStatus::violated);
  const QuadraticBezier arc{{Point(45, 30), Point(50, 40), Point(55, 30)}};
  CHECK(certify(space, curve_of(arc)).status == ProofStatus::violated);
}

TEST_CASE("at safety radius 0 nothing inside an obstacle is proved, far from its edges or not") {
  const auto space = InflatedSpace::build({.bounds = {{0, 0}, {100, 100}},
                                           .safety_radius = 0,
                                           .obstacles = {Polygon{{{0, 0}, {100, 0}, {50, 100}}}}})
                         .value();
  for (const Piece& piece : {Piece(Segment{{45, 30}, {55, 30}}), Piece(Segment{{45, 30}, {45, 30}}),
                             Piece(Segment{{50, 0}, {50, 30}}),
                             Piece(QuadraticBezier{{Point(45, 30), Point(50, 40), Point(55, 30)}}),
                             Piece(Arc::around({50, 30}, 5, 0, 3))}) {
    CHECK(certify(space, curve_of(piece)).status != ProofStatus::proved);
  }
  CHECK(certify(space, curve_of(Segment{{45, 30}, {55, 30}})).status == ProofStatus::violated);
  CHECK(certify(space, curve_of(Segment{{0, 0}, {100, 0}})).status == ProofStatus::proved);
}

TEST_CASE("a segment at exactly the safety radius is proved, one ulp closer is violated") {
  const auto space = InflatedSpace::build({.bounds = {{0, 0}, {10, 10}},
                                           .safety_radius = 0.3,
                                           .obstacles = {Polygon{{{0, 0}, {10, 0}}}}})
                         .value();
  const Point exact[] = {{1, 0.3}, {9, 0.3}};
  const Certificate c = certify(space, Curve::polyline(exact));
  CHECK(c.status == ProofStatus::proved);
  CHECK(c.lower == 0.3);
  CHECK(c.upper - c.lower <= 1e-6);
  const Point below[] = {{1, 0.3}, {9, std::nextafter(0.3, 0.0)}};
  CHECK(certify(space, Curve::polyline(below)).status == ProofStatus::violated);
}

TEST_CASE("what is not a curve is never proved") {
  const auto space = disc_space(0.5);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(certify(space, Curve{}).status == ProofStatus::undecided);
  CHECK(certify(space, curve_of(Segment{{2, 2}, {nan, 2}})).status != ProofStatus::proved);
  CHECK(certify(space, curve_of(QuadraticBezier{{Point(2, 2), Point(infinity, 2), Point(3, 3)}}))
            .status != ProofStatus::proved);
  CHECK(
      certify(space, curve_of(CubicBezier{{Point(2, 2), Point(3, nan), Point(3, 3), Point(2, 4)}}))
          .status != ProofStatus::proved);
  CHECK(certify(space, curve_of(QuadraticBezier{{Point(2, 2), Point(1e300, 2), Point(3, 3)}}))
            .status != ProofStatus::proved);
}

TEST_CASE("an arc is proved in closed form, in the bounds as well") {
  const double pi = std::acos(-1);
  const auto space = disc_space(0.5);
  const Certificate around = certify(space, curve_of(Arc::around({0, 0}, 1.5 + 1e-12, 0, 2 * pi)));
  CHECK(around.status == ProofStatus::proved);
  CHECK(around.lower == Approx(0.5));
  CHECK(around.upper - around.lower <= 1e-6);
  CHECK(around.evaluations == 2);
  CHECK(certify(space, curve_of(Arc::around({0, 0}, 1.5 - 1e-12, 0, 1))).status ==
        ProofStatus::violated);
  CHECK(certify(space, curve_of(Arc::around({0, 0}, 1.5, 0.3, 1))).status ==
        ProofStatus::undecided);
  CHECK(certify(space, curve_of(Arc::around({5, 0}, 4.9, pi / 2, -pi))).status ==
        ProofStatus::proved);
  const Certificate out = certify(space, curve_of(Arc::around({5, 0}, 5.1, pi / 2, -pi)));
  CHECK(out.status == ProofStatus::violated);
  CHECK(out.point.x() > 10);
}

TEST_CASE("a single point has a certificate, and an empty world an infinite one") {
  const Point point[] = {{3, 0}};
  const Certificate c = certify(disc_space(0.5), Curve::polyline(point));
  CHECK(c.status == ProofStatus::proved);
  CHECK(c.lower == Approx(2));
  CHECK(c.upper == Approx(2));
  const auto empty = InflatedSpace::build({.bounds = {{0, 0}, {4, 4}}, .safety_radius = 1}).value();
  const Certificate e = certify(empty, Curve::polyline(point));
  CHECK(e.status == ProofStatus::proved);
  CHECK(std::isinf(e.lower));
  CHECK(std::isinf(e.upper));
}

TEST_CASE("a spent budget leaves the curve undecided") {
  const Point line[] = {{3, 0}, {3, 3}};
  CHECK(certify(disc_space(0.5), Curve::polyline(line), {}, Budget::for_seconds(-1)).status ==
        ProofStatus::undecided);
}

/// Stops a budget at one of the distances it is asked for.
struct StoppingSpace : InflatedSpace {
  template <class P>
  NearestObstacle nearest(const P& piece, double cap) const {
    if (++*calls == stop_at) source.request_stop();
    return InflatedSpace::nearest(piece, cap);
  }
  std::shared_ptr<std::size_t> calls = std::make_shared<std::size_t>(0);
  std::size_t stop_at = 0;
  mutable StopSource source{};
};

TEST_CASE("a proof ends soon after it was cancelled, wherever it was") {
  std::vector<Point> line;
  for (int i = 0; i <= 2000; ++i) line.emplace_back(-9 + 0.009 * i, 3);
  const Curve curve = Curve::polyline(line);
  const StoppingSpace all{disc_space(0.5)};
  REQUIRE(certify(all, curve).status == ProofStatus::proved);
  for (std::size_t stop_at = 1; stop_at < *all.calls; stop_at += 150) {
    CAPTURE(stop_at, *all.calls);
    StoppingSpace space{disc_space(0.5)};
    space.stop_at = stop_at;
    const Certificate c = certify(space, curve, {}, Budget{.stop = space.source.get_token()});
    if (stop_at + 64 > *all.calls) continue;  // the last pieces
    CHECK(c.status == ProofStatus::undecided);
    CHECK(std::isinf(c.lower));
    CHECK(*space.calls <= stop_at + 64);
  }
}

}  // namespace
