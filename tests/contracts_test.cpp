// SPDX-License-Identifier: MIT
/// \file
/// The contracts themselves: they name the clauses that an algorithm breaks, and no others.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "support/searcher_contract.hpp"
#include "support/smoother_contract.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/smooth/shortcut.hpp"

namespace {

using namespace tutavia;
using Answer = Expected<Route, Failure>;
using Clauses = std::vector<std::string>;

Clauses clauses(const test::Breaches& breaches) {
  Clauses result;
  for (const test::Breach& breach : breaches.list()) result.push_back(breach.clause);
  return result;
}

/// The clauses that A* breaks when `change` does something to its queries and answers.
template <class S>
Clauses broken_by(const std::function<Answer(const AnySearch<S>&, const S&, Query,
                                             detail::AnyScratch&)>& change) {
  const AnySearch<S> astar = erase_search<S>(AStar{});
  const AnySearch<S> changed{"changed",
                             [&](const S& space, const Query& query, detail::AnyScratch& scratch,
                                 SearchRecord*) { return change(astar, space, query, scratch); }};
  return clauses(test::broken_clauses(changed, {}));
}

Answer ask(const auto& search, const auto& space, const Query& query, detail::AnyScratch& scratch) {
  NoObserver no_observer;
  return search.search(space, query, scratch, no_observer);
}

TEMPLATE_TEST_CASE("the searcher contract is kept by A*", "", LatticeSpace, CellSpace) {
  CHECK(broken_by<TestType>([](const auto& astar, const auto& space, Query query,
                               detail::AnyScratch& scratch) {
          return ask(astar, space, query, scratch);
        }).empty());
}

TEMPLATE_TEST_CASE("the searcher contract is broken by a search that never finds a route", "",
                   LatticeSpace, CellSpace) {
  CHECK(broken_by<TestType>([](const auto& astar, const auto& space, Query query,
                               detail::AnyScratch& scratch) -> Answer {
          const Answer answer = ask(astar, space, query, scratch);
          if (answer) return fail(PlanError::unreachable);
          return answer;
        }) == Clauses{"a route is found on a built-in map",
                      "a route from a point to itself is that point",
                      "a third of random queries has a route",
                      "so many routes as promised are found where A* finds one"});
}

TEMPLATE_TEST_CASE("the searcher contract is broken by a route through a wall", "", LatticeSpace,
                   CellSpace) {
  CHECK(broken_by<TestType>(
            [](const auto& astar, const auto& space, Query query, detail::AnyScratch& scratch) {
              Answer answer = ask(astar, space, query, scratch);
              if (answer) answer->curve = Curve::polyline(std::vector{query.start, query.goal});
              return answer;
            }) == Clauses{"it is proved free", "it keeps the safety radius, by brute force",
                          "it is free to the exact checker"});
}

TEMPLATE_TEST_CASE("the searcher contract is broken by a route that ends beside the goal", "",
                   LatticeSpace, CellSpace) {
  CHECK(broken_by<TestType>(
            [](const auto& astar, const auto& space, Query query, detail::AnyScratch& scratch) {
              Answer answer = ask(astar, space, query, scratch);
              if (answer && answer->curve.pieces().size() > 1) {
                answer->curve = answer->curve.split(0.999 * answer->curve.length()).first;
              }
              return answer;
            }) == Clauses{"it begins at the start and ends at the goal"});
}

TEMPLATE_TEST_CASE("the searcher contract is broken by answers that change", "", LatticeSpace,
                   CellSpace) {
  int count = 0;
  CHECK(broken_by<TestType>(
            [&](const auto& astar, const auto& space, Query query, detail::AnyScratch& scratch) {
              Answer answer = ask(astar, space, query, scratch);
              if (answer) answer->cost += ++count;
              return answer;
            }) == Clauses{"equal queries give equal routes, with any scratch"});
}

TEMPLATE_TEST_CASE("the searcher contract is broken by a search without a budget", "", LatticeSpace,
                   CellSpace) {
  CHECK(broken_by<TestType>(
            [](const auto& astar, const auto& space, Query query, detail::AnyScratch& scratch) {
              query.budget = {};
              return ask(astar, space, query, scratch);
            }) == Clauses{"a budget without expansions is reported", "a past deadline is reported",
                          "a cancelled budget is reported"});
}

TEMPLATE_TEST_CASE("the searcher contract is broken by a failure for another reason", "",
                   LatticeSpace, CellSpace) {
  CHECK(broken_by<TestType>([](const auto& astar, const auto& space, Query query,
                               detail::AnyScratch& scratch) -> Answer {
          const Answer answer = ask(astar, space, query, scratch);
          if (!answer) return fail(PlanError::limit_exceeded);
          return answer;
        }) == Clauses{"a blocked start is reported", "the clearance of a blocked start is reported",
                      "a blocked goal is reported", "a start out of bounds is reported",
                      "a goal out of bounds is reported", "a start that is NaN is reported",
                      "a missing goal is reported", "a budget without expansions is reported",
                      "a past deadline is reported", "a cancelled budget is reported",
                      "it is reported that there is no path",
                      "a query without a route fails for a reason that holds"});
}

/// The clauses that Shortcut breaks when `change` does something to it.
template <class S>
Clauses broken_by_smoother(
    const std::function<Expected<Curve, Failure>(const S&, const Curve&, const Budget&)>& change) {
  return clauses(test::broken_clauses(AnySmoother<S>{"changed", change}, {}));
}

TEMPLATE_TEST_CASE("the smoother contract is kept by Shortcut", "", LatticeSpace, CellSpace,
                   InflatedSpace) {
  CHECK(clauses(test::broken_clauses(erase_smoother<TestType>(Shortcut{}), {})).empty());
}

TEMPLATE_TEST_CASE("the smoother contract is broken by a smoother that ignores its budget", "",
                   LatticeSpace, CellSpace, InflatedSpace) {
  CHECK(broken_by_smoother<TestType>([](const auto& space, const Curve& curve, const Budget&) {
          return Shortcut{}.smooth(space, curve, {});
        }) == Clauses{"a cancelled budget is reported", "a past deadline is reported"});
}

TEMPLATE_TEST_CASE("the smoother contract is broken by a curve through a wall", "", LatticeSpace,
                   CellSpace, InflatedSpace) {
  CHECK(broken_by_smoother<TestType>([](const auto& space, const Curve& curve,
                                        const Budget& budget) -> Expected<Curve, Failure> {
          const auto result = Shortcut{}.smooth(space, curve, budget);
          if (!result) return result;
          return Curve::polyline(std::vector{curve.start(), curve.end()});
        }) == Clauses{"it is proved free", "it keeps the safety radius, by brute force",
                      "it is free to the exact checker"});
}

TEMPLATE_TEST_CASE("the smoother contract is broken by a curve that goes there and back", "",
                   LatticeSpace, CellSpace, InflatedSpace) {
  CHECK(
      broken_by_smoother<TestType>([](const auto& space, const Curve& curve, const Budget& budget) {
        auto result = Shortcut{}.smooth(space, curve, budget);
        if (!result) return result;
        for (const Curve& more : {curve.reversed(), curve}) {
          for (const Piece& piece : more.pieces()) result->push_back(piece);
        }
        return result;
      }) == Clauses{"it is no longer than its bound"});
}

TEMPLATE_TEST_CASE("the smoother contract is broken by a smoother that fails or changes its mind",
                   "", LatticeSpace, CellSpace, InflatedSpace) {
  int count = 0;
  CHECK(broken_by_smoother<TestType>([&](const auto& space, const Curve& curve,
                                         const Budget& budget) -> Expected<Curve, Failure> {
          const auto result = Shortcut{}.smooth(space, curve, budget);
          if (result && curve.pieces().size() > 3 && ++count % 7 == 3) {
            return fail(PlanError::not_proved);
          }
          return result && count % 2 == 1 ? curve : result;
        }) == Clauses{"equal curves give equal results", "a curve that is free is smoothed"});
}

}  // namespace
