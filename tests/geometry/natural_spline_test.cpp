// SPDX-License-Identifier: MIT
#include "tutavia/geometry/natural_spline.hpp"

#include <Eigen/Dense>
#include <cmath>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;

std::vector<double> sites_of(const std::vector<Point>& data) {
  std::vector<double> sites{0};
  for (std::size_t i = 1; i < data.size(); ++i) {
    sites.push_back(sites.back() + (data[i] - data[i - 1]).norm());
  }
  return sites;
}

double residual_sum(const NaturalSpline& spline, const std::vector<Point>& data) {
  const auto sites = sites_of(data);
  double sum = 0;
  for (std::size_t i = 0; i < data.size(); ++i) {
    sum += (spline.point(sites[i]) - data[i]).squaredNorm();
  }
  return sum;
}

std::vector<Point> random_walk(Random& random, std::size_t count) {
  std::vector<Point> data{{random.uniform(-3, 3), random.uniform(-3, 3)}};
  while (data.size() < count) {
    data.push_back(data.back() + Point(random.uniform(0.01, 1), random.uniform(-1, 1)));
  }
  return data;
}

std::vector<Point> zigzag(std::size_t count) {
  std::vector<Point> data;
  for (std::size_t i = 0; i < count; ++i) {
    data.emplace_back(0.3 * static_cast<double>(i), i % 2 == 0 ? 0.0 : 0.2);
  }
  return data;
}

/// The minimum by brute force: a dense system in the values and the slopes at all sites. Row i of
/// the result holds x, y and their slopes at site i.
Eigen::MatrixXd reference(const std::vector<Point>& data, double penalty) {
  const auto n = static_cast<Eigen::Index>(data.size());
  const auto sites = sites_of(data);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(2 * n, 2);
  for (Eigen::Index i = 0; i + 1 < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double h = sites[at + 1] - sites[at];
    Eigen::Matrix4d energy;  // the integral of the squared second derivative
    energy << 12, 6 * h, -12, 6 * h, 6 * h, 4 * h * h, -6 * h, 2 * h * h, -12, -6 * h, 12, -6 * h,
        6 * h, 2 * h * h, -6 * h, 4 * h * h;
    matrix.block<4, 4>(2 * i, 2 * i) += penalty / (h * h * h) * energy;
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    matrix(2 * i, 2 * i) += 1;
    right.row(2 * i) = data[static_cast<std::size_t>(i)].transpose();
  }
  for (const Eigen::Index i : {Eigen::Index{0}, n - 1}) {
    matrix.row(2 * i).setZero();
    matrix(2 * i, 2 * i) = 1;
  }
  const Eigen::MatrixXd solution = matrix.fullPivLu().solve(right);
  Eigen::MatrixXd result(n, 4);
  for (Eigen::Index i = 0; i < n; ++i) {
    result.row(i) << solution.row(2 * i), solution.row(2 * i + 1);
  }
  return result;
}

TEST_CASE("a smoothing spline solves the dense equations of its minimum") {
  const std::uint64_t seed = 91;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto data = random_walk(random, 2 + random.below(14));
    const double penalty = std::pow(10, random.uniform(-4, 2));
    const auto spline = NaturalSpline::penalised(data, penalty);
    const auto expected = reference(data, penalty);
    const auto sites = sites_of(data);
    CHECK(spline.end() == Approx(sites.back()));
    for (std::size_t i = 0; i < data.size(); ++i) {
      const auto row = expected.row(static_cast<Eigen::Index>(i));
      CHECK((spline.point(sites[i]) - Point(row(0), row(1))).norm() < 1e-8);
      CHECK((spline.derivative(sites[i]) - Point(row(2), row(3))).norm() < 1e-7);
    }
    CHECK(spline.residual_sum() == Approx(residual_sum(spline, data)).margin(1e-15));
    CHECK(spline.point(0) == data.front());
    CHECK((spline.point(spline.end()) - data.back()).norm() < 1e-14);
  }
}

TEST_CASE("position, slope and bend of a spline are continuous and belong together") {
  const std::uint64_t seed = 92;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(50); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto data = random_walk(random, 3 + random.below(20));
    const auto spline = NaturalSpline::penalised(data, std::pow(10, random.uniform(-3, 1)));
    CHECK(spline.second_derivative(0).norm() == 0);
    CHECK(spline.second_derivative(spline.end()).norm() == 0);
    double bend = 0;
    for (const double t : sites_of(data))
      bend = std::fmax(bend, spline.second_derivative(t).norm());
    const auto sites = sites_of(data);
    for (std::size_t i = 1; i + 1 < sites.size(); ++i) {
      const double before = std::nextafter(sites[i], 0), after = std::nextafter(sites[i], 1e9);
      CHECK((spline.point(after) - spline.point(before)).norm() < 1e-13);
      CHECK((spline.derivative(after) - spline.derivative(before)).norm() < 1e-11 * (1 + bend));
      CHECK((spline.second_derivative(after) - spline.second_derivative(before)).norm() <
            1e-11 * (1 + bend));
    }
    for (int i = 1; i < 40; ++i) {
      const double t = spline.end() * i / 40, h = 1e-5;
      const Point slope = (spline.point(t + h) - spline.point(t - h)) / (2 * h);
      const Point change = (spline.derivative(t + h) - spline.derivative(t - h)) / (2 * h);
      CHECK((slope - spline.derivative(t)).norm() < 1e-6 * (1 + bend));
      CHECK((change - spline.second_derivative(t)).norm() < 1e-2 * (1 + bend));
    }
  }
}

TEST_CASE("without a penalty a spline interpolates, with a growing one it nears the chord") {
  const auto data = zigzag(15);
  const auto through = NaturalSpline::penalised(data, 0);
  CHECK(residual_sum(through, data) < 1e-28);
  CHECK_FALSE(through.is_straight());
  double last = 0;
  for (double penalty = 1e-8; penalty < 1e9; penalty *= 3) {
    const double sum = residual_sum(NaturalSpline::penalised(data, penalty), data);
    CHECK(sum >= last * (1 - 1e-9));
    last = sum;
  }
  const auto chord = NaturalSpline::within(data, 1e9);
  CHECK(chord.is_straight());
  CHECK(last == Approx(residual_sum(chord, data)).epsilon(1e-4));
  CHECK(chord.derivative(1).normalized().isApprox((data.back() - data.front()).normalized()));
}

TEST_CASE("a spline within a bound uses 99 % of it, unless the chord needs less") {
  for (const std::size_t count : {3u, 4u, 5u, 50u, 1000u, 10'000u}) {
    const auto data = zigzag(count);
    const double chord = residual_sum(NaturalSpline::within(data, 1e9), data);
    for (const double part : {1e-9, 1e-3, 0.1, 0.9, 0.999}) {
      INFO(count << " points, " << part << " of the chord's sum");
      const auto spline = NaturalSpline::within(data, part * chord);
      const double sum = residual_sum(spline, data);
      CHECK(sum <= part * chord * (1 + 1e-6));
      CHECK(sum >= 0.99 * part * chord * (1 - 1e-6));
      CHECK_FALSE(spline.is_straight());
    }
    CHECK(NaturalSpline::within(data, chord * (1 + 1e-9)).is_straight());
    CHECK(residual_sum(NaturalSpline::within(data, 0), data) < 1e-20);
  }
}

TEST_CASE("a long and all but straight spline still turns continuously") {
  std::vector<Point> data;  // an arc of 2 rad
  for (int i = 0; i < 10'000; ++i) {
    data.emplace_back(500 * std::cos(2e-4 * i), 500 * std::sin(2e-4 * i));
  }
  const double chord = NaturalSpline::within(data, 1e300).residual_sum();
  const auto spline = NaturalSpline::within(data, 0.9 * chord);
  CHECK(residual_sum(spline, data) == Approx(0.895 * chord).epsilon(0.006));
  const auto sites = sites_of(data);
  double jump = 0;
  for (std::size_t i = 1; i + 1 < sites.size(); ++i) {
    const Point before = spline.derivative(std::nextafter(sites[i], 0));
    jump = std::fmax(jump, (spline.derivative(sites[i]) - before).norm());
  }
  CHECK(jump < 1e-12);
}

TEST_CASE("a spline far from the origin is the same spline") {
  const auto near = zigzag(30);
  std::vector<Point> far;
  const Point offset(16384, -32768);
  for (const Point& p : near) far.push_back(p + offset);
  const auto a = NaturalSpline::within(near, 0.05), b = NaturalSpline::within(far, 0.05);
  for (int i = 0; i <= 100; ++i) {
    const double t = a.end() * i / 100;
    CHECK((b.point(t) - offset - a.point(t)).norm() < 1e-10);
    CHECK((b.derivative(t) - a.derivative(t)).norm() < 1e-9);
  }
}

TEST_CASE("splines through one and two points are the point and the line") {
  const std::vector<Point> data{{1, 2}, {4, 6}};
  const auto point = NaturalSpline::within(std::span(data).first(1), 0.1);
  CHECK(point.end() == 0);
  CHECK(point.point(0) == data[0]);
  CHECK(point.derivative(0).norm() == 0);
  CHECK(point.second_derivative(0).norm() == 0);
  for (const auto& line : {NaturalSpline::within(data, 0), NaturalSpline::penalised(data, 0.5)}) {
    CHECK(line.end() == 5);
    CHECK(line.is_straight());
    CHECK(line.point(2.5).isApprox(Point(2.5, 4)));
    CHECK(line.derivative(5).isApprox(Point(0.6, 0.8)));
  }
}

TEST_CASE("points as good as equal, and points that turn back, have finite splines") {
  const std::vector<Point> tight{{0, 0}, {1, 0}, {1, 1e-12}, {1, 1}, {1 + 1e-9, 1}, {2, 1}};
  const std::vector<Point> back{{0, 0}, {1, 0}, {2, 0}, {1, 0}, {0, 0}};
  for (const auto& data : {tight, back}) {
    for (const double bound : {0.0, 1e-6, 0.01, 0.1}) {
      INFO(data.size() << " points, bound " << bound);
      const auto spline = NaturalSpline::within(data, bound);
      for (int i = 0; i <= 50; ++i) {
        CHECK(detail::is_finite(spline.point(spline.end() * i / 50)));
        CHECK(detail::is_finite(spline.derivative(spline.end() * i / 50)));
      }
      CHECK(residual_sum(spline, data) <= bound + 1e-20);
    }
  }
}

}  // namespace
