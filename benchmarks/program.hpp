// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <string>
#include <utility>

#include "tutavia/core/expected.hpp"
#include "tutavia/io/text/write_file.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// What every benchmark program does around its measuring.

namespace bench {

using Clock = std::chrono::steady_clock;

/// Bad usage or bad input: one line on stderr, exit code 2.
struct UsageError {
  std::string message;
};

inline double micros_since(Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

template <class T>
T value_or_throw(tutavia::Expected<T, tutavia::Failure> result) {
  if (!result) {
    const tutavia::Failure& failure = result.error();
    throw UsageError{failure.detail.empty() ? std::string(to_string(failure.code))
                                            : failure.detail};
  }
  return std::move(*result);
}

/// Writes a file, if its path is not empty.
inline void write_if_named(const std::string& path, const std::string& text) {
  if (path.empty()) return;
  if (const auto written = tutavia::detail::write_file(path, text); !written) {
    throw UsageError{written.error().detail};
  }
}

/// Reads the command line and runs; errors come out on one line.
template <class Run>
int run_program(CLI::App& app, int argc, char** argv, const Run& run) {
  try {
    app.parse(argc, argv);
    return run();
  } catch (const CLI::Success& request) {
    return app.exit(request);
  } catch (const CLI::ParseError& error) {
    std::cerr << app.get_name() << ": " << error.what() << '\n';
  } catch (const UsageError& error) {
    std::cerr << app.get_name() << ": " << error.message << '\n';
  }
  return 2;
}

}  // namespace bench
