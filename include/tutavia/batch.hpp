// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "tutavia/core/parts/parallel.hpp"
#include "tutavia/planner.hpp"

/// \file
/// plan_batch: many queries on one space, in parallel.

namespace tutavia {

/// Plans every query in `threads` threads (0: one per core), each with a worker of `planner`.
/// Results are in query order. Unless a budget expires, they do not depend on the number of
/// threads. Throws the first exception of a thread, such as std::bad_alloc, when all have ended.
///
/// Example: examples/07_batch.cpp.
template <class Search, class Smooth, detail::PlannableSpace<Search, Smooth> S>
std::vector<Expected<Plan, Failure>> plan_batch(const Planner<Search, Smooth>& planner,
                                                const S& space, std::span<const Query> queries,
                                                unsigned threads = 0) {
  std::vector<std::optional<Expected<Plan, Failure>>> slots(queries.size());
  detail::for_each_in_parallel(queries.size(), threads, [&] {
    return [&, worker = planner.worker()](std::size_t i) mutable {
      slots[i].emplace(worker.plan(space, queries[i]));
    };
  });
  std::vector<Expected<Plan, Failure>> results;
  results.reserve(slots.size());
  for (auto& slot : slots) results.push_back(std::move(*slot));
  return results;
}

}  // namespace tutavia
