// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/smooth/string/chain_finder.hpp"
#include "tutavia/smooth/string/string_bends.hpp"

/// \file
/// TautStringSolver: pulls a string taut.

namespace tutavia::detail {

/// A string along a polyline, which is pulled taut bend by bend. Every intermediate string is
/// proved free.
///
/// Bends are pins (the path's own waypoints) and circles of the safety radius around obstacle
/// vertices (around discs: larger ones). A bend that is not taut is removed: the string between its
/// neighbours A and C then runs straight, or around the circles in between.
template <FeatureSpace S>
class TautStringSolver {
 public:
  TautStringSolver(const S& space, const std::vector<Point>& nodes, const Budget& budget)
      : budget_(budget),
        error_bound_(space.distance_error_bound()),
        string_(nodes),
        finder_(space, string_, budget) {}
  TautStringSolver(const TautStringSolver&) = delete;
  TautStringSolver& operator=(const TautStringSolver&) = delete;

  /// Pulls until every bend is taut or has no proved pull.
  Expected<void, Failure> pull() {
    for (std::size_t b = string_[0].next; b != none && b != string_.last();) {
      if (const auto exceeded = budget_.exceeded()) return fail(*exceeded);
      const std::optional<std::size_t> before = string_.is_taut(b) ? std::nullopt : remove_bend(b);
      b = !before ? string_[b].next : *before == 0 ? string_[0].next : *before;
    }
    return {};
  }

  Curve curve() const { return string_.curve(error_bound_); }

 private:
  static constexpr std::size_t none = StringBends::none;

  /// Removes a bend, and neighbours from which the string then lifts off, if the replacement is
  /// proved and no longer. Returns the bend before the change.
  std::optional<std::size_t> remove_bend(std::size_t b) {
    std::size_t a = string_[b].previous, c = string_[b].next;
    if (string_.is_spur(a, c)) return string_.close_spur(a, c);
    const int side = string_.side_of_turn(b);
    finder_.find_obstacles(a, c, side);
    for (int proofs = 0; proofs < 8;) {
      if (!finder_.wrap(a, c, side)) break;
      if (finder_.add_blocking(a, c)) continue;
      const bool lifts_a =
          !string_[a].is_pin && !lies_on(string_[a].circle, string_.turn_after(a, finder_.chain()));
      const bool lifts_c = !string_[c].is_pin &&
                           !lies_on(string_[c].circle, string_.turn_before(c, finder_.chain()));
      if (lifts_a || lifts_c) {
        if (lifts_a) {
          a = string_[a].previous;
        } else {
          c = string_[c].next;
        }
        finder_.find_obstacles(a, c, side);
        continue;
      }
      if (!finder_.turns_as_before(a, c, side)) break;
      const std::size_t known = finder_.obstacle_count();
      if (finder_.is_proved(a, c, side)) {
        return string_.replace(a, c, finder_.chain()) ? std::optional(a) : std::nullopt;
      }
      if (finder_.obstacle_count() == known) break;
      ++proofs;
    }
    return std::nullopt;
  }

  const Budget& budget_;
  double error_bound_;
  StringBends string_;
  ChainFinder<S> finder_;
};

}  // namespace tutavia::detail
