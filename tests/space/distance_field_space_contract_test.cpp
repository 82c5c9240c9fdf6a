// SPDX-License-Identifier: MIT
/// \file
/// Every search and smoother that needs no more than distances and a grid keeps its contract on a
/// distance field.

#include <algorithm>
#include <string_view>
#include <vector>

#include "support/field_space.hpp"
#include "support/searcher_contract.hpp"
#include "support/smoother_contract.hpp"
#include "tutavia/registry.hpp"

namespace {

using namespace tutavia;
using test::FieldSpace;

bool is_one_of(std::string_view name, const std::vector<std::string_view>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The promise of a search in the test of its own.
test::SearcherPromise promise_of(std::string_view search) {
  using test::Completeness;
  if (search == "ant_colony") return {.completeness = Completeness::gives_up};
  const bool is_tree =
      is_one_of(search, {"rrt", "rrt_star", "rrt_connect", "informed_rrt_star", "safe_rrt_star"});
  return is_tree ? test::SearcherPromise{.completeness = Completeness::gives_up, .found = 0.9}
                 : test::SearcherPromise{};
}

TEST_CASE("searches keep the searcher contract on a distance field") {
  const auto searches = all_searches<FieldSpace>();
  CHECK(searches.size() == 22);
  for (const AnySearch<FieldSpace>& search : searches) {
    // These two take longest. Ants have fewer iterations below, and SafeRrtStar has one query in
    // distance_field_space_test.cpp.
    if (search.name == "ant_colony" || search.name == "safe_rrt_star") continue;
    test::report(test::broken_clauses(search, promise_of(search.name)), search.name, "FieldSpace");
  }
  const auto ants = erase_search<FieldSpace>(AntColony{.iterations = 5});
  test::report(test::broken_clauses(ants, promise_of(ants.name)), ants.name, "FieldSpace");
}

TEST_CASE("smoothers keep the smoother contract on a distance field") {
  const auto smoothers = all_smoothers<FieldSpace>();
  CHECK(smoothers.size() == 7);
  for (const AnySmoother<FieldSpace>& smoother : smoothers) {
    const test::SmootherPromise promise{
        .longest = smoother.name == "two_stage_b_spline" ? 3.0 : 1.0,
        .budget = smoother.name == "none" ? test::BudgetUse::ignored : test::BudgetUse::reported};
    test::report(test::broken_clauses(smoother, promise), smoother.name, "FieldSpace");
  }
}

}  // namespace
