// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "tutavia/geometry/vehicle_path.hpp"
#include "tutavia/search/vehicle/drive_chain.hpp"
#include "tutavia/search/vehicle/driving_costs.hpp"

/// \file
/// PathPart: a vehicle's path cut into parts of pieces.

namespace tutavia::detail {

/// A part of a piece, between parameters.
struct PathPart {
  std::size_t piece;
  double from, to;
};

/// Appends the parts of a piece, of equal lengths of at most `spacing` metres.
inline void cut_piece(const VehiclePath& path, std::size_t piece, double spacing,
                      std::vector<PathPart>& parts) {
  const double length = path.curve.length_before(piece + 1) - path.curve.length_before(piece);
  const int count =
      length > 0 ? std::max(1, static_cast<int>(std::ceil(length / spacing - 1e-6))) : 1;
  for (int k = 1; k <= count; ++k) {
    parts.push_back({piece, (k - 1.0) / count, static_cast<double>(k) / count});
  }
}

/// The parts of all pieces, after an empty part at the start.
inline std::vector<PathPart> cut(const VehiclePath& path, double spacing) {
  std::vector<PathPart> parts{{0, 0, 0}};
  for (std::size_t i = 0; i < path.gears.size(); ++i) cut_piece(path, i, spacing, parts);
  return parts;
}

/// A part as a step of a chain of drives.
inline KnownPath known_path(const VehiclePath& path, const PathPart& part,
                            const DrivingCosts& costs) {
  const Gear gear = path.gears[part.piece];
  const double length =
      path.curve.length_before(part.piece + 1) - path.curve.length_before(part.piece);
  const double weight = gear == Gear::reverse ? costs.reverse : costs.forward;
  return {gear, weight * (part.to - part.from) * length};
}

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
}

}  // namespace tutavia::detail
