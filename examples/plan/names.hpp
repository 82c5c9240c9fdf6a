// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "options.hpp"

/// \file
/// Names: the searches and smoothers chosen on the command line.

namespace plan_program {

/// Names of searches and smoothers. A smoother "A+B" is a pipeline of A and B.
struct Names {
  std::vector<std::string> searches;
  std::vector<std::string> smoothers;
};

/// The names in --search and --smoother. Throws a UsageError for a name that is not in `known`, and
/// for more than one search or smoother with --compare.
Names choose(const Arguments& args, const Names& known);

}  // namespace plan_program
