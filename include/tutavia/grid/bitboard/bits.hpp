// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

/// \file
/// Reading runs of bits.

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

}  // namespace tutavia::detail
