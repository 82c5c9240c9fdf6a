// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "tutavia/any_algorithm.hpp"
#include "tutavia/search/ant_colony.hpp"
#include "tutavia/search/any_angle.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/bidirectional_astar.hpp"
#include "tutavia/search/canonical_astar.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/dijkstra.hpp"
#include "tutavia/search/improved_rea_star.hpp"
#include "tutavia/search/informed_rrt_star.hpp"
#include "tutavia/search/jps.hpp"
#include "tutavia/search/jps_plus.hpp"
#include "tutavia/search/jps_theta_star.hpp"
#include "tutavia/search/lazy_theta_star.hpp"
#include "tutavia/search/penalty_astar.hpp"
#include "tutavia/search/rea_star.hpp"
#include "tutavia/search/rrt.hpp"
#include "tutavia/search/rrt_connect.hpp"
#include "tutavia/search/rrt_star.hpp"
#include "tutavia/search/safe_rrt_star.hpp"
#include "tutavia/search/sb_rea_star.hpp"
#include "tutavia/search/search_record.hpp"
#include "tutavia/search/ssa_astar.hpp"
#include "tutavia/search/tangent_graph.hpp"
#include "tutavia/search/theta_star.hpp"
#include "tutavia/search/weighted_astar.hpp"
#include "tutavia/smooth/b_spline_smoother.hpp"
#include "tutavia/smooth/bezier_smoother.hpp"
#include "tutavia/smooth/clothoid_smoother.hpp"
#include "tutavia/smooth/concepts.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "tutavia/smooth/homotopy_refine.hpp"
#include "tutavia/smooth/no_smoothing.hpp"
#include "tutavia/smooth/redundant_node_removal.hpp"
#include "tutavia/smooth/shortcut.hpp"
#include "tutavia/smooth/smoothing_spline.hpp"
#include "tutavia/smooth/string_pull.hpp"
#include "tutavia/smooth/taut_string.hpp"
#include "tutavia/smooth/two_stage_b_spline.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// all_searches and all_smoothers: the algorithms by name, for selection at run time.

namespace tutavia {

namespace detail {

/// The jump table that all copies of a type-erased JPS+ share; each prepared table is immutable.
class SharedJumpTable {
 public:
  template <GridSpace S>
  Expected<std::shared_ptr<const JumpTable>, Failure> prepared_for(const S& space) {
    const std::lock_guard lock(mutex_);
    if (table_ == nullptr || !table_->matches(space.grid())) {
      auto table = JpsPlus::prepare(space);
      if (!table) return table;
      table_ = std::move(*table);
    }
    return table_;
  }

 private:
  std::mutex mutex_;
  std::shared_ptr<const JumpTable> table_;
};

/// A type-erased JPS+ that prepares the table of a space at its first query.
template <GridSpace S>
AnySearch<S> erase_jps_plus() {
  auto shared = std::make_shared<SharedJumpTable>();
  return {JpsPlus::name,
          [shared](const S& space, const Query& query, AnyScratch& any,
                   SearchRecord* record) -> Expected<Route, Failure> {
            const auto table = shared->prepared_for(space);
            if (!table) return Unexpected{table.error()};
            OptionalRecord observer{record};
            auto& scratch = any.get<JpsPlus::Scratch>();
            return JpsPlus{*table}.search(space, query, scratch, observer);
          }};
}

/// Adds the searches that work on S, with default options.
template <class... Searches, class S>
void add_searches(std::vector<AnySearch<S>>& all) {
  const auto add = [&]<class A>(const A& search) {
    if constexpr (Searcher<A, S>) all.push_back(erase_search<S>(search));
  };
  (add(Searches{}), ...);
}

/// Adds the smoothers that work on S, with default options.
template <class... Smoothers, class S>
void add_smoothers(std::vector<AnySmoother<S>>& all) {
  const auto add = [&]<class A>(const A& smoother) {
    if constexpr (Smoother<A, S>) all.push_back(erase_smoother<S>(smoother));
  };
  (add(Smoothers{}), ...);
}

}  // namespace detail

/// Every searcher of the library that works on S, with default options.
///
/// TangentGraph requires a workspace. A CellSpace has features, too, but every exposed side of a
/// blocked cell is one. Each would add a circle to a graph of quadratic size. At safety radius 0,
/// which is usual for cells, the search is not defined.
template <FreeSpace S>
std::vector<AnySearch<S>> all_searches() {
  std::vector<AnySearch<S>> all;
  detail::add_searches<Dijkstra, AStar, WeightedAStar, CanonicalAStar, BidirectionalAStar,
                       PenaltyAStar, Jps>(all);
  if constexpr (GridSpace<S>) all.push_back(detail::erase_jps_plus<S>());
  detail::add_searches<ThetaStar, LazyThetaStar, JpsThetaStar, SsaAStar, AntColony, ReaStar,
                       SbReaStar, ImprovedReaStar, Rrt, RrtStar, RrtConnect, InformedRrtStar,
                       SafeRrtStar, AnyAngle>(all);
  if constexpr (WorkspaceSpace<S>) detail::add_searches<TangentGraph>(all);
  return all;
}

/// Every smoother of the library that works on S, with default options. HomotopyRefine, which uses
/// TangentGraph, requires a workspace for the same reasons.
template <FreeSpace S>
std::vector<AnySmoother<S>> all_smoothers() {
  std::vector<AnySmoother<S>> all;
  detail::add_smoothers<NoSmoothing, Shortcut, RedundantNodeRemoval, DeltaSmoother, BezierSmoother,
                        BSplineSmoother, SmoothingSpline, TwoStageBSpline, TautString,
                        ClothoidSmoother>(all);
  if constexpr (WorkspaceSpace<S>) detail::add_smoothers<HomotopyRefine>(all);
  detail::add_smoothers<StringPull>(all);
  return all;
}

}  // namespace tutavia
