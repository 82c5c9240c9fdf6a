// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

/// \file
/// for_each_in_parallel: a loop on several threads.

namespace tutavia::detail {

/// Calls `body(i)` for every index i below `count`, on `threads` threads (0: one per core)
/// including the calling one. Each thread makes its own `body` with `make_body()`, and takes the
/// next index when it finishes one. An exception in a body terminates the program.
template <class MakeBody>
void for_each_in_parallel(std::size_t count, unsigned threads, const MakeBody& make_body) {
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    auto body = make_body();
    for (std::size_t i = next++; i < count; i = next++) body(i);
  };
  if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::thread> workers;
  for (std::size_t i = 1; i < std::min<std::size_t>(threads, count); ++i) {
    workers.emplace_back(work);
  }
  work();
  for (std::thread& worker : workers) worker.join();
}

}  // namespace tutavia::detail
