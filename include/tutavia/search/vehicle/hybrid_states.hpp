// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "tutavia/geometry/steering_word.hpp"
#include "tutavia/geometry/vehicle_path.hpp"

/// \file
/// The states of a hybrid A* search, its open list and its closed cells.

namespace tutavia::detail {

/// A move of fixed length: a turn at the turning radius by whole steps of the heading, and then
/// straight on.
struct HybridMove {
  Gear gear = Gear::forward;
  Steering steering = Steering::straight;
  int turns = 0;        ///< change of the heading in steps, left positive
  double straight = 0;  ///< [m], not negative
};

/// A state of the vehicle and the move that led to it.
struct HybridState {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  Point position = Point::Zero();
  double cost = 0;              ///< from the start [m]
  std::uint32_t parent = none;  ///< none: a start
  std::int16_t heading = 0;     ///< in steps, from 0 to their number
  std::int16_t move = -1;       ///< index of the move from the parent
};

/// An entry of the open list: a state that is not proved yet, or a drive from it to the goal.
struct HybridEntry {
  std::int64_t key;  ///< cost plus estimate, in 2^-20 m
  std::uint32_t state;
  enum class Kind : std::uint8_t { near_estimate, full_estimate, to_goal } kind;

  /// The cheapest entry first, of equal ones the state that came last.
  bool operator<(const HybridEntry& other) const {
    return key != other.key ? key > other.key : state < other.state;
  }
};

/// A set of numbers, by hash and linear probing.
class NumberSet {
 public:
  void clear() {
    std::fill(slots_.begin(), slots_.end(), empty);
    size_ = 0;
  }

  /// Whether the number was not in the set. \pre not 2^64 - 1
  bool insert(std::uint64_t number) {
    if (2 * (size_ + 1) > slots_.size()) grow();
    std::uint64_t& slot = slots_[find(number)];
    if (slot == number) return false;
    slot = number;
    ++size_;
    return true;
  }
  bool contains(std::uint64_t number) const {
    return !slots_.empty() && slots_[find(number)] == number;
  }

 private:
  static constexpr std::uint64_t empty = ~std::uint64_t{0};

  std::size_t find(std::uint64_t number) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = static_cast<std::size_t>(number * 0x9E3779B97F4A7C15u >> 20) & mask;
    while (slots_[i] != empty && slots_[i] != number) i = (i + 1) & mask;
    return i;
  }
  void grow() {
    std::vector<std::uint64_t> old(std::max<std::size_t>(1024, 2 * slots_.size()), empty);
    old.swap(slots_);
    for (const std::uint64_t number : old) {
      if (number != empty) slots_[find(number)] = number;
    }
  }

  std::vector<std::uint64_t> slots_;
  std::size_t size_ = 0;
};

}  // namespace tutavia::detail
