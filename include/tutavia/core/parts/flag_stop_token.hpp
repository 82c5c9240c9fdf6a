// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <memory>
#include <utility>

/// \file
/// FlagStopSource and FlagStopToken: std::stop_source and std::stop_token for standard libraries
/// that have none.

namespace tutavia::detail {

/// As std::stop_token, without callbacks. A token of no source is never stopped.
class FlagStopToken {
 public:
  FlagStopToken() = default;

  bool stop_requested() const noexcept {
    return flag_ != nullptr && flag_->load(std::memory_order_acquire);
  }
  bool stop_possible() const noexcept { return flag_ != nullptr; }

 private:
  friend class FlagStopSource;
  explicit FlagStopToken(std::shared_ptr<const std::atomic<bool>> flag) : flag_(std::move(flag)) {}

  std::shared_ptr<const std::atomic<bool>> flag_{};
};

/// As std::stop_source. Copies share one state.
class FlagStopSource {
 public:
  FlagStopToken get_token() const { return FlagStopToken(flag_); }
  bool stop_requested() const noexcept { return flag_->load(std::memory_order_acquire); }
  /// Whether this call is the first.
  bool request_stop() noexcept { return !flag_->exchange(true, std::memory_order_acq_rel); }

 private:
  std::shared_ptr<std::atomic<bool>> flag_ = std::make_shared<std::atomic<bool>>(false);
};

}  // namespace tutavia::detail
