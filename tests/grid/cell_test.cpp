// SPDX-License-Identifier: MIT
#include "tutavia/grid/cell.hpp"

#include <cstdint>

#include "support/catch.hpp"

namespace {

using namespace tutavia;

TEST_CASE("a turn is positive to the left, 0 on the line, and twice the triangle's area",
          "[grid]") {
  CHECK(detail::turn({0, 0}, {4, 0}, {1, 3}) == 12);
  CHECK(detail::turn({0, 0}, {4, 0}, {1, -3}) == -12);
  CHECK(detail::turn({0, 0}, {4, 2}, {10, 5}) == 0);
  CHECK(detail::turn({1, 3}, {0, 0}, {4, 0}) == detail::turn({0, 0}, {4, 0}, {1, 3}));
}

TEST_CASE("turns among far cells do not overflow", "[grid]") {
  constexpr int far = 1 << 30;
  CHECK(detail::turn({-far / 2, -far / 2}, {far / 2, -far / 2}, {far / 2, far / 2}) ==
        std::int64_t{far} * far);
}

}  // namespace
