// SPDX-License-Identifier: MIT
#include "planner.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "arrays.hpp"
#include "batch.hpp"
#include "bindings.hpp"
#include "failures.hpp"
#include "interrupt.hpp"
#include "results.hpp"

namespace tutavia_python {

namespace {

using namespace pybind11::literals;

template <class S>
const plan_program::Algorithms<S>& known_algorithms() {
  if constexpr (std::is_same_v<S, LatticeSpace>) {
    return plan_program::lattice_algorithms();
  } else {
    return plan_program::cell_algorithms();
  }
}

/// The algorithm, or InvalidOption with the keyword and its name before the detail.
template <class Any>
Any made(const char* keyword, Expected<Any, Failure> any) {
  if (any) return std::move(*any);
  raise(any.error().code, std::string(keyword) + ": " + any.error().detail);
}

template <class S>
AnySearch<S> make_search(const Choice& choice) {
  const auto& all = known_algorithms<S>();
  AnySearch<S> search = made("search", all.make_search(choice.search.name, choice.search.options));
  if (!choice.vehicle) return search;
  if (!search.for_vehicle) {
    raise(PlanError::invalid_option, "vehicle: the search " + choice.search.name +
                                         " plans no headings; give search=\"hybrid_astar\" and "
                                         "smoother=\"vehicle_shortcut\"");
  }
  return search.for_vehicle(*choice.vehicle);
}

template <class S>
AnySmoother<S> make_smoother(const Choice& choice) {
  const auto& all = known_algorithms<S>();
  std::optional<AnySmoother<S>> chain;
  for (const AlgorithmText& text : choice.smoothers) {
    AnySmoother<S> stage = made("smoother", all.make_smoother(text.name, text.options));
    chain = chain ? tutavia::detail::chain(*chain, stage) : std::move(stage);
  }
  return *chain;
}

using Options = std::vector<std::pair<std::string, std::string>>;
using Stage = std::pair<std::string, Options>;

AlgorithmText to_text(const Stage& stage) {
  AlgorithmText text{.name = stage.first};
  for (const auto& [name, value] : stage.second) text.options.push_back({name, value});
  return text;
}

std::shared_ptr<PlannerHandle> make_planner(const Stage& search,
                                            const std::vector<Stage>& smoothers,
                                            const std::optional<Vehicle>& vehicle) {
  Choice choice{.search = to_text(search)};
  for (const Stage& stage : smoothers) choice.smoothers.push_back(to_text(stage));
  if (choice.smoothers.empty()) choice.smoothers.push_back({.name = "none"});
  choice.vehicle = vehicle;
  return std::make_shared<PlannerHandle>(std::move(choice));
}

Budget to_budget(const py::object& time_limit, const py::object& max_expansions) {
  Budget budget;
  if (const auto seconds = to_optional_number(time_limit, "time_limit")) {
    if (!(*seconds >= 0)) {
      raise(PlanError::invalid_option, "time_limit: expected seconds, not negative, or None");
    }
    budget = Budget::for_seconds(*seconds);
  }
  if (!max_expansions.is_none()) budget.max_expansions = to_count(max_expansions, "max_expansions");
  return budget;
}

py::object plan(PlannerHandle& self, const py::object& space, const py::object& start,
                const py::object& goal, const py::object& start_heading,
                const py::object& goal_heading, const py::object& seed,
                const py::object& time_limit, const py::object& max_expansions) {
  Query query{.start = to_point(start, "start"), .goal = to_point(goal, "goal")};
  query.start_heading = to_optional_number(start_heading, "start_heading");
  query.goal_heading = to_optional_number(goal_heading, "goal_heading");
  query.budget = to_budget(time_limit, max_expansions);
  query.seed = to_count(seed, "seed");
  return with_space(space, [&]<class Handle>(const std::shared_ptr<Handle>& handle) -> py::object {
    auto& pool = self.pool<typename Handle::Space>();
    const auto planner = pool.lend();
    auto result = run_interruptible([&](const std::stop_token& stop) {
      query.budget.stop = stop;
      return planner->plan(handle->space, query);
    });
    if (!result) raise(result.error(), &query);
    return py::cast(PlanHandle{std::move(*result), space});
  });
}

py::object batch(PlannerHandle& self, const py::object& space, const py::object& starts,
                 const py::object& goals, const py::object& start_headings,
                 const py::object& goal_headings, const py::object& seeds,
                 const py::object& time_limit, const py::object& max_expansions,
                 const py::object& threads, bool keep_plans) {
  BatchQueries queries{to_queries(starts, goals, start_headings, goal_headings, seeds)};
  if (const auto seconds = to_optional_number(time_limit, "time_limit")) {
    to_budget(time_limit, py::none());
    queries.time_limit = seconds;
  }
  if (!max_expansions.is_none()) {
    const std::uint64_t most = to_count(max_expansions, "max_expansions");
    for (Query& query : queries.queries) query.budget.max_expansions = most;
  }
  constexpr std::uint64_t most_threads = 4096;
  const auto used = static_cast<unsigned>(to_count(threads, "threads", most_threads));
  return with_space(space, [&]<class Handle>(const std::shared_ptr<Handle>& handle) -> py::object {
    auto& pool = self.pool<typename Handle::Space>();
    auto result = run_interruptible([&](const std::stop_token& stop) {
      return run_batch(pool.model(), handle->space, queries, stop, used, keep_plans);
    });
    return py::cast(BatchHandle{std::move(queries.queries), std::move(result.rows),
                                std::move(result.plans), space});
  });
}

void check_on(PlannerHandle& self, const py::object& space) {
  with_space(space, [&]<class Handle>(const std::shared_ptr<Handle>&) {
    self.pool<typename Handle::Space>();
  });
}

std::string describe_job(const PlannerHandle& self, const py::object& space,
                         const py::object& queries) {
  const std::string digest =
      with_space(space, [](const auto& handle) { return batch_program::digest_of(handle->space); });
  return batch_program::describe_job(self.choice().text(), digest,
                                     queries.cast<const QueriesHandle&>().queries);
}

}  // namespace

std::string Choice::text() const {
  std::string line = batch_program::algorithms_text(search, smoothers);
  if (vehicle) line.append(", vehicle ").append(batch_program::digest_of(*vehicle));
  return line;
}

template <class S>
void PlannerPool<S>::make(const Choice& choice) {
  if (model_ != nullptr) return;
  model_ = std::make_unique<AnyPlanner<S>>(make_search<S>(choice), make_smoother<S>(choice));
}

void refuse_space(const py::object& space) {
  raise(PlanError::invalid_input, "space: expected a LatticeSpace or a CellSpace, got " +
                                      std::string(py::str(py::type::of(space))));
}

void bind_planner(py::module_& m) {
  py::class_<PlannerHandle, std::shared_ptr<PlannerHandle>>(m, "_Planner")
      .def(py::init(&make_planner), "search"_a, "smoothers"_a, "vehicle"_a = py::none())
      .def("plan", &plan, "space"_a, "start"_a, "goal"_a, py::kw_only(),
           "start_heading"_a = py::none(), "goal_heading"_a = py::none(), "seed"_a = 0,
           "time_limit"_a = py::none(), "max_expansions"_a = py::none(),
           "The Plan from start to goal: see tutavia.Planner.plan.")
      .def("plan_batch", &batch, "space"_a, "starts"_a, "goals"_a, py::kw_only(),
           "start_headings"_a = py::none(), "goal_headings"_a = py::none(), "seeds"_a = py::none(),
           "time_limit"_a = py::none(), "max_expansions"_a = py::none(), "threads"_a = 0,
           "keep_plans"_a = true)
      .def("check_on", &check_on, "space"_a)
      .def("describe_job", &describe_job, "space"_a, "queries"_a)
      .def_property_readonly("text",
                             [](const PlannerHandle& self) { return self.choice().text(); });
}

}  // namespace tutavia_python
