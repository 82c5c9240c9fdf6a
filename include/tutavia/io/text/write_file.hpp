// SPDX-License-Identifier: MIT
#pragma once

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include "tutavia/plan/failure.hpp"

/// \file
/// write_file: writes a file completely or not at all.

namespace tutavia::detail {

/// Writes `text` to a file beside `path` and moves it there, so that `path` is never incomplete.
/// Anything but a regular file (a pipe, a terminal) is written directly. Errors: `invalid_input`
/// with the system's reason.
inline Expected<void, Failure> write_file(const std::filesystem::path& path,
                                          std::string_view text) {
  namespace fs = std::filesystem;
  const auto failed = [&](const std::string& reason) {
    return fail(PlanError::invalid_input, "cannot write " + path.string() + ": " + reason);
  };
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) return failed("it is a directory");
  const bool direct = fs::exists(status) && !fs::is_regular_file(status);
  fs::path target = path;
  if (!direct) target += ".part";

  errno = 0;
  std::ofstream file(target, std::ios::binary | std::ios::trunc);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  if (!file) {
    const std::string reason = errno != 0 ? std::strerror(errno) : "output error";
    if (!direct) fs::remove(target, error);
    return failed(reason);
  }
  if (direct) return {};
  fs::rename(target, path, error);
  if (!error) return {};
  const std::string reason = error.message();
  fs::remove(target, error);
  return failed(reason);
}

}  // namespace tutavia::detail
