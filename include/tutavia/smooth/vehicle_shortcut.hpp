// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "tutavia/certify/certify_vehicle.hpp"
#include "tutavia/core/budget.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/plan/vehicle.hpp"
#include "tutavia/search/vehicle/drive_chain.hpp"
#include "tutavia/search/vehicle/driving_costs.hpp"
#include "tutavia/smooth/concepts.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// VehicleShortcut: shortens a vehicle's path by drives of Reeds and Shepp, or of Dubins.

namespace tutavia {

/// Replaces parts of a vehicle's path by shortest drives that are proved free.
///
/// The candidates are the joints of the pieces and up to `places` poses at equal steps of arc
/// length. Dynamic programming finds the cheapest chain of parts of the path and of shortest drives
/// between any two candidates, each proved. It is repeated while it saves more than a thousandth.
/// The result never costs more than the input by the weights below, and keeps its ends, its
/// headings there and the turning radius. A vehicle that turns on the spot keeps its path. If the
/// budget ends, the best path so far is returned.
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
      auto better = with_shortcuts(space, vehicle, footprint, result, budget);
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
  double cost_of(const VehiclePath& path) const { return detail::cost_of(path, costs()); }

 private:
  /// A part of a piece, between parameters.
  struct Part {
    std::size_t piece;
    double from, to;
  };

  detail::DrivingCosts costs() const { return {1, reverse_weight, cusp_cost}; }

  /// The cheapest chain of parts of the path and drives between their ends. Empty if the budget
  /// ends, or if rounding spoils the parts.
  template <ClearanceSpace S>
  std::optional<VehiclePath> with_shortcuts(const S& space, const Vehicle& vehicle,
                                            detail::FootprintTest& footprint,
                                            const VehiclePath& path, const Budget& budget) const {
    const std::vector<Part> parts = cut(path);  // part i ends at place i
    std::vector<Pose> ends;
    ends.reserve(parts.size());
    for (const Part& part : parts) ends.push_back(path.pose(part.piece, part.to));
    detail::DriveChain chain(vehicle, costs(), ends);
    const auto way = chain.cheapest(
        space, footprint,
        [&](std::size_t i) -> std::optional<detail::DriveChain::KnownWay> {
          const auto& [piece, from, to] = parts[i];
          const Gear gear = path.gears[piece];
          const double length =
              path.curve.length_before(piece + 1) - path.curve.length_before(piece);
          const double weight = gear == Gear::reverse ? reverse_weight : 1;
          return detail::DriveChain::KnownWay{gear, weight * (to - from) * length};
        },
        budget);
    if (way.empty()) return std::nullopt;
    VehiclePath result;
    for (std::size_t i = 0; i < way.size(); ++i) {
      if (way[i].drive) {
        result.append(chain.path(*way[i].drive, way[i].from, way[i].to));
        continue;
      }
      Part part = parts[way[i].to];  // parts of one piece are joined again
      while (i + 1 < way.size() && !way[i + 1].drive && parts[way[i + 1].to].piece == part.piece) {
        part.to = parts[way[++i].to].to;
      }
      add_part(path, part, result);
    }
    if (!footprint.is_free(space, result)) return std::nullopt;
    return result;
  }

  /// The parts between neighbouring candidates, after an empty part at the start.
  std::vector<Part> cut(const VehiclePath& path) const {
    const double spacing = path.length() / places;
    std::vector<Part> parts{{0, 0, 0}};
    for (std::size_t i = 0; i < path.gears.size(); ++i) {
      const double length = path.curve.length_before(i + 1) - path.curve.length_before(i);
      const int count =
          length > 0 ? std::max(1, static_cast<int>(std::ceil(length / spacing - 1e-6))) : 1;
      for (int k = 1; k <= count; ++k) {
        parts.push_back({i, (k - 1.0) / count, static_cast<double>(k) / count});
      }
    }
    return parts;
  }

  static void add_part(const VehiclePath& path, const Part& part, VehiclePath& result) {
    const Gear gear = path.gears[part.piece];
    path.curve.pieces()[part.piece].visit([&](const auto& piece) {
      if (part.from == 0 && part.to == 1) return result.push_back(piece, gear);
      const auto shorter = piece.part(part.from, part.to);
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(piece)>, Segment>) {
        const double direction = detail::travel_direction(piece, 0);
        result.push_back(detail::straight_piece(shorter.a, shorter.b, direction), gear);
      } else {
        result.push_back(shorter, gear);
      }
    });
  }
};

}  // namespace tutavia
