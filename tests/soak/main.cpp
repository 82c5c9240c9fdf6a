// SPDX-License-Identifier: MIT
/// \file
/// tutavia-soak: judges random worlds by their numbers, resumes where it stopped, and keeps the
/// ledger docs/evidence.md.

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <thread>

#include "soak/ledger.hpp"
#include "soak/world_judge.hpp"

namespace {

using namespace tutavia;
using test::Row;
using test::Tally;

struct Arguments {
  std::optional<std::uint64_t> worlds, only;
  std::optional<double> seconds;
  std::string state = TUTAVIA_SOAK_STATE, ledger, revision, fuzz_target, stats;
  unsigned jobs = 1;
};

/// What a killed run leaves behind: the next world, and rows that are in no ledger yet.
struct State {
  std::uint64_t next = 0;
  std::vector<Row> rows;
};

std::string read(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) throw std::runtime_error(path + " cannot be read");
  return text;
}

/// The old file or the new one is there at any time.
void write(const std::string& path, const std::string& text) {
  {
    std::ofstream out(path + ".new", std::ios::binary);
    out << text << std::flush;
    if (!out) throw std::runtime_error(path + ".new cannot be written");
  }
  std::filesystem::rename(path + ".new", path);
}

State read_state(const std::string& path) {
  if (!std::filesystem::exists(path)) return {};
  const auto json = nlohmann::json::parse(read(path));
  return {json.at("next").get<std::uint64_t>(), json.at("rows").get<std::vector<Row>>()};
}

void write_state(const std::string& path, const State& state) {
  write(path, nlohmann::json{{"next", state.next}, {"rows", state.rows}}.dump(1) + "\n");
}

/// The last commit that changed what is judged or how, so that a commit of the ledger is no new
/// revision; "-dirty" if files differ from it.
std::string revision_of_sources() {
  constexpr const char* command =
      "cd '" TUTAVIA_SOURCE_DIR
      "' && set -- include tests/soak tests/support && "
      "git describe --always --abbrev=10 \"$(git log -1 --format=%H -- \"$@\")\" && "
      "{ git diff --quiet HEAD -- \"$@\" || echo -dirty; }";
  std::string revision;
  std::FILE* pipe = popen(command, "r");
  for (int c; pipe != nullptr && (c = std::fgetc(pipe)) != EOF;) {
    if (c != '\n') revision.push_back(static_cast<char>(c));
  }
  if (pipe == nullptr || pclose(pipe) != 0) {
    throw std::runtime_error("git names no revision; name one with --revision");
  }
  return revision;
}

/// Where to go on. No world of the ledger is judged again, not even in a new build folder.
State resume(const Arguments& args) {
  State state = read_state(args.state);
  if (args.ledger.empty()) return state;
  const auto ledger =
      test::read_ledger(read(args.ledger), test::world_heading, test::world_columns);
  if (!ledger) throw std::runtime_error(args.ledger + ": " + ledger.error().detail);
  state.next = std::max(state.next, test::world_after(ledger->rows));
  return state;
}

void update_ledger(const std::string& path, std::string_view heading,
                   std::span<const test::Column> columns, const std::vector<Row>& rows) {
  const auto text = test::add_to_ledger(read(path), heading, columns, rows);
  if (!text) throw std::runtime_error(path + ": " + text.error().detail);
  write(path, *text);
}

/// The worlds [first, first + count), in an order that does not depend on the number of threads.
Tally judge(std::vector<test::WorldJudge>& judges, std::uint64_t first, std::uint64_t count) {
  std::vector<Tally> tallies(count);
  std::atomic<std::uint64_t> next = 0;
  const auto work = [&](test::WorldJudge& judge) {
    for (std::uint64_t i; (i = next++) < count;) tallies[i] = judge.judge(first + i);
  };
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 1; i < judges.size(); ++i) threads.emplace_back(work, std::ref(judges[i]));
    work(judges[0]);
  }
  Tally sum;
  for (const Tally& tally : tallies) sum.add(tally);
  return sum;
}

Row world_row(const Arguments& args, std::uint64_t first, std::uint64_t next, const Tally& sum) {
  const double seconds = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  const auto text = [](std::uint64_t number) { return std::to_string(number); };
  return {args.revision,         TUTAVIA_SOAK_COMPILER, text(first) + "-" + text(next - 1),
          text(sum.plans),       text(sum.pieces),      text(sum.free),
          text(sum.unknown),     text(sum.blocked),     text(sum.findings.size()),
          test::minutes(seconds)};
}

/// The state after the worlds [state.next, next).
State after(State state, const Arguments& args, std::uint64_t next, const Tally& sum) {
  if (next == state.next) return state;
  const Row row = world_row(args, state.next, next, sum);
  if (auto added = test::add_row(state.rows, test::world_columns, row); !added) {
    throw std::runtime_error(args.state + ": " + added.error().detail);
  }
  state.next = next;
  return state;
}

/// The number of findings.
std::size_t soak(const Arguments& args) {
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;
  const auto begin = Clock::now();
  auto saved = begin;
  const State before = resume(args);
  const std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max() - before.next;
  const std::uint64_t worlds = args.worlds.value_or(args.seconds ? unlimited : 1000);
  std::vector<test::WorldJudge> judges(args.jobs);
  std::uint64_t next = before.next;
  Tally sum;
  while (next - before.next < worlds &&
         Seconds(Clock::now() - begin).count() < args.seconds.value_or(1e18)) {
    const std::uint64_t left = worlds - (next - before.next);
    const std::uint64_t count = std::min<std::uint64_t>(left, std::uint64_t{16} * args.jobs);
    const Tally block = judge(judges, next, count);
    for (const std::string& finding : block.findings) std::cout << finding << std::endl;
    sum.add(block);
    next += count;
    if (isatty(STDERR_FILENO) != 0) {
      std::cerr << "\rworld " << next << ", " << sum.plans << " plans, " << sum.findings.size()
                << " findings" << std::flush;
    }
    if (Seconds(Clock::now() - saved).count() > 5) {
      write_state(args.state, after(before, args, next, sum));
      saved = Clock::now();
    }
  }
  State state = after(before, args, next, sum);
  write_state(args.state, state);
  if (!args.ledger.empty()) {
    update_ledger(args.ledger, test::world_heading, test::world_columns, state.rows);
    state.rows.clear();
    write_state(args.state, state);
  }
  std::cout << "worlds " << before.next << " to " << next << ": " << sum.plans << " plans, "
            << sum.pieces << " pieces, " << sum.free << " free, " << sum.unknown << " unknown, "
            << sum.blocked << " blocked, " << sum.findings.size() << " findings\n";
  return sum.findings.size();
}

std::size_t judge_one(std::uint64_t number) {
  const Tally tally = test::WorldJudge().judge(number);
  for (const std::string& finding : tally.findings) std::cout << finding << '\n';
  std::cout << "world " << number << ": " << tally.plans << " plans, " << tally.findings.size()
            << " findings\n";
  return tally.findings.size();
}

std::size_t add_fuzz_row(const Arguments& args) {
  const auto row = test::fuzz_row(args.fuzz_target, args.revision, read(args.stats));
  if (!row) throw std::runtime_error(args.stats + " has no statistics (-print_final_stats=1)");
  update_ledger(args.ledger, test::fuzz_heading, test::fuzz_columns, {*row});
  return std::stoull(row->back());
}

void add_options(CLI::App& app, Arguments& args) {
  app.add_option("--worlds", args.worlds,
                 "How many more worlds. Default: 1000, or no limit with --seconds");
  app.add_option("--seconds", args.seconds, "Stop after this time");
  app.add_option("--state", args.state, "Resume from this file")->capture_default_str();
  auto* ledger = app.add_option("--ledger", args.ledger, "Add the row to this ledger");
  app.add_option("--revision", args.revision, "Default: the last commit that changed the sources");
  app.add_option("--jobs", args.jobs, "Threads")->check(CLI::Range(1, 1024));
  app.add_option("--only", args.only, "Judge the world of this number alone, without state");
  auto* fuzz = app.add_option("--fuzz-row", args.fuzz_target,
                              "Add a run of this fuzz target to the ledger instead");
  auto* stats = app.add_option("--stats", args.stats, "What libFuzzer printed in that run");
  fuzz->needs(stats)->needs(ledger);
  stats->needs(fuzz);
}

}  // namespace

/// Ends with 1 if there are findings, with 2 if the run failed.
int main(int argc, char** argv) {
  Arguments args;
  CLI::App app{"Judges the plans of all smoothers through random worlds by exact arithmetic."};
  add_options(app, args);
  try {
    app.parse(argc, argv);
    if (args.only) return judge_one(*args.only) > 0 ? 1 : 0;
    if (args.revision.empty()) args.revision = revision_of_sources();
    return (args.fuzz_target.empty() ? soak(args) : add_fuzz_row(args)) > 0 ? 1 : 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::cerr << "tutavia-soak: " << error.what() << '\n';
  }
  return 2;
}
