// SPDX-License-Identifier: MIT
#include "tutavia/registry/nearest_name.hpp"

#include "support/catch.hpp"

namespace {

using namespace tutavia;

const std::vector<std::string> names{"astar", "dijkstra", "rrt_star", "iterations", "step"};

TEST_CASE("letters inserted, removed, replaced and swapped count one each") {
  CHECK(detail::edit_distance("", "") == 0);
  CHECK(detail::edit_distance("", "abc") == 3);
  CHECK(detail::edit_distance("abc", "") == 3);
  CHECK(detail::edit_distance("delta", "delta") == 0);
  CHECK(detail::edit_distance("delt", "delta") == 1);
  CHECK(detail::edit_distance("deltas", "delta") == 1);
  CHECK(detail::edit_distance("dalta", "delta") == 1);
  CHECK(detail::edit_distance("detla", "delta") == 1);
  CHECK(detail::edit_distance("kitten", "sitting") == 3);
  CHECK(detail::edit_distance("ca", "abc") == 3);  // no letter is changed twice
}

TEST_CASE("a misspelt name finds the one that it means") {
  CHECK(nearest_name("dstar", names) == "astar");
  CHECK(nearest_name("dijsktra", names) == "dijkstra");
  CHECK(nearest_name("rrtstar", names) == "rrt_star");
  CHECK(nearest_name("max_iterations", names) == "iterations");
  CHECK(nearest_name("iteration", names) == "iterations");
  CHECK(nearest_name("ration", names) == "iterations");  // a part of it
  CHECK(nearest_name("step", names) == "step");
  CHECK(nearest_name("stp", names) == "step");
}

TEST_CASE("what resembles no name finds none") {
  CHECK_FALSE(nearest_name("", names));
  CHECK_FALSE(nearest_name("x", names));
  CHECK_FALSE(nearest_name("goal", names));
  CHECK_FALSE(nearest_name("bezier", names));
  CHECK_FALSE(nearest_name(std::string(1000, 'a'), names));
  CHECK_FALSE(nearest_name("astar", {}));
}

TEST_CASE("of names equally near the first is found") {
  const std::vector<std::string> pair{"bat", "cat"};
  CHECK(nearest_name("hat", pair) == "bat");
}

}  // namespace
