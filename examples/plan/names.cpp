// SPDX-License-Identifier: MIT
#include "names.hpp"

#include <utility>

#include "usage_error.hpp"

namespace plan_program {

namespace {

std::vector<tutavia::PipelineText> parse_list(const std::string& option, const std::string& text) {
  auto parsed = tutavia::parse_algorithms(text);
  if (!parsed) throw UsageError{option + ": " + parsed.error().detail};
  return std::move(*parsed);
}

}  // namespace

Choices parse_choices(const Arguments& args) {
  Choices chosen{parse_list("--search", args.search), parse_list("--smoother", args.smoother)};
  for (const tutavia::PipelineText& search : chosen.searches) {
    if (search.stages.size() == 1) continue;
    throw UsageError{"--search: unknown name \"" + search.text + "\"; only smoothers are chained"};
  }
  if (args.compare && (chosen.searches.size() > 1 || chosen.smoothers.size() > 1)) {
    throw UsageError{"--compare takes one --search and one --smoother to hold the others against"};
  }
  return chosen;
}

tutavia::PipelineText default_choice(const std::string& name) {
  return {.text = name, .stages = {{.text = name, .name = name}}};
}

}  // namespace plan_program
