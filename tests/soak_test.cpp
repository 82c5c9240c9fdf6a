// SPDX-License-Identifier: MIT
/// \file
/// The program tutavia-soak: its worlds, its judge and its ledger.
#include <string>
#include <vector>

#include "soak/ledger.hpp"
#include "soak/world_judge.hpp"
#include "support/catch.hpp"
#include "support/same_obstacles.hpp"

namespace {

using namespace tutavia;
using test::Row;
using test::Tally;

TEST_CASE("a numbered world is the same however it is reached") {
  const auto draw = [](std::uint64_t k) { return test::numbered_world(k); };
  test::WorldJudge in_order, one_late;
  std::uint64_t plans = 0;
  for (std::uint64_t k = 0; k < 12; ++k) plans += in_order.judge(k).plans;
  CHECK(plans > 12);
  for (std::uint64_t k = 12; k < 18; ++k) {
    CAPTURE(k);
    const auto first = draw(k);
    draw(k + 1);
    const auto again = draw(k);
    CHECK(test::same_obstacles(first.world.obstacles, again.world.obstacles));
    CHECK(first.world.safety_radius == again.world.safety_radius);
    CHECK(first.query.start == again.query.start);
    CHECK(first.query.goal != draw(k + 1).query.goal);
    const Tally a = in_order.judge(k), b = one_late.judge(k);  // scratch memory of others or none
    CHECK(a.plans == b.plans);
    CHECK(a.pieces == b.pieces);
    CHECK(a.free == b.free);
    CHECK(a.findings == b.findings);
  }
}

TEST_CASE("the judge of worlds finds wrong plans") {
  const Workspace world{
      .bounds = {{0, 0}, {10, 10}}, .safety_radius = 1, .obstacles = {Disc{{5, 5}, 1}}};
  const auto findings = [&](const Point& a, const Point& b, double lower) {
    Tally tally;
    const Point points[] = {a, b};
    test::judge_curve(world, {.start = {1, 2}, .goal = {9, 2}}, Curve::polyline(points), lower, "x",
                      tally);
    CHECK(tally.plans == 1);
    CHECK(tally.pieces == 1);
    CHECK(tally.free + tally.blocked == 1);
    return tally.findings;
  };
  using Findings = std::vector<std::string>;
  CHECK(findings({1, 2}, {9, 2}, 2).empty());
  CHECK(findings({1, 2}, {9, 2}, 2.001) ==
        Findings{"x: the certificate says more than the clearance"});
  CHECK(findings({1, 2}, {9, 2.5}, 1) == Findings{"x: the ends are not exact"});
  CHECK(findings({1, 2}, {9, 8}, 1) ==
        Findings{"x: the ends are not exact", "x: the curve is blocked"});
}

TEST_CASE("leaving out obstacles far from arcs changes no verdict") {
  const std::uint64_t seed = 400;
  test::WorldGenerator worlds(seed);
  Random& random = worlds.random();
  std::size_t free = 0, blocked = 0, smaller = 0;
  for (int round = 0; round < 100; ++round) {
    INFO("seed " << seed << ", round " << round);
    const Workspace world = worlds.workspace();
    const Arc arc = Arc::around(worlds.point(world), 0.1 * world.bounds.width() * random.uniform(),
                                random.uniform(-4, 4), random.uniform(-6, 6));
    Curve curve;
    curve.push_back(arc);
    const auto verdict = test::ExactChecker(world).check(curve);
    CHECK(test::exact_verdict(world, curve) == verdict);
    ++(verdict == test::ExactVerdict::free ? free : blocked);
    if (test::near_arc(world, arc).obstacles.size() < world.obstacles.size()) ++smaller;
  }
  CHECK(free > 15);
  CHECK(blocked > 15);
  CHECK(smaller > 60);
}

const std::string ledger =
    "# Evidence\n\n## Worlds\n\nText.\n\n"
    "| revision | compiler | worlds | plans | pieces | free | unknown | blocked | findings | CPU "
    "|\n"
    "|---|---|---|---|---|---|---|---|---|---|\n"
    "| a | GNU | 0-99 | 10 | 20 | 9 | 1 | 0 | 0 | 1.50 |\n"
    "| b | GNU | 0-9 | 1 | 2 | 1 | 0 | 0 | 0 | 0.10 |\n\n"
    "## Fuzz targets\n\n| target | revision | runs | time [min] | findings "
    "|\n|---|---|---|---|---|\n";

TEST_CASE("rows of one revision and compiler add up, and other rows stay") {
  const auto add = [](const std::string& text, const Row& row) {
    return test::add_to_ledger(text, test::world_heading, test::world_columns, {row});
  };
  const auto replaced = [](std::string text, const std::string& old, const std::string& now) {
    return text.replace(text.find(old), old.size(), now);
  };
  const auto sum = add(ledger, {"a", "GNU", "100-149", "5", "6", "4", "1", "0", "2", "0.25"});
  const std::string old = "| a | GNU | 0-99 | 10 | 20 | 9 | 1 | 0 | 0 | 1.50 |\n";
  const std::string now = "| a | GNU | 0-149 | 15 | 26 | 13 | 2 | 0 | 2 | 1.75 |\n";
  CHECK(sum.value() == replaced(ledger, old, now));
  const auto gap = add(ledger, {"a", "GNU", "200-299", "0", "0", "0", "0", "0", "0", "0.00"});
  CHECK(gap.value() == replaced(ledger, "0-99 |", "0-99, 200-299 |"));
  const auto filled = add(*gap, {"a", "GNU", "100-199", "0", "0", "0", "0", "0", "0", "0.00"});
  CHECK(filled.value() == replaced(ledger, "0-99 |", "0-299 |"));
  // Another compiler is another row, whatever its worlds.
  const auto other = add(ledger, {"a", "Clang", "0-99", "1", "1", "1", "0", "0", "0", "0.01"});
  CHECK(other.value() == replaced(ledger, "0.10 |\n",
                                  "0.10 |\n| a | Clang | 0-99 | 1 | 1 | 1 | 0 | 0 | 0 | 0.01 |\n"));
}

TEST_CASE("a run goes on after all worlds of the ledger") {
  const auto read = test::read_ledger(ledger, test::world_heading, test::world_columns);
  CHECK(test::world_after(read.value().rows) == 100);
  CHECK(test::world_after({{"a", "GNU", "0-9, 50-299"}, {"b", "GNU", "10-49"}}) == 300);
  CHECK(test::world_after({}) == 0);
}

TEST_CASE("no world counts twice, and a ledger without the table is refused") {
  const Row row{"a", "GNU", "99-120", "1", "1", "1", "0", "0", "0", "0.01"};
  const auto twice = test::add_to_ledger(ledger, test::world_heading, test::world_columns, {row});
  REQUIRE_FALSE(twice);
  CHECK(twice.error().detail == "worlds 99-120 were counted before, in 0-99");
  CHECK_FALSE(test::add_to_ledger("# Evidence\n", test::world_heading, test::world_columns, {row}));
  CHECK_FALSE(test::add_to_ledger(ledger, test::fuzz_heading, test::world_columns, {row}));
  CHECK_FALSE(test::add_to_ledger(ledger + "| wkt | a |\n", test::fuzz_heading, test::fuzz_columns,
                                  {{"wkt", "a", "1", "1", "1"}}));
}

TEST_CASE("a run of libFuzzer becomes a row") {
  const std::string stats =
      "stat::number_of_executed_units: 5000\nstat::average_exec_per_sec: 100\n";
  const auto done = test::fuzz_row("wkt", "a", "Done 5000 runs in 61 second(s)\n" + stats);
  CHECK(done.value() == Row{"wkt", "a", "5000", "1.02", "0"});
  const auto crash =
      test::fuzz_row("wkt", "a", "artifact_prefix='./'; Test unit written to ./crash-1\n" + stats);
  CHECK(crash.value() == Row{"wkt", "a", "5000", "0.83", "1"});
  CHECK_FALSE(test::fuzz_row("wkt", "a", "#1 INITED\n"));
  const auto text =
      test::add_to_ledger(ledger, test::fuzz_heading, test::fuzz_columns, {*done, *crash});
  CHECK(text.value() == ledger + "| wkt | a | 10000 | 1.85 | 1 |\n");
}

}  // namespace
