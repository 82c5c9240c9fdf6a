// SPDX-License-Identifier: MIT
#include "tutavia/grid/bitboard/bits.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

TEST_CASE("bits are loaded from any place, 57 of them at least", "[grid]") {
  const std::uint64_t seed = 1;
  Random random(seed);
  CAPTURE(seed);
  std::vector<std::uint64_t> words(8);
  for (std::uint64_t& word : words) word = random();
  const auto bit = [&](std::size_t i) { return (words[i / 64] >> (i % 64)) & 1u; };
  for (std::size_t first = 0; first + 63 < 64 * words.size(); ++first) {
    const std::uint64_t loaded = detail::load_bits(words.data(), first);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < detail::loaded_bits; ++i) {
      if (((loaded >> i) & 1u) != bit(first + i)) ++wrong;
    }
    CAPTURE(first);
    CHECK(wrong == 0);
  }
  CHECK(detail::loaded_bits >= 57);
}

}  // namespace
