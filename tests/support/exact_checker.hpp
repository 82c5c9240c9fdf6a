// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// ExactChecker: an independent judge of paths: rational arithmetic for segments and Beziers, a
/// hundred digits for arcs and clothoids. It shares types with the library, but no computation.

namespace tutavia::test {

/// `free`: every point keeps the safety radius and the bounds. `blocked`: some point does not.
/// `unknown`: a tie that subdivision cannot decide (a curve that touches a zone exactly).
enum class ExactVerdict { free, blocked, unknown };

class ExactChecker {
 public:
  explicit ExactChecker(const Workspace& world);

  ExactVerdict check(const Curve& curve) const;
  ExactVerdict check(const Piece& piece) const;

 private:
  class Judge;  // compiled once for all tests
  std::shared_ptr<const Judge> judge_;
};

}  // namespace tutavia::test
