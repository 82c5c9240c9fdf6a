// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;

static_assert(std::uniform_random_bit_generator<Random>);
static_assert(Random::min() == 0 && Random::max() == 0xFFFFFFFFFFFFFFFFu);

TEST_CASE("Random gives the published numbers of SplitMix64", "[core]") {
  Random from_zero(0);
  CHECK(from_zero() == 0xE220A8397B1DCDAFu);
  CHECK(from_zero() == 0x6E789E6AA1B965F4u);
  CHECK(from_zero() == 0x06C45D188009454Fu);
  Random other(1234567);
  CHECK(other() == 6457827717110365317u);
  CHECK(other() == 3203168211198807973u);
}

TEST_CASE("equal seeds and copies give equal numbers, other seeds others", "[core]") {
  Random a(5), b(5), c(6);
  CHECK(a() == b());
  CHECK(a() != c());
  Random copy = a;
  CHECK(copy() == a());
}

TEST_CASE("uniform() is a multiple of 2^-53 from 0 to below 1, made of the upper bits", "[core]") {
  const std::uint64_t seed = 1;
  CAPTURE(seed);
  Random random(seed), bits(seed);
  double sum = 0, square = 0;
  const std::size_t rounds = test::scaled(10000);
  for (std::size_t round = 0; round < rounds; ++round) {
    const double x = random.uniform();
    const double scaled = std::ldexp(x, 53);
    if (!(0 <= x && x < 1 && scaled == std::floor(scaled))) FAIL("round " << round << ": " << x);
    if (static_cast<std::uint64_t>(scaled) != bits() >> 11) FAIL("round " << round);
    sum += x;
    square += x * x;
  }
  const double n = static_cast<double>(rounds);
  CHECK(std::abs(sum / n - 1.0 / 2) < 5 * std::sqrt(1.0 / 12 / n));  // 5 standard deviations
  CHECK(std::abs(square / n - 1.0 / 3) < 5 * std::sqrt(4.0 / 45 / n));
}

TEST_CASE("uniform(low, high) maps the unit interval linearly", "[core]") {
  Random random(3), unit(3);
  for (int round = 0; round < 100; ++round) {
    const double u = unit.uniform();
    const double x = random.uniform(-3, 5);
    CHECK(x == Approx(-3 + 8 * u).margin(1e-15));
    CHECK((-3 <= x && x < 5));
  }
  CHECK(random.uniform(2, 2) == 2);
}

TEST_CASE("below(bound) reaches every number below the bound about equally often", "[core]") {
  const std::uint64_t seed = 1;
  CAPTURE(seed);
  Random random(seed);
  std::array<double, 10> counts{};
  const std::size_t rounds = test::scaled(10000);
  for (std::size_t round = 0; round < rounds; ++round) ++counts.at(random.below(counts.size()));
  double chi_square = 0;
  const double expected = static_cast<double>(rounds) / 10;
  for (const double count : counts) {
    chi_square += (count - expected) * (count - expected) / expected;
  }
  CHECK(chi_square < 33.7);  // nine degrees of freedom: exceeded once in 10000 seeds
  CHECK(chi_square > 0.5);   // a mere counter would be too even
}

TEST_CASE("below(0) and below(1) are 0", "[core]") {
  Random random(1);
  CHECK(random.below(0) == 0);
  for (int i = 0; i < 10; ++i) CHECK(random.below(1) == 0);
}

}  // namespace
