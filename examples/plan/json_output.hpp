// SPDX-License-Identifier: MIT
#pragma once

#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "input.hpp"
#include "result.hpp"
#include "tutavia/world/scene.hpp"

/// \file
/// JSON output: the result file and the trace.

namespace plan_program {

/// Writes the result file, or prints it if the path is "-". Of a ROS map it has the frame, as
/// `map`. Throws UsageError.
void write_results(const std::string& path, const Task& task, const std::vector<Group>& groups);

/// The file of --trace. It is written while the searches run and holds each search once, however
/// many smoothers follow it. With an empty path it does nothing. A file NAME.trace.json is for
/// Posthoc and holds one search. Every member throws UsageError if the file cannot be written.
class TraceFile {
 public:
  explicit TraceFile(const std::string& path);

  /// Whether the file takes the results of a search: true for the first call with its name
  /// and options.
  bool takes(const std::string& search);
  void write(const Task& task, const Result& result, const SearchRecord& record);
  void close();

 private:
  void check() const;

  std::string path_;
  std::ofstream file_{};
  std::set<std::string> searches_{};
  bool has_posthoc_ = false;  // a search for Posthoc is written
};

}  // namespace plan_program
