// SPDX-License-Identifier: MIT
#include "names.hpp"

#include <algorithm>

#include "usage_error.hpp"

namespace plan_program {

namespace {

void require_known(const std::string& option, const std::string& name,
                   const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), name) != known.end()) return;
  std::string message = option;
  message.append(": unknown name \"").append(name).append("\"; known:");
  for (const std::string& other : known) message.append(" ").append(other);
  throw UsageError{message};
}

}  // namespace

Names choose(const Arguments& args, const Names& known) {
  Names chosen{split(args.search, ','), split(args.smoother, ',')};
  for (const std::string& search : chosen.searches) {
    require_known("--search", search, known.searches);
  }
  for (const std::string& smoother : chosen.smoothers) {
    for (const std::string& stage : split(smoother, '+')) {
      require_known("--smoother", stage, known.smoothers);
    }
  }
  if (args.compare && (chosen.searches.size() > 1 || chosen.smoothers.size() > 1)) {
    throw UsageError{"--compare takes one --search and one --smoother to hold the others against"};
  }
  return chosen;
}

}  // namespace plan_program
