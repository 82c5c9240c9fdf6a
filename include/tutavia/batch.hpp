// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "tutavia/planner.hpp"

/// \file
/// plan_batch: many queries on one space, on all cores.

namespace tutavia {

/// Plans every query, in `threads` threads (0: one per core), each with a copy of `planner` and so
/// with scratch memory of its own. The results stand in the order of the queries and do not depend
/// on the number of threads, as far as budgets do not end them.
template <class Search, class Smooth, ClearanceSpace S>
std::vector<Expected<Plan, Failure>> plan_batch(const Planner<Search, Smooth>& planner,
                                                const S& space, std::span<const Query> queries,
                                                unsigned threads = 0) {
  std::vector<std::optional<Expected<Plan, Failure>>> slots(queries.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    Planner<Search, Smooth> own(planner.search(), planner.smoother());
    for (std::size_t i = next++; i < queries.size(); i = next++) {
      slots[i].emplace(own.plan(space, queries[i]));
    }
  };
  if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
  threads = static_cast<unsigned>(std::min<std::size_t>(threads, queries.size()));
  std::vector<std::thread> workers;
  for (unsigned i = 1; i < threads; ++i) workers.emplace_back(work);
  work();
  for (std::thread& worker : workers) worker.join();
  std::vector<Expected<Plan, Failure>> results;
  results.reserve(slots.size());
  for (auto& slot : slots) results.push_back(std::move(*slot));
  return results;
}

}  // namespace tutavia
