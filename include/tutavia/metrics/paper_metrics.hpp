// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "tutavia/core/assert.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/resample.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// The measures that papers print and PathMetrics does not have: MD, AD, AT, relative smoothness.

namespace tutavia {

/// Distances from samples of a path to the nearest obstacle [m], 0 inside of one; infinite without
/// obstacles. MD and AD of the SSA-A* paper, which prints them in cells.
struct ObstacleDistances {
  double min = 0;
  double mean = 0;
};

/// Distances to the nearest obstacle from the points of a curve at the arc lengths 0, step, 2 step,
/// ... before its end [m]; the end counts for the least one alone. Reading of the paper: distances
/// to the extents of blocked cells, not to their centres, at a step of 0.05 cells. The least
/// distance is that of the samples; a certificate has a proved bound.
/// \pre the curve is finite and not empty, step > 0
///
/// Source: the SSA-A* paper, MD and AD; docs/algorithms.md.
template <ClearanceSpace S>
ObstacleDistances obstacle_distances(const S& space, const Curve& curve, double step) {
  TUTAVIA_ASSERT(!curve.empty() && step > 0);
  const std::vector<CurvePoint> samples = resample(curve, step);
  const std::size_t counted = std::max<std::size_t>(1, samples.size() - 1);
  ObstacleDistances distances{std::numeric_limits<double>::infinity(), 0};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double distance = std::fmax(0.0, space.clearance(samples[i].position));
    distances.min = std::fmin(distances.min, distance);
    if (i < counted) distances.mean += distance / static_cast<double>(counted);
  }
  return distances;
}

/// The mean magnitude of the change of heading at the points between the first and the last [rad],
/// where repeated points count once; 0 for less than three points. AT of the SSA-A* paper ("degree
/// of meandering"). It is not a curvature: more samples of the same path make it smaller.
///
/// Source: the SSA-A* paper, AT; docs/algorithms.md.
inline double mean_turn(std::span<const Point> points) {
  std::vector<Point> distinct(points.begin(), points.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  if (distinct.size() < 3) return 0;
  double sum = 0;
  for (std::size_t i = 1; i + 1 < distinct.size(); ++i) {
    sum += std::abs(turn_angle(distinct[i] - distinct[i - 1], distinct[i + 1] - distinct[i]));
  }
  return sum / static_cast<double>(distinct.size() - 2);
}

/// The same for `samples` points of a curve at equal steps of arc length, its ends included.
/// \pre the curve is finite and not empty, samples >= 2
inline double mean_turn(const Curve& curve, std::size_t samples = 100) {
  TUTAVIA_ASSERT(!curve.empty() && samples >= 2);
  std::vector<Point> points;
  points.reserve(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    points.push_back(
        curve.point(curve.length() * static_cast<double>(i) / static_cast<double>(samples - 1)));
  }
  return mean_turn(points);
}

/// All nodes of a route on a grid whose steps are `resolution` wide [m]: the waypoints, and the
/// nodes within straight runs, which routes hold whole. No node is repeated. Pieces are taken for
/// straight; a link to a point off the grid has no nodes inside unless it is longer than 1.5 steps.
/// For `mean_turn` of raw paths, which papers measure at every node. \pre resolution > 0
inline std::vector<Point> grid_nodes(const Curve& route, double resolution) {
  TUTAVIA_ASSERT(resolution > 0);
  std::vector<Point> nodes;
  for (const Point& p : waypoints(route)) {
    const Point from = nodes.empty() ? p : nodes.back();
    if (!nodes.empty() && p == from) continue;
    const double count = std::round((p - from).cwiseAbs().maxCoeff() / resolution);
    for (double k = 1; k < count; ++k) nodes.emplace_back(from + (p - from) * (k / count));
    nodes.push_back(p);
  }
  return nodes;
}

/// RS of the paper on improved REA*: the total turning of a reference path, there that of A*, over
/// the path's own (PathMetrics::turning_angle). 1 if neither turns, infinite if only the reference
/// does.
inline double relative_smoothness(double reference_turning, double turning) {
  if (turning > 0) return reference_turning / turning;
  return reference_turning > 0 ? std::numeric_limits<double>::infinity() : 1;
}

}  // namespace tutavia
