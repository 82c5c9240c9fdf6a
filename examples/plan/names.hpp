// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "options.hpp"
#include "tutavia/registry/algorithm_text.hpp"

/// \file
/// Choices: the searches and smoothers chosen on the command line.

namespace plan_program {

/// Names of searches and smoothers.
struct Names {
  std::vector<std::string> searches;
  std::vector<std::string> smoothers;
};

/// Searches and smoothers with their options. A smoother of several stages is a pipeline.
struct Choices {
  bool for_vehicle = false;
  std::vector<tutavia::PipelineText> searches{};
  std::vector<tutavia::PipelineText> smoothers{};
};

/// What --search and --smoother say, and their defaults. They are for a vehicle if the command line
/// describes one, or if a search is one of those for vehicles. Names and options are not checked.
/// Throws a UsageError for what is no list of algorithms, and for more than one search or smoother
/// with --compare.
Choices parse_choices(const Arguments& args, const Names& for_vehicles);

/// An algorithm with default options.
tutavia::PipelineText default_choice(const std::string& name);

}  // namespace plan_program
