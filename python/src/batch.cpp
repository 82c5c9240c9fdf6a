// SPDX-License-Identifier: MIT
#include "batch.hpp"

#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "arrays.hpp"
#include "batch/queries.hpp"
#include "bindings.hpp"
#include "failures.hpp"
#include "results.hpp"

namespace tutavia_python {

namespace {

using namespace pybind11::literals;

std::size_t to_index(std::int64_t index, std::size_t size) {
  if (index < 0) index += static_cast<std::int64_t>(size);
  if (index < 0 || static_cast<std::size_t>(index) >= size) {
    throw py::index_error("there are " + std::to_string(size) + " queries");
  }
  return static_cast<std::size_t>(index);
}

/// A plan, or the exception of a failure, not raised.
py::object result_at(const BatchHandle& self, std::int64_t signed_index) {
  const std::size_t i = to_index(signed_index, self.rows.size());
  if (self.plans.empty()) {
    raise(PlanError::invalid_option, "the batch kept no plans: give keep_plans=True");
  }
  const Expected<Plan, Failure>& result = *self.plans[i];
  if (!result) return to_exception(result.error(), &self.queries[i]);
  return py::cast(PlanHandle{*result, self.space});
}

/// A column of figures, NaN where there is no plan.
template <class Figure>
Numbers figures(const BatchHandle& self, const Figure& figure) {
  return make_column(self.rows.size(), [&](std::size_t i) {
    const ResultRow& row = self.rows[i];
    return row.is_planned ? row.*figure : std::numeric_limits<double>::quiet_NaN();
  });
}

std::string status_of(const ResultRow& row) {
  return std::string(row.is_planned ? "planned" : to_string(row.code));
}

/// The lines of a file of results for the queries from `first` on, counted from `number`.
std::string lines_of(const BatchHandle& self, std::size_t number) {
  std::string text;
  for (std::size_t i = 0; i < self.rows.size(); ++i) {
    batch_program::append_line(text, number + i, self.queries[i], self.rows[i]);
  }
  return text;
}

constexpr auto last_code = PlanError::limit_exceeded;

/// A plan as tutavia.Plan, or the members of a failure but its statistics.
py::object result_state(const Expected<Plan, Failure>& result) {
  if (result) return py::cast(PlanHandle{*result});
  const Failure& failure = result.error();
  std::optional<std::array<double, 2>> safe;
  if (const auto& point = failure.nearest_safe_point) safe = {{point->x(), point->y()}};
  return py::make_tuple(static_cast<int>(failure.code), failure.detail, failure.clearance,
                        failure.obstacle, safe, failure.stats.expanded);
}

Expected<Plan, Failure> result_of(const py::handle& state) {
  if (py::isinstance<PlanHandle>(state)) return state.cast<const PlanHandle&>().plan;
  const auto members = state.cast<py::tuple>();
  const int code = members[0].cast<int>();
  if (code < 0 || code > static_cast<int>(last_code)) {
    raise(PlanError::invalid_input, "the pickle of this failure is damaged");
  }
  Failure failure;
  failure.code = static_cast<PlanError>(code);
  failure.detail = members[1].cast<std::string>();
  failure.clearance = members[2].cast<std::optional<double>>();
  failure.obstacle = members[3].cast<std::optional<std::size_t>>();
  if (const auto safe = members[4].cast<std::optional<std::array<double, 2>>>()) {
    failure.nearest_safe_point = Point((*safe)[0], (*safe)[1]);
  }
  failure.stats.expanded = members[5].cast<std::uint64_t>();
  return Unexpected{std::move(failure)};
}

// The figures of a row, as they are pickled.
constexpr std::array row_figures{&ResultRow::length, &ResultRow::clearance_lower,
                                 &ResultRow::clearance_upper, &ResultRow::turning_angle,
                                 &ResultRow::max_curvature};
constexpr unsigned char planned_code = 255;

py::tuple batch_state(const BatchHandle& self) {
  std::string codes, fell_back;
  Numbers figures({self.rows.size(), row_figures.size()});
  py::array_t<std::uint64_t> expanded(static_cast<py::ssize_t>(self.rows.size()));
  double* figure = figures.mutable_data();
  std::uint64_t* count = expanded.mutable_data();
  for (const ResultRow& row : self.rows) {
    codes.push_back(
        static_cast<char>(row.is_planned ? planned_code : static_cast<unsigned char>(row.code)));
    fell_back.push_back(row.fell_back ? 1 : 0);
    for (const auto member : row_figures) *figure++ = row.*member;
    *count++ = row.expanded;
  }
  py::list plans;
  for (const auto& result : self.plans) plans.append(result_state(*result));
  return pickle_head("Batch") + py::make_tuple(QueriesHandle{self.queries}, py::bytes(codes),
                                               py::bytes(fell_back), figures, expanded, plans);
}

BatchHandle batch_of(const py::tuple& state) {
  check_pickle(state, "Batch", 9);
  BatchHandle batch{.queries = state[3].cast<const QueriesHandle&>().queries,
                    .rows = {},
                    .plans = {},
                    .space = py::none()};
  const auto codes = state[4].cast<std::string>(), fell_back = state[5].cast<std::string>();
  const auto figures = state[6].cast<Numbers>();
  const auto expanded = state[7].cast<py::array_t<std::uint64_t, py::array::c_style>>();
  const std::size_t count = batch.queries.size();
  const auto rows = static_cast<py::ssize_t>(count);
  const bool is_whole = codes.size() == count && fell_back.size() == count && figures.ndim() == 2 &&
                        figures.shape(0) == rows &&
                        figures.shape(1) == py::ssize_t{row_figures.size()} &&
                        expanded.ndim() == 1 && expanded.shape(0) == rows;
  const auto damaged = [] {
    raise(PlanError::invalid_input, "the pickle of this batch is damaged");
  };
  if (!is_whole) damaged();
  const double* figure = figures.data();
  for (std::size_t i = 0; i < count; ++i) {
    const auto code = static_cast<unsigned char>(codes[i]);
    if (code != planned_code && code > static_cast<unsigned char>(last_code)) damaged();
    ResultRow& row = batch.rows.emplace_back();
    row.is_planned = code == planned_code;
    if (!row.is_planned) row.code = static_cast<PlanError>(code);
    row.fell_back = fell_back[i] != 0;
    for (const auto member : row_figures) row.*member = *figure++;
    row.expanded = expanded.data()[i];
  }
  for (const py::handle result : state[8]) batch.plans.emplace_back(result_of(result));
  if (!batch.plans.empty() && batch.plans.size() != count) damaged();
  for (std::size_t i = 0; i < batch.plans.size(); ++i) {
    const bool is_planned = batch.plans[i]->has_value();
    if (is_planned != batch.rows[i].is_planned ||
        (!is_planned && batch.plans[i]->error().code != batch.rows[i].code)) {
      damaged();
    }
  }
  return batch;
}

void bind_results_of_batch(py::module_& m) {
  py::class_<BatchHandle> batch(m, "Batch", R"(The results of many queries, in their order.

batch[i] is the Plan of query i, or its exception, which is not raised. The columns are arrays of
one figure per query, NaN where there is no plan. Pickles hold everything but the space.)");
  const auto column = [&](const char* name, double ResultRow::*figure, const char* doc) {
    batch.def_property_readonly(
        name, [figure](const BatchHandle& self) { return figures(self, figure); }, doc);
  };
  column("length", &ResultRow::length, "[m]");
  column("clearance_lower", &ResultRow::clearance_lower, "The proved lower bound [m].");
  column("clearance_upper", &ResultRow::clearance_upper, "The proved upper bound [m].");
  column("turning_angle", &ResultRow::turning_angle, "[rad]");
  column("max_curvature", &ResultRow::max_curvature, "[1/m]");
  batch.def("__len__", [](const BatchHandle& self) { return self.rows.size(); })
      .def("__getitem__", &result_at, "index"_a)
      .def_property_readonly(
          "planned",
          [](const BatchHandle& self) {
            py::array_t<bool> array(static_cast<py::ssize_t>(self.rows.size()));
            bool* data = array.mutable_data();
            for (const ResultRow& row : self.rows) *data++ = row.is_planned;
            return array;
          },
          "Whether each query has a plan: an array of bools.")
      .def_property_readonly(
          "status",
          [](const BatchHandle& self) {
            std::vector<std::string> names;
            for (const ResultRow& row : self.rows) names.push_back(status_of(row));
            return names;
          },
          "\"planned\" or the code of the failure, a list.")
      .def("_lines", &lines_of, "first"_a)
      .def(py::pickle(&batch_state, &batch_of))
      .def("__repr__", [](const BatchHandle& self) {
        std::size_t planned = 0;
        for (const ResultRow& row : self.rows) planned += row.is_planned ? 1 : 0;
        return "<Batch of " + std::to_string(self.rows.size()) + " queries, " +
               std::to_string(planned) + " planned>";
      });
  m.attr("_result_header") = std::string(batch_program::result_header);
  m.def(
      "_count_results",
      [](const py::bytes& bytes) {
        const auto progress =
            value_or_raise(batch_program::count_results(static_cast<std::string>(bytes)));
        return py::make_tuple(progress.results, progress.bytes);
      },
      "text"_a);
}

template <class Get>
Numbers headings_of(const QueriesHandle& self, const Get& get) {
  return make_column(self.queries.size(), [&](std::size_t i) {
    return get(self.queries[i]).value_or(std::numeric_limits<double>::quiet_NaN());
  });
}

QueriesHandle part_of(const QueriesHandle& self, const py::slice& slice) {
  std::size_t start = 0, stop = 0, step = 0, count = 0;
  if (!slice.compute(self.queries.size(), &start, &stop, &step, &count)) {
    throw py::error_already_set();
  }
  QueriesHandle part;
  for (std::size_t i = 0; i < count; ++i) part.queries.push_back(self.queries[start + i * step]);
  return part;
}

void bind_queries(py::module_& m) {
  const auto points = [](const QueriesHandle& self, Point Query::*end) {
    return make_points(self.queries.size(),
                       [&](std::size_t i) -> const Point& { return self.queries[i].*end; });
  };
  const auto seeds_of = [](const QueriesHandle& self) {
    py::array_t<std::uint64_t> array(static_cast<py::ssize_t>(self.queries.size()));
    std::uint64_t* data = array.mutable_data();
    for (const Query& query : self.queries) *data++ = query.seed;
    return array;
  };
  py::class_<QueriesHandle>(m, "Queries", R"(Starts and goals of many queries.

starts, goals: arrays of shape (n, 2) [m].
start_headings, goal_headings: arrays of shape (n,) [rad], NaN: any; or None.
seeds: an array of n whole numbers, or None.

`Queries.from_csv` reads them from a file. Raises InvalidInput for other shapes and dtypes.)")
      .def(py::init([](const py::object& starts, const py::object& goals,
                       const py::object& start_headings, const py::object& goal_headings,
                       const py::object& seeds) {
             return QueriesHandle{to_queries(starts, goals, start_headings, goal_headings, seeds)};
           }),
           "starts"_a, "goals"_a, "start_headings"_a = py::none(), "goal_headings"_a = py::none(),
           "seeds"_a = py::none())
      .def_static(
          "_parse",
          [](const std::string& text) {
            return QueriesHandle{value_or_raise(batch_program::parse_queries(text))};
          },
          "text"_a)
      .def("__len__", [](const QueriesHandle& self) { return self.queries.size(); })
      .def("__getitem__", &part_of, "part"_a)
      .def_property_readonly(
          "starts", [points](const QueriesHandle& self) { return points(self, &Query::start); },
          "(n, 2) [m].")
      .def_property_readonly(
          "goals", [points](const QueriesHandle& self) { return points(self, &Query::goal); },
          "(n, 2) [m].")
      .def_property_readonly(
          "start_headings",
          [](const QueriesHandle& self) {
            return headings_of(self, [](const Query& query) { return query.start_heading; });
          },
          "(n,) [rad], NaN: any.")
      .def_property_readonly(
          "goal_headings",
          [](const QueriesHandle& self) {
            return headings_of(self, [](const Query& query) { return query.goal_heading; });
          },
          "(n,) [rad], NaN: any.")
      .def_property_readonly("seeds", seeds_of, "(n,)")
      .def(py::pickle(
          [seeds_of, points](const QueriesHandle& self) {
            return pickle_head("Queries") +
                   py::make_tuple(
                       points(self, &Query::start), points(self, &Query::goal),
                       headings_of(self, [](const Query& query) { return query.start_heading; }),
                       headings_of(self, [](const Query& query) { return query.goal_heading; }),
                       seeds_of(self));
          },
          [](const py::tuple& state) {
            check_pickle(state, "Queries", 8);
            return QueriesHandle{to_queries(state[3], state[4], state[5], state[6], state[7])};
          }));
}

}  // namespace

std::vector<Query> to_queries(const py::object& starts, const py::object& goals,
                              const py::object& start_headings, const py::object& goal_headings,
                              const py::object& seeds) {
  const Numbers from = to_table(starts, 2, "starts"), to = to_table(goals, 2, "goals");
  if (from.shape(0) != to.shape(0)) {
    raise(PlanError::invalid_input, "starts and goals: expected as many of both, got " +
                                        std::to_string(from.shape(0)) + " and " +
                                        std::to_string(to.shape(0)));
  }
  const auto count = static_cast<std::size_t>(from.shape(0));
  std::vector<Query> queries(count);
  for (std::size_t i = 0; i < count; ++i) {
    queries[i].start = {from.data()[2 * i], from.data()[2 * i + 1]};
    queries[i].goal = {to.data()[2 * i], to.data()[2 * i + 1]};
  }
  const auto add_headings = [&](const py::object& given, const char* name, auto member) {
    if (given.is_none()) return;
    const Numbers headings = to_column(given, from.shape(0), name);
    for (std::size_t i = 0; i < count; ++i) {
      const double heading = headings.data()[i];
      if (!std::isnan(heading)) queries[i].*member = heading;
    }
  };
  add_headings(start_headings, "start_headings", &Query::start_heading);
  add_headings(goal_headings, "goal_headings", &Query::goal_heading);
  if (seeds.is_none()) return queries;
  const py::array array = py::array::ensure(seeds);
  const char kind = array ? array.dtype().kind() : 'O';
  if ((kind != 'u' && kind != 'i') || array.ndim() != 1 || array.shape(0) != from.shape(0)) {
    raise(PlanError::invalid_input,
          "seeds: expected an array of shape (" + std::to_string(count) + ",) of whole numbers");
  }
  if (kind == 'i' && array.attr("min")(py::arg("initial") = 0).cast<std::int64_t>() < 0) {
    raise(PlanError::invalid_input, "seeds: expected whole numbers that are not negative");
  }
  const auto numbers =
      py::array_t<std::uint64_t, py::array::c_style | py::array::forcecast>::ensure(array);
  for (std::size_t i = 0; i < count; ++i) queries[i].seed = numbers.data()[i];
  return queries;
}

void bind_batch(py::module_& m) {
  bind_queries(m);
  bind_results_of_batch(m);
}

}  // namespace tutavia_python
