// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

/// \file
/// Random: a generator with the same numbers for the same seed on every compiler.

namespace tutavia {

/// SplitMix64 (Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators"). A
/// std::uniform_random_bit_generator. Unlike std::uniform_real_distribution, its own distributions
/// do not depend on the standard library.
class Random {
 public:
  using result_type = std::uint64_t;

  explicit Random(std::uint64_t seed) : state_(seed) {}

  static constexpr std::uint64_t min() { return 0; }
  static constexpr std::uint64_t max() { return ~std::uint64_t{0}; }

  std::uint64_t operator()() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }

  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>((*this)() >> 11) * 0x1p-53; }

  /// Uniform between low and high; high itself only by rounding.
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Uniform in {0, ..., bound - 1}, for a bound far below 2^64; 0 for bound 0.
  std::uint64_t below(std::uint64_t bound) { return bound == 0 ? 0 : (*this)() % bound; }

 private:
  std::uint64_t state_;
};

}  // namespace tutavia
