// SPDX-License-Identifier: MIT
#include "tutavia/geometry/b_spline.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;

/// The B-spline by its definition: sum of control points and Cox's and de Boor's basis functions.
double basis(std::size_t i, int degree, double t, std::size_t n) {
  const auto knot = [&](std::size_t k) {
    return k < 4 ? 0.0 : k >= n ? double(n - 3) : double(k - 3);
  };
  if (degree == 0) {
    const bool last = knot(i + 1) == double(n - 3) && t == double(n - 3) && knot(i) < knot(i + 1);
    return (knot(i) <= t && t < knot(i + 1)) || last ? 1 : 0;
  }
  const auto d = static_cast<std::size_t>(degree);
  double sum = 0;
  if (knot(i + d) > knot(i)) {
    sum += (t - knot(i)) / (knot(i + d) - knot(i)) * basis(i, degree - 1, t, n);
  }
  if (knot(i + d + 1) > knot(i + 1)) {
    sum += (knot(i + d + 1) - t) / (knot(i + d + 1) - knot(i + 1)) * basis(i + 1, degree - 1, t, n);
  }
  return sum;
}

TEST_CASE("pieces are the spline of its definition, meet with equal curvature, stay in the hull") {
  const std::uint64_t seed = 33;
  Random random(seed);
  for (int round = 0; round < 60; ++round) {
    INFO("seed " << seed << ", round " << round);
    std::vector<Point> control(4 + random.below(8));
    for (Point& p : control) p = {random.uniform(-5, 5), random.uniform(-5, 5)};
    const std::vector<CubicBezier> pieces = bezier_pieces(control);
    REQUIRE(pieces.size() == control.size() - 3);
    CHECK(pieces.front().start() == control.front());
    CHECK(pieces.back().end() == control.back());
    double length = 0, polygon = 0;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      length += pieces[k].length();
      for (const double t : {0.0, 0.3, 0.8, 1.0}) {
        Point sum = Point::Zero();
        for (std::size_t i = 0; i < control.size(); ++i) {
          sum += basis(i, 3, double(k) + t, control.size()) * control[i];
        }
        CHECK(distance(pieces[k].point(t), sum) < 1e-12);
      }
      if (k == 0) continue;
      CHECK(pieces[k].start() == pieces[k - 1].end());
      CHECK(distance(pieces[k].derivative(0), pieces[k - 1].derivative(1)) < 1e-11);
      CHECK(distance(pieces[k].second_derivative(0), pieces[k - 1].second_derivative(1)) < 1e-10);
    }
    for (std::size_t i = 1; i < control.size(); ++i)
      polygon += distance(control[i - 1], control[i]);
    CHECK(length <= polygon * (1 + 1e-12));
  }
}

TEST_CASE("three equal control points are a corner that the spline passes, its legs straight") {
  const Point corner{4, 0};
  const Point control[] = {{0, 0}, {1, 0}, corner, corner, corner, {4, 2}, {4, 3}};
  const auto pieces = bezier_pieces(control);
  REQUIRE(pieces.size() == 4);
  CHECK(pieces[1].end() == corner);
  CHECK(pieces[2].start() == corner);
  for (const Point& p : pieces[1].points) CHECK(p.y() == 0);
  for (const Point& p : pieces[2].points) CHECK(p.x() == 4);
}

}  // namespace
