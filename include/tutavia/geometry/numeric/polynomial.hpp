// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

/// \file
/// Polynomials of low degree, and their real roots between 0 and 1.

namespace tutavia::detail {

/// The polynomial c[0] + c[1] t + ... + c[N - 1] t^(N - 1).
template <std::size_t N>
using Polynomial = std::array<double, N>;

/// Numbers in ascending order, at most N.
template <std::size_t N>
class Roots {
 public:
  const double* begin() const { return values_.data(); }
  const double* end() const { return values_.data() + size_; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  double operator[](std::size_t i) const { return values_[i]; }
  /// \pre fewer than N, none larger than `value`
  void push_back(double value) { values_[size_++] = value; }

 private:
  std::array<double, N> values_{};
  std::size_t size_ = 0;
};

/// The value at t, by Horner's rule: the error is below 2 N u times the sum of |c[i] t^i|.
template <std::size_t N>
double evaluate(const Polynomial<N>& f, double t) {
  double value = 0;
  for (std::size_t i = N; i-- > 0;) value = value * t + f[i];
  return value;
}

template <std::size_t N>
Polynomial<N - 1> derivative(const Polynomial<N>& f) {
  Polynomial<N - 1> result{};
  for (std::size_t i = 1; i < N; ++i) result[i - 1] = static_cast<double>(i) * f[i];
  return result;
}

template <std::size_t N, std::size_t M>
Polynomial<N + M - 1> multiply(const Polynomial<N>& f, const Polynomial<M>& g) {
  Polynomial<N + M - 1> result{};
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t k = 0; k < M; ++k) result[i + k] += f[i] * g[k];
  }
  return result;
}

/// The root between low and high, at which f has opposite signs: Newton's method, with bisection if
/// it leaves the bracket or becomes slow (Press et al., Numerical Recipes, section 9.4). Accurate
/// up to rounding of f.
template <std::size_t N>
double bracketed_root(const Polynomial<N>& f, double low, double high) {
  const Polynomial<N - 1> slope = derivative(f);
  const bool negative_at_low = evaluate(f, low) < 0;
  double t = 0.5 * (low + high), step = high - low;
  for (int i = 0; i < 128; ++i) {
    const double value = evaluate(f, t);
    if (value == 0) break;
    if ((value < 0) == negative_at_low) {
      low = t;
    } else {
      high = t;
    }
    const double newton = -value / evaluate(slope, t);
    double next = t + newton;
    if (!(low < next && next < high && std::abs(newton) <= 0.5 * std::abs(step))) {
      next = 0.5 * (low + high);
    }
    if (next == t || next <= low || next >= high) break;
    step = next - t;
    t = next;
  }
  return t;
}

/// The real roots of a polynomial in [0, 1], in ascending order. Each is bracketed between roots of
/// its derivative, where the polynomial is monotone.
///
/// Every root with a change of sign is found. A root without one is found if the value is 0 up to
/// rounding. Roots that rounding cannot separate count once. The zero polynomial, and one with
/// coefficients that are not finite, has none.
template <std::size_t N>
Roots<N - 1> roots_in_unit_interval(const Polynomial<N>& f) {
  Roots<N - 1> roots;
  if constexpr (N > 1) {
    Polynomial<N> magnitudes{};
    for (std::size_t i = 0; i < N; ++i) magnitudes[i] = std::abs(f[i]);
    const double sum = evaluate(magnitudes, 1);
    if (!(sum > 0) || !std::isfinite(sum)) return roots;
    const auto value = [&](double t) {  // 0 if within rounding
      const double v = evaluate(f, t);
      return std::abs(v) <= 2 * N * 0x1p-53 * evaluate(magnitudes, t) ? 0 : v;
    };
    double low = 0, at_low = value(0);
    if (at_low == 0) roots.push_back(0);
    const auto advance_to = [&](double high) {
      const double at_high = value(high);
      if (at_low != 0 && at_high == 0) roots.push_back(high);
      if ((at_low < 0 && at_high > 0) || (at_low > 0 && at_high < 0)) {
        roots.push_back(bracketed_root(f, low, high));
      }
      low = high, at_low = at_high;
    };
    for (const double t : roots_in_unit_interval(derivative(f))) advance_to(t);
    advance_to(1);
  }
  return roots;
}

}  // namespace tutavia::detail
