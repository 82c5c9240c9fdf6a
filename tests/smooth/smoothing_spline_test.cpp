// SPDX-License-Identifier: MIT
#include "tutavia/smooth/smoothing_spline.hpp"

#include <cmath>
#include <limits>

#include "support/smoother_contract.hpp"
#include "support/touching_run.hpp"
#include "tutavia/certify/certify.hpp"

namespace {

using namespace tutavia;

TEST_CASE("SmoothingSpline keeps the smoother contract") {
  test::smoother_contract(SmoothingSpline{});
  test::smoother_contract(SmoothingSpline{.smoothing = 5, .output_points = 2});
}

InflatedSpace corridor_with(std::vector<Obstacle> obstacles) {
  return InflatedSpace::build({.bounds = {{-1, -9}, {2500, 9}},
                               .safety_radius = 0.5,
                               .obstacles = std::move(obstacles)})
      .value();
}

std::vector<Point> zigzag(std::size_t count) {
  std::vector<Point> nodes;
  for (std::size_t i = 0; i < count; ++i) {
    nodes.emplace_back(0.2 * static_cast<double>(i), i % 4 < 2 ? 0.0 : 0.2);
  }
  return nodes;
}

/// Whether a curve consists of Bezier pieces only, `count` of them.
bool is_one_spline(const Curve& curve, std::size_t count) {
  return curve.pieces().size() == count &&
         std::all_of(curve.pieces().begin(), curve.pieces().end(),
                     [](const Piece& p) { return p.holds<CubicBezier>(); });
}

/// The sum of squared distances between the nodes and the curve's points at their sites, where the
/// curve's pieces have equal shares of the parameter.
double residual_sum(const Curve& curve, const std::vector<Point>& nodes) {
  std::vector<double> sites{0};
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    sites.push_back(sites.back() + (nodes[i] - nodes[i - 1]).norm());
  }
  const auto count = static_cast<double>(curve.pieces().size());
  double sum = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double t = std::fmin(count * sites[i] / sites.back(), count);
    const double whole = std::fmin(std::floor(t), count - 1);
    const auto& piece = *curve.pieces()[static_cast<std::size_t>(whole)].get_if<CubicBezier>();
    sum += (piece.point(t - whole) - nodes[i]).squaredNorm();
  }
  return sum;
}

/// The largest jumps of direction and curvature where two pieces meet.
std::pair<double, double> largest_jumps(const Curve& curve) {
  double turn = 0, bend = 0;
  for (std::size_t i = 0; i + 1 < curve.pieces().size(); ++i) {
    const auto& in = *curve.pieces()[i].get_if<CubicBezier>();
    const auto& out = *curve.pieces()[i + 1].get_if<CubicBezier>();
    turn = std::fmax(turn, std::abs(turn_angle(in.derivative(1), out.derivative(0))));
    bend = std::fmax(bend, std::abs(curvature(in, 1) - curvature(out, 0)));
  }
  return {turn, bend};
}

TEST_CASE("in the open, a spline spends its bound and has one point per share of the route") {
  const auto space = corridor_with({});
  for (const std::size_t count : {20u, 60u, 400u}) {
    const auto nodes = zigzag(count);
    const Curve input = Curve::polyline(nodes);
    for (const double per_node : {0.0005, 0.001, 0.002}) {
      INFO(count << " nodes, smoothing per node " << per_node);
      const double smoothing = per_node * static_cast<double>(count);
      // Enough points for the pieces to follow the spline closely.
      const SmoothingSpline smoother{.smoothing = smoothing, .output_points = 20'001};
      const auto curve = smoother.smooth(space, input, {}).value();
      REQUIRE(is_one_spline(curve, 20'000));
      const double sum = residual_sum(curve, nodes);
      CHECK(sum <= smoothing * (1 + 1e-4));
      CHECK(sum >= 0.99 * smoothing * (1 - 1e-4));
      CHECK(curve.length() < input.length());
    }
    const auto curve = SmoothingSpline{}.smooth(space, input, {}).value();
    CHECK(is_one_spline(curve, 99));
    CHECK(curve.length() < input.length());
  }
}

TEST_CASE("a spline turns continuously, and its curvature nearly so") {
  const auto space = corridor_with({});
  const Curve input = Curve::polyline(zigzag(60));
  double last = std::numeric_limits<double>::infinity();
  for (const std::size_t points : {100u, 1000u, 10'000u}) {
    const SmoothingSpline smoother{.output_points = points};
    const auto curve = smoother.smooth(space, input, {}).value();
    REQUIRE(is_one_spline(curve, points - 1));
    const auto [turn, bend] = largest_jumps(curve);
    CHECK(turn < 1e-9);
    CHECK(bend < last / 3);
    last = bend;
  }
  CHECK(last < 0.1);
}

TEST_CASE("more smoothing makes a spline shorter and straighter, up to the straight line") {
  const auto space = corridor_with({});
  const auto nodes = zigzag(60);
  const Curve input = Curve::polyline(nodes);
  double last = input.length();
  for (double smoothing = 0.02; smoothing < 0.5; smoothing *= 1.5) {
    const auto curve = SmoothingSpline{.smoothing = smoothing}.smooth(space, input, {}).value();
    CHECK(curve.length() < last);
    last = curve.length();
  }
  for (const double smoothing : {1.0, 1e9, std::numeric_limits<double>::infinity()}) {
    const auto line = SmoothingSpline{.smoothing = smoothing}.smooth(space, input, {}).value();
    REQUIRE(line.pieces().size() == 1);
    CHECK(line.pieces()[0].holds<Segment>());
    CHECK(line.length() == (nodes.back() - nodes.front()).norm());
  }
}

TEST_CASE("nodes on a line become one segment, whatever the smoothing") {
  const auto space = corridor_with({});
  const auto lattice =
      LatticeSpace::build({.bounds = {{0, 0}, {20, 20}}, .safety_radius = 0.5}, {.resolution = 0.1})
          .value();
  const std::vector<Point> line{{0.1, 0.2}, {0.4, 0.35}, {1, 0.65}, {2, 1.15}, {10, 5.15}};
  const std::vector<Point> diagonal{{1, 1}, {12.3, 12.3}};
  for (const double smoothing : {0.0, 1e-12, 0.1}) {
    const SmoothingSpline smoother{.smoothing = smoothing};
    const auto a = smoother.smooth(space, Curve::polyline(line), {}).value();
    REQUIRE(a.pieces().size() == 1);
    CHECK(test::same_curve(a, Curve::polyline(std::vector<Point>{line.front(), line.back()})));
    const auto b = smoother.smooth(lattice, Curve::polyline(diagonal), {}).value();
    CHECK(test::same_curve(b, Curve::polyline(diagonal)));
  }
}

TEST_CASE("smoothing is measured in squared grid spacings where there is a grid") {
  const Workspace world{.bounds = {{-1, -9}, {30, 9}}, .safety_radius = 0.5};
  const auto grid = LatticeSpace::build(world, {.resolution = 0.7}).value();
  const auto open = InflatedSpace::build(world).value();
  const Curve input = Curve::polyline(zigzag(40));
  const auto a = SmoothingSpline{.smoothing = 0.1}.smooth(grid, input, {}).value();
  const auto b = SmoothingSpline{.smoothing = 0.1 * 0.7 * 0.7}.smooth(open, input, {}).value();
  REQUIRE(is_one_spline(a, 99));
  REQUIRE(is_one_spline(b, 99));
  for (std::size_t i = 0; i < 99; ++i) {
    CHECK(distance(end_of(a.pieces()[i]), end_of(b.pieces()[i])) < 1e-9);
  }
}

TEST_CASE("where an obstacle is in the way a part of the route keeps its steps") {
  // Within the first corner, a zone that both legs touch: no spline can cut that corner by much.
  const auto post = corridor_with({Disc{{3.5, -0.5}, 0}});
  const auto disc = corridor_with({Disc{{3.25, -0.75}, 0.25}});
  std::vector<Point> nodes;
  for (int i = 0; i <= 40; ++i) nodes.emplace_back(0.1 * i, 0);
  for (int i = 1; i <= 40; ++i) nodes.emplace_back(4, -0.1 * i);
  for (int i = 1; i <= 60; ++i) nodes.emplace_back(4 + 0.1 * i, -4 + (i % 4 < 2 ? 0 : 0.1));
  const Curve input = Curve::polyline(nodes);
  for (const auto& world : {corridor_with({}), post, disc}) {
    REQUIRE(certify(world, input).status == ProofStatus::proved);
    for (const double smoothing : {1.0, 2.0, 5.0}) {
      INFO("smoothing " << smoothing);
      const auto curve = SmoothingSpline{.smoothing = smoothing}.smooth(world, input, {}).value();
      CHECK(certify(world, curve).status == ProofStatus::proved);
      CHECK(curve.start() == input.start());
      CHECK(curve.end() == input.end());
      CHECK(curve.length() < input.length());
      std::size_t bent = 0;
      for (const Piece& p : curve.pieces()) bent += p.holds<CubicBezier>();
      CHECK(bent >= 10);
      const bool is_open = world.workspace().obstacles.empty();
      CHECK(is_one_spline(curve, 99) == is_open);
      CHECK((bent == curve.pieces().size()) == is_open);
    }
  }
}

TEST_CASE("the spline keeps a run that touches a zone where its rounded steps enter it") {
  const test::TouchingRun run = test::touching_run();
  CHECK(test::same_curve(SmoothingSpline{}.smooth(run.space, run.input, {}).value(), run.input));
}

TEST_CASE("steps that remain of one run of a route come out as that run") {
  const auto space =
      LatticeSpace::build({.bounds = {{0, 0}, {9, 9}}, .safety_radius = 0.5}, {.resolution = 0.1})
          .value();
  const Point corners[] = {{1, 1}, {4.3, 1}, {7, 3.7}, {7, 4}};
  const Curve input = Curve::polyline(corners);
  CHECK(test::same_curve(SmoothingSpline{.smoothing = 0}.smooth(space, input, {}).value(), input));
}

TEST_CASE("points, reversals and repeated nodes are smoothed or left") {
  const auto space = corridor_with({});
  const std::vector<Point> point{{1, 1}}, resting{{1, 1}, {1, 1}},
      there_and_back{{0, 0}, {3, 0}, {0, 0}};
  const std::vector<Point> circuit{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}};
  const std::vector<Point> repeated{{0, 0}, {0, 0}, {1, 0.1}, {1, 0.1}, {1, 0.1}, {2, 0}, {2, 0}};
  const std::vector<Point> tight{{0, 0}, {1, 0}, {1, 1e-13}, {1, 1}, {1 + 1e-15, 1}, {2, 1}};
  CHECK(SmoothingSpline{}.smooth(space, Curve{}, {}).value().empty());
  for (const auto& nodes : {point, resting, there_and_back, circuit, repeated, tight}) {
    for (const double smoothing : {0.0, 1e-6, 1e-3, 0.1, 10.0}) {
      INFO(nodes.size() << " nodes, smoothing " << smoothing);
      const Curve input = Curve::polyline(nodes);
      const auto curve = SmoothingSpline{.smoothing = smoothing}.smooth(space, input, {});
      REQUIRE(curve);
      CHECK(curve->start() == nodes.front());
      CHECK(curve->end() == nodes.back());
      CHECK(curve->length() <= input.length() * (1 + 1e-12));
      CHECK(certify(space, *curve).status == ProofStatus::proved);
    }
  }
}

TEST_CASE("a repeated node counts once") {
  const auto space = corridor_with({});
  const auto nodes = zigzag(40);
  std::vector<Point> repeated;
  for (const Point& p : nodes) repeated.insert(repeated.end(), 1 + repeated.size() % 3, p);
  REQUIRE(repeated.size() > nodes.size());
  const auto a = SmoothingSpline{}.smooth(space, Curve::polyline(nodes), {}).value();
  const auto b = SmoothingSpline{}.smooth(space, Curve::polyline(repeated), {}).value();
  CHECK(is_one_spline(a, 99));
  CHECK(test::same_curve(a, b));
}

TEST_CASE("ten thousand nodes are smoothed, in the open and where sections are cut to pieces") {
  // A square wave of 10 nodes per side.
  std::vector<Point> nodes{{0, 0}};
  const Point steps[] = {{0.2, 0}, {0, 0.2}, {0.2, 0}, {0, -0.2}};
  for (int i = 0; i < 10'000; ++i) nodes.push_back(nodes.back() + steps[i / 10 % 4]);
  const Curve input = Curve::polyline(nodes);
  const auto open = SmoothingSpline{.smoothing = 100}.smooth(corridor_with({}), input, {}).value();
  CHECK(is_one_spline(open, 99));
  CHECK(open.length() < input.length());

  // A post in every tooth that leaves 10 cm on three sides.
  std::vector<Obstacle> posts;
  for (int i = 0; i < 500; ++i) posts.emplace_back(Disc{{1 + 2 * i, 1}, 0.4});
  const auto narrow = corridor_with(posts);
  REQUIRE(certify(narrow, input).status == ProofStatus::proved);
  for (const double smoothing : {10.0, 1e4}) {
    const auto curve = SmoothingSpline{.smoothing = smoothing}.smooth(narrow, input, {}).value();
    CHECK(certify(narrow, curve).status == ProofStatus::proved);
    CHECK(curve.length() <= input.length());
    CHECK(curve.length() > 0.7 * input.length());
    CHECK(curve.pieces().size() > 500);
  }
}

TEST_CASE("options without meaning and routes that are no free polylines are refused") {
  const auto space = corridor_with({Disc{{2, 0}, 0.5}});
  const std::vector<Point> free{{0, 2}, {4, 2}}, blocked{{0, 0}, {4, 0}};
  const Curve input = Curve::polyline(free);
  const auto refusal = [&](const SmoothingSpline& smoother, const Curve& curve) {
    return smoother.smooth(space, curve, {}).error();
  };
  for (const double bad : {-1e-300, std::nan("")}) {
    CHECK(refusal({.smoothing = bad}, input).code == PlanError::invalid_option);
    CHECK(refusal({.smoothing = bad}, input).detail == "smoothing must not be negative");
  }
  for (const std::size_t bad : {0u, 1u, 1'000'001u}) {
    CHECK(refusal({.output_points = bad}, input).code == PlanError::invalid_option);
    CHECK(refusal({.output_points = bad}, input).detail.find("output_points") == 0);
  }
  Curve bent;
  bent.push_back(QuadraticBezier{{Point(0, 2), Point(1, 3), Point(2, 2)}});
  CHECK(refusal({}, bent).code == PlanError::invalid_input);
  CHECK(refusal({}, Curve::polyline(blocked)).code == PlanError::invalid_input);
  std::stop_source source;
  source.request_stop();
  const auto cancelled = SmoothingSpline{}.smooth(space, input, {.stop = source.get_token()});
  CHECK(cancelled.error().code == PlanError::cancelled);
}

}  // namespace
