// SPDX-License-Identifier: MIT
#include "tutavia/io/trace_json.hpp"

#include <sstream>
#include <string>
#include <vector>

#include "support/catch.hpp"

namespace {

using namespace tutavia;
using Json = nlohmann::json;

std::vector<Json> lines_of(const std::string& text) {
  std::vector<Json> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(Json::parse(line));
  return lines;
}

const ResultHeader trace_header{"rea_star", "none", {1, 2}, {3, 0.1}, 0.25};

TEST_CASE("a search without events is one line that says what was asked and what came of it") {
  std::string text;
  append_trace(text, trace_header, "unreachable", {});
  const auto lines = lines_of(text);
  REQUIRE(lines.size() == 1);
  CHECK(lines[0] == Json{{"event", "search"},
                         {"search", "rea_star"},
                         {"status", "unreachable"},
                         {"start", {1.0, 2.0}},
                         {"goal", {3.0, 0.1}},
                         {"safety_radius", 0.25}});
}

TEST_CASE("every event is a line with its kind and its points, in order, behind what is there") {
  SearchRecord record;
  record.generated({1, 2});
  record.expanded({3, 4});
  record.on_rectangle({{0, 0}, {2, 0}}, {{0, 0}, {2, 5}}, SearchSide::goal);
  record.edge({1, 1}, {2, 3});
  std::string text = "{\"event\":\"before\"}\n";
  append_trace(text, trace_header, "success", record);
  const auto lines = lines_of(text);
  REQUIRE(lines.size() == 7);
  CHECK(lines[0]["event"] == "before");
  CHECK(lines[2] == Json{{"event", "generated"}, {"at", {1.0, 2.0}}});
  CHECK(lines[3] == Json{{"event", "expanded"}, {"at", {3.0, 4.0}}});
  CHECK(lines[4] ==
        Json{{"event", "interval"}, {"from", {0.0, 0.0}}, {"to", {2.0, 0.0}}, {"side", "goal"}});
  CHECK(lines[5] ==
        Json{{"event", "rectangle"}, {"min", {0.0, 0.0}}, {"max", {2.0, 5.0}}, {"side", "goal"}});
  record.on_rectangle({{0, 0}, {2, 0}}, {{0, 0}, {2, 5}});
  std::string again;
  append_trace(again, trace_header, "success", record);
  CHECK(lines_of(again).back()["side"] == "start");
  CHECK(lines[6] == Json{{"event", "edge"}, {"from", {1.0, 1.0}}, {"to", {2.0, 3.0}}});
}

}  // namespace
