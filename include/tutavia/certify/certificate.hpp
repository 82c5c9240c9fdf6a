// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

#include "tutavia/geometry/point.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// Certificate: the proved bounds of a curve's clearance.

namespace tutavia {

/// Whether the whole curve keeps the safety radius and stays within the bounds.
enum class ProofStatus {
  proved,     ///< yes, for every point of the continuous curve
  violated,   ///< no: a point of the curve is too close or out of bounds
  undecided,  ///< not decided within the allowed evaluations; treat it as a no
};

constexpr std::string_view to_string(ProofStatus status) {
  switch (status) {
    case ProofStatus::proved:
      return "proved";
    case ProofStatus::violated:
      return "violated";
    case ProofStatus::undecided:
      return "undecided";
  }
  return "unknown";
}

/// The proved bounds of the clearance of one curve in one space.
///
/// `lower <= c <= upper` holds for the curve's true clearance c, the least distance between any of
/// its points and any obstacle, rounding included. `point` attains `upper` (within
/// `distance_error_bound`); for a violation it is the witness. A violated curve has the lower bound
/// -infinity; without obstacles both bounds are infinite.
struct Certificate {
  ProofStatus status = ProofStatus::undecided;
  double lower = -std::numeric_limits<double>::infinity();  ///< [m]
  double upper = std::numeric_limits<double>::infinity();   ///< [m]
  Point point = Point::Zero();                     ///< on the curve, nearest to an obstacle
  std::size_t piece = 0;                           ///< index of the piece with that point
  double parameter = 0;                            ///< of the point on that piece, in [0, 1]
  std::uint32_t obstacle = NearestObstacle::none;  ///< the obstacle nearest to it
  std::uint32_t edge = 0;                          ///< and which of its edges
  double distance_error_bound = 0;                 ///< rounding error of one distance [m]
  std::size_t evaluations = 0;                     ///< distances computed
};

}  // namespace tutavia
