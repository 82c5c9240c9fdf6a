// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

/// \file
/// for_each_in_parallel: a loop on several threads.

namespace tutavia::detail {

/// Calls `body(i)` for every index i below `count`, on `threads` threads (0: one per core)
/// including the calling one. Each thread makes its own `body` with `make_body()`, and takes the
/// next index when it finishes one. Where the system starts fewer threads, those do all the work.
/// After an exception no index is begun any more; the first one is thrown when all threads have
/// ended.
template <class MakeBody>
void for_each_in_parallel(std::size_t count, unsigned threads, const MakeBody& make_body) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr first_error;
  const auto work = [&] {
    try {
      auto body = make_body();
      for (std::size_t i = next++; i < count; i = next++) body(i);
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      if (!first_error) first_error = std::current_exception();
    }
  };
  if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::thread> workers;
  try {
    for (std::size_t i = 1; i < std::min<std::size_t>(threads, count); ++i) {
      workers.emplace_back(work);
    }
  } catch (const std::exception&) {  // no more threads, or no memory for them
  }
  work();
  for (std::thread& worker : workers) worker.join();
  if (first_error) std::rethrow_exception(first_error);
}

}  // namespace tutavia::detail
