// SPDX-License-Identifier: MIT
#include "results_file.hpp"

#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "job.hpp"
#include "plan/usage_error.hpp"
#include "result_row.hpp"
#include "tutavia/io/text/read_file.hpp"
#include "tutavia/io/text/write_file.hpp"

namespace batch_program {

using plan_program::UsageError;

namespace {

/// Keeps other writers away, also those of Python, until the file is closed.
void lock(std::FILE* file, const std::string& path) {
  if (flock(fileno(file), LOCK_EX | LOCK_NB) == 0) return;
  throw UsageError{path + (errno == EWOULDBLOCK
                               ? ": another process is writing it"
                               : std::string(": cannot be locked: ") + std::strerror(errno))};
}

/// Whether the file has a beginning: results, or the start of a header.
bool has_begun(const std::string& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  return !error && size > 0;
}

/// Checks the job of a file that has begun; writes it beside a new one.
void check_job(const std::string& path, const std::string& job, bool is_begun) {
  const std::string job_path = path + ".job";
  if (!is_begun) {
    plan_program::throw_failure(tutavia::detail::write_file(job_path, job + "\n"));
    return;
  }
  const auto written = tutavia::detail::read_text(job_path);
  if (!written) {
    throw UsageError{path + ": there is no " + job_path +
                     " that says of which job these results are: give another --results"};
  }
  if (*written == job + "\n") return;
  throw UsageError{path + ": these results are of another job (" +
                   written->substr(0, written->find('\n')) + ") than this one (" + job +
                   "): give another --results"};
}

}  // namespace

ResultsFile::ResultsFile(const std::string& path, const std::string& job) : path_(path) {
  file_.reset(std::fopen(path.c_str(), "ab"));
  if (file_ == nullptr) throw UsageError{path + ": cannot be written"};
  lock(file_.get(), path);
  const bool is_begun = has_begun(path);
  check_job(path, job, is_begun);
  std::string start(result_header);
  start.append("\n");
  if (is_begun) {
    const auto progress =
        plan_program::value_or_throw(tutavia::detail::read_file(path, &count_results));
    done_ = progress.results;
    if (ftruncate(fileno(file_.get()), static_cast<off_t>(progress.bytes)) != 0) {
      throw UsageError{path + ": cannot be written"};
    }
    if (progress.bytes > 0) start.clear();
  }
  append(start);
}

void ResultsFile::append(const std::string& lines) {
  std::FILE* const file = file_.get();
  const bool is_written =
      std::fwrite(lines.data(), 1, lines.size(), file) == lines.size() && std::fflush(file) == 0;
  if (!is_written) throw UsageError{path_ + ": cannot be written"};
}

}  // namespace batch_program
