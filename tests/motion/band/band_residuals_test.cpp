// SPDX-License-Identifier: MIT
#include "tutavia/motion/band/band_residuals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

#include "support/catch.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/space/inflated_space.hpp"

namespace {

using namespace tutavia;
using detail::BandProblem;
using detail::BandResiduals;

struct ResidualRow {
  BandTerm term;
  std::size_t first;
  double value;
  BandResiduals::Gradient gradient;
};

std::vector<ResidualRow> rows_of(const BandProblem& problem, const detail::BandFeatures& features,
                                 const Band& band) {
  std::vector<ResidualRow> rows;
  BandResiduals(problem, features, band)
      .for_each(
          [&](BandTerm term, std::size_t i, double value, const BandResiduals::Gradient& gradient) {
            rows.push_back({term, i, value, gradient});
          });
  return rows;
}

/// The variable of a band that belongs to entry k of the gradient of residuals at pose i.
double* variable(Band& band, std::size_t i, int k) {
  const std::size_t pose = i + std::size_t(k / 4);
  if (pose >= band.poses.size()) return nullptr;
  if (k % 4 == 3) return pose == 0 ? nullptr : &band.intervals[pose - 1];
  if (k % 4 == 2) return &band.poses[pose].heading;
  return &band.poses[pose].position[k % 4];
}

Band random_band(Random& random, std::size_t poses) {
  Band band;
  double heading = random.uniform(-3, 3);
  Point p{random.uniform(-1, 1), random.uniform(-1, 1)};
  for (std::size_t i = 0; i < poses; ++i) {
    band.poses.push_back({p, heading});
    if (i + 1 == poses) break;
    band.intervals.push_back(random.uniform(0.1, 0.5));
    heading += random.uniform(-0.6, 0.6);
    const double length = random.uniform(-0.1, 0.4), angle = heading + random.uniform(-0.3, 0.3);
    p = detail::offset_along(p, length, {std::cos(angle), std::sin(angle)});
  }
  return band;
}

InflatedSpace obstacles_around() {
  Workspace workspace{.bounds = {{-9, -9}, {9, 9}}, .safety_radius = 0.2};
  workspace.obstacles.push_back(Polygon{{{0.5, 0.2}, {1.5, 0.3}, {1.2, 1.4}}});
  workspace.obstacles.push_back(Disc{{-1, 0.5}, 0.3});
  workspace.obstacles.push_back(Polygon{{{-1, -1.5}, {2, -1.4}, {1, -0.8}}});
  return InflatedSpace::build(workspace).value();
}

TEST_CASE("gradients of a band's residuals are their finite differences") {
  const std::uint64_t seed = 20;
  CAPTURE(seed);
  Random random(seed);
  const InflatedSpace space = obstacles_around();
  const std::vector<MovingObstacle> moving{{Disc{{0, -0.5}, 0.2}, {0.3, 0.1}},
                                           {Polygon{{{1, 2}, {2, 2}, {2, 3}}}, {0, -0.2}}};
  std::array<std::size_t, band_terms> seen{};
  for (int round = 0; round < 60; ++round) {
    Band band = random_band(random, 4 + std::size_t(round) % 5);
    const std::vector<detail::ViaPoint> vias{{2, {random.uniform(-1, 1), 0.3}}};
    const BandProblem problem{{}, {}, 0.6, {0.2, 0.1}, Twist{}, vias};
    detail::BandFeatures features;
    features.find(space, moving, band, 2);
    const auto rows = rows_of(problem, features, band);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (rows[r].value == 0) continue;  // a limit that is not reached, which only stiffens steps
      for (int k = 0; k < 12; ++k) {
        double* x = variable(band, rows[r].first, k);
        if (x == nullptr) {
          CHECK(rows[r].gradient[k] == 0);
          continue;
        }
        const double before = *x, h = 1e-6;
        *x = before + h;
        const auto above = rows_of(problem, features, band);
        *x = before - h;
        const auto below = rows_of(problem, features, band);
        *x = before;
        // A hinge that opens or an obstacle that takes over has no derivative.
        if (above.size() != rows.size() || below.size() != rows.size()) continue;
        const double forward = (above[r].value - rows[r].value) / h;
        const double backward = (rows[r].value - below[r].value) / h;
        const double scale = 1 + rows[r].gradient.norm();
        if (std::abs(forward - backward) > 1e-3 * scale) continue;
        CAPTURE(round, r, k, std::string(to_string(rows[r].term)));
        CHECK(std::abs(0.5 * (forward + backward) - rows[r].gradient[k]) <= 1e-3 * scale);
        ++seen[std::size_t(rows[r].term)];
      }
    }
  }
  for (const std::size_t count : seen) CHECK(count > 100);
}

}  // namespace
