// SPDX-License-Identifier: MIT
#include "tutavia/core/parts/flag_stop_token.hpp"

#include <thread>

#include "support/catch.hpp"

using namespace tutavia;

TEST_CASE("a token without a source is never stopped", "[core]") {
  const detail::FlagStopToken token;
  CHECK_FALSE(token.stop_requested());
  CHECK_FALSE(token.stop_possible());
}

TEST_CASE("a source stops all its tokens, and says so once", "[core]") {
  detail::FlagStopSource source;
  const detail::FlagStopToken early = source.get_token();
  CHECK(early.stop_possible());
  CHECK_FALSE(early.stop_requested());
  detail::FlagStopSource copy = source;
  CHECK(copy.request_stop());
  CHECK_FALSE(source.request_stop());
  CHECK(source.stop_requested());
  CHECK(early.stop_requested());
  CHECK(source.get_token().stop_requested());
}

TEST_CASE("a token outlives its source, and is seen from another thread", "[core]") {
  detail::FlagStopToken token;
  {
    detail::FlagStopSource source;
    token = source.get_token();
    std::thread([source]() mutable { source.request_stop(); }).join();
  }
  CHECK(token.stop_requested());
}
