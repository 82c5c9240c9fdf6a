// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "tutavia/certify/certify_vehicle.hpp"
#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/dubins.hpp"
#include "tutavia/geometry/reeds_shepp.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/plan/vehicle.hpp"
#include "tutavia/smooth/concepts.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// VehicleShortcut: shortens a vehicle's path by drives of Reeds and Shepp, or of Dubins.

namespace tutavia {

/// Replaces parts of a vehicle's path by shortest drives that are proved free.
///
/// The path is cut into at most `places` parts, and its joints besides. A cheapest chain of the
/// parts and of shortest drives between any two places, each proved, is found by dynamic
/// programming; this is repeated while it saves more than a thousandth. The result never costs more
/// than the input by the weights below, and keeps its ends, its headings there and the turning
/// radius. A vehicle that turns on the spot keeps its path. If the budget ends, the best path so
/// far is returned.
///
/// Errors: `invalid_option` for a weight below 1, a negative cusp_cost and less than 2 or more than
/// 1000 places.
///
/// Example: examples/car.cpp.
struct VehicleShortcut {
  static constexpr std::string_view name = "vehicle_shortcut";

  double reverse_weight = 1.5;  ///< a metre in reverse costs so much
  double cusp_cost = 1;         ///< a change of gear costs so much [m]
  int places = 40;

  template <ClearanceSpace S>
  Expected<VehiclePath, Failure> smooth(const S& space, const Vehicle& vehicle,
                                        const VehiclePath& path, const Budget& budget) const {
    if (!(reverse_weight >= 1) || !std::isfinite(reverse_weight) || !(cusp_cost >= 0) ||
        !std::isfinite(cusp_cost) || places < 2 || places > 1000) {
      return fail(PlanError::invalid_option,
                  "vehicle_shortcut needs a finite reverse_weight of 1 or more, a finite cusp_cost "
                  "of 0 or more and 2 to 1000 places");
    }
    if (!(vehicle.min_turning_radius > 0) || path.empty()) return path;
    VehiclePath result = path;
    detail::FootprintTest footprint(vehicle);
    double cost = cost_of(path);
    while (!budget.exceeded()) {
      Chain chain(*this, vehicle, result);
      auto better = chain.cheapest(space, footprint, budget);
      if (!better) break;
      const double reached = cost_of(*better);
      if (!(reached < cost)) break;
      const bool is_little = reached > cost * (1 - 1e-3);
      result = std::move(*better);
      cost = reached;
      if (is_little) break;
    }
    return result;
  }

  /// A curve without gears is no path of a vehicle: `invalid_option`.
  template <class S>
  Expected<Curve, Failure> smooth(const S&, const Curve&, const Budget&) const {
    return fail(PlanError::invalid_option,
                "vehicle_shortcut smooths routes with headings; search with hybrid_astar");
  }

  /// The cost of a path by the weights [m].
  double cost_of(const VehiclePath& path) const {
    double cost = cusp_cost * static_cast<double>(path.cusps().size());
    for (std::size_t i = 0; i < path.gears.size(); ++i) {
      const double length = path.curve.length_before(i + 1) - path.curve.length_before(i);
      cost += path.gears[i] == Gear::reverse ? reverse_weight * length : length;
    }
    return cost;
  }

 private:
  /// The places of a path, and the cheapest way to each of them in either gear.
  class Chain {
   public:
    Chain(const VehicleShortcut& options, const Vehicle& vehicle, const VehiclePath& path)
        : options_(options), vehicle_(vehicle), path_(path) {
      const double spacing = path.length() / options.places;
      places_.push_back({path.pose(0, 0), 0, 0, 0});
      for (std::size_t i = 0; i < path.gears.size(); ++i) {
        const double length = path.curve.length_before(i + 1) - path.curve.length_before(i);
        const int parts = std::max(1, static_cast<int>(std::ceil(length / spacing - 1e-6)));
        for (int k = 1; k <= parts; ++k) {
          places_.push_back(
              {path.pose(i, double{1} * k / parts), i, (k - 1.0) / parts, double{1} * k / parts});
        }
      }
      ways_.resize(places_.size());
    }

    /// The cheapest chain; empty if the budget ends or rounding spoils the parts.
    template <ClearanceSpace S>
    std::optional<VehiclePath> cheapest(const S& space, detail::FootprintTest& footprint,
                                        const Budget& budget) {
      for (std::size_t to = 1; to < places_.size(); ++to) {
        if (budget.exceeded()) return std::nullopt;
        reach(space, footprint, to);
      }
      VehiclePath result = assembled();
      for (std::size_t i = 0; i < result.gears.size(); ++i) {
        if (!footprint.is_free(space, result.curve.pieces()[i], result.gears[i])) {
          return std::nullopt;
        }
      }
      return result;
    }

   private:
    struct Place {
      Pose pose;
      // The part of the path that ends here: parameters of a piece.
      std::size_t piece;
      double from, to;
    };
    /// How a place is reached in one gear.
    struct Way {
      double cost = std::numeric_limits<double>::infinity();
      std::size_t from = 0;
      std::size_t gear_before = 0;
      std::optional<SteeringWord> drive{};  // empty: the part of the path
    };
    /// A drive that would be cheaper, if it is free.
    struct Candidate {
      double cost;
      std::size_t from, gear_before, gear;
      SteeringWord drive;
    };

    static std::size_t number(Gear gear) { return gear == Gear::forward ? 0 : 1; }
    static Gear first_gear(const SteeringWord& word) {
      return detail::gear_of(word.moves[0].length);
    }
    static Gear last_gear(const SteeringWord& word) {
      return detail::gear_of(word.moves[word.size - 1].length);
    }

    /// The cost of changing from one gear to another; none at the start.
    double change(std::size_t place, std::size_t before, Gear gear) const {
      return place > 0 && before != number(gear) ? options_.cusp_cost : 0;
    }

    template <ClearanceSpace S>
    void reach(const S& space, detail::FootprintTest& footprint, std::size_t to) {
      const Place& place = places_[to];
      const Gear gear = path_.gears[place.piece];
      const double length = (place.to - place.from) * (path_.curve.length_before(place.piece + 1) -
                                                       path_.curve.length_before(place.piece));
      const double weighted = gear == Gear::reverse ? options_.reverse_weight * length : length;
      for (std::size_t before = 0; before < 2; ++before) {
        const double cost = cost_at(to - 1, before) + change(to - 1, before, gear) + weighted;
        Way& way = ways_[to][number(gear)];
        if (cost < way.cost) way = {cost, to - 1, before, std::nullopt};
      }
      candidates_.clear();
      for (std::size_t from = 0; from + 1 < to; ++from) collect(from, to);
      std::stable_sort(candidates_.begin(), candidates_.end(),
                       [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
      for (const Candidate& c : candidates_) {
        Way& way = ways_[to][c.gear];
        if (!(c.cost < way.cost)) continue;
        const VehiclePath drive = drive_path(c.drive, c.from, to);
        if (footprint.is_free(space, drive)) way = {c.cost, c.from, c.gear_before, c.drive};
      }
    }

    double cost_at(std::size_t place, std::size_t gear) const {
      return place == 0 ? 0.0 : ways_[place][gear].cost;
    }

    void collect(std::size_t from, std::size_t to) {
      const Pose &a = places_[from].pose, &b = places_[to].pose;
      const double radius = vehicle_.min_turning_radius;
      const SteeringWord drive =
          (vehicle_.reverse ? reeds_shepp_word(a, b, radius) : dubins_word(a, b, radius))
              .without_rounding();
      if (drive.size == 0) return;
      double cost = options_.cusp_cost * static_cast<double>(drive.cusps());
      for (std::size_t i = 0; i < drive.size; ++i) {
        const double length = radius * drive.moves[i].length;
        cost += length < 0 ? -options_.reverse_weight * length : length;
      }
      const std::size_t gear = number(last_gear(drive));
      for (std::size_t before = 0; before < 2; ++before) {
        const double total = cost_at(from, before) + change(from, before, first_gear(drive)) + cost;
        if (total < ways_[to][gear].cost * (1 - 1e-9)) {
          candidates_.push_back({total, from, before, gear, drive});
        }
      }
    }

    VehiclePath drive_path(const SteeringWord& drive, std::size_t from, std::size_t to) const {
      return vehicle_path(drive, places_[from].pose, places_[to].pose, vehicle_.min_turning_radius);
    }

    /// The path of the cheapest way to the last place; parts of one piece are joined again.
    VehiclePath assembled() const {
      std::vector<std::pair<std::size_t, const Way*>> chain;
      std::size_t place = places_.size() - 1;
      std::size_t gear = ways_[place][1].cost < ways_[place][0].cost ? 1 : 0;
      while (place > 0) {
        const Way& way = ways_[place][gear];
        chain.emplace_back(place, &way);
        place = way.from;
        gear = way.gear_before;
      }
      std::reverse(chain.begin(), chain.end());
      VehiclePath result;
      for (std::size_t i = 0; i < chain.size(); ++i) {
        const auto& [to, way] = chain[i];
        if (way->drive) {
          const VehiclePath drive = drive_path(*way->drive, way->from, to);
          for (std::size_t k = 0; k < drive.gears.size(); ++k) {
            result.push_back(drive.curve.pieces()[k], drive.gears[k]);
          }
          continue;
        }
        const double from = places_[to].from;
        const std::size_t piece = places_[to].piece;
        std::size_t last = to;
        while (i + 1 < chain.size() && !chain[i + 1].second->drive &&
               places_[chain[i + 1].first].piece == piece) {
          last = chain[++i].first;
        }
        add_part(piece, from, places_[last].to, result);
      }
      return result;
    }

    void add_part(std::size_t index, double from, double to, VehiclePath& result) const {
      const Gear gear = path_.gears[index];
      path_.curve.pieces()[index].visit([&](const auto& piece) {
        if (from == 0 && to == 1) return result.push_back(piece, gear);
        const auto part = piece.part(from, to);
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(piece)>, Segment>) {
          result.push_back(
              detail::straight_piece(part.a, part.b, detail::travel_direction(piece, 0)), gear);
        } else {
          result.push_back(part, gear);
        }
      });
    }

    const VehicleShortcut& options_;
    const Vehicle& vehicle_;
    const VehiclePath& path_;
    std::vector<Place> places_;
    std::vector<std::array<Way, 2>> ways_;  // by the gear in which a place is reached
    std::vector<Candidate> candidates_;
  };
};

}  // namespace tutavia
