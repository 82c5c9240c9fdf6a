// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "tutavia/core/assert.hpp"

/// \file
/// ExactNumber: sums and products of doubles without rounding, for exact predicates.

namespace tutavia::detail {

/// Digits to the base 2^32, least significant first. Allocates only for more than 32 digits, which
/// coordinates of similar magnitude do not need.
class Limbs {
 public:
  Limbs() = default;
  /// `count` zeros.
  explicit Limbs(std::size_t count) { resize(count); }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  std::uint32_t* data() { return size_ <= few ? few_.data() : many_.data(); }
  const std::uint32_t* data() const { return size_ <= few ? few_.data() : many_.data(); }
  std::uint32_t& operator[](std::size_t i) { return data()[i]; }
  std::uint32_t operator[](std::size_t i) const { return data()[i]; }

  /// New digits are zero.
  void resize(std::size_t count) {
    if (count > few) {
      const std::size_t kept = std::min(size_, count);
      std::vector<std::uint32_t> digits(count, 0);
      std::copy_n(data(), kept, digits.begin());
      many_ = std::move(digits);
    } else if (size_ > few) {
      std::copy_n(many_.data(), count, few_.data());
    } else if (count > size_) {
      std::fill(few_.data() + size_, few_.data() + count, 0u);
    }
    size_ = count;
  }
  /// Drops leading zeros.
  void trim() {
    std::size_t count = size_;
    while (count > 0 && (*this)[count - 1] == 0) --count;
    if (count != size_) resize(count);
  }

 private:
  static constexpr std::size_t few = 32;

  std::array<std::uint32_t, few> few_;
  std::vector<std::uint32_t> many_;
  std::size_t size_ = 0;
};

/// A number m 2^e with integers m and e of any size; every finite double is one, and sums,
/// differences and products of such numbers are computed exactly.
///
/// It uses integers only, so fused multiply-add, extended precision and rounding modes do not
/// affect it. It is meant for the rare cases that a floating-point filter leaves open: an operation
/// takes some 100 ns.
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
    limbs_.resize(2);
    limbs_[0] = static_cast<std::uint32_t>(bits);
    limbs_[1] = static_cast<std::uint32_t>(bits >> 32);
    limbs_.trim();
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
    result.limbs_.resize(a.limbs_.size() + b.limbs_.size());
    for (std::size_t i = 0; i < a.limbs_.size(); ++i) {
      std::uint64_t carry = 0;
      for (std::size_t j = 0; j < b.limbs_.size(); ++j) {
        carry += result.limbs_[i + j] + std::uint64_t{a.limbs_[i]} * b.limbs_[j];
        result.limbs_[i + j] = static_cast<std::uint32_t>(carry);
        carry >>= 32;
      }
      result.limbs_[i + b.limbs_.size()] = static_cast<std::uint32_t>(carry);
    }
    result.limbs_.trim();
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
    result.limbs_.trim();
    return result;
  }

  friend ExactNumber operator-(const ExactNumber& a, const ExactNumber& b) { return a + (-b); }

 private:
  ExactNumber() = default;

  /// The limbs of |n| / 2^exponent. \pre `exponent` is at most the exponent of n
  static Limbs shifted(const ExactNumber& n, int exponent) {
    const auto shift = static_cast<std::size_t>(n.exponent_ - exponent);
    const std::size_t whole = shift / 32;
    Limbs limbs(whole + n.limbs_.size() + 1);
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < n.limbs_.size(); ++i) {
      carry |= std::uint64_t{n.limbs_[i]} << (shift % 32);
      limbs[whole + i] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    limbs[whole + n.limbs_.size()] = static_cast<std::uint32_t>(carry);
    limbs.trim();
    return limbs;
  }

  static bool less(const Limbs& x, const Limbs& y) {
    if (x.size() != y.size()) return x.size() < y.size();
    for (std::size_t i = x.size(); i-- > 0;) {
      if (x[i] != y[i]) return x[i] < y[i];
    }
    return false;
  }

  static Limbs sum(Limbs x, const Limbs& y) {
    x.resize(std::max(x.size(), y.size()) + 1);
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

}  // namespace tutavia::detail
