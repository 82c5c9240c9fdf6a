// SPDX-License-Identifier: MIT
#include "tutavia/certify/piece_proof.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;

TEST_CASE("the number of distances grows with the logarithm of the gap") {
  // A parabola above a half plane's edge: its clearance is known to the last digit.
  const auto space = InflatedSpace::build({.bounds = {{-10, -1}, {10, 10}},
                                           .safety_radius = 1,
                                           .obstacles = {Polygon{{{-10, 0}, {10, 0}, {0, -1}}}}})
                         .value();
  std::size_t last = 0;
  for (const double gap : {1e-1, 1e-3, 1e-6, 1e-9, 1e-12}) {
    INFO("gap " << gap);
    const double low = 1 + gap;
    const QuadraticBezier above{{Point(-2, low + 1), Point(0, low - 1), Point(2, low + 1)}};
    const PieceProof proof = prove_distance(space, above, 1);
    CHECK(proof.status == ProofStatus::proved);
    CHECK(proof.evaluations >= last);
    CHECK(proof.evaluations <= 100);
    last = proof.evaluations;
    const double too_low = 1 - gap;
    const QuadraticBezier below{
        {Point(-2, too_low + 1), Point(0, too_low - 1), Point(2, too_low + 1)}};
    const PieceProof refusal = prove_distance(space, below, 1);
    CHECK(refusal.status == ProofStatus::violated);
    CHECK(below.point(refusal.parameter).y() < 1);
  }
}

TEST_CASE("an exact tie of a curve is undecided within the evaluations allowed") {
  const auto space = InflatedSpace::build({.bounds = {{-10, -1}, {10, 10}},
                                           .safety_radius = 1,
                                           .obstacles = {Polygon{{{-10, 0}, {10, 0}, {0, -1}}}}})
                         .value();
  const QuadraticBezier touching{{Point(-2, 2), Point(0, 0), Point(2, 2)}};
  const PieceProof proof = prove_distance(space, touching, 1);
  CHECK(proof.status == ProofStatus::undecided);
  CHECK(proof.evaluations <= 256);
  CHECK(prove_distance(space, touching, 0.9999).status == ProofStatus::proved);
  CHECK(prove_distance(space, touching, 0.9, 0).status == ProofStatus::undecided);
}

}  // namespace
