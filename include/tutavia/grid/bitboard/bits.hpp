// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

/// \file
/// Reading runs of bits, searching for the next one that is set, and reversing them.

namespace tutavia::detail {

/// The number of valid bits that `load_bits` guarantees.
inline constexpr std::size_t loaded_bits = 57;

/// At least 57 bits of an array of words, from bit `first` on; the bits above them are undefined.
/// \pre the array holds bit first + 63
inline std::uint64_t load_bits(const std::uint64_t* words, std::size_t first) {
  if constexpr (std::endian::native == std::endian::little) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, reinterpret_cast<const unsigned char*>(words) + first / 8, sizeof bits);
    return bits >> (first % 8);
  } else {
    const std::size_t shift = first % 64;
    const std::uint64_t low = words[first / 64] >> shift;
    return shift == 0 ? low : low | words[first / 64 + 1] << (64 - shift);
  }
}

/// Bit `index` of an array of words.
inline bool bit_at(const std::uint64_t* words, std::size_t index) {
  return ((words[index / 64] >> (index % 64)) & 1u) != 0;
}

/// Distance from bit `from` to the next set bit after it. \pre there is one, and bit 64 after it is
/// in the array
inline int next_bit(const std::uint64_t* words, std::size_t from) {
  std::size_t first = from + 1;
  while (true) {
    const std::uint64_t bits = load_bits(words, first);
    if (bits != 0) return static_cast<int>(first - from) + std::countr_zero(bits);
    first += loaded_bits;
  }
}

/// A word with its bits in reverse order.
inline std::uint64_t reversed(std::uint64_t word) {
  constexpr std::array<std::uint64_t, 5> masks{0x5555555555555555u, 0x3333333333333333u,
                                               0x0F0F0F0F0F0F0F0Fu, 0x00FF00FF00FF00FFu,
                                               0x0000FFFF0000FFFFu};
  int width = 1;
  for (const std::uint64_t mask : masks) {
    word = ((word >> width) & mask) | (word & mask) << width;
    width *= 2;
  }
  return word >> 32 | word << 32;
}

}  // namespace tutavia::detail
