// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

/// \file
/// Adaptive Gauss-Legendre quadrature.

namespace tutavia::detail {

/// The positive half of the eight nodes on [-1, 1] and their weights (Abramowitz and Stegun 1964,
/// table 25.4).
inline constexpr std::array<double, 4> gauss_nodes{0.1834346424956498, 0.5255324099163290,
                                                   0.7966664774136267, 0.9602898564975363};
inline constexpr std::array<double, 4> gauss_weights{0.3626837833783620, 0.3137066458778873,
                                                     0.2223810344533745, 0.1012285362903763};

/// Gauss-Legendre quadrature of `f` over [a, b] with eight nodes, exact for polynomials up to
/// degree 15.
template <class F>
double gauss_legendre(const F& f, double a, double b) {
  const auto& nodes = gauss_nodes;
  const double centre = 0.5 * (a + b), half = 0.5 * (b - a);
  double sum = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    sum += gauss_weights[i] * (f(centre - half * nodes[i]) + f(centre + half * nodes[i]));
  }
  return half * sum;
}

/// Integral of `f` over [a, b]: halves the interval until two halves agree with the whole to
/// `tolerance` (absolute), at most 20 times. The function must be smooth on the scale of the
/// interval: a kink between two nodes may go unnoticed.
template <class F>
double integrate(const F& f, double a, double b, double tolerance, int halvings = 20) {
  const double middle = 0.5 * (a + b);
  const double left = gauss_legendre(f, a, middle), right = gauss_legendre(f, middle, b);
  if (halvings == 0 || !(std::abs(left + right - gauss_legendre(f, a, b)) > tolerance)) {
    return left + right;
  }
  return integrate(f, a, middle, tolerance / 2, halvings - 1) +
         integrate(f, middle, b, tolerance / 2, halvings - 1);
}

}  // namespace tutavia::detail
