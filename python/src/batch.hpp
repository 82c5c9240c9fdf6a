// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "batch/job.hpp"
#include "batch/result_row.hpp"
#include "tutavia/core/parts/parallel.hpp"
#include "tutavia/planner.hpp"

/// \file
/// Many queries on all cores, and their results.

namespace tutavia_python {

namespace py = pybind11;
using namespace tutavia;
using batch_program::ResultRow;

/// tutavia.Queries.
struct QueriesHandle {
  std::vector<Query> queries;
};

struct BatchQueries {
  std::vector<Query> queries;
  std::optional<double> time_limit{};  ///< of each query, from its own start [s]
};

struct BatchResults {
  std::vector<ResultRow> rows;
  std::vector<std::optional<Expected<Plan, Failure>>> plans;  ///< empty if they are not kept
};

/// tutavia.Batch.
struct BatchHandle {
  std::vector<Query> queries;
  std::vector<ResultRow> rows;
  std::vector<std::optional<Expected<Plan, Failure>>> plans;
  py::object space;
};

/// Queries from arrays of shapes (n, 2), (n, 2), (n,), (n,), (n,); NaN headings are any. Raises
/// InvalidInput.
std::vector<Query> to_queries(const py::object& starts, const py::object& goals,
                              const py::object& start_headings, const py::object& goal_headings,
                              const py::object& seeds);

/// Plans every query with workers of the planner. A stop skips the queries that have not begun.
template <class PlannerType, class S>
BatchResults run_batch(const PlannerType& planner, const S& space, const BatchQueries& input,
                       const std::stop_token& stop, unsigned threads, bool keep_plans) {
  const std::size_t count = input.queries.size();
  BatchResults results;
  results.rows.resize(count);
  if (keep_plans) results.plans.resize(count);
  tutavia::detail::for_each_in_parallel(count, threads, [&] {
    return [&, worker = planner.worker()](std::size_t i) mutable {
      if (stop.stop_requested()) return;
      Query query = input.queries[i];
      if (input.time_limit) {
        query.budget.deadline = Budget::for_seconds(*input.time_limit).deadline;
      }
      query.budget.stop = stop;
      auto result = worker.plan(space, query);
      results.rows[i] = batch_program::to_row(result);
      if (keep_plans) results.plans[i].emplace(std::move(result));
    };
  });
  return results;
}

}  // namespace tutavia_python
