// SPDX-License-Identifier: MIT
#include "tutavia/registry/movement_name.hpp"

#include "support/catch.hpp"

namespace {

using namespace tutavia;

TEST_CASE("movement rules have names, and other texts are refused with all of them") {
  CHECK(parse_movement_rule("no_cut").value() == MovementRule::no_cut);
  CHECK(parse_movement_rule("no_squeeze").value() == MovementRule::no_squeeze);
  CHECK(parse_movement_rule("allow").value() == MovementRule::allow);
  CHECK(parse_movement_rule("four_connected").value() == MovementRule::four_connected);
  for (const char* bad : {"", "four", "NO_CUT", "0", "by_edge"}) {
    const auto rule = parse_movement_rule(bad);
    REQUIRE_FALSE(rule);
    CHECK(rule.error().code == PlanError::invalid_option);
    CHECK(rule.error().detail ==
          "expected no_cut, no_squeeze, allow or four_connected, got \"" + std::string(bad) + "\"");
  }
}

TEST_CASE("edge rules have names") {
  CHECK(parse_edge_rule("uniform").value() == EdgeRule::uniform);
  CHECK(parse_edge_rule("paper_strict").value() == EdgeRule::paper_strict);
  const auto rule = parse_edge_rule("strict");
  REQUIRE_FALSE(rule);
  CHECK(rule.error().detail == "expected uniform or paper_strict, got \"strict\"");
}

}  // namespace
