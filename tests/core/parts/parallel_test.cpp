// SPDX-License-Identifier: MIT
#include "tutavia/core/parts/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "support/catch.hpp"

namespace {

using tutavia::detail::for_each_in_parallel;

TEST_CASE("every index is done once, by any number of threads") {
  for (const unsigned threads : {0u, 1u, 2u, 7u}) {
    for (const std::size_t count : {0u, 1u, 3u, 1000u}) {
      CAPTURE(threads, count);
      std::vector<std::atomic<int>> visits(count);
      for_each_in_parallel(count, threads, [&] { return [&](std::size_t i) { ++visits[i]; }; });
      for (const auto& visit : visits) CHECK(visit == 1);
    }
  }
}

TEST_CASE("every thread has a body of its own, and there are no more threads than indices") {
  for (const std::size_t count : {1u, 2u, 100u}) {
    CAPTURE(count);
    std::atomic<std::size_t> bodies{0}, done{0};
    for_each_in_parallel(count, 4, [&] {
      ++bodies;
      return [&, own = std::size_t{0}](std::size_t) mutable { done += ++own > 0 ? 1 : 0; };
    });
    CHECK(bodies == std::min<std::size_t>(count, 4));
    CHECK(done == count);
  }
}

TEST_CASE("one thread is this one, and takes the indices in order") {
  std::vector<std::size_t> order;
  std::set<std::thread::id> threads;
  for_each_in_parallel(5, 1, [&] {
    return [&](std::size_t i) {
      order.push_back(i);
      threads.insert(std::this_thread::get_id());
    };
  });
  CHECK(order == std::vector<std::size_t>{0, 1, 2, 3, 4});
  CHECK(threads == std::set{std::this_thread::get_id()});
}

TEST_CASE("an exception ends the loop and is thrown when all threads have ended") {
  for (const unsigned threads : {1u, 4u}) {
    CAPTURE(threads);
    std::atomic<std::size_t> begun{0}, running{0};
    const auto loop = [&] {
      for_each_in_parallel(1000000, threads, [&] {
        return [&](std::size_t i) {
          ++begun;
          ++running;
          --running;
          if (i == 20) throw std::runtime_error("20");
        };
      });
    };
    CHECK_THROWS_AS(loop(), std::runtime_error);
    CHECK(running == 0);
    CHECK(begun >= 21);
    CHECK(begun < 1000000);
  }
}

TEST_CASE("a body that cannot be made is an exception, too") {
  const auto make = []() -> void (*)(std::size_t) { throw std::logic_error("no body"); };
  CHECK_THROWS_AS(for_each_in_parallel(10, 3, make), std::logic_error);
}

}  // namespace
