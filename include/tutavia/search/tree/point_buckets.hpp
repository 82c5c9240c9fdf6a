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
/// PointBuckets: the nearest of many points, while they become more.

namespace tutavia::detail {

/// Points by number, in square buckets over the bounds they lie in. The buckets are made anew,
/// smaller, whenever the points have become four times as many, so that adding a point takes
/// constant time, and so does a question where the points are spread evenly. Of equally near points
/// the one with the lower number is nearer: answers depend on the points alone.
class PointBuckets {
 public:
  using Index = std::uint32_t;
  static constexpr Index none = std::numeric_limits<Index>::max();

  struct Neighbour {
    double square;  ///< of the distance
    Index index;

    friend bool operator<(const Neighbour& a, const Neighbour& b) {
      return a.square != b.square ? a.square < b.square : a.index < b.index;
    }
  };

  /// Forgets all points. \pre bounds are finite
  void reset(const Box& bounds) {
    bounds_ = bounds;
    entries_.clear();
    divide(1);
  }

  std::size_t size() const { return entries_.size(); }
  Point operator[](Index i) const { return {entries_[i].x, entries_[i].y}; }

  /// Gives the next number. \pre p lies in the bounds
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
    const BucketPosition place(*this, p);
    Neighbour best{std::numeric_limits<double>::infinity(), none};
    for (int ring = 0;; ++ring) {
      for_each_in_ring(place, ring, [&](const Neighbour& neighbour) {
        if (neighbour < best) best = neighbour;
      });
      if (best.square < square_beyond(place, ring)) return best.index;
    }
  }

  /// The points within a distance of p, in no particular order.
  void within(const Point& p, double distance, std::vector<Neighbour>& found) const {
    found.clear();
    const double square = distance * distance;
    const BucketPosition place(*this, p);
    const int left = column(p.x() - distance), right = column(p.x() + distance);
    const int bottom = row(p.y() - distance), top = row(p.y() + distance);
    for (int y = bottom; y <= top; ++y) {
      for_each_in_row(place, y, left, right, [&](const Neighbour& neighbour) {
        if (neighbour.square <= square) found.push_back(neighbour);
      });
    }
  }

  /// The k points nearest to p, or all where there are fewer, in no particular order.
  void k_nearest(const Point& p, std::size_t k, std::vector<Neighbour>& found) const {
    found.clear();
    const BucketPosition place(*this, p);
    for (int ring = 0;; ++ring) {
      for_each_in_ring(place, ring,
                       [&](const Neighbour& neighbour) { found.push_back(neighbour); });
      if (found.size() == size()) break;
      const double known = square_beyond(place, ring);
      const auto is_known = [known](const Neighbour& n) { return n.square < known; };
      if (found.size() >= k &&
          static_cast<std::size_t>(std::count_if(found.begin(), found.end(), is_known)) >= k) {
        break;
      }
    }
    if (found.size() <= k) return;
    std::nth_element(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(k), found.end());
    found.resize(k);
  }

 private:
  static constexpr std::size_t most_per_bucket = 4;

  struct Entry {
    double x, y;
    Index next;  // in the same bucket
  };

  /// A point and its bucket.
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

  /// Makes about so many buckets.
  void divide(std::size_t buckets) {
    const double width = bounds_.width(), height = bounds_.height();
    // Also for bounds with little or no extent one way.
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
  void for_each_in_row(const BucketPosition& place, int row, int left, int right,
                       const Visit& visit) const {
    for (std::size_t b = bucket(left, row), end = bucket(right, row); b <= end; ++b) {
      for (Index i = first_[b]; i != none; i = entries_[i].next) {
        const Entry& entry = entries_[i];
        const double dx = entry.x - place.x, dy = entry.y - place.y;
        visit(Neighbour{dx * dx + dy * dy, i});
      }
    }
  }

  /// Visits the buckets that are `ring` steps away.
  template <class Visit>
  void for_each_in_ring(const BucketPosition& place, int ring, const Visit& visit) const {
    const int left = place.column - ring, right = place.column + ring;
    const int from = std::max(left, 0), to = std::min(right, columns_ - 1);
    const int bottom = std::max(place.row - ring, 0), top = std::min(place.row + ring, rows_ - 1);
    for (int y = bottom; y <= top; ++y) {
      if (y == place.row - ring || y == place.row + ring) {
        for_each_in_row(place, y, from, to, visit);
        continue;
      }
      if (left >= 0) for_each_in_row(place, y, left, left, visit);
      if (right < columns_) for_each_in_row(place, y, right, right, visit);
    }
  }

  /// The square of how far all points are that lie beyond so many rings; infinity where none can.
  double square_beyond(const BucketPosition& place, int ring) const {
    double gap = std::numeric_limits<double>::infinity();
    const auto look = [&](double x, double low, int slot, int count) {
      if (slot - ring > 0) gap = std::min(gap, x - (low + side_ * (slot - ring)));
      if (slot + ring + 1 < count) gap = std::min(gap, low + side_ * (slot + ring + 1) - x);
    };
    look(place.x, bounds_.min.x(), place.column, columns_);
    look(place.y, bounds_.min.y(), place.row, rows_);
    gap -= 1e-9 * side_;  // rounding may put a point next to a bucket's side into the other one
    return gap > 0 ? gap * gap : 0;
  }

  Box bounds_;
  double side_ = 0, per_metre_ = 0;  // of a bucket
  int columns_ = 1, rows_ = 1;
  std::vector<Index> first_;  // per bucket, row by row
  std::vector<Entry> entries_;
};

}  // namespace tutavia::detail
