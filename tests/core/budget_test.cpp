// SPDX-License-Identifier: MIT
#include <chrono>
#include <cstdint>
#include <limits>
#include <thread>

#include "support/catch.hpp"
#include "tutavia/core/budget.hpp"

namespace {

using namespace tutavia;

TEST_CASE("the default budget has no limits", "[core]") {
  const Budget budget;
  CHECK(budget.deadline == Budget::Clock::time_point::max());
  CHECK(budget.max_expansions == std::numeric_limits<std::uint64_t>::max());
  CHECK_FALSE(budget.cancelled());
  CHECK_FALSE(budget.exceeded().has_value());
}

TEST_CASE("no time at all is exhausted at once", "[core]") {
  for (const double seconds : {0.0, -0.0, -1.0, -1e300, -std::numeric_limits<double>::infinity()}) {
    CAPTURE(seconds);
    CHECK(Budget::for_seconds(seconds).exceeded() == Budget::End::exhausted);
  }
}

TEST_CASE("a time that no clock reaches is no limit", "[core]") {
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double seconds : {1e9, 1e18, 1e300, inf, nan}) {
    CAPTURE(seconds);
    CHECK(Budget::for_seconds(seconds).deadline == Budget::Clock::time_point::max());
  }
}

TEST_CASE("the deadline lies the given seconds ahead", "[core]") {
  for (const double seconds : {1e-3, 60.0, 86400.0, 9.9e8}) {
    CAPTURE(seconds);
    const auto before = Budget::Clock::now();
    const Budget budget = Budget::for_seconds(seconds);
    const auto after = Budget::Clock::now();
    const std::chrono::duration<double> least = budget.deadline - after;
    const std::chrono::duration<double> most = budget.deadline - before;
    CHECK(least.count() <= seconds);
    CHECK(most.count() >= seconds - 1e-6);
  }
  CHECK_FALSE(Budget::for_seconds(3600).exceeded().has_value());
}

TEST_CASE("a deadline that passes exhausts the budget", "[core]") {
  const Budget budget = Budget::for_seconds(1e-3);
  std::this_thread::sleep_until(budget.deadline);
  CHECK(budget.exceeded() == Budget::End::exhausted);
}

TEST_CASE("a stop request reaches every copy and goes before the deadline", "[core]") {
  StopSource source;
  Budget budget = Budget::for_seconds(0);
  budget.stop = source.get_token();
  const Budget copy = budget;
  CHECK_FALSE(copy.cancelled());
  CHECK(copy.exceeded() == Budget::End::exhausted);
  std::thread([&] { source.request_stop(); }).join();
  CHECK(copy.cancelled());
  CHECK(copy.exceeded() == Budget::End::cancelled);
}

}  // namespace
