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

TEST_CASE("the next bit is found across any number of words", "[grid]") {
  const std::uint64_t seed = 2;
  Random random(seed);
  CAPTURE(seed);
  for (int round = 0; round < 100; ++round) {
    std::vector<std::uint64_t> words(8, 0);
    std::vector<bool> set(64 * words.size(), false);
    const std::size_t count = 1 + random.below(20);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t bit = random.below(64 * (words.size() - 1));
      words[bit / 64] |= std::uint64_t{1} << (bit % 64);
      set[bit] = true;
    }
    std::size_t wrong = 0, next = 0;
    for (std::size_t bit = set.size(); bit-- > 0;) {
      if (detail::bit_at(words.data(), bit) != set[bit]) ++wrong;
      if (next > 0 && detail::next_bit(words.data(), bit) != static_cast<int>(next - bit)) ++wrong;
      if (set[bit]) next = bit;
    }
    CAPTURE(round);
    CHECK(wrong == 0);
  }
}

TEST_CASE("a reversed word holds every bit at the other end", "[grid]") {
  const std::uint64_t seed = 3;
  Random random(seed);
  CAPTURE(seed);
  for (int round = 0; round < 100; ++round) {
    const std::uint64_t word = random(), turned = detail::reversed(word);
    std::size_t wrong = 0;
    for (int i = 0; i < 64; ++i) {
      if (((word >> i) & 1u) != ((turned >> (63 - i)) & 1u)) ++wrong;
    }
    CHECK(wrong == 0);
  }
}

}  // namespace
