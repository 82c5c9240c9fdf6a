// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "tutavia/core/assert.hpp"
#include "tutavia/grid/cell.hpp"

/// \file
/// EndpointLinks: the segments that join a point to a grid.

namespace tutavia {

/// A proved segment between a point and the reference point of a cell.
struct EndpointLink {
  Cell cell{};
  double length = 0;  ///< [m]
};

/// The links of one point. The capacity is fixed, so that searches do not allocate.
class EndpointLinks {
 public:
  static constexpr std::size_t capacity = 16;

  void push_back(const EndpointLink& link) {
    TUTAVIA_ASSERT(size_ < links_.size());
    links_[size_++] = link;
  }
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  const EndpointLink* begin() const { return links_.data(); }
  const EndpointLink* end() const { return links_.data() + size_; }
  const EndpointLink& operator[](std::size_t i) const { return links_[i]; }

 private:
  std::array<EndpointLink, capacity> links_{};
  std::size_t size_ = 0;
};

}  // namespace tutavia
