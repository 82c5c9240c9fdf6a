// SPDX-License-Identifier: MIT
#pragma once

#include "support/catch.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/smooth/route/grid_nodes.hpp"
#include "tutavia/space/lattice_space.hpp"

/// \file
/// A straight run that is free as a whole, although its rounded steps are not.

namespace tutavia::test {

struct TouchingRun {
  // The zone ends at y = 0.7; the lattice has nodes at 7 * 0.1, which is more.
  LatticeSpace space =
      LatticeSpace::build({.bounds = {{0, 0}, {4, 4}},
                           .safety_radius = 0.5,
                           .obstacles = {Polygon{{{1, 1.2}, {3, 1.2}, {3, 2}, {1, 2}}}}},
                          {.resolution = 0.1})
          .value();
  Curve input = Curve::polyline(std::vector<Point>{{0.3, 0.7}, {3.7, 0.7}});
};

inline TouchingRun touching_run() {
  TouchingRun run;
  REQUIRE(certify(run.space, run.input).status == ProofStatus::proved);
  REQUIRE(certify(run.space, detail::split_at_nodes(run.space, run.input)).status !=
          ProofStatus::proved);
  return run;
}

}  // namespace tutavia::test
