// SPDX-License-Identifier: MIT
#include "tutavia/core/parts/zeroed_array.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "support/catch.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

static_assert(std::is_nothrow_move_constructible_v<ZeroedArray<int>>);
static_assert(std::is_nothrow_move_assignable_v<ZeroedArray<int>>);
static_assert(!std::is_copy_constructible_v<ZeroedArray<int>>);

struct Label {
  double g;
  std::uint16_t step;
};

TEST_CASE("an array is all zeros at first, also where memory was used before") {
  for (const std::size_t size : {1u, 7u, 1000u, 300000u}) {
    CAPTURE(size);
    for (int round = 0; round < 3; ++round) {
      ZeroedArray<std::uint64_t> words(size);
      ZeroedArray<Label> labels(size);
      REQUIRE(words.size() == size);
      REQUIRE(labels.size() == size);
      CHECK(std::all_of(words.data(), words.data() + size, [](auto word) { return word == 0; }));
      CHECK(std::all_of(labels.data(), labels.data() + size,
                        [](const Label& label) { return label.g == 0 && label.step == 0; }));
      std::fill(words.data(), words.data() + size, ~std::uint64_t{0});
      std::fill(labels.data(), labels.data() + size, Label{1.5, 3});
    }
  }
}

TEST_CASE("an array keeps what is written to it, wherever it moves") {
  ZeroedArray<int> first(100);
  for (std::size_t i = 0; i < 100; ++i) first[i] = static_cast<int>(3 * i);
  const int* data = first.data();
  ZeroedArray<int> second(std::move(first));
  CHECK(second.size() == 100);
  CHECK(second.data() == data);
  ZeroedArray<int> third(5);
  third = std::move(second);
  const ZeroedArray<int>& fixed = third;
  REQUIRE(fixed.size() == 100);
  CHECK(fixed.data() == data);
  for (std::size_t i = 0; i < 100; ++i) CHECK(fixed[i] == static_cast<int>(3 * i));
  second = ZeroedArray<int>(7);  // what was moved from can be used again
  CHECK(second.size() == 7);
  CHECK(second[6] == 0);
}

TEST_CASE("an array of no elements is fine") {
  CHECK(ZeroedArray<int>().size() == 0);
  ZeroedArray<int> empty(0);
  CHECK(empty.size() == 0);
  empty = ZeroedArray<int>(3);
  CHECK(empty.size() == 3);
  empty = ZeroedArray<int>(0);
  CHECK(empty.size() == 0);
}

}  // namespace
