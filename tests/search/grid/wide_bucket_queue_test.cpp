// SPDX-License-Identifier: MIT
#include "tutavia/search/grid/wide_bucket_queue.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>

#include "support/catch.hpp"
#include "support/scale.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

constexpr Cost width = WideBucketQueue::width;
constexpr Cost circle = 4096 * width;  // what all buckets hold

/// Takes one entry and compares it with the model; the key, or -1 where they differ.
Cost pop(WideBucketQueue& queue, std::multimap<Cost, std::uint32_t>& model) {
  if (queue.empty() != model.empty()) return -1;
  const Cost bound = queue.seek_first();
  const Cost first = model.begin()->first;
  const WideBucketQueue::Entry entry = queue.pop();
  // The tag holds the low bits of the key.
  const Cost key = bound + static_cast<Cost>(entry.tag - static_cast<std::uint32_t>(bound));
  const auto [begin, end] = model.equal_range(key);
  const auto known =
      std::find_if(begin, end, [&](const auto& e) { return e.second == entry.node; });
  if (known == end || bound > first || key - first >= width) return -1;
  model.erase(known);
  return queue.empty() == model.empty() ? key : -1;
}

TEST_CASE("a jump queue gives a key less than one bucket above the least, however far keys reach",
          "[search]") {
  const std::uint64_t seed = 1;
  Random random(seed);
  WideBucketQueue queue;
  std::size_t pops = 0;
  for (std::size_t round = 0; round < test::scaled(120); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto least = static_cast<Cost>(random.below(round % 2 == 0 ? 100000 : 400000000000));
    // How far new keys lie above the one popped: within a bucket, the circle, or far beyond.
    const Cost reaches[] = {1,      width,      40 * width, circle - 1,
                            circle, circle + 1, 3 * circle, Cost{1} << 40};
    const std::size_t kinds = 1 + random.below(std::size(reaches));
    queue.reset(least);
    REQUIRE(queue.empty());
    std::multimap<Cost, std::uint32_t> model;
    std::uint32_t node = 0;
    const auto push = [&](Cost from) {
      const Cost reach = reaches[random.below(kinds)];
      const Cost key =
          from + (random.below(3) == 0
                      ? reach
                      : static_cast<Cost>(random.below(static_cast<std::uint64_t>(reach) + 1)));
      queue.push(key, node, static_cast<std::uint32_t>(key));
      model.emplace(key, node++);
    };
    push(least);
    push(least);
    const std::size_t turns = 1 + random.below(1500);
    bool agrees = true;
    for (std::size_t turn = 0; turn < turns && !model.empty() && agrees; ++turn) {
      const Cost key = pop(queue, model);
      agrees = key >= 0;
      ++pops;
      for (std::uint64_t i = random.below(turn < turns / 2 ? 4 : 2); i > 0; --i) push(key);
    }
    while (round % 3 != 0 && !model.empty() && agrees) {  // else something is left for `begin`
      agrees = pop(queue, model) >= 0;
      ++pops;
    }
    CHECK(agrees);
  }
  CHECK(pops > test::scaled(10000));
}

TEST_CASE("a jump queue keeps the buckets of its whole circle apart", "[search]") {
  WideBucketQueue queue;
  for (const Cost start : {Cost{0}, Cost{1}, Cost{63}, Cost{64}, Cost{4095}, Cost{5000}}) {
    CAPTURE(start);
    queue.reset(start * width);
    for (Cost i = 5000; i >= 0; i -= 1) {  // the last ones lie beyond the circle
      queue.push((start + i) * width + i % width, static_cast<std::uint32_t>(i), 0);
    }
    std::size_t wrong = 0;
    for (std::uint32_t i = 0; i <= 5000; ++i) {
      if (queue.empty() || queue.seek_first() != (start + i) * width || queue.pop().node != i)
        ++wrong;
    }
    CHECK(wrong == 0);
    CHECK(queue.empty());
  }
}

TEST_CASE("keys below the bucket popped last are given at once", "[search]") {
  WideBucketQueue queue;
  queue.reset(0);
  queue.push(100 * width, 1, 0);
  CHECK(queue.seek_first() == 100 * width);
  queue.push(7, 2, 0);  // a heuristic that rounds may fall a little
  queue.push(101 * width, 3, 0);
  queue.seek_first();
  CHECK(queue.pop().node == 2);
  CHECK(queue.pop().node == 1);
  CHECK(queue.seek_first() == 101 * width);
  CHECK(queue.pop().node == 3);
  CHECK(queue.empty());
}

}  // namespace
