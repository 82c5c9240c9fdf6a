// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "tutavia/any_algorithm.hpp"
#include "tutavia/pull/redundant_node_removal.hpp"
#include "tutavia/pull/shortcut.hpp"
#include "tutavia/pull/string_pull.hpp"
#include "tutavia/pull/taut_string.hpp"
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
#include "tutavia/smooth/smoothing_spline.hpp"
#include "tutavia/smooth/two_stage_b_spline.hpp"

/// \file
/// The algorithms by name, for tools that choose at run time.

namespace tutavia {

namespace detail {

/// A table that all copies of one erased JPS+ share; immutable once it is prepared.
class SharedJumpTable {
 public:
  template <class S>
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

}  // namespace detail

/// JPS+ with a table that is prepared for the space at the first query.
template <class S>
AnySearch<S> erase_jps_plus() {
  auto shared = std::make_shared<detail::SharedJumpTable>();
  return {JpsPlus::name,
          [shared](const S& space, const Query& query, AnyScratch& any,
                   SearchRecord* record) -> Expected<Route, Failure> {
            const auto table = shared->prepared_for(space);
            if (!table) return Unexpected{table.error()};
            detail::OptionalRecord observer{record};
            auto& scratch = any.get<JpsPlus::Scratch>();
            return JpsPlus{*table}.search(space, query, scratch, observer);
          }};
}

/// Every searcher of the library that works on S, with default options.
template <class S>
std::vector<AnySearch<S>> all_searches() {
  std::vector<AnySearch<S>> all{erase_search<S>(Dijkstra{}),
                                erase_search<S>(AStar{}),
                                erase_search<S>(WeightedAStar{}),
                                erase_search<S>(CanonicalAStar{}),
                                erase_search<S>(BidirectionalAStar{}),
                                erase_search<S>(PenaltyAStar{}),
                                erase_search<S>(Jps{}),
                                erase_jps_plus<S>(),
                                erase_search<S>(ThetaStar{}),
                                erase_search<S>(LazyThetaStar{}),
                                erase_search<S>(JpsThetaStar{}),
                                erase_search<S>(SsaAStar{}),
                                erase_search<S>(AntColony{}),
                                erase_search<S>(ReaStar{}),
                                erase_search<S>(SbReaStar{}),
                                erase_search<S>(ImprovedReaStar{}),
                                erase_search<S>(Rrt{}),
                                erase_search<S>(RrtStar{}),
                                erase_search<S>(RrtConnect{}),
                                erase_search<S>(InformedRrtStar{}),
                                erase_search<S>(SafeRrtStar{})};
  if constexpr (Searcher<AnyAngle, S>) all.push_back(erase_search<S>(AnyAngle{}));
  if constexpr (requires(const S& s) { s.workspace(); }) {
    all.push_back(erase_search<S>(TangentGraph{}));
  }
  return all;
}

/// Every smoother of the library that works on S, with default options.
template <class S>
std::vector<AnySmoother<S>> all_smoothers() {
  std::vector<AnySmoother<S>> all{
      erase_smoother<S>(NoSmoothing{}),          erase_smoother<S>(Shortcut{}),
      erase_smoother<S>(RedundantNodeRemoval{}), erase_smoother<S>(DeltaSmoother{}),
      erase_smoother<S>(BezierSmoother{}),       erase_smoother<S>(BSplineSmoother{}),
      erase_smoother<S>(SmoothingSpline{}),      erase_smoother<S>(TwoStageBSpline{}),
      erase_smoother<S>(TautString{}),           erase_smoother<S>(ClothoidSmoother{})};
  if constexpr (requires(const S& s) { s.workspace(); }) {
    all.push_back(erase_smoother<S>(HomotopyRefine{}));
  }
  if constexpr (Smoother<StringPull, S>) all.push_back(erase_smoother<S>(StringPull{}));
  return all;
}

}  // namespace tutavia
