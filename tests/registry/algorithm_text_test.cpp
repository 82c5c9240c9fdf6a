// SPDX-License-Identifier: MIT
#include "tutavia/registry/algorithm_text.hpp"

#include "support/catch.hpp"

namespace {

using namespace tutavia;

/// What was read, in one line: algorithms by ';', stages by '+', options in brackets.
std::string read(const std::string& text) {
  const auto parsed = parse_algorithms(text);
  if (!parsed) {
    CHECK(parsed.error().code == PlanError::invalid_option);
    return "error: " + parsed.error().detail;
  }
  std::string line;
  for (const PipelineText& pipeline : *parsed) {
    if (!line.empty()) line += ';';
    for (const AlgorithmText& stage : pipeline.stages) {
      if (&stage != &pipeline.stages.front()) line += '+';
      line += stage.name;
      for (const OptionText& option : stage.options) {
        line += '[' + option.name + '|' + option.text + ']';
      }
    }
  }
  return line;
}

TEST_CASE("lists and pipelines are read with the options of each stage") {
  CHECK(read("astar") == "astar");
  CHECK(read("astar,jps") == "astar;jps");
  CHECK(read("rrt_star:max_iterations=5000,goal_bias=0.1") ==
        "rrt_star[max_iterations|5000][goal_bias|0.1]");
  CHECK(read("astar:heuristic=euclidean,jps,rrt_star:max_iterations=5000,goal_bias=0.1,rrt") ==
        "astar[heuristic|euclidean];jps;rrt_star[max_iterations|5000][goal_bias|0.1];rrt");
  CHECK(read("shortcut+bezier:trim=0.5,delta") == "shortcut+bezier[trim|0.5];delta");
  CHECK(read("bezier:trim=0.5,fullness=0.6+delta:join=paper,none") ==
        "bezier[trim|0.5][fullness|0.6]+delta[join|paper];none");
  CHECK(read("a:x=1,b:y=2") == "a[x|1];b[y|2]");
}

TEST_CASE("a plus within a number joins no stages") {
  CHECK(read("bezier:trim=1e+5+delta") == "bezier[trim|1e+5]+delta");
  CHECK(read("bezier:trim=+5") == "bezier[trim|+5]");
}

TEST_CASE("empty names and values are kept for those who know what is allowed") {
  CHECK(read("") == "");
  CHECK(parse_algorithms("").value().size() == 1);
  CHECK(read("astar,") == "astar;");
  CHECK(read("taut_string+") == "taut_string+");
  CHECK(read("+bezier") == "+bezier");
  CHECK(read("a:x=") == "a[x|]");
  CHECK(read("a:x=1=2") == "a[x|1=2]");
  CHECK(read(":x=1") == "[x|1]");
}

TEST_CASE("options without a name, a value or an algorithm are refused") {
  CHECK(read("a:") == "error: a: expected OPTION=VALUE, got \"\"");
  CHECK(read("a:x") == "error: a: expected OPTION=VALUE, got \"x\"");
  CHECK(read("a:=1") == "error: a: expected OPTION=VALUE, got \"=1\"");
  CHECK(read("a:x=1,=2") == "error: a: expected OPTION=VALUE, got \"=2\"");
  CHECK(read("x=1") == "error: expected NAME:OPTION=VALUE, got \"x=1\"");
  CHECK(read("a,x=1") == "error: expected NAME:OPTION=VALUE, got \"a,x=1\"");
  CHECK(read("a:x=1,b,y=2") == "error: expected NAME:OPTION=VALUE, got \"b,y=2\"");
  CHECK(read("a:x=1+b,y=2") == "error: expected NAME:OPTION=VALUE, got \"b,y=2\"");
}

TEST_CASE("each algorithm keeps the text that stands for it") {
  const auto parsed =
      parse_algorithms("delta:join=paper,shortcut+bezier:trim=1,fullness=1").value();
  REQUIRE(parsed.size() == 2);
  CHECK(parsed[0].text == "delta:join=paper");
  CHECK(parsed[0].name() == "delta");
  CHECK(parsed[1].text == "shortcut+bezier:trim=1,fullness=1");
  CHECK(parsed[1].name() == "shortcut+bezier");
  CHECK(parsed[1].stages[1].text == "bezier:trim=1,fullness=1");
}

}  // namespace
