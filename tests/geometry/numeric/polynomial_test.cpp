// SPDX-License-Identifier: MIT
#include "tutavia/geometry/numeric/polynomial.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

/// (t - roots[0]) (t - roots[1]) ...
template <std::size_t N>
Polynomial<N + 1> with_roots(const std::array<double, N>& roots) {
  if constexpr (N == 0) {
    return {1};
  } else {
    std::array<double, N - 1> others;
    std::copy(roots.begin() + 1, roots.end(), others.begin());
    return multiply(with_roots(others), Polynomial<2>{-roots[0], 1});
  }
}

TEST_CASE("polynomials are evaluated, derived and multiplied", "[geometry]") {
  const Polynomial<4> f{1, -2, 3, 4};
  CHECK(evaluate(f, 0) == 1);
  CHECK(evaluate(f, 2) == 1 - 4 + 12 + 32);
  CHECK(derivative(f) == Polynomial<3>{-2, 6, 12});
  CHECK(multiply(Polynomial<2>{1, 2}, Polynomial<3>{3, 0, 5}) == Polynomial<4>{3, 6, 5, 10});
}

TEST_CASE("roots in the unit interval are found in order, others are not", "[geometry]") {
  const auto roots = roots_in_unit_interval(with_roots<5>({0.75, -0.5, 0.25, 0.5, 1.5}));
  REQUIRE(roots.size() == 3);
  CHECK(roots[0] == Approx(0.25).epsilon(1e-14));
  CHECK(roots[1] == Approx(0.5).epsilon(1e-14));
  CHECK(roots[2] == Approx(0.75).epsilon(1e-14));
  CHECK(roots_in_unit_interval(Polynomial<3>{1, 0, 1}).empty());
  CHECK(roots_in_unit_interval(Polynomial<3>{-2, 0, 1}).empty());
  CHECK(roots_in_unit_interval(Polynomial<1>{0}).empty());
}

TEST_CASE("roots at both ends of the interval count", "[geometry]") {
  const auto roots = roots_in_unit_interval(with_roots<3>({0, 1, 0.5}));
  REQUIRE(roots.size() == 3);
  CHECK(roots[0] == 0);
  CHECK(roots[1] == Approx(0.5).epsilon(1e-14));
  CHECK(roots[2] == 1);
  REQUIRE(roots_in_unit_interval(Polynomial<2>{0, 3}).size() == 1);
  CHECK(roots_in_unit_interval(Polynomial<2>{0, 3})[0] == 0);
}

TEST_CASE("a root next to 0 keeps its digits", "[geometry]") {
  for (const double root : {1e-9, 1e-20, 1e-30}) {
    CAPTURE(root);
    const auto roots = roots_in_unit_interval(Polynomial<4>{-root, 1, -1, 0.125});
    REQUIRE(roots.size() == 1);
    CHECK(roots[0] == Approx(root).epsilon(1e-8));
  }
}

TEST_CASE("multiple roots are reported once", "[geometry]") {
  const auto check = [](const auto& f, double root, double tolerance) {
    const auto roots = roots_in_unit_interval(f);
    REQUIRE(roots.size() == 1);
    CHECK(std::abs(roots[0] - root) < tolerance);
  };
  check(with_roots<2>({0.3, 0.3}), 0.3, 1e-7);
  check(with_roots<3>({0.3, 0.3, 0.3}), 0.3, 1e-4);
  check(with_roots<4>({0.7, 0.7, 0.7, 0.7}), 0.7, 1e-3);
  check(with_roots<5>({0.3, 0.3, 0.3, 0.3, 0.3}), 0.3, 1e-2);
  check(with_roots<5>({0, 0, 0, 0, 0}), 0, 1e-9);
  check(with_roots<4>({1, 1, 1, 1}), 1, 1e-3);
  check(with_roots<4>({0.5, 0.5, 2, -1}), 0.5, 1e-7);
}

TEST_CASE("polynomials of lower degree than their coefficients allow have their roots") {
  const auto roots = roots_in_unit_interval(Polynomial<6>{-0.25, 1, 0, 0, 0, 0});
  REQUIRE(roots.size() == 1);
  CHECK(roots[0] == 0.25);
  CHECK(roots_in_unit_interval(Polynomial<6>{1, 0, 0, 0, 0, 0}).empty());
  CHECK(roots_in_unit_interval(Polynomial<6>{}).empty());
}

TEST_CASE("coefficients that are not finite have no roots") {
  const double inf = std::numeric_limits<double>::infinity();
  CHECK(roots_in_unit_interval(Polynomial<3>{-1, std::nan(""), 4}).empty());
  CHECK(roots_in_unit_interval(Polynomial<3>{-1, inf, 4}).empty());
}

TEST_CASE("random quintics have the roots they were made from", "[geometry]") {
  const std::uint64_t seed = 1;
  Random random(seed);
  std::size_t quintics = 0, roots = 0;
  for (std::size_t round = 0; round < test::scaled(2000); ++round) {
    INFO("seed " << seed << ", round " << round);
    std::array<double, 5> made;
    for (double& root : made) root = random.uniform(-1, 2);
    std::sort(made.begin(), made.end());
    double gap = std::min(std::abs(made[0]), std::abs(made[4] - 1));
    for (std::size_t i = 0; i < 5; ++i) {
      gap = std::min({gap, std::abs(made[i]), std::abs(made[i] - 1)});
      if (i > 0) gap = std::min(gap, made[i] - made[i - 1]);
    }
    if (gap < 0.01) continue;
    ++quintics;
    auto f = with_roots(made);
    const double factor = std::pow(10, random.uniform(-30, 30));
    for (double& c : f) c *= factor;
    const auto found = roots_in_unit_interval(f);
    std::size_t i = 0;
    for (const double root : made) {
      if (root < 0 || root > 1) continue;
      REQUIRE(i < found.size());
      CHECK(std::abs(found[i++] - root) < 1e-6);
    }
    CHECK(i == found.size());
    roots += i;
  }
  CHECK(quintics > test::scaled(2000) / 2);
  CHECK(roots > quintics);
}

TEST_CASE("between the roots found the sign never changes", "[geometry]") {
  const std::uint64_t seed = 2;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(500); ++round) {
    INFO("seed " << seed << ", round " << round);
    Polynomial<6> f;
    for (double& c : f) c = random.below(4) == 0 ? 0 : random.uniform(-1, 1);
    const auto roots = roots_in_unit_interval(f);
    double low = 0;
    const auto check_up_to = [&](double high) {
      double least = 0, largest = 0;
      for (int i = 1; i < 200; ++i) {
        const double value = evaluate(f, low + (high - low) * i / 200);
        least = std::min(least, value), largest = std::max(largest, value);
      }
      CHECK((least > -1e-14 || largest < 1e-14));
      low = high;
    };
    for (const double root : roots) {
      CHECK((root >= low && root <= 1));
      CHECK(std::abs(evaluate(f, root)) < 1e-14);
      check_up_to(root);
    }
    check_up_to(1);
  }
}

}  // namespace
