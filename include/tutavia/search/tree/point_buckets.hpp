// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/point.hpp"

/// \file
/// PointBuckets: nearest-neighbour queries on a growing set of points.

namespace tutavia::detail {

/// Numbered points in square buckets over the bounds. Whenever the number of points has
/// quadrupled, the points are redistributed to smaller buckets. Adding a point takes amortised
/// constant time; so does a query if the points are spread evenly. Ties go to the lower number, so
/// results depend on the points alone.
class PointBuckets {
 public:
  using Index = std::uint32_t;
  static constexpr Index none = std::numeric_limits<Index>::max();

  struct Neighbour {
    double squared_distance;
    Index index;

    friend bool operator<(const Neighbour& a, const Neighbour& b) {
      return a.squared_distance != b.squared_distance ? a.squared_distance < b.squared_distance
                                                      : a.index < b.index;
    }
  };

  /// Removes all points. \pre bounds are finite
  void reset(const Box& bounds) {
    bounds_ = bounds;
    entries_.clear();
    divide(1);
  }

  std::size_t size() const { return entries_.size(); }
  Point operator[](Index i) const { return {entries_[i].x, entries_[i].y}; }

  /// Adds a point and returns its number. \pre p lies in the bounds
  Index add(const Point& p) {
    const auto index = static_cast<Index>(entries_.size());
    entries_.push_back({p.x(), p.y(), none});
    if (entries_.size() > most_per_bucket * first_.size()) {
      divide(most_per_bucket * first_.size());
    } else {
      put(index);
    }
    return index;
  }

  /// \pre not empty
  Index nearest(const Point& p) const {
    const BucketPosition centre(*this, p);
    Neighbour best{std::numeric_limits<double>::infinity(), none};
    for (int ring = 0;; ++ring) {
      for_each_in_ring(centre, ring, [&](const Neighbour& neighbour) {
        if (neighbour < best) best = neighbour;
      });
      if (best.squared_distance < squared_distance_beyond(centre, ring)) return best.index;
    }
  }

  /// The points within a distance of p, unordered.
  void within(const Point& p, double distance, std::vector<Neighbour>& neighbours) const {
    neighbours.clear();
    const double limit = distance * distance;
    const BucketPosition centre(*this, p);
    const int left = column(p.x() - distance), right = column(p.x() + distance);
    const int bottom = row(p.y() - distance), top = row(p.y() + distance);
    for (int y = bottom; y <= top; ++y) {
      for_each_in_row(centre, y, left, right, [&](const Neighbour& neighbour) {
        if (neighbour.squared_distance <= limit) neighbours.push_back(neighbour);
      });
    }
  }

  /// The k points nearest to p, or all if there are fewer; unordered.
  void k_nearest(const Point& p, std::size_t k, std::vector<Neighbour>& neighbours) const {
    neighbours.clear();
    const BucketPosition centre(*this, p);
    for (int ring = 0;; ++ring) {
      for_each_in_ring(centre, ring,
                       [&](const Neighbour& neighbour) { neighbours.push_back(neighbour); });
      if (neighbours.size() == size()) break;
      const double known = squared_distance_beyond(centre, ring);
      const auto is_known = [known](const Neighbour& n) { return n.squared_distance < known; };
      if (neighbours.size() >= k && static_cast<std::size_t>(std::count_if(
                                        neighbours.begin(), neighbours.end(), is_known)) >= k) {
        break;
      }
    }
    if (neighbours.size() <= k) return;
    std::nth_element(neighbours.begin(), neighbours.begin() + static_cast<std::ptrdiff_t>(k),
                     neighbours.end());
    neighbours.resize(k);
  }

 private:
  static constexpr std::size_t most_per_bucket = 4;

  struct Entry {
    double x, y;
    Index next;  // in the same bucket
  };

  /// A query point and its bucket.
  struct BucketPosition {
    BucketPosition(const PointBuckets& index, const Point& p)
        : x(p.x()), y(p.y()), column(index.column(x)), row(index.row(y)) {}
    double x, y;
    int column, row;
  };

  int column(double x) const { return slot(x, bounds_.min.x(), columns_); }
  int row(double y) const { return slot(y, bounds_.min.y(), rows_); }
  int slot(double x, double low, int count) const {
    const double at = (x - low) * per_metre_;
    return at > 0 ? static_cast<int>(std::min(at, count - 1.0)) : 0;
  }

  /// Redistributes the points to about `buckets` buckets.
  void divide(std::size_t buckets) {
    const double width = bounds_.width(), height = bounds_.height();
    // Works for bounds with little or no extent in one direction, too.
    side_ = std::max(std::sqrt(width * height / static_cast<double>(buckets)),
                     std::max(width, height) / static_cast<double>(buckets));
    per_metre_ = side_ > 0 ? 1 / side_ : 0;
    columns_ = static_cast<int>(width * per_metre_) + 1;
    rows_ = static_cast<int>(height * per_metre_) + 1;
    first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), none);
    for (Index i = 0; i < entries_.size(); ++i) put(i);
  }

  std::size_t bucket(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  void put(Index i) {
    Entry& entry = entries_[i];
    Index& first = first_[bucket(column(entry.x), row(entry.y))];
    entry.next = first;
    first = i;
  }

  template <class Visit>
  void for_each_in_row(const BucketPosition& centre, int row, int left, int right,
                       const Visit& visit) const {
    for (std::size_t b = bucket(left, row), end = bucket(right, row); b <= end; ++b) {
      for (Index i = first_[b]; i != none; i = entries_[i].next) {
        const Entry& entry = entries_[i];
        const double dx = entry.x - centre.x, dy = entry.y - centre.y;
        visit(Neighbour{dx * dx + dy * dy, i});
      }
    }
  }

  /// Visits the points in buckets that are `ring` steps away.
  template <class Visit>
  void for_each_in_ring(const BucketPosition& centre, int ring, const Visit& visit) const {
    const int left = centre.column - ring, right = centre.column + ring;
    const int from = std::max(left, 0), to = std::min(right, columns_ - 1);
    const int bottom = std::max(centre.row - ring, 0), top = std::min(centre.row + ring, rows_ - 1);
    for (int y = bottom; y <= top; ++y) {
      if (y == centre.row - ring || y == centre.row + ring) {
        for_each_in_row(centre, y, from, to, visit);
        continue;
      }
      if (left >= 0) for_each_in_row(centre, y, left, left, visit);
      if (right < columns_) for_each_in_row(centre, y, right, right, visit);
    }
  }

  /// A lower bound on the squared distance of points beyond `ring` rings; infinity if there are no
  /// buckets beyond.
  double squared_distance_beyond(const BucketPosition& centre, int ring) const {
    double gap = std::numeric_limits<double>::infinity();
    const auto look = [&](double x, double low, int slot, int count) {
      if (slot - ring > 0) gap = std::min(gap, x - (low + side_ * (slot - ring)));
      if (slot + ring + 1 < count) gap = std::min(gap, low + side_ * (slot + ring + 1) - x);
    };
    look(centre.x, bounds_.min.x(), centre.column, columns_);
    look(centre.y, bounds_.min.y(), centre.row, rows_);
    gap -= 1e-9 * side_;  // rounding may move a point near a bucket's side into the next bucket
    return gap > 0 ? gap * gap : 0;
  }

  Box bounds_;
  double side_ = 0, per_metre_ = 0;  // of a bucket
  int columns_ = 1, rows_ = 1;
  std::vector<Index> first_;  // per bucket, row by row
  std::vector<Entry> entries_;
};

}  // namespace tutavia::detail
