// SPDX-License-Identifier: MIT
#include "tutavia/search/theta_star.hpp"

#include "support/any_angle_checks.hpp"
#include "support/searcher_contract.hpp"

namespace {

using namespace tutavia;

TEST_CASE("Theta* keeps the searcher contract") { test::searcher_contract(ThetaStar{}); }

TEST_CASE("Theta* finds free paths wherever A* does") {
  test::check_any_angle_search(ThetaStar{}, 510, 1.01);
}

TEST_CASE("on an empty grid the path of Theta* is one segment") {
  test::check_straight_paths(ThetaStar{});
}

}  // namespace
