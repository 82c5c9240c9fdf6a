// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "options.hpp"

/// \file
/// The options that say what to plan on. Other programs have them, too.

namespace CLI {
class App;
}

namespace plan_program {

/// Defines the options for maps and files.
void define_input_options(CLI::App& app, Arguments& args);

/// Reads a command line. Returns false for --help, which it prints. Throws a UsageError that names
/// the option nearest to an unknown one.
bool parse(CLI::App& app, int argc, const char* const* argv);

/// The N of --unknown cost:N: what unknown cells cost, times their length. Throws a UsageError for
/// anything else than blocked, free and cost:N.
std::optional<double> unknown_cost(const Arguments& args);

}  // namespace plan_program
