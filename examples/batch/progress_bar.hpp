// SPDX-License-Identifier: MIT
#pragma once

#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>

/// \file
/// ProgressBar: how far a batch has come, on a terminal.

namespace batch_program {

/// Draws a bar on stderr while it lives, if that is a terminal.
class ProgressBar {
 public:
  ProgressBar(std::size_t done, std::size_t all) : first_(done), all_(all) { show(done); }
  ~ProgressBar() {
    if (is_terminal_) std::fputc('\n', stderr);
  }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(std::size_t done) const {
    if (!is_terminal_) return;
    constexpr std::size_t width = 40;
    const std::size_t filled = all_ > 0 ? width * done / all_ : width;
    const std::string bar = std::string(filled, '#') + std::string(width - filled, '.');
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    const double rate = static_cast<double>(done - first_) / elapsed.count();
    const double left = done > first_ ? static_cast<double>(all_ - done) / rate : 0;
    std::fprintf(stderr, "\r[%s] %zu/%zu, %.0f/s, %.0f s left  ", bar.c_str(), done, all_, rate,
                 left);
  }

 private:
  std::size_t first_, all_;
  bool is_terminal_ = isatty(STDERR_FILENO) == 1;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace batch_program
