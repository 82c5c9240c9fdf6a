// SPDX-License-Identifier: MIT
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include "support/catch.hpp"
#include "tutavia/plan/failure.hpp"

namespace {

using namespace tutavia;

constexpr PlanError last_code = PlanError::limit_exceeded;

std::string printed(const Failure& failure) {
  std::ostringstream out;
  out << failure;
  return out.str();
}

TEST_CASE("every failure code has a name of its own", "[core]") {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(last_code); ++i) {
    const std::string_view name = to_string(static_cast<PlanError>(i));
    CAPTURE(i, name);
    CHECK(name != "unknown");
    CHECK(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") == std::string_view::npos);
    CHECK(names.insert(name).second);
  }
  CHECK(to_string(static_cast<PlanError>(static_cast<int>(last_code) + 1)) == "unknown");
}

TEST_CASE("the codes carry the names that stand in result files", "[core]") {
  CHECK(to_string(PlanError::start_blocked) == "start_blocked");
  CHECK(to_string(PlanError::goal_out_of_bounds) == "goal_out_of_bounds");
  CHECK(to_string(PlanError::unreachable) == "unreachable");
  CHECK(to_string(PlanError::unreachable_at_resolution) == "unreachable_at_resolution");
  CHECK(to_string(PlanError::not_proved) == "not_proved");
  CHECK(to_string(PlanError::limit_exceeded) == "limit_exceeded");
}

TEST_CASE("a failure prints its code, and its detail where it has one", "[core]") {
  CHECK(printed(fail(PlanError::cancelled).error) == "cancelled");
  CHECK(printed(fail(PlanError::invalid_option, "step is 0").error) == "invalid_option: step is 0");
}

TEST_CASE("fail() becomes the error of any Expected", "[core]") {
  const Expected<int, Failure> number = fail(PlanError::unreachable, "walled in");
  const Expected<void, Failure> nothing = fail(PlanError::cancelled);
  CHECK_FALSE(number.has_value());
  CHECK(number.error().code == PlanError::unreachable);
  CHECK(number.error().detail == "walled in");
  CHECK_FALSE(nothing.has_value());
  CHECK(nothing.error().code == PlanError::cancelled);
  CHECK(nothing.error().detail.empty());
}

TEST_CASE("a failure knows no clearance, safe point or work until it is told", "[core]") {
  const Failure failure = fail(PlanError::goal_blocked).error;
  CHECK_FALSE(failure.clearance.has_value());
  CHECK_FALSE(failure.nearest_safe_point.has_value());
  CHECK(failure.stats.expanded == 0);
  CHECK(failure.stats.generated == 0);
}

}  // namespace
