// SPDX-License-Identifier: MIT
#include "names.hpp"

#include <algorithm>
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

Choices parse_choices(const Arguments& args, const Names& for_vehicles) {
  const auto is_for_vehicle = [&](const tutavia::PipelineText& search) {
    const auto& names = for_vehicles.searches;
    return std::find(names.begin(), names.end(), search.name()) != names.end();
  };
  Choices chosen{.for_vehicle = args.vehicle.is_given()};
  chosen.searches =
      parse_list("--search",
                 args.search.value_or(chosen.for_vehicle ? for_vehicles.searches.front() : "auto"));
  chosen.for_vehicle = chosen.for_vehicle ||
                       std::any_of(chosen.searches.begin(), chosen.searches.end(), is_for_vehicle);
  chosen.smoothers = parse_list(
      "--smoother", args.smoother.value_or(chosen.for_vehicle ? "vehicle_shortcut" : "clothoid"));
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
