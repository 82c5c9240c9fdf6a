// SPDX-License-Identifier: MIT
// Proves curves of your own: a certificate encloses the clearance of the whole curve. Of a curve
// that comes too near to an obstacle it names a witness: where, to which obstacle, how near.

#include <iomanip>
#include <iostream>
#include <tutavia/tutavia.hpp>

/// Certifies a curve and prints what is proved.
template <class Space>
void judge(const Space& space, const tutavia::Curve& curve) {
  const tutavia::Certificate found = tutavia::certify(space, curve);
  if (found.status == tutavia::ProofStatus::proved) {
    std::cout << "proved: at least " << found.lower << " m from every obstacle\n";
  } else if (found.status == tutavia::ProofStatus::violated) {
    std::cout << "violated: piece " << found.piece << " at (" << found.point.x() << ", "
              << found.point.y() << ") is at most " << found.upper << " m from obstacle "
              << found.obstacle << '\n';
  } else {
    std::cout << "undecided: treat it as unsafe\n";
  }
}

int main() {
  using namespace tutavia;
  std::cout << std::fixed << std::setprecision(3);
  const Workspace room{.bounds = {{0, 0}, {10, 6}},
                       .safety_radius = 0.4,
                       .obstacles = {Disc{.center = {2.4, 4.2}, .radius = 1},
                                     Polygon{{{5, 0}, {6, 0}, {6, 3.2}, {5, 2.6}}}}};
  const auto space = InflatedSpace::build(room);
  if (!space) {
    std::cerr << space.error() << '\n';
    return 1;
  }

  // A straight piece and a bend over the polygon: too low, and high enough.
  for (const double top : {4.0, 4.5}) {
    Curve curve;
    curve.push_back(Segment{{1, 2}, {4, 2.5}});
    curve.push_back(CubicBezier{{Point(4, 2.5), Point(5, top), Point(7, top), Point(9, 1)}});
    judge(*space, curve);
  }
}
