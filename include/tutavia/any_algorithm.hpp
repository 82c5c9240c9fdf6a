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
#include "tutavia/plan/failure.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"
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

  std::string_view name{};
  std::function<Expected<Route, Failure>(const S&, const Query&, Scratch&, SearchRecord*)> run{};
  OptionSettings options{};  ///< its options, for reports; empty if it is not from the registry

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

  Expected<Curve, Failure> smooth(const S& space, const Curve& curve, const Budget& budget) const {
    return run(space, curve, budget);
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
  return {A::name, [algorithm](const S& space, const Query& query, detail::AnyScratch& any,
                               SearchRecord* record) {
            auto& scratch = any.get<typename A::Scratch>();
            detail::OptionalRecord observer{record};
            const auto add = [&](const Point& a, const Point& b) { record->edge(a, b); };
            constexpr bool grows_tree = requires { scratch.for_each_edge(add); };
            // A query that fails early must not report the tree of the previous query.
            if constexpr (grows_tree) scratch.clear();
            auto route = algorithm.search(space, query, scratch, observer);
            if constexpr (grows_tree) {
              if (record != nullptr) scratch.for_each_edge(add);
            }
            return route;
          }};
}

/// Wraps a smoother.
template <class S, Smoother<S> A>
AnySmoother<S> erase_smoother(const A& algorithm) {
  return {std::string(A::name),
          [algorithm](const S& space, const Curve& curve, const Budget& budget) {
            return algorithm.smooth(space, curve, budget);
          }};
}

namespace detail {

/// Two smoothers one after the other, named "first+second"; see Pipeline.
template <class S>
AnySmoother<S> chain(const AnySmoother<S>& first, const AnySmoother<S>& second) {
  std::vector<OptionSettings> options = first.options;
  options.insert(options.end(), second.options.begin(), second.options.end());
  return {first.name + "+" + second.name,
          [first, second](const S& space, const Curve& curve, const Budget& budget) {
            auto result = first.smooth(space, curve, budget);
            return result ? second.smooth(space, *result, budget) : result;
          },
          std::move(options)};
}

}  // namespace detail

}  // namespace tutavia
