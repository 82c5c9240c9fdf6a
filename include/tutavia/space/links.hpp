// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "tutavia/core/assert.hpp"
#include "tutavia/grid/cell.hpp"

/// \file
/// Links: how a point is joined to a grid.

namespace tutavia {

/// A proved segment between a point and the reference point of a cell.
struct Link {
  Cell cell{};
  double length = 0;  ///< [m]
};

/// The links of one point; a fixed capacity keeps searches free of allocation.
class Links {
 public:
  static constexpr std::size_t capacity = 16;

  void push_back(const Link& link) {
    TUTAVIA_ASSERT(size_ < links_.size());
    links_[size_++] = link;
  }
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  const Link* begin() const { return links_.data(); }
  const Link* end() const { return links_.data() + size_; }
  const Link& operator[](std::size_t i) const { return links_[i]; }

 private:
  std::array<Link, capacity> links_{};
  std::size_t size_ = 0;
};

}  // namespace tutavia
