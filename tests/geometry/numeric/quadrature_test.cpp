// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "support/catch.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/geometry/numeric/quadrature.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

using std::numbers::pi;

TEST_CASE("eight nodes integrate polynomials exactly up to degree 15 and not beyond",
          "[geometry]") {
  for (int degree = 0; degree <= 15; ++degree) {
    CAPTURE(degree);
    const auto power = [&](double x) { return std::pow(x, degree); };
    const double exact = (std::pow(2.0, degree + 1) - std::pow(-1.0, degree + 1)) / (degree + 1);
    CHECK(gauss_legendre(power, -1, 2) == Approx(exact).epsilon(1e-14));
  }
  const auto power = [](double x) { return std::pow(x, 16); };
  CHECK(gauss_legendre(power, -1, 1) != Approx(2.0 / 17).epsilon(1e-6));
}

TEST_CASE("an integral changes sign with its limits and vanishes between equal ones",
          "[geometry]") {
  const auto f = [](double x) { return std::exp(x); };
  CHECK(integrate(f, 0, 1, 1e-12) == Approx(std::exp(1.0) - 1).epsilon(1e-14));
  CHECK(integrate(f, 1, 0, 1e-12) == -integrate(f, 0, 1, 1e-12));
  CHECK(integrate(f, 3, 3, 0) == 0);
}

TEST_CASE("halving resolves what eight nodes miss", "[geometry]") {
  const auto waves = [](double x) { return std::sin(40 * x) * std::sin(40 * x); };
  CHECK(std::abs(gauss_legendre(waves, 0, pi) - pi / 2) > 1e-3);
  CHECK(integrate(waves, 0, pi, 1e-12) == Approx(pi / 2).epsilon(1e-12));
  const auto root = [](double x) { return std::sqrt(x); };
  CHECK(integrate(root, 0, 1, 1e-10) == Approx(2.0 / 3).margin(1e-10));
  const auto kink = [](double x) { return std::abs(x - 0.3); };
  CHECK(integrate(kink, 0, 1, 1e-10) == Approx(0.29).margin(1e-10));
  const auto peak = [](double x) { return 1e-3 / (x * x + 1e-6); };
  CHECK(integrate(peak, -1, 1, 1e-11) == Approx(2 * std::atan(1e3)).margin(1e-11));
}

TEST_CASE("a finer tolerance costs more evaluations and is kept", "[geometry]") {
  int last = 0;
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    int calls = 0;
    const auto root = [&](double x) { return ++calls, std::sqrt(x); };
    CAPTURE(tolerance);
    CHECK(std::abs(integrate(root, 0, 1, tolerance) - 2.0 / 3) <= tolerance);
    CHECK(calls > last);
    last = calls;
  }
}

TEST_CASE("a function that never settles is halved no further than asked", "[geometry]") {
  Random random(1);
  int calls = 0;
  const auto noise = [&](double) { return ++calls, random.uniform(); };
  CHECK(integrate(noise, 0, 1, 0, 3) == Approx(0.5).margin(0.3));
  CHECK(calls == 7 * 24 + 8 * 16);  // seven intervals halved, eight taken as they are
}

}  // namespace
