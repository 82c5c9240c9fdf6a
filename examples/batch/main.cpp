// SPDX-License-Identifier: MIT
/// \file
/// tutavia-batch: plans the queries of a CSV file on all cores, into a CSV file that a restart
/// completes.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <iostream>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "job.hpp"
#include "plan/input.hpp"
#include "plan/input_options.hpp"
#include "plan/names.hpp"
#include "plan/planning_space.hpp"
#include "plan/run_program.hpp"
#include "progress_bar.hpp"
#include "queries.hpp"
#include "result_row.hpp"
#include "results_file.hpp"
#include "tutavia/core/parts/number_text.hpp"
#include "tutavia/core/parts/parallel.hpp"
#include "tutavia/io/text/read_file.hpp"

namespace batch_program {

namespace {

using plan_program::Arguments;
using plan_program::Choices;
using plan_program::Task;
using plan_program::UsageError;

struct BatchArguments {
  Arguments input{.program = "tutavia-batch", .search = "astar", .smoother = "clothoid"};
  std::string queries{};
  std::string results{};
  unsigned threads = 0;
};

/// Nothing for --help, which it prints. Throws UsageError.
std::optional<BatchArguments> parse_command_line(int argc, const char* const* argv) {
  CLI::App app{
      "Plans the queries of a CSV file on all cores. Results are appended to a CSV file in the "
      "order of the queries; after an interruption the same command completes it.",
      "tutavia-batch"};
  app.footer(
      "QUERIES has the columns start_x, start_y, goal_x, goal_y in metres and, if need be, "
      "start_heading and goal_heading in radians and seed.");
  BatchArguments args;
  app.add_option("QUERIES", args.queries, "The CSV file of queries");
  app.add_option("--results", args.results, "The CSV file of results");
  app.add_option("--threads", args.threads, "Threads; default: one per core");
  app.add_option("--search", args.input.search,
                 "Search, with options as NAME:OPTION=VALUE,... Default: astar");
  app.add_option("--smoother", args.input.smoother,
                 "Smoother, with options as for --search; A+B is a pipeline. Default: clothoid");
  plan_program::define_input_options(app, args.input);
  if (!plan_program::parse(app, argc, argv)) return std::nullopt;
  if (args.queries.empty()) throw UsageError{"give the CSV file of queries"};
  if (args.results.empty()) throw UsageError{"give --results FILE"};
  return args;
}

/// Loads the map. Bounds that it does not have are laid around all queries.
Task load(Arguments args, std::span<const Query> queries) {
  if (args.buffer) throw UsageError{"--buffer is for single queries; give --radius R"};
  Box box = queries.empty() ? Box::around({Point::Zero()}) : Box{};
  for (const Query& query : queries) {
    box.include(query.start);
    box.include(query.goal);
  }
  const auto text = [](const Point& p) {
    return tutavia::detail::number_text(p.x()) + "," + tutavia::detail::number_text(p.y());
  };
  args.start = text(box.min);
  args.goals = {text(box.max)};
  return plan_program::load_task(args);
}

/// One search and one smoother.
Choices choose(const BatchArguments& args, const Task& task) {
  Choices choices = plan_program::parse_choices(args.input, plan_program::vehicle_names());
  if (choices.searches.size() != 1 || choices.smoothers.size() != 1) {
    throw UsageError{"--search and --smoother: give one of each"};
  }
  plan_program::check_choices(choices, args.input.vehicle,
                              std::holds_alternative<CellSpace>(task.space));
  return choices;
}

std::string algorithms_of(const Choices& choices, const Arguments& args) {
  std::string text =
      algorithms_text(choices.searches.front().stages.front(), choices.smoothers.front().stages);
  if (plan_program::unknown_cost(args)) text.append(", unknown ").append(args.unknown);
  return text;
}

/// The space with all that its answers depend on.
std::string space_text(const Task& task) {
  std::string text = std::visit([](const auto& known) { return digest_of(known); }, task.space);
  if (task.frame.is_turned()) {
    const Point origin = task.frame.to_map(Point::Zero());
    text.append(" turned ")
        .append(Digest().add(origin.x()).add(origin.y()).add(task.frame.yaw()).text());
  }
  if (task.costs != nullptr) text.append(" costs ").append(digest_of(*task.costs));
  return text;
}

/// The queries in the frame of the grid, which is another one than the map's if that is turned.
std::vector<Query> to_grid(const Task& task, std::vector<Query> queries) {
  if (!task.frame.is_turned()) return queries;
  for (Query& query : queries) {
    plan_program::MapFrame frame = task.frame;  // it keeps the points that it converts
    query.start = frame.to_grid(query.start);
    query.goal = frame.to_grid(query.goal);
    if (query.start_heading) query.start_heading = frame.heading_to_grid(*query.start_heading);
    if (query.goal_heading) query.goal_heading = frame.heading_to_grid(*query.goal_heading);
  }
  return queries;
}

std::vector<ResultRow> plan_block(const Task& task, const BatchArguments& args,
                                  const Choices& choices, std::span<const Query> queries) {
  std::vector<ResultRow> rows(queries.size());
  tutavia::detail::for_each_in_parallel(queries.size(), args.threads, [&] {
    return
        [&, planner = plan_program::make_planner(task.space, task.costs, choices.searches.front(),
                                                 choices.smoothers.front(), args.input.vehicle)](
            std::size_t i) { rows[i] = to_row(planner.plan(queries[i], nullptr)); };
  });
  return rows;
}

/// Throws a UsageError if the choices do not fit the queries, such as headings and a search that
/// plans none: every query is refused then, each with the same detail.
void check_options(const Task& task, const BatchArguments& args, const Choices& choices,
                   std::span<const Query> queries, std::span<const ResultRow> rows) {
  const bool all_refused = std::all_of(rows.begin(), rows.end(), [](const ResultRow& row) {
    return !row.is_planned && row.code == PlanError::invalid_option;
  });
  if (rows.empty() || !all_refused) return;
  const auto planner = plan_program::make_planner(task.space, task.costs, choices.searches.front(),
                                                  choices.smoothers.front(), args.input.vehicle);
  plan_program::value_or_throw(planner.plan(queries.front(), nullptr));
}

int run(const BatchArguments& args) {
  const std::vector<Query> queries =
      plan_program::value_or_throw(tutavia::detail::read_file(args.queries, &parse_queries));
  const Task task = load(args.input, queries);
  const Choices choices = choose(args, task);
  ResultsFile results(args.results,
                      describe_job(algorithms_of(choices, args.input), space_text(task), queries));
  const std::vector<Query> in_grid = to_grid(task, queries);
  // Memory of planners is warm after the first queries of a block.
  constexpr std::size_t block = 8192;
  std::size_t done = results.done();
  std::size_t planned = 0, first = done;
  {
    ProgressBar bar(done, queries.size());
    while (done < queries.size()) {
      const std::size_t count = std::min(block, queries.size() - done);
      const auto block_queries = std::span(in_grid).subspan(done, count);
      const auto rows = plan_block(task, args, choices, block_queries);
      if (done == 0) check_options(task, args, choices, block_queries, rows);
      std::string lines;
      for (std::size_t i = 0; i < count; ++i) {
        append_line(lines, done + i, queries[done + i], rows[i]);
        planned += rows[i].is_planned ? 1 : 0;
      }
      results.append(lines);
      bar.show(done += count);
    }
  }
  if (first > 0) std::cout << first << " results were there, ";
  std::cout << done - first << " queries planned or refused, " << planned << " plans\n";
  return 0;
}

}  // namespace

}  // namespace batch_program

int main(int argc, char** argv) {
  return plan_program::run_program("tutavia-batch", [&] {
    const auto args = batch_program::parse_command_line(argc, argv);
    return args ? batch_program::run(*args) : 0;
  });
}
