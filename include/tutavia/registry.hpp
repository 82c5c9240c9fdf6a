// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/any_algorithm.hpp"
#include "tutavia/registry/algorithm_description.hpp"
#include "tutavia/registry/algorithm_text.hpp"
#include "tutavia/registry/options/bound_option.hpp"
#include "tutavia/registry/options/search_options.hpp"
#include "tutavia/registry/options/smoother_options.hpp"
#include "tutavia/registry/options/tree_options.hpp"
#include "tutavia/registry/options/vehicle_options.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/search_record.hpp"
#include "tutavia/smooth/concepts.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// all_searches, all_smoothers and those for vehicles: the algorithms by name, for selection at run
/// time.

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

/// The algorithms of the library, in the order of tables.
template <class... A>
struct AlgorithmList {};
using Searches =
    AlgorithmList<AutoSearch, Dijkstra, AStar, WeightedAStar, CanonicalAStar, BidirectionalAStar,
                  PenaltyAStar, Jps, JpsPlus, ThetaStar, LazyThetaStar, JpsThetaStar, SsaAStar,
                  AntColony, ReaStar, SbReaStar, ImprovedReaStar, Rrt, RrtStar, RrtConnect,
                  InformedRrtStar, SafeRrtStar, AnyAngle, TangentGraph>;
using Smoothers = AlgorithmList<NoSmoothing, Shortcut, RedundantNodeRemoval, DeltaSmoother,
                                BezierSmoother, BSplineSmoother, SmoothingSpline, TwoStageBSpline,
                                TautString, ClothoidSmoother, HomotopyRefine, StringPull>;
/// Those that plan headings. Other smoothers keep none, so they stand in lists of their own.
using VehicleSearches = AlgorithmList<HybridAStar>;
using VehicleSmoothers = AlgorithmList<VehicleShortcut, ContinuousCurvature>;

template <class... A, class... B>
constexpr AlgorithmList<A..., B...> joined(AlgorithmList<A...>, AlgorithmList<B...>) {
  return {};
}
using EverySearch = decltype(joined(Searches{}, VehicleSearches{}));
using EverySmoother = decltype(joined(Smoothers{}, VehicleSmoothers{}));

/// Whether the registry offers the searcher or smoother A on S.
template <class A, class S>
constexpr bool is_offered() {
  if constexpr (std::same_as<A, JpsPlus>) {
    return GridSpace<S>;
  } else if constexpr (std::same_as<A, HomotopyRefine>) {
    return WorkspaceSpace<S>;
  } else {
    return Searcher<A, S> || Smoother<A, S>;
  }
}

/// A name on S, and what makes the algorithm, type-erased. Every list and every choice by name
/// comes from here, so an algorithm is compiled once per space.
template <class Any>
struct Offer {
  std::string_view name;
  std::span<const OptionField> fields;
  Any (*make)(OptionSetter& options);

  /// Errors: those of `set_options`.
  Expected<Any, Failure> with(std::span<const OptionText> texts) const {
    OptionSetter setter(name, fields, texts);
    Any any = make(setter);
    if (!setter.result()) return Unexpected{setter.result().error()};
    add_options(any.options, setter.settings());
    return any;
  }

 private:
  static void add_options(OptionSettings& options, const OptionSettings& set) { options = set; }
  static void add_options(std::vector<OptionSettings>& stages, const OptionSettings& set) {
    stages.push_back(set);
  }
};

template <class A, class S>
AnySearch<S> make_any_search(OptionSetter& options) {
  A search{};
  options.set(&search);
  if constexpr (std::same_as<A, JpsPlus>) {
    return erase_jps_plus<S>();
  } else {
    return erase_search<S>(search);
  }
}
template <class A, class S>
AnySmoother<S> make_any_smoother(OptionSetter& options) {
  A smoother{};
  options.set(&smoother);
  return erase_smoother<S>(smoother);
}

template <class S, class... A>
std::vector<Offer<AnySearch<S>>> search_offers(AlgorithmList<A...>) {
  std::vector<Offer<AnySearch<S>>> offers;
  const auto add = [&]<class One>(AlgorithmList<One>) {
    if constexpr (is_offered<One, S>()) {
      offers.push_back({One::name, OptionTable<One>::fields.all, &make_any_search<One, S>});
    }
  };
  (add(AlgorithmList<A>{}), ...);
  return offers;
}
template <class S, class... A>
std::vector<Offer<AnySmoother<S>>> smoother_offers(AlgorithmList<A...>) {
  std::vector<Offer<AnySmoother<S>>> offers;
  const auto add = [&]<class One>(AlgorithmList<One>) {
    if constexpr (is_offered<One, S>()) {
      offers.push_back({One::name, OptionTable<One>::fields.all, &make_any_smoother<One, S>});
    }
  };
  (add(AlgorithmList<A>{}), ...);
  return offers;
}

template <class Any>
std::vector<Any> make_all(const std::vector<Offer<Any>>& offers) {
  std::vector<Any> all;
  all.reserve(offers.size());
  for (const auto& offer : offers) all.push_back(std::move(offer.with({}).value()));
  return all;
}
template <class Any>
Expected<Any, Failure> make_one(const std::vector<Offer<Any>>& offers, std::string_view name,
                                std::span<const OptionText> options) {
  std::vector<std::string> names;
  for (const auto& offer : offers) {
    if (offer.name == name) return offer.with(options);
    names.emplace_back(offer.name);
  }
  std::string message = "unknown name \"";
  message.append(name).append("\"; ");
  return fail(PlanError::invalid_option, message.append(hint(name, names)));
}

template <class... A>
std::vector<AlgorithmDescription> describe_all(AlgorithmList<A...>) {
  return {describe<A>()...};
}

}  // namespace detail

/// Every searcher of the library for robots without headings that works on S, with default options.
template <FreeSpace S>
std::vector<AnySearch<S>> all_searches() {
  return detail::make_all(detail::search_offers<S>(detail::Searches{}));
}

/// Every smoother of the library that works on S, with default options. HomotopyRefine requires a
/// workspace.
template <FreeSpace S>
std::vector<AnySmoother<S>> all_smoothers() {
  return detail::make_all(detail::smoother_offers<S>(detail::Smoothers{}));
}

/// Every searcher of the library that plans headings, with default options (vehicle: a point).
template <FreeSpace S>
std::vector<AnySearch<S>> vehicle_searches() {
  return detail::make_all(detail::search_offers<S>(detail::VehicleSearches{}));
}

/// Every smoother of the library for the routes of `vehicle_searches`, beside `none`.
template <FreeSpace S>
std::vector<AnySmoother<S>> vehicle_smoothers() {
  return detail::make_all(detail::smoother_offers<S>(detail::VehicleSmoothers{}));
}

/// The searcher of a name, with options as texts:
///
///     const std::array options{OptionText{"goal_bias", "0.1"}, OptionText{"step", "2"}};
///     const auto search = make_search<LatticeSpace>("rrt_star", options);
///
/// Errors: `invalid_option` for a name or an option that is not known on S, with the nearest one;
/// for an option given twice; for a text that is no value of the option's type. Values out of range
/// are answered by the search itself.
///
/// Example: examples/05_compare_planners.cpp.
template <FreeSpace S>
Expected<AnySearch<S>, Failure> make_search(std::string_view name,
                                            std::span<const OptionText> options = {}) {
  return detail::make_one(detail::search_offers<S>(detail::EverySearch{}), name, options);
}

/// The smoother of a name, with options as texts. Errors as for `make_search`.
template <FreeSpace S>
Expected<AnySmoother<S>, Failure> make_smoother(std::string_view name,
                                                std::span<const OptionText> options = {}) {
  return detail::make_one(detail::smoother_offers<S>(detail::EverySmoother{}), name, options);
}

/// Every searcher of the library with its options, whatever the spaces on which it works.
inline std::vector<AlgorithmDescription> describe_searches() {
  return detail::describe_all(detail::EverySearch{});
}

/// Every smoother of the library with its options.
inline std::vector<AlgorithmDescription> describe_smoothers() {
  return detail::describe_all(detail::EverySmoother{});
}

}  // namespace tutavia
