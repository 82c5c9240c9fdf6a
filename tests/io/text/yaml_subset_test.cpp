// SPDX-License-Identifier: MIT
#include "tutavia/io/text/yaml_subset.hpp"

#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;
using detail::YamlSubset;

const std::string all_settings =
    "image: a.pgm\nresolution: 0.05\norigin: [1.5, -2, 0]\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\nnegate: 0\n";

/// What is said when a text is read that is refused.
std::string subset_complaint(const std::string& yaml) {
  const auto read = detail::parse_or_fail([&] { return YamlSubset(yaml); });
  REQUIRE_FALSE(read);
  CHECK(read.error().code == PlanError::invalid_input);
  return read.error().detail;
}

TEST_CASE("scalars and lists are read by their keys, and what is asked for becomes no warning") {
  YamlSubset yaml("a: 1\nb: [2, 'three', \"4\"]\nc:\n- 5\n- six\nd: left over\n");
  CHECK(yaml.has("a"));
  CHECK_FALSE(yaml.has("e"));
  CHECK(yaml.value("a") == "1");
  CHECK(yaml.number("b", 0, 10, "a number", 0, 3) == 2);
  CHECK(yaml.number("b", 0, 10, "a number", 2, 3) == 4);
  CHECK(yaml.number("c", 0, 10, "a number", 0, 2) == 5);
  CHECK(yaml.warnings() == std::vector<std::string>{"line 6: unknown key d"});
}

TEST_CASE("values that are not as asked are refused with the line of their key") {
  const auto refusal = [](const auto& ask) {
    const auto asked = detail::parse_or_fail([&] {
      YamlSubset yaml("a: 1\nb: [2, three]\n");
      return ask(yaml);
    });
    REQUIRE_FALSE(asked);
    return asked.error().detail;
  };
  CHECK(refusal([](YamlSubset& yaml) { return yaml.value("c"); }) == "the key c is missing");
  CHECK(refusal([](YamlSubset& yaml) { return yaml.value("b"); }) ==
        "line 2: expected b with 1 value, found 2");
  CHECK(refusal([](YamlSubset& yaml) { return yaml.number("a", 2, 3, "two or three"); }) ==
        "line 1: expected a: two or three, found 1");
  CHECK(refusal([](YamlSubset& yaml) { return yaml.number("b", 0, 9, "a digit", 1, 2); }) ==
        "line 2: expected b: a digit, found three");
}

const std::vector<std::pair<std::string, std::string>> refused_lines = {
    {"a", "key: value, not indented"},
    {"a:b", "key: value, not indented"},
    {" a: b", "key: value, not indented"},
    {"\ta: b", "key: value, not indented"},
    {"a b: c", "key: value, not indented"},
    {"\"a\": b", "key: value, not indented"},
    {": b", "key: value, not indented"},
    {"? a", "key: value, not indented"},
    {"<<: *base", "key: value, not indented"},
    {"{a: b}", "key: value, not indented"},
    {"%YAML 1.2", "key: value, not indented"},
    {"---", "key: value, not indented"},
    {"...", "key: value, not indented"},
    {"\xEF\xBB\xBF"
     "a: b",
     "key: value, not indented"},
    {"image: b.pgm", "every key once"},
    {"- 1", "key: value"},
    {"a: {b: 1}", "a plain value or a list in one line"},
    {"a: |", "a plain value or a list in one line"},
    {"a: >-", "a plain value or a list in one line"},
    {"a: &anchor 1", "a plain value or a list in one line"},
    {"a: *anchor", "a plain value or a list in one line"},
    {"a: !!float 1", "a plain value or a list in one line"},
    {"a: [1, 2", "a plain value or a list in one line"},
    {"a: b: c", "a plain value or a list in one line"},
    {"a: b:", "a plain value or a list in one line"},
    {"a: - 1", "a plain value or a list in one line"},
    {"a: [1, b: 2]", "a plain value or a list in one line"},
    {"a: [[1], 2]", "a list of scalars"},
    {"a: [1, {b: 2}]", "a list of scalars"},
    {"a: []", "a value"},
    {"a: [1, ]", "a value"},
    {"a: [, 1]", "a value"},
    {"a: \"b", "quotes around all of a value"},
    {"a: 'b' c", "quotes around all of a value"},
    {"a: '", "quotes around all of a value"},
    {"a: \"b # c\"", "quotes around all of a value"},
    {"a: ['1, 2']", "quotes around all of a value"},
    {"a: 'it''s'", "no quotes or escapes in quotes"},
    {"a: \"b\\n\"", "no quotes or escapes in quotes"},
    {"a: b\rc: d", "text, LF or CRLF"},
    {std::string("a: b\0c", 6), "text, LF or CRLF"},
};

TEST_CASE("YAML beyond one value or list per key is refused with its line") {
  for (const auto& [line, expected] : refused_lines) {
    CAPTURE(line);
    CHECK(subset_complaint(all_settings + line + "\n")
              .find("line 7: expected " + expected + ", found \"") == 0);
  }
  CHECK(
      subset_complaint(all_settings + "a:\n  b: 1\n").find("line 8: expected key: value, not i") ==
      0);
  CHECK(
      subset_complaint(all_settings + "a: b\n  c\n").find("line 8: expected key: value, not ind") ==
      0);
  CHECK(subset_complaint(all_settings + "a: b\n- c\n").find("line 8: expected key: value, found") ==
        0);
  CHECK(subset_complaint(all_settings + "a:\n- b: 1\n").find("line 8: expected a plain value") ==
        0);
  CHECK(subset_complaint(all_settings + "a:\n-\n").find("line 8: expected a value, found \"-\"") ==
        0);
  CHECK(subset_complaint(all_settings + "a:\n- 1\n  - 2\n") ==
        "line 9: expected list items one below the other, found \"- 2\"");
  CHECK(subset_complaint("---\n---\n" + all_settings).find("line 2: expected key: value") == 0);
}

}  // namespace
