// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>
#include <string_view>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"

/// \file
/// The concepts of observers and searchers.

namespace tutavia {

/// Receives every node that a search expands or generates, as a point in the plane.
///
/// Example: examples/09_observer.cpp.
template <class O>
concept Observer = requires(O& o, const Point& p) {
  o.expanded(p);
  o.generated(p);
};

/// The end of a query from which a part of a search grows.
enum class SearchSide : std::uint8_t { start, goal };

namespace detail {

template <class O>
concept TakesRectangle = requires(O& o, const Segment& from, const Box& grown) {
  o.on_rectangle(from, grown);
};
template <class O>
concept TakesSide = requires(O& o, const Segment& from, const Box& grown, SearchSide side) {
  o.on_rectangle(from, grown, side);
};

}  // namespace detail

/// An observer that also receives every free rectangle that a search grows, and the interval of
/// cells from which it grew. The rectangle spans the reference points of its corner cells. An
/// observer whose `on_rectangle` takes a SearchSide as third argument is told the side as well.
///
/// Example: examples/09_observer.cpp.
template <class O>
concept RectangleObserver = Observer<O> &&(detail::TakesRectangle<O> || detail::TakesSide<O>);

/// An observer that also receives every improved path that a search finds, and its cost.
///
/// Example: examples/09_observer.cpp.
template <class O>
concept AnytimeObserver = Observer<O> && requires(O& o, const Curve& path, double cost) {
  o.improved(path, cost);
};

/// Ignores all events; compiles to nothing.
struct NoObserver {
  void expanded(const Point&) {}
  void generated(const Point&) {}
};

/// A search algorithm: a regular value whose members are its options. `search` returns a route, or
/// the reason why there is none. Every piece of the route lies in free space, and its ends are
/// exactly those of the query. `search` stays within the query's budget. The answer to a query does
/// not depend on the contents of the scratch.
///
/// Example: examples/11_own_searcher.cpp.
template <class A, class S>
concept Searcher = std::copyable<A> && std::default_initializable<typename A::Scratch> &&
    requires(const A& a, const S& space, const Query& query, typename A::Scratch& scratch,
             NoObserver& observer) {
  { A::name } -> std::convertible_to<std::string_view>;
  { a.search(space, query, scratch, observer) } -> std::same_as<Expected<Route, Failure>>;
};

/// A search whose routes may have a vehicle and gears. It says so by `plans_vehicles = true`; the
/// planner refuses such routes of a search that does not.
///
/// Example: tests/search/heading_join_test.cpp.
template <class A>
concept PlansVehicles = bool{A::plans_vehicles};

}  // namespace tutavia
