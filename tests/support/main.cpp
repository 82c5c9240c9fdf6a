// SPDX-License-Identifier: MIT
/// \file
/// The test runner, for Catch2 2 and 3.

#if !__has_include(<catch2/catch_all.hpp>)
#define CATCH_CONFIG_RUNNER
#endif
#include "support/catch.hpp"
#include "support/skip.hpp"

int main(int argc, char** argv) {
  const int result = Catch::Session().run(argc, argv);
  return result == 0 && tutavia::test::any_skipped() ? tutavia::test::skip_code : result;
}
