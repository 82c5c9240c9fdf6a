// SPDX-License-Identifier: MIT
#include "tutavia/search/grid/bucket_queue.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

/// Pushes and pops at random, as a monotone search does, and compares with an ordered model.
template <int Shift>
void check_against_model(std::uint64_t seed, Cost least, std::size_t rounds) {
  CAPTURE(Shift, seed, least);
  constexpr Cost width = Cost{1} << Shift;
  Random random(seed);
  Buckets buckets;
  std::size_t pops = 0, wrong = 0;
  for (std::size_t round = 0; round < rounds; ++round) {
    BucketQueue<Shift> queue(buckets, least);
    std::multimap<Cost, std::uint32_t> model;
    Cost from = least / width * width;  // the bucket popped last begins here
    std::uint32_t node = 0;
    const auto push = [&](Cost key) {
      queue.push(key, node, static_cast<std::uint32_t>(key));
      model.emplace(key, node++);
    };
    push(least);
    const std::size_t turns = 1 + random.below(400);
    for (std::size_t turn = 0; turn < turns && !queue.empty(); ++turn) {
      const Cost bound = queue.seek_first();
      const Cost first = model.begin()->first;
      if (bound > first || queue.seek_first() != bound) ++wrong;
      const BucketEntry entry = queue.pop();
      const Cost key = bound + static_cast<Cost>(entry.tag - static_cast<std::uint32_t>(bound));
      if (key - first >= width || bound + width <= first) ++wrong;
      const auto [begin, end] = model.equal_range(key);
      const auto known =
          std::find_if(begin, end, [&](const auto& e) { return e.second == entry.node; });
      if (known == end) {
        ++wrong;
        break;
      }
      model.erase(known);
      ++pops;
      from = key / width * width;
      for (std::uint64_t i = random.below(4); i > 0; --i) {
        const Cost reach = random.below(3) == 0 ? 63 * width : 3 * width;
        push(from + static_cast<Cost>(random.below(static_cast<std::uint64_t>(reach))));
      }
      if (queue.empty() != model.empty()) ++wrong;
    }
  }
  CHECK(wrong == 0);
  CHECK(pops > 10 * rounds);
}

TEST_CASE("a bucket queue gives a key less than one bucket above the least", "[search]") {
  const std::size_t rounds = test::scaled(40);
  check_against_model<0>(1, 0, rounds);
  check_against_model<10>(2, 12345, rounds);
  check_against_model<13>(3, 0, rounds);
  check_against_model<10>(4, (Cost{1} << 32) - 5000, rounds);  // keys pass 32 bits on the way
  check_against_model<13>(5, Cost{470000000000000}, rounds);
}

TEST_CASE("what was left in the buckets is gone when a queue begins", "[search]") {
  Buckets buckets;
  {
    BucketQueue<10> queue(buckets, 0);
    for (std::uint32_t i = 0; i < 63; ++i) queue.push(Cost{1024} * i, i, 0);
    CHECK_FALSE(queue.empty());
  }
  BucketQueue<10> queue(buckets, 5000);
  CHECK(queue.empty());
  queue.push(5000 + 62 * 1024, 7, 11);
  CHECK(queue.seek_first() == (5000 + 62 * 1024) / 1024 * 1024);
  const BucketEntry entry = queue.pop();
  CHECK(entry.node == 7);
  CHECK(entry.tag == 11);
  CHECK(queue.empty());
}

TEST_CASE("the 63 buckets from the one popped last are kept apart", "[search]") {
  for (Cost start = 0; start < 70; ++start) {
    Buckets buckets;
    BucketQueue<4> queue(buckets, 16 * start);
    queue.push(16 * start, 0, 0);
    queue.seek_first();
    queue.pop();
    for (Cost i = 62; i >= 0; --i)
      queue.push(16 * (start + i) + 3, static_cast<std::uint32_t>(i), 0);
    std::size_t wrong = 0;
    for (std::uint32_t i = 0; i < 63; ++i) {
      if (queue.empty() || queue.seek_first() != 16 * (start + i) || queue.pop().node != i) ++wrong;
    }
    CAPTURE(start);
    CHECK(wrong == 0);
    CHECK(queue.empty());
  }
}

}  // namespace
