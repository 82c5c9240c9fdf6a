// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tutavia/geometry/predicates.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/plan/statistics.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/mesh/convex_pieces.hpp"
#include "tutavia/search/mesh/interval_expansion.hpp"
#include "tutavia/search/mesh/interval_geometry.hpp"
#include "tutavia/search/mesh/interval_scratch.hpp"
#include "tutavia/search/query_checks.hpp"
#include "tutavia/space/cell_space.hpp"

/// \file
/// Polyanya: the search of AnyAngle over intervals of the sides of convex pieces.

namespace tutavia::detail {

/// One query over a decomposition of the free cells into convex pieces: FreeRuns or NavigationMesh.
template <ConvexPieces Pieces, Observer O>
class Polyanya {
 public:
  Polyanya(const CellSpace& space, const Pieces& pieces, const Query& query,
           IntervalScratch& scratch, O& observer, Statistics& stats)
      : space_(space),
        query_(query),
        scratch_(scratch),
        stats_(stats),
        expansion_(space, pieces, query, scratch, observer, stats) {}

  Expected<void, Failure> run() {
    expansion_.start();
    for (const Node& node : scratch_.successors) scratch_.push(node);
    while (!scratch_.empty() && scratch_.seek_first() < expansion_.best()) {
      Node node = scratch_.pop();
      while (true) {
        if (expansion_.is_stale(node)) break;
        if (auto within = check_budget(query_.budget, stats_.expanded, 256); !within) return within;
        scratch_.successors.clear();
        expansion_.expand(node);
        const auto& next = scratch_.successors;
        if (next.size() == 1 && scratch_.is_next(next[0])) {
          node = next[0];
          continue;
        }
        for (const Node& successor : next) {
          if (successor.f < expansion_.best()) scratch_.push(successor);
        }
        break;
      }
    }
    if (expansion_.best() == Expansion::infinity) return fail(PlanError::unreachable);
    return {};
  }

  /// The path found, without collinear vertices.
  Curve curve() const {
    const IntervalGeometry& geometry = expansion_.geometry();
    std::vector<Point> points{query_.goal};
    for (std::uint32_t root = geometry.id(expansion_.best_root()); root != geometry.corners();
         root = scratch_.root(root).parent) {
      const Point p = space_.corner(geometry.corner_of(root));
      if (p != points.back()) points.push_back(p);
    }
    if (query_.start != points.back() || points.size() == 1) points.push_back(query_.start);
    std::reverse(points.begin(), points.end());
    Curve result;
    std::size_t from = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const bool straight_on = i + 1 < points.size() &&
                               orientation(points[from], points[i], points[i + 1]) == 0 &&
                               (points[i] - points[from]).dot(points[i + 1] - points[i]) > 0;
      if (straight_on) continue;
      result.push_back(Segment{points[from], points[i]});
      from = i;
    }
    return result;
  }

 private:
  using Expansion = IntervalExpansion<Pieces, O>;
  using Node = IntervalNode;

  const CellSpace& space_;
  const Query& query_;
  IntervalScratch& scratch_;
  Statistics& stats_;
  Expansion expansion_;
};

}  // namespace tutavia::detail
