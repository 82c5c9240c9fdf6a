// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/geometry/numeric/exact_number.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

__extension__ typedef __int128 Wide;
using Number = ExactNumber;

constexpr double least = std::numeric_limits<double>::denorm_min();
constexpr double largest = std::numeric_limits<double>::max();

bool equal(const Number& a, const Number& b) { return (a - b).sign() == 0; }

Number exact(Wide value) {
  if (value < 0) return -exact(-value);
  // By digits to the base 2^32: g++ 14.2 -O2 loses the upper word in `value >> 43 & mask`.
  Number sum = 0;
  for (int shift = 0; shift < 128; shift += 32) {
    const auto digit = static_cast<std::uint32_t>(value >> shift);
    sum = sum + Number(static_cast<double>(digit)) * std::ldexp(1, shift);
  }
  return sum;
}

/// Any finite double with an exponent of at most 300 in magnitude; small integers now and then.
double any_double(Random& random) {
  if (random.below(4) == 0) return static_cast<double>(random.below(5)) - 2;
  const double magnitude = random.uniform(0.5, 1) * (random.below(2) == 0 ? 1 : -1);
  return std::ldexp(magnitude, static_cast<int>(random.below(601)) - 300);
}

TEST_CASE("an exact number has the sign of the double it was made from", "[geometry]") {
  for (const double x : {least, 0x1p-1022, 0x1p-400, 1.0, 1e9, 0x1p400, largest}) {
    CAPTURE(x);
    CHECK(Number(x).sign() == 1);
    CHECK(Number(-x).sign() == -1);
    CHECK((-Number(x)).sign() == -1);
    CHECK((Number(x) - x).sign() == 0);
    CHECK((Number(x) - std::nextafter(x, 0.0)).sign() == 1);
  }
  CHECK(Number(0.0).sign() == 0);
  CHECK(Number(-0.0).sign() == 0);
  CHECK((-Number(0.0)).sign() == 0);
}

TEST_CASE("no bit is lost however far apart the magnitudes lie", "[geometry]") {
  const Number huge = 0x1p400, tiny = 0x1p-400;
  CHECK((huge + tiny - huge).sign() == 1);
  CHECK(equal(huge + tiny - huge, tiny));
  CHECK(equal((huge + tiny) * (huge + tiny), Number(0x1p800) + 2 + 0x1p-800));
  CHECK(equal((huge + tiny) * (huge - tiny), Number(0x1p800) - 0x1p-800));
  CHECK(equal(huge * tiny, 1));
  const Number product = Number(largest) * largest;
  CHECK((product + Number(least) * least - product).sign() == 1);
  CHECK((product - Number(least) * least - product).sign() == -1);
}

TEST_CASE("cancellation leaves exactly what remains", "[geometry]") {
  const Number x = 1 + 0x1p-52;
  const Number zero = x * x - 1 - 0x1p-51 - 0x1p-104;
  CHECK(zero.sign() == 0);
  CHECK((zero - least).sign() == -1);
  CHECK((zero + least).sign() == 1);
  CHECK(equal(zero * x + 3, 3));
  const Number ones = 0x1p53 - 1;  // all bits set: carries and borrows run through every limb
  CHECK(equal(ones * ones, Number(0x1p106) - 0x1p54 + 1));
  for (int bits = 1; bits <= 200; ++bits) {  // a carry or borrow through every bit
    CAPTURE(bits);
    const Number power = std::ldexp(1, bits);
    CHECK(equal(power - 1 + 1, power));
    CHECK((power - 1 - power).sign() == -1);
    CHECK((power - 1 + 1 - std::nextafter(std::ldexp(1, bits), 0)).sign() == 1);
  }
}

TEST_CASE("sums and products of integers agree with 128-bit arithmetic", "[geometry]") {
  const std::uint64_t seed = 1;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(1000); ++round) {
    Wide n[4];
    for (Wide& value : n) {
      value = static_cast<std::int64_t>(random() >> 1 >> (10 + random.below(53)));
      if (random.below(2) == 0) value = -value;
    }
    const auto number = [&](int i) { return Number(static_cast<double>(n[i])); };
    INFO("round " << round);
    CHECK(equal(number(0) * number(1) + number(2) * number(3), exact(n[0] * n[1] + n[2] * n[3])));
    CHECK(equal(number(0) * number(1) - number(2) - number(3), exact(n[0] * n[1] - n[2] - n[3])));
    const Wide difference = n[0] * n[1] - n[2] * n[3];
    CHECK((number(0) * number(1) - number(2) * number(3)).sign() ==
          (difference > 0) - (difference < 0));
  }
}

TEST_CASE("exact numbers form an ordered ring", "[geometry]") {
  const std::uint64_t seed = 2;
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(300); ++round) {
    const double x = any_double(random), y = any_double(random), z = any_double(random);
    INFO("round " << round << ": " << x << ", " << y << ", " << z);
    const Number a = x, b = Number(y) * x + z, c = Number(z) - y;
    CHECK(equal(a + b, b + a));
    CHECK(equal(a * b, b * a));
    CHECK(equal((a + b) + c, a + (b + c)));
    CHECK(equal((a * b) * c, a * (b * c)));
    CHECK(equal((a + b) * c, a * c + b * c));
    CHECK(equal(a + 0, a));
    CHECK(equal(a * 1, a));
    CHECK((a * 0).sign() == 0);
    CHECK((a + (-a)).sign() == 0);
    CHECK((b * c).sign() == b.sign() * c.sign());
    CHECK((c - b).sign() == -(b - c).sign());
    CHECK((a - y).sign() == (x > y) - (x < y));
  }
}

}  // namespace
