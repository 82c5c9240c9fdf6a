// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>

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

/// The links of one point, to a cell and its eight neighbours. The capacity is fixed, so that
/// searches do not allocate.
class EndpointLinks {
 public:
  static constexpr std::size_t capacity = 16;

  EndpointLinks() = default;
  /// `centre`: the cell in the middle of the linked ones, where it is not the one nearest to the
  /// point.
  explicit EndpointLinks(Cell centre) : centre_(centre) {}
  const std::optional<Cell>& centre() const { return centre_; }

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
  std::optional<Cell> centre_{};
};

}  // namespace tutavia
