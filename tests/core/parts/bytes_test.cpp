// SPDX-License-Identifier: MIT
#include "tutavia/core/parts/bytes.hpp"

#include <cstdint>
#include <string>

#include "support/catch.hpp"

namespace {

using namespace tutavia::detail;

TEST_CASE("the low byte of a number comes first, whatever the machine") {
  std::string bytes = "x";
  append_bytes(bytes, 0x0102, 2);
  append_bytes(bytes, 0xFF, 3);
  CHECK(bytes == std::string("x\x02\x01\xFF\0\0", 6));
}

TEST_CASE("bytes above the asked count are dropped") {
  std::string bytes;
  append_bytes(bytes, 0x12345678, 2);
  CHECK(bytes == "\x78\x56");
}

TEST_CASE("numbers of every length are read back from anywhere") {
  for (int count = 1; count <= 8; ++count) {
    for (const std::uint64_t value : {std::uint64_t{0}, std::uint64_t{0x80}, ~std::uint64_t{0},
                                      std::uint64_t{0x8182838485868788}}) {
      CAPTURE(count, value);
      std::string bytes(3, '\xAB');
      append_bytes(bytes, value, count);
      bytes += '\xCD';
      const std::uint64_t kept = count == 8 ? value : value % (std::uint64_t{1} << (8 * count));
      CHECK(read_bytes(bytes, 3, count) == kept);
    }
  }
}

}  // namespace
