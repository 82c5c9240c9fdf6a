// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "tutavia/certify/certify_vehicle.hpp"
#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/dubins.hpp"
#include "tutavia/geometry/reeds_shepp.hpp"
#include "tutavia/plan/vehicle.hpp"
#include "tutavia/search/vehicle/driving_costs.hpp"

/// \file
/// DriveChain: the cheapest chain of drives through some of a row of places.

namespace tutavia::detail {

/// The gear and the cost [m] of a known path from the pose before.
struct KnownPath {
  Gear gear;
  double cost;
};

/// Shortest drives at a vehicle's turning radius: of Reeds and Shepp, or of Dubins without reverse.
class CircularDrives {
 public:
  using Word = SteeringWord;

  explicit CircularDrives(const Vehicle& vehicle)
      : radius_(vehicle.min_turning_radius), reverse_(vehicle.reverse) {}

  /// The drives that a chain tries between two poses: the shortest one.
  std::array<Word, 1> words(const Pose& from, const Pose& to) const {
    return {(reverse_ ? reeds_shepp_word(from, to, radius_) : dubins_word(from, to, radius_))
                .without_rounding()};
  }
  /// The length of a move [m].
  double length(const SteeringMove& move) const { return driven_length(move, radius_); }
  VehiclePath path(const Word& word, const Pose& from, const Pose& to) const {
    return vehicle_path(word, from, to, radius_);
  }

 private:
  double radius_;
  bool reverse_;
};

/// The cheapest path from the first of several poses to the last. It consists of shortest drives
/// between any two of them that are proved free (CircularDrives or ContinuousDrives), and of known
/// paths between neighbours. Dynamic programming over poses and gears finds it.
template <class Drives>
class DriveChain {
 public:
  using Word = typename Drives::Word;
  /// A step of the chain: a drive between two poses, or the known path between neighbours.
  struct Step {
    std::size_t from, to;
    std::optional<Word> drive;
  };

  DriveChain(const Drives& drives, const DrivingCosts& costs, std::span<const Pose> places)
      : drives_(drives), costs_(costs), places_(places), ways_(places.size()) {}

  /// The chain, from the first place on; empty if there is none, or the budget ends. `known(i)` is
  /// the known path to place i, if any.
  template <ClearanceSpace S, class Known>
  std::vector<Step> cheapest(const S& space, FootprintTest& footprint, const Known& known,
                             const Budget& budget) {
    for (std::size_t to = 1; to < places_.size(); ++to) {
      if (budget.exceeded()) return {};
      if (const std::optional<KnownPath> path = known(to)) take(to, *path);
      collect(to);
      for (const Candidate& c : candidates_) {
        Way& way = ways_[to][c.gear];
        if (!(order_key(c.cost) < order_key(way.cost))) continue;
        if (footprint.is_free(space, path(c.drive, c.from, to))) {
          way = {c.cost, c.from, c.gear_before, c.drive};
        }
      }
    }
    return steps();
  }

  VehiclePath path(const Word& drive, std::size_t from, std::size_t to) const {
    return drives_.path(drive, places_[from], places_[to]);
  }

 private:
  /// How a place is reached in one gear.
  struct Way {
    double cost = std::numeric_limits<double>::infinity();
    std::size_t from = 0, gear_before = 0;
    std::optional<Word> drive{};  // empty: the known path
  };
  /// A drive that would be cheaper, if it is free.
  struct Candidate {
    double cost;
    std::size_t from, gear_before, gear;
    Word drive;
  };

  static std::size_t number(Gear gear) { return gear == Gear::forward ? 0 : 1; }

  double cost_at(std::size_t place, std::size_t gear) const {
    return place == 0 ? 0.0 : ways_[place][gear].cost;
  }
  /// The cost of a change of gear at a place; none at the start.
  double change(std::size_t place, std::size_t before, Gear gear) const {
    return place > 0 && before != number(gear) ? costs_.cusp : 0;
  }

  void take(std::size_t to, const KnownPath& known) {
    for (std::size_t before = 0; before < 2; ++before) {
      const double cost = cost_at(to - 1, before) + change(to - 1, before, known.gear) + known.cost;
      Way& way = ways_[to][number(known.gear)];
      if (cost < way.cost) way = {cost, to - 1, before, std::nullopt};
    }
  }

  /// A shortest drive costs as much as shortest drives to a place on it and on from there. Costs
  /// are therefore compared without their last digits, and of equal ones the longest drive is
  /// taken.
  static double order_key(double cost) {
    if (std::isinf(cost)) return cost;
    int exponent = 0;
    const double fraction = std::frexp(cost, &exponent);
    return std::ldexp(std::nearbyint(std::ldexp(fraction, 32)), exponent - 32);
  }

  /// Collects the drives to a place from all earlier ones, the cheapest first.
  void collect(std::size_t to) {
    candidates_.clear();
    for (std::size_t from = 0; from < to; ++from) {
      for (const Word& drive : drives_.words(places_[from], places_[to])) collect(from, to, drive);
    }
    std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
      const bool a_reverses = a.drive.moves[0].length < 0, b_reverses = b.drive.moves[0].length < 0;
      return std::tuple(order_key(a.cost), a.from, a.gear_before, a_reverses) <
             std::tuple(order_key(b.cost), b.from, b.gear_before, b_reverses);
    });
  }

  /// Adds a drive, if it is cheaper than the way to its end so far.
  void collect(std::size_t from, std::size_t to, const Word& drive) {
    if (drive.size == 0) return;
    const Gear first = gear_of(drive.moves[0].length);
    const std::size_t gear = number(gear_of(drive.moves[drive.size - 1].length));
    const double cost = cost_of(drive, costs_, std::nullopt,
                                [&](const SteeringMove& move) { return drives_.length(move); });
    for (std::size_t before = 0; before < 2; ++before) {
      const double total = cost_at(from, before) + change(from, before, first) + cost;
      if (total < ways_[to][gear].cost * (1 - 1e-9)) {
        candidates_.push_back({total, from, before, gear, drive});
      }
    }
  }

  std::vector<Step> steps() const {
    std::size_t place = places_.size() - 1;
    const std::array<Way, 2>& ends = ways_[place];
    std::size_t gear = order_key(ends[1].cost) < order_key(ends[0].cost) ? 1 : 0;
    std::vector<Step> chain;
    if (ways_[place][gear].cost == std::numeric_limits<double>::infinity()) return chain;
    while (place > 0) {
      const Way& way = ways_[place][gear];
      chain.push_back({way.from, place, way.drive});
      place = way.from;
      gear = way.gear_before;
    }
    std::reverse(chain.begin(), chain.end());
    return chain;
  }

  const Drives& drives_;
  DrivingCosts costs_;
  std::span<const Pose> places_;
  std::vector<std::array<Way, 2>> ways_;  // by the gear in which a place is reached
  std::vector<Candidate> candidates_;
};

}  // namespace tutavia::detail
