// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// \file
/// print_help_of: the options of one algorithm.

namespace plan_program {

/// Prints an algorithm and its options, for --help-NAME. Throws a UsageError for an unknown name.
void print_help_of(const std::string& name);

}  // namespace plan_program
