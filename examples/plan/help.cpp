// SPDX-License-Identifier: MIT
#include "help.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

#include "tutavia/registry.hpp"
#include "usage_error.hpp"

namespace plan_program {

namespace {

using tutavia::AlgorithmDescription;
using tutavia::OptionDescription;

/// Prints the options, a line each, in columns as wide as their texts.
void print_options(const std::vector<OptionDescription>& options) {
  using Row = std::array<std::string, 5>;
  std::vector<Row> rows{{"option", "type", "unit", "default", "meaning"}};
  for (const OptionDescription& option : options) {
    rows.push_back({option.name, option.type, option.unit, option.default_value, option.sentence});
  }
  std::array<std::size_t, 4> widths{};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  for (const Row& row : rows) {
    std::printf(" ");
    for (std::size_t i = 0; i < widths.size(); ++i) {
      std::printf(" %-*s ", static_cast<int>(widths[i]), row[i].c_str());
    }
    std::printf(" %s\n", row.back().c_str());
  }
}

}  // namespace

void print_help_of(const std::string& name) {
  std::vector<std::string> names;
  for (const bool is_search : {true, false}) {
    const char* kind = is_search ? "search" : "smoother";
    const auto all = is_search ? tutavia::describe_searches() : tutavia::describe_smoothers();
    for (const AlgorithmDescription& algorithm : all) {
      names.push_back(algorithm.name);
      if (algorithm.name != name) continue;
      std::printf("%s (--%s): %s.\n", name.c_str(), kind, algorithm.sentence.c_str());
      if (algorithm.options.empty()) {
        std::printf("It has no options.\n");
      } else {
        std::printf("Options, as --%s %s:OPTION=VALUE,OPTION=VALUE\n", kind, name.c_str());
        print_options(algorithm.options);
      }
      return;
    }
  }
  std::string message = "--help-" + name + ": unknown name \"" + name + "\"; ";
  const auto nearest = tutavia::nearest_name(name, names);
  throw UsageError{message + (nearest ? "did you mean " + *nearest + "?" : "see --list")};
}

}  // namespace plan_program
