// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <typeinfo>
#include <utility>
#include <vector>

#include "tutavia/core/budget.hpp"
#include "tutavia/core/expected.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/vehicle_path.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/plan/vehicle.hpp"
#include "tutavia/registry/option_value.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/search_record.hpp"
#include "tutavia/smooth/concepts.hpp"

/// \file
/// AnySearch and AnySmoother: type-erased searches and smoothers.

namespace tutavia {

namespace detail {

/// Scratch memory of the search that used it last. Not copyable, like the scratch memory of some
/// searches.
class AnyScratch {
 public:
  /// The scratch memory as a Scratch; new if it was of another type.
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

}  // namespace detail

/// A type-erased searcher on spaces of type S. \pre `run` is set
template <class S>
struct AnySearch {
  using Scratch = detail::AnyScratch;
  static constexpr bool plans_vehicles = true;  // some of them do

  std::string_view name{};
  std::function<Expected<Route, Failure>(const S&, const Query&, Scratch&, SearchRecord*)> run{};
  OptionSettings options{};  ///< its options, for reports; empty if it is not from the registry
  /// The same search for another vehicle; empty if it plans no headings.
  std::function<AnySearch(const Vehicle&)> for_vehicle{};

  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  NoObserver&) const {
    return run(space, query, scratch, nullptr);
  }
  Expected<Route, Failure> search(const S& space, const Query& query, Scratch& scratch,
                                  SearchRecord& record) const {
    return run(space, query, scratch, &record);
  }
};

/// A type-erased smoother on spaces of type S. \pre `run` is set
template <class S>
struct AnySmoother {
  std::string name{};
  std::function<Expected<Curve, Failure>(const S&, const Curve&, const Budget&)> run{};
  std::vector<OptionSettings> options{};  ///< of each stage, for reports; empty as for AnySearch
  /// Smooths the paths of vehicles; empty if the smoother keeps no headings.
  std::function<Expected<VehiclePath, Failure>(const S&, const Vehicle&, const VehiclePath&,
                                               const Budget&)>
      run_for_vehicle{};

  Expected<Curve, Failure> smooth(const S& space, const Curve& curve, const Budget& budget) const {
    return run(space, curve, budget);
  }
  Expected<VehiclePath, Failure> smooth(const S& space, const Vehicle& vehicle,
                                        const VehiclePath& path, const Budget& budget) const {
    if (run_for_vehicle) return run_for_vehicle(space, vehicle, path, budget);
    return fail(PlanError::invalid_option,
                name + " keeps no headings; use none, vehicle_shortcut or continuous_curvature");
  }
};

namespace detail {

/// An optional SearchRecord as one observer type, so that every search is compiled only once.
struct OptionalRecord {
  SearchRecord* record;
  void expanded(const Point& p) const {
    if (record != nullptr) record->expanded(p);
  }
  void generated(const Point& p) const {
    if (record != nullptr) record->generated(p);
  }
  void on_rectangle(const Segment& interval, const Box& rectangle, SearchSide side) const {
    if (record != nullptr) record->on_rectangle(interval, rectangle, side);
  }
  void improved(const Curve& path, double cost) const {
    if (record != nullptr) record->improved(path, cost);
  }
};

}  // namespace detail

/// Wraps a searcher. A search that grows a tree also reports the tree's edges to the record.
template <class S, Searcher<S> A>
AnySearch<S> erase_search(const A& algorithm) {
  AnySearch<S> any_search{A::name, [algorithm](const S& space, const Query& query,
                                               detail::AnyScratch& any, SearchRecord* record) {
                            auto& scratch = any.get<typename A::Scratch>();
                            detail::OptionalRecord observer{record};
                            const auto add = [&](const Point& a, const Point& b) {
                              record->edge(a, b);
                            };
                            constexpr bool grows_tree = requires { scratch.for_each_edge(add); };
                            // A query that fails early must not report the tree of the previous
                            // query.
                            if constexpr (grows_tree) scratch.clear();
                            auto route = algorithm.search(space, query, scratch, observer);
                            if constexpr (grows_tree) {
                              if (record != nullptr) scratch.for_each_edge(add);
                            }
                            return route;
                          }};
  if constexpr (requires { algorithm.vehicle; }) {
    any_search.for_vehicle = [algorithm](const Vehicle& vehicle) {
      A other = algorithm;
      other.vehicle = vehicle;
      return erase_search<S>(other);
    };
  }
  return any_search;
}

/// Wraps a smoother.
template <class S, Smoother<S> A>
AnySmoother<S> erase_smoother(const A& algorithm) {
  AnySmoother<S> any{std::string(A::name),
                     [algorithm](const S& space, const Curve& curve, const Budget& budget) {
                       return algorithm.smooth(space, curve, budget);
                     }};
  if constexpr (VehicleSmoother<A, S>) {
    any.run_for_vehicle = [algorithm](const S& space, const Vehicle& vehicle,
                                      const VehiclePath& path, const Budget& budget) {
      return algorithm.smooth(space, vehicle, path, budget);
    };
  }
  return any;
}

namespace detail {

/// Two smoothers one after the other, named "first+second"; see Pipeline.
template <class S>
AnySmoother<S> chain(const AnySmoother<S>& first, const AnySmoother<S>& second) {
  std::vector<OptionSettings> options = first.options;
  options.insert(options.end(), second.options.begin(), second.options.end());
  AnySmoother<S> any{first.name + "+" + second.name,
                     [first, second](const S& space, const Curve& curve, const Budget& budget) {
                       auto result = first.smooth(space, curve, budget);
                       return result ? second.smooth(space, *result, budget) : result;
                     },
                     std::move(options)};
  any.run_for_vehicle = [first, second](const S& space, const Vehicle& vehicle,
                                        const VehiclePath& path, const Budget& budget) {
    auto result = first.smooth(space, vehicle, path, budget);
    return result ? second.smooth(space, vehicle, *result, budget) : result;
  };
  return any;
}

}  // namespace detail

}  // namespace tutavia
