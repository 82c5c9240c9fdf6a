// SPDX-License-Identifier: MIT
#include "shown_parts.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "text_arguments.hpp"
#include "tutavia/registry/nearest_name.hpp"
#include "usage_error.hpp"

namespace plan_program {

ShownParts parse_shown_parts(const std::string& text) {
  using Part = std::pair<const char*, bool ShownParts::*>;
  constexpr std::array<Part, 6> parts{
      Part{"visited", &ShownParts::visited}, {"tree", &ShownParts::tree},
      {"zones", &ShownParts::zones},         {"passages", &ShownParts::passages},
      {"profile", &ShownParts::profile},     {"footprint", &ShownParts::footprint}};
  ShownParts shown;
  for (const std::string& name : split(text, ',')) {
    const auto* const part = std::find_if(parts.begin(), parts.end(),
                                          [&](const Part& known) { return known.first == name; });
    if (part != parts.end()) {
      shown.*part->second = true;
      continue;
    }
    std::vector<std::string> names;
    names.reserve(parts.size());
    for (const Part& known : parts) names.emplace_back(known.first);
    const auto nearest = tutavia::nearest_name(name, names);
    std::string message = "--show: unknown part \"" + name + "\"; ";
    throw UsageError{message +
                     (nearest ? "did you mean " + *nearest + "?"
                              : "expected visited, tree, zones, passages, profile or footprint")};
  }
  return shown;
}

}  // namespace plan_program
