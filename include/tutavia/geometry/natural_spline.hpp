// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "tutavia/geometry/point.hpp"

/// \file
/// NaturalSpline: cubic smoothing splines in the plane.

namespace tutavia {

namespace detail {
class SplineFit;
}

/// A twice continuously differentiable curve of cubic spans, one between every two data points,
/// with second derivatives of 0 at both ends. Its parameter is the chord length of the data, from 0
/// to end(); the parameter of a data point is called its site.
///
/// Among all curves g from the first data point to the last, it minimises the sum of |y - g|^2 over
/// the sites plus `penalty` times the integral of |g''|^2. Penalty 0 interpolates. As the penalty
/// grows, so do the residuals, and the curve tends to the chord. Fitting takes O(n) for n points.
/// Beyond 10,000 points, if the bound is close to the chord's sum, rounding may keep the residuals
/// smaller than the bound allows.
///
/// Source: Reinsch 1967, "Smoothing by Spline Functions"; both ends are pinned here.
class NaturalSpline {
 public:
  /// The spline for a penalty [m^3]. \pre one point or more, no two successive ones equal
  static NaturalSpline penalised(std::span<const Point> data, double penalty);

  /// The spline whose sum of squared residuals [m^2] is `bound` or up to 1 % less; the chord if its
  /// sum is within the bound. \pre as above
  static NaturalSpline within(std::span<const Point> data, double bound);

  double end() const { return sites_.back(); }
  double residual_sum() const { return residual_sum_; }
  /// Whether the spline is the chord.
  bool is_straight() const { return std::all_of(bends_.begin(), bends_.end(), detail::is_zero); }

  /// Position at t in [0, end()].
  Point point(double t) const {
    if (sites_.size() == 1) return origin_;
    const SpanParameter at = span_parameter(t);
    const double scale = at.width * at.width / 6;
    const Point line = detail::lerp(values_[at.span], values_[at.span + 1], at.after);
    const Point bent = detail::offset_along(line, scale * cubic(at.before), bends_[at.span]);
    return detail::offset_along(
        origin_, 1, detail::offset_along(bent, scale * cubic(at.after), bends_[at.span + 1]));
  }

  Point derivative(double t) const {
    if (sites_.size() == 1) return Point::Zero();
    const SpanParameter at = span_parameter(t);
    const Point &p = values_[at.span], &q = values_[at.span + 1];
    const Point slope{(q.x() - p.x()) / at.width, (q.y() - p.y()) / at.width};
    const Point bent = detail::offset_along(slope, at.width / 6 * (1 - 3 * at.before * at.before),
                                            bends_[at.span]);
    return detail::offset_along(bent, at.width / 6 * (3 * at.after * at.after - 1),
                                bends_[at.span + 1]);
  }

  Point second_derivative(double t) const {
    if (sites_.size() == 1) return Point::Zero();
    const SpanParameter at = span_parameter(t);
    return detail::lerp(bends_[at.span], bends_[at.span + 1], at.after);
  }

 private:
  /// A parameter within a span: the distances to its end and from its start, as fractions of its
  /// width.
  struct SpanParameter {
    std::size_t span;
    double width, before, after;
  };

  NaturalSpline(std::vector<double> sites, Point origin, std::vector<Point> values,
                std::vector<Point> bends, double residual_sum)
      : sites_(std::move(sites)),
        origin_(std::move(origin)),
        values_(std::move(values)),
        bends_(std::move(bends)),
        residual_sum_(residual_sum) {}

  static double cubic(double x) { return x * (x * x - 1); }

  SpanParameter span_parameter(double t) const {
    const auto above = std::upper_bound(sites_.begin() + 1, sites_.end() - 1, t);
    const auto i = static_cast<std::size_t>(above - sites_.begin()) - 1;
    const double width = sites_[i + 1] - sites_[i];
    const double after = std::clamp((t - sites_[i]) / width, 0.0, 1.0);
    return {i, width, 1 - after, after};
  }

  friend class detail::SplineFit;

  std::vector<double> sites_;
  Point origin_;               // the first data point; the values are relative to it
  std::vector<Point> values_;  // at the sites
  std::vector<Point> bends_;   // second derivatives at the sites
  double residual_sum_;
};

namespace detail {

/// The equations of a smoothing spline: (R + penalty Q^T D Q) bends = Q^T data, symmetric with five
/// diagonals. Column i of Q is the second difference at site i, R holds the inner products of the
/// piecewise linear hat functions, and D is 0 at both ends and 1 elsewhere.
class SplineFit {
 public:
  explicit SplineFit(std::span<const Point> data) : origin_(data.front()), sites_(data.size()) {
    data_.reserve(data.size());
    for (const Point& p : data) data_.emplace_back(p.x() - origin_.x(), p.y() - origin_.y());
    for (std::size_t i = 1; i < data.size(); ++i) {
      sites_[i] = sites_[i - 1] + distance(data_[i - 1], data_[i]);
    }
    values_ = data_;
    bends_.resize(data.size(), Point::Zero());
    rows_.resize(data.size());
  }

  double typical_width() const {
    return sites_.back() / static_cast<double>(std::max<std::size_t>(sites_.size() - 1, 1));
  }

  /// Sets the spline to the chord. Returns the sum of squared residuals, like `solve`.
  double straighten() {
    std::fill(bends_.begin(), bends_.end(), Point::Zero());
    for (std::size_t i = 1; i + 1 < data_.size(); ++i) {
      values_[i] = lerp(Point::Zero(), data_.back(), sites_[i] / sites_.back());
    }
    return residual_sum();
  }

  double solve(double penalty) {
    factor(penalty);
    const std::size_t n = data_.size();
    for (std::size_t i = 1; i + 1 < n; ++i) {
      bends_[i] = offset_along(second_difference(data_, i), -rows_[i - 1].first, bends_[i - 1]);
      if (i > 2) bends_[i] = offset_along(bends_[i], -rows_[i - 2].second, bends_[i - 2]);
    }
    for (std::size_t i = n - 1; i-- > 1;) {
      const Row& row = rows_[i];
      bends_[i] = {bends_[i].x() / row.pivot, bends_[i].y() / row.pivot};
      if (i + 2 < n) bends_[i] = offset_along(bends_[i], -row.first, bends_[i + 1]);
      if (i + 3 < n) bends_[i] = offset_along(bends_[i], -row.second, bends_[i + 2]);
    }
    for (std::size_t i = 1; i + 1 < n; ++i) {
      values_[i] = offset_along(data_[i], -penalty, second_difference(bends_, i));
    }
    return residual_sum();
  }

  NaturalSpline spline() && {
    const double sum = residual_sum();
    // Rounded values and second derivatives fit no spline exactly: interpolate the values.
    if (!std::all_of(bends_.begin(), bends_.end(), is_zero)) {
      data_ = values_;
      solve(0);
    }
    return {std::move(sites_), origin_, std::move(values_), std::move(bends_), sum};
  }

 private:
  /// The entries of the factorisation L D L^T for one unknown: that of D, and those of L in its
  /// column, one and two rows below.
  struct Row {
    double pivot = 1, first = 0, second = 0;
  };

  double width(std::size_t i) const { return sites_[i + 1] - sites_[i]; }

  /// The change of slope at site i of the polygon through `points`.
  Point second_difference(const std::vector<Point>& points, std::size_t i) const {
    const Point &p = points[i - 1], &q = points[i], &r = points[i + 1];
    const double before = width(i - 1), after = width(i);
    return {(r.x() - q.x()) / after - (q.x() - p.x()) / before,
            (r.y() - q.y()) / after - (q.y() - p.y()) / before};
  }

  void factor(double penalty) {
    const std::size_t n = data_.size();
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const double before = width(i - 1), after = width(i);
      const double sum = 1 / before + 1 / after;
      double squares = sum * sum;
      if (i > 1) squares += 1 / (before * before);
      if (i + 2 < n) squares += 1 / (after * after);
      Row& row = rows_[i];
      row.pivot = (before + after) / 3 + penalty * squares;
      // The entries below the diagonal, if those rows exist.
      const double next = i + 2 < n ? 1 / width(i + 1) : 0;
      double first = after / 6 - penalty * (sum + 1 / after + next) / after;
      if (i > 1) {
        const Row& above = rows_[i - 1];
        row.pivot -= above.first * above.first * above.pivot;
        first -= above.first * above.second * above.pivot;
      }
      if (i > 2) row.pivot -= rows_[i - 2].second * rows_[i - 2].second * rows_[i - 2].pivot;
      row.first = first / row.pivot;
      row.second = penalty * next / after / row.pivot;
    }
  }

  double residual_sum() const {
    double sum = 0;
    for (std::size_t i = 0; i < data_.size(); ++i) {
      const double gap = distance(data_[i], values_[i]);
      sum += gap * gap;
    }
    return sum;
  }

  Point origin_;
  std::vector<double> sites_;
  std::vector<Point> data_, values_, bends_;  // at the sites, the data relative to the origin
  std::vector<Row> rows_;
};

}  // namespace detail

inline NaturalSpline NaturalSpline::penalised(std::span<const Point> data, double penalty) {
  detail::SplineFit fit(data);
  fit.solve(penalty);
  return std::move(fit).spline();
}

inline NaturalSpline NaturalSpline::within(std::span<const Point> data, double bound) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  detail::SplineFit fit(data);
  if (fit.straighten() <= bound) return std::move(fit).spline();
  double low = 0, high = infinity, penalty = std::pow(fit.typical_width(), 3);
  for (int i = 0; i < 100 && bound > 0; ++i) {
    const double sum = fit.solve(penalty);
    if (0.99 * bound <= sum && sum <= bound) return std::move(fit).spline();
    if (sum <= bound) {
      low = penalty;
    } else {
      high = penalty;
    }
    if (high <= low * (1 + 1e-9)) break;
    if (low == 0) {
      penalty /= 64;
    } else {
      penalty = high == infinity ? 64 * penalty : std::sqrt(low) * std::sqrt(high);
    }
  }
  fit.solve(low);
  return std::move(fit).spline();
}

}  // namespace tutavia
