// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

#include "tutavia/geometry/point.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// Certificate: what has been proved about a curve's clearance.

namespace tutavia {

/// The answer to "does the whole curve keep the safety radius and stay in the bounds?".
enum class ProofStatus {
  proved,     ///< yes, for every point of the continuous curve
  violated,   ///< no: a point of the curve is closer or out of bounds
  undecided,  ///< too close to call in the evaluations allowed; treat it as a no
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

/// What has been proved about one curve in one space.
///
/// `lower <= c <= upper` holds for the curve's true clearance c, the least distance between any of
/// its points and any obstacle, rounding included. The place where `upper` is attained (within
/// `distance_error_bound`) is given, and for a violation it is the witness. A violated curve has no
/// lower bound
/// (-infinity); a curve in a space without obstacles has both bounds infinite.
struct Certificate {
  ProofStatus status = ProofStatus::undecided;
  double lower = -std::numeric_limits<double>::infinity();  ///< [m]
  double upper = std::numeric_limits<double>::infinity();   ///< [m]
  Point point = Point::Zero();                     ///< on the curve, nearest to an obstacle
  std::size_t piece = 0;                           ///< which piece holds it
  double parameter = 0;                            ///< where on that piece, in [0, 1]
  std::uint32_t obstacle = NearestObstacle::none;  ///< the obstacle nearest to it
  std::uint32_t edge = 0;                          ///< and which of its edges
  double distance_error_bound = 0;                 ///< allowance for rounding in one distance [m]
  std::size_t evaluations = 0;                     ///< distances computed
};

}  // namespace tutavia
