// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <typeinfo>
#include <utility>
#include <vector>

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

/// Scratch memory of whichever search it was last handed to. Not to be copied, as that of some
/// searches is not.
class AnyScratch {
 public:
  /// The scratch memory of one kind, made anew where it is another's.
  template <class Scratch>
  Scratch& get() {
    if (memory_ == nullptr || *kind_ != typeid(Scratch)) {
      memory_ = {new Scratch{}, [](void* memory) { delete static_cast<Scratch*>(memory); }};
      kind_ = &typeid(Scratch);
    }
    return *static_cast<Scratch*>(memory_.get());
  }

 private:
  std::unique_ptr<void, void (*)(void*)> memory_{nullptr, [](void*) {}};
  const std::type_info* kind_ = nullptr;
};

/// Any searcher on spaces of type S.
template <class S>
struct AnySearch {
  using Scratch = AnyScratch;

  std::string_view name{};
  std::function<Expected<Route, Failure>(const S&, const Query&, Scratch&, SearchRecord*)> run{};

  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  NoObserver&) const {
    return run(space, query, scratch, nullptr);
  }
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  SearchRecord& record) const {
    return run(space, query, scratch, &record);
  }
};

/// Any smoother on spaces of type S.
template <class S>
struct AnySmoother {
  std::string name{};
  std::function<Expected<Curve, Failure>(const S&, const Curve&, const Budget&)> run{};

  Expected<Curve, Failure> smooth(const S& space, const Curve& curve, const Budget& budget) const {
    return run(space, curve, budget);
  }
};

namespace detail {

/// An observer that may be there or not; one for both, so that every search is compiled once.
struct OptionalRecord {
  SearchRecord* record;
  void expanded(const Point& p) {
    if (record != nullptr) record->expanded(p);
  }
  void generated(const Point& p) {
    if (record != nullptr) record->generated(p);
  }
  void grown(const Segment& interval, const Box& rectangle) {
    if (record != nullptr) record->grown(interval, rectangle);
  }
};

}  // namespace detail

template <class S, Searcher<S> A>
AnySearch<S> erase_search(const A& algorithm) {
  return {A::name,
          [algorithm](const S& space, const Query& query, AnyScratch& any, SearchRecord* record) {
            auto& scratch = any.get<typename A::Scratch>();
            detail::OptionalRecord observer{record};
            const auto add = [&](const Point& a, const Point& b) { record->edge(a, b); };
            constexpr bool grows_tree = requires { scratch.for_each_edge(add); };
            // A query that fails early must not report the tree of the query before.
            if constexpr (grows_tree) scratch.clear();
            auto route = algorithm.search(space, query, scratch, observer);
            if constexpr (grows_tree) {
              if (record != nullptr) scratch.for_each_edge(add);
            }
            return route;
          }};
}

template <class S, Smoother<S> A>
AnySmoother<S> erase_smoother(const A& algorithm) {
  return {std::string(A::name),
          [algorithm](const S& space, const Curve& curve, const Budget& budget) {
            return algorithm.smooth(space, curve, budget);
          }};
}

/// Two smoothers one after the other, named "first+second"; see Pipeline.
template <class S>
AnySmoother<S> chain(const AnySmoother<S>& first, const AnySmoother<S>& second) {
  return {first.name + "+" + second.name,
          [first, second](const S& space, const Curve& curve, const Budget& budget) {
            auto result = first.smooth(space, curve, budget);
            return result ? second.smooth(space, *result, budget) : result;
          }};
}

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
