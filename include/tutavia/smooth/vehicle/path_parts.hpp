// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

#include "tutavia/certify/certify_vehicle.hpp"
#include "tutavia/core/budget.hpp"
#include "tutavia/geometry/pose.hpp"
#include "tutavia/geometry/vehicle_path.hpp"
#include "tutavia/search/vehicle/drive_chain.hpp"
#include "tutavia/search/vehicle/driving_costs.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// PathPart: a vehicle's path cut into parts, and chained anew from parts and drives.

namespace tutavia::detail {

/// A part of a piece, between parameters, and all of the pieces that follow up to `last`.
struct PathPart {
  std::size_t piece;
  double from, to;
  std::size_t last;
  bool may_stay = true;  ///< whether the smoothed path may contain it
};

/// Appends the parts of a piece, of equal lengths of at most `spacing` metres.
inline void cut_piece(const VehiclePath& path, std::size_t piece, double spacing, bool may_stay,
                      std::vector<PathPart>& parts) {
  const double length = path.curve.length_before(piece + 1) - path.curve.length_before(piece);
  const int count =
      length > 0 ? std::max(1, static_cast<int>(std::ceil(length / spacing - 1e-6))) : 1;
  for (int k = 1; k <= count; ++k) {
    parts.push_back({piece, (k - 1.0) / count, static_cast<double>(k) / count, piece, may_stay});
  }
}

/// A part as a step of a chain of drives.
inline KnownPath known_path(const VehiclePath& path, const PathPart& part,
                            const DrivingCosts& costs) {
  const Gear gear = path.gears[part.piece];
  const auto length = [&](std::size_t i) {
    return path.curve.length_before(i + 1) - path.curve.length_before(i);
  };
  double driven = (part.to - part.from) * length(part.piece);
  for (std::size_t i = part.piece + 1; i <= part.last; ++i) driven += length(i);
  return {gear, (gear == Gear::reverse ? costs.reverse : costs.forward) * driven};
}

/// Appends a part to another path. \pre it starts where that ends
inline void append_part(const VehiclePath& path, const PathPart& part, VehiclePath& result) {
  const Gear gear = path.gears[part.piece];
  path.curve.pieces()[part.piece].visit([&](const auto& piece) {
    if (part.from == 0 && part.to == 1) return result.push_back(piece, gear);
    const auto shorter = piece.part(part.from, part.to);
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(piece)>, Segment>) {
      const double direction = travel_direction(piece, 0);
      result.push_back(straight_piece(shorter.a, shorter.b, direction), gear);
    } else {
      result.push_back(shorter, gear);
    }
  });
  for (std::size_t i = part.piece + 1; i <= part.last; ++i) {
    result.push_back(path.curve.pieces()[i], path.gears[i]);
  }
}

/// The cheapest chain of drives, which are proved free, and of parts of the path that may stay.
/// Part i ends at place i; the first is empty. Nothing is returned if there is no chain, if the
/// budget ends, or if rounding spoils the parts.
template <ClearanceSpace S, class Drives>
std::optional<VehiclePath> chain_of(const S& space, FootprintTest& footprint, const Drives& drives,
                                    const DrivingCosts& costs, const VehiclePath& path,
                                    const std::vector<PathPart>& parts, const Budget& budget) {
  std::vector<Pose> ends;
  ends.reserve(parts.size());
  for (const PathPart& part : parts) ends.push_back(path.pose(part.last, part.to));
  DriveChain chain(drives, costs, ends);
  const auto way = chain.cheapest(
      space, footprint,
      [&](std::size_t i) {
        return parts[i].may_stay ? std::optional(known_path(path, parts[i], costs)) : std::nullopt;
      },
      budget);
  if (way.empty()) return std::nullopt;
  VehiclePath result;
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (way[i].drive) {
      result.append(chain.path(*way[i].drive, way[i].from, way[i].to));
      continue;
    }
    PathPart part = parts[way[i].to];  // parts of one piece are joined again
    while (i + 1 < way.size() && !way[i + 1].drive && parts[way[i + 1].to].piece == part.piece) {
      part.to = parts[way[++i].to].to;
    }
    append_part(path, part, result);
  }
  if (!footprint.is_free(space, result)) return std::nullopt;
  return result;
}

}  // namespace tutavia::detail
