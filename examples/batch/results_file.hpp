// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>

/// \file
/// ResultsFile: a file of results that a restart completes.

namespace batch_program {

/// The lines of results, one per query in their order, and beside them FILE.job, the line of the
/// job (see describe_job). What is written is a prefix of the whole file at any time.
class ResultsFile {
 public:
  /// Opens a file to append results: an empty or new one, or one that the same job began, whose
  /// last line is removed if it is not whole. Throws a UsageError for a file of another job or of
  /// something else, for one that another process writes, and for one that cannot be written.
  ResultsFile(const std::string& path, const std::string& job);

  /// How many results the file held when it was opened.
  std::size_t done() const { return done_; }

  /// Appends whole lines. Throws UsageError.
  void append(const std::string& lines);

 private:
  std::string path_;
  std::size_t done_ = 0;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_{nullptr, &std::fclose};
};

}  // namespace batch_program
