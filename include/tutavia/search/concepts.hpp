// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <string_view>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"

/// \file
/// What a search algorithm is.

namespace tutavia {

/// Told of every node that a search expands or generates, by the node's place in the plane.
template <class O>
concept Observer = requires(O& o, const Point& p) {
  o.expanded(p);
  o.generated(p);
};

/// An observer that is also told of every free rectangle that a search grows, between the reference
/// points of its corner cells, and of the interval that it grew from.
template <class O>
concept RectangleObserver = Observer<O> && requires(O& o, const Segment& from, const Box& grown) {
  o.on_rectangle(from, grown);
};

/// An observer that is also told of every better path that a search finds on its way, and of its
/// cost.
template <class O>
concept AnytimeObserver = Observer<O> && requires(O& o, const Curve& path, double cost) {
  o.improved(path, cost);
};

/// The observer that looks away; it costs nothing.
struct NoObserver {
  void expanded(const Point&) {}
  void generated(const Point&) {}
};

/// A search algorithm: a regular value that is its own options. `search` returns a route whose
/// every piece is in free space and whose ends are exactly the query's, or why there is none; it
/// keeps within the query's budget, and gives the same answer for the same query with any scratch.
template <class A, class S>
concept Searcher = std::copyable<A> && std::default_initializable<typename A::Scratch> &&
    requires(const A& a, const S& space, const Query& query, typename A::Scratch& scratch,
             NoObserver& observer) {
  { A::name } -> std::convertible_to<std::string_view>;
  { a.search(space, query, scratch, observer) } -> std::same_as<Expected<Route, Failure>>;
};

}  // namespace tutavia
