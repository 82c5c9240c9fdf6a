// SPDX-License-Identifier: MIT
#include "tutavia/core/parts/remove_redundant.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

std::vector<int> kept(std::vector<int> path, bool (*sees)(const int&, const int&)) {
  detail::remove_redundant(path, sees);
  return path;
}

TEST_CASE("where all is in sight both ends are left, where nothing is all nodes") {
  const auto always = [](const int&, const int&) { return true; };
  const auto never = [](const int&, const int&) { return false; };
  CHECK(kept({1, 2, 3, 4}, always) == std::vector{1, 4});
  CHECK(kept({1, 2, 3, 4}, never) == std::vector{1, 2, 3, 4});
  for (const std::vector<int>& few : {std::vector<int>{}, {1}, {1, 2}}) {
    CHECK(kept(few, always) == few);
    CHECK(kept(few, never) == few);
  }
}

TEST_CASE("from each node kept the last one is kept that is seen without a break") {
  // Up to 3 apart is in sight: 0, 3, 6, 7.
  CHECK(kept({0, 1, 2, 3, 4, 5, 6, 7}, [](const int& a, const int& b) { return b - a <= 3; }) ==
        std::vector{0, 3, 6, 7});
  // 0 sees 4 again, but not 3 before it: the scan has stopped at 2.
  CHECK(kept({0, 1, 2, 3, 4}, [](const int& a, const int& b) { return a > 0 || b != 3; }) ==
        std::vector{0, 2, 4});
}

TEST_CASE("what is left is a path in sight from the first node to the last, in n - 2 looks") {
  const std::uint64_t seed = 21;
  Random random(seed);
  for (std::size_t round = 0; round < test::scaled(200); ++round) {
    INFO("seed " << seed << ", round " << round);
    const std::size_t count = 3 + random.below(20);
    std::vector<std::vector<bool>> sight(count, std::vector<bool>(count));
    for (auto& row : sight) {
      for (std::size_t j = 0; j < count; ++j) row[j] = random.below(2) == 0;
    }
    std::vector<std::size_t> path(count);
    for (std::size_t i = 0; i < count; ++i) path[i] = i;
    std::size_t looks = 0;
    detail::remove_redundant(path, [&](std::size_t a, std::size_t b) {
      ++looks;
      return static_cast<bool>(sight[a][b]);
    });
    CHECK(path.front() == 0);
    CHECK(path.back() == count - 1);
    CHECK(looks == count - 2);
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      CHECK(path[i] < path[i + 1]);
      CHECK((path[i + 1] == path[i] + 1 || sight[path[i]][path[i + 1]]));
    }
  }
}

}  // namespace
