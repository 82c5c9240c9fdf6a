// SPDX-License-Identifier: MIT
#include "tutavia/smooth/route/farthest_in_sight.hpp"

#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

TEST_CASE("the node found is in sight and its successor is not, whatever is in sight") {
  const std::uint64_t seed = 12;
  Random random(seed);
  for (int round = 0; round < 500; ++round) {
    INFO("seed " << seed << ", round " << round);
    const std::size_t end = 1 + random.below(200), i = random.below(end);
    std::vector<bool> visible(end + 1);
    const double density = random.uniform();
    for (std::size_t j = 0; j <= end; ++j) visible[j] = random.uniform() < density;
    if (i < end) visible[i + 1] = true;
    std::size_t looks = 0;
    const auto sees = [&](std::size_t j) {
      ++looks;
      REQUIRE(j > i);
      REQUIRE(j <= end);
      return visible[j];
    };
    for (const bool ahead : {true, false}) {
      looks = 0;
      const std::size_t found =
          ahead ? farthest_looking_ahead(i, end, sees) : farthest_looking_back(i, end, sees);
      CHECK(found > i);
      CHECK(visible[found]);
      CHECK((found == end || !visible[found + 1]));
      CHECK(looks <= 18);
    }
  }
}

TEST_CASE("looking back finds the end where sight opens again, looking ahead stops before") {
  const std::vector<bool> visible{true, true, true, false, false, false, true, true};
  const auto sees = [&](std::size_t j) { return bool(visible[j]); };
  CHECK(farthest_looking_ahead(0, 7, sees) == 2);
  CHECK(farthest_looking_back(0, 7, sees) == 7);
}

}  // namespace
