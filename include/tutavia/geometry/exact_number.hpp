// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "tutavia/core/assert.hpp"

/// \file
/// ExactNumber: sums and products of doubles without rounding, for the ties that doubles cannot
/// decide.

namespace tutavia {

/// A number m 2^e with integers m and e of any size; every finite double is one, and sums,
/// differences and products of such numbers are computed exactly.
///
/// It works on integers alone, so contraction to fused multiply-add, extended precision or the
/// rounding mode of the user's build cannot touch it. It is meant for the rare case behind a
/// floating-point filter: an operation takes some 100 ns and allocates.
class ExactNumber {
 public:
  /// \pre `value` is finite
  ExactNumber(double value) {  // NOLINT: a double is an exact number
    TUTAVIA_ASSERT(std::isfinite(value));
    int exponent = 0;
    const double mantissa = std::frexp(std::abs(value), &exponent);
    const auto bits = static_cast<std::uint64_t>(std::ldexp(mantissa, 53));
    negative_ = value < 0;
    exponent_ = exponent - 53;
    limbs_ = {static_cast<std::uint32_t>(bits), static_cast<std::uint32_t>(bits >> 32)};
    trim();
  }

  /// -1, 0 or 1.
  int sign() const { return limbs_.empty() ? 0 : (negative_ ? -1 : 1); }

  ExactNumber operator-() const {
    ExactNumber result = *this;
    result.negative_ = !negative_;
    return result;
  }

  friend ExactNumber operator*(const ExactNumber& a, const ExactNumber& b) {
    ExactNumber result;
    result.negative_ = a.negative_ != b.negative_;
    result.exponent_ = a.exponent_ + b.exponent_;
    result.limbs_.assign(a.limbs_.size() + b.limbs_.size(), 0);
    for (std::size_t i = 0; i < a.limbs_.size(); ++i) {
      std::uint64_t carry = 0;
      for (std::size_t j = 0; j < b.limbs_.size(); ++j) {
        carry += result.limbs_[i + j] + std::uint64_t{a.limbs_[i]} * b.limbs_[j];
        result.limbs_[i + j] = static_cast<std::uint32_t>(carry);
        carry >>= 32;
      }
      result.limbs_[i + b.limbs_.size()] = static_cast<std::uint32_t>(carry);
    }
    result.trim();
    return result;
  }

  friend ExactNumber operator+(const ExactNumber& a, const ExactNumber& b) {
    if (a.limbs_.empty()) return b;
    if (b.limbs_.empty()) return a;
    const int exponent = std::min(a.exponent_, b.exponent_);
    Limbs x = shifted(a, exponent), y = shifted(b, exponent);
    ExactNumber result;
    result.exponent_ = exponent;
    if (a.negative_ == b.negative_) {
      result.negative_ = a.negative_;
      result.limbs_ = sum(std::move(x), y);
    } else {
      const bool larger_x = !less(x, y);
      result.negative_ = larger_x ? a.negative_ : b.negative_;
      result.limbs_ = larger_x ? difference(std::move(x), y) : difference(std::move(y), x);
    }
    result.trim();
    return result;
  }

  friend ExactNumber operator-(const ExactNumber& a, const ExactNumber& b) { return a + (-b); }

 private:
  using Limbs = std::vector<std::uint32_t>;  // least significant first, none for zero

  ExactNumber() = default;

  void trim() {
    while (!limbs_.empty() && limbs_.back() == 0) limbs_.pop_back();
  }

  /// The limbs of |n| as a multiple of 2^exponent, for an exponent not above its own.
  static Limbs shifted(const ExactNumber& n, int exponent) {
    const auto shift = static_cast<std::size_t>(n.exponent_ - exponent);
    Limbs limbs(shift / 32, 0);
    std::uint64_t carry = 0;
    for (const std::uint32_t limb : n.limbs_) {
      carry |= std::uint64_t{limb} << (shift % 32);
      limbs.push_back(static_cast<std::uint32_t>(carry));
      carry >>= 32;
    }
    limbs.push_back(static_cast<std::uint32_t>(carry));
    while (!limbs.empty() && limbs.back() == 0) limbs.pop_back();
    return limbs;
  }

  static bool less(const Limbs& x, const Limbs& y) {
    if (x.size() != y.size()) return x.size() < y.size();
    return std::lexicographical_compare(x.rbegin(), x.rend(), y.rbegin(), y.rend());
  }

  static Limbs sum(Limbs x, const Limbs& y) {
    x.resize(std::max(x.size(), y.size()) + 1, 0);
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      carry += std::uint64_t{x[i]} + (i < y.size() ? y[i] : 0u);
      x[i] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    return x;
  }

  /// x - y for x >= y.
  static Limbs difference(Limbs x, const Limbs& y) {
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const std::uint64_t subtrahend = (i < y.size() ? y[i] : 0u) + borrow;
      borrow = x[i] < subtrahend ? 1 : 0;
      x[i] = static_cast<std::uint32_t>(x[i] - subtrahend);
    }
    return x;
  }

  bool negative_ = false;
  int exponent_ = 0;
  Limbs limbs_;
};

}  // namespace tutavia
