// SPDX-License-Identifier: MIT
#include "tutavia/search/lazy_theta_star.hpp"

#include "support/any_angle_checks.hpp"
#include "support/searcher_contract.hpp"

namespace {

using namespace tutavia;

TEST_CASE("Lazy Theta* keeps the searcher contract") { test::searcher_contract(LazyThetaStar{}); }

TEST_CASE("Lazy Theta* finds free paths wherever A* does") {
  test::check_any_angle_search(LazyThetaStar{}, 520, 1.01);
}

TEST_CASE("on an empty grid the path of Lazy Theta* is one segment") {
  test::check_straight_paths(LazyThetaStar{});
}

}  // namespace
