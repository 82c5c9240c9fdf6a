// SPDX-License-Identifier: MIT
#include "tutavia/io/text/svg_samples.hpp"

#include "support/catch.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

double height_of(const Point& p) { return p.y(); }

TEST_CASE("a curve is sampled from end to end, with the corners between its pieces") {
  const Curve curve = Curve::polyline(std::vector<Point>{{0, 0}, {3, 0}, {3, 1}, {3, 2}});
  const CurveSamples result = sample_curve(curve, 400, height_of);
  CHECK(result.samples.size() > 400);
  CHECK(result.samples.front().s == 0);
  CHECK(result.samples.back().s == Approx(5));
  for (std::size_t i = 0; i < result.samples.size(); ++i) {
    const auto& [s, clearance, curvature] = result.samples[i];
    CHECK(clearance == Approx(std::max(0.0, s - 3)).margin(1e-9));
    CHECK(curvature == 0);
    if (i > 0) CHECK(s - result.samples[i - 1].s < 5.0 / 400 + 1e-9);
  }
  CHECK(result.corners == std::vector<double>{3});  // the second joint is straight
}

TEST_CASE("the largest curvature of a short piece is a sample, and that of a cusp infinite") {
  Curve curve = Curve::polyline(std::vector<Point>{{0, 0}, {100, 0}});
  const QuadraticBezier tight{{Point{100, 0}, Point{100.02, 0}, Point{100.02, 0.03}}};
  curve.push_back(tight);
  const CurveSamples result = sample_curve(curve, 400, height_of);
  CHECK(result.corners.empty());
  double most = 0;
  for (const auto& sample : result.samples) most = std::max(most, sample.curvature);
  CHECK(most == max_curvature(Piece(tight)));

  Curve back;
  back.push_back(CubicBezier{{Point{0, 0}, Point{1, 1}, Point{0, 1}, Point{1, 0}}});
  most = 0;
  for (const auto& sample : sample_curve(back, 400, height_of).samples) {
    most = std::max(most, sample.curvature);
    CHECK_FALSE(std::isnan(sample.curvature));
  }
  CHECK(std::isinf(most));
}

TEST_CASE("single points have no samples") {
  Curve curve;
  curve.push_back(Segment{{1, 1}, {1, 1}});
  CHECK(sample_curve(curve, 400, height_of).samples.empty());
  CHECK(sample_curve(Curve{}, 400, height_of).samples.empty());
}

TEST_CASE("few tight bends do not set the scale of curvature") {
  const auto limit = [](std::vector<double> bends) {
    CurveSamples curve;
    for (const double bend : bends) curve.samples.push_back({0, 0, bend});
    return curvature_limit(std::span(&curve, 1));
  };
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK(limit({}) == 1);
  CHECK(limit({0, 0, infinite}) == 1);
  CHECK(limit({1, 1, 2, 2, 3}) == 3);
  CHECK(limit({1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 500, infinite}) == 3);
  CurveSamples unknown;
  unknown.samples = {{0, infinite, 0}, {1, -2, 0}};
  CHECK(clearance_limit(std::span(&unknown, 1)) == 1);
  unknown.samples.push_back({2, 4, 0});
  CHECK(clearance_limit(std::span(&unknown, 1)) == 4);
}

}  // namespace
