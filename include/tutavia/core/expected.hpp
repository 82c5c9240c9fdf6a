// SPDX-License-Identifier: MIT
#pragma once

#include <new>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "tutavia/core/assert.hpp"
#include "tutavia/core/version.hpp"

/// \file
/// Expected<T, E>: a value or the reason why there is none.

namespace tutavia {

/// Wraps an error so that it converts to any Expected<T, E>.
template <class E>
struct Unexpected {
  E error;
};

template <class E>
Unexpected(E) -> Unexpected<E>;

/// Thrown by Expected::value() when there is no value.
class BadExpectedAccess : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// A value of type T or an error of type E: the subset of C++23's std::expected that the library
/// needs, the same on every compiler.
///
/// `operator*` and `operator->` require a value (asserted). `value()` throws BadExpectedAccess if
/// there is none, for programs that end at the first failure.
template <class T, class E>
class Expected {
 public:
  using value_type = T;
  using error_type = E;

  Expected(T value) : value_(std::move(value)) {}  // NOLINT: implicit
  template <class G>
  Expected(Unexpected<G> unexpected)  // NOLINT: implicit
      : error_(std::move(unexpected.error)), has_value_(false) {}

  Expected(const Expected& other) requires std::is_copy_constructible_v<T>
      : has_value_(other.has_value_) {
    if (has_value_) {
      new (&value_) T(other.value_);
    } else {
      new (&error_) E(other.error_);
    }
  }
  Expected(Expected&& other) noexcept : has_value_(other.has_value_) { take(other); }
  Expected& operator=(Expected other) noexcept {
    destroy();
    has_value_ = other.has_value_;
    take(other);
    return *this;
  }
  ~Expected() { destroy(); }

  bool has_value() const noexcept { return has_value_; }
  explicit operator bool() const noexcept { return has_value_; }

  T& operator*() & { return checked(); }
  const T& operator*() const& { return const_cast<Expected*>(this)->checked(); }
  T&& operator*() && { return std::move(checked()); }
  T* operator->() { return &checked(); }
  const T* operator->() const { return &**this; }

  T& value() & { return or_throw(), **this; }
  const T& value() const& { return or_throw(), **this; }
  T&& value() && { return or_throw(), std::move(checked()); }

  E& error() {
    TUTAVIA_ASSERT(!has_value_);
    return error_;
  }
  const E& error() const { return const_cast<Expected*>(this)->error(); }
  /// The error, to return it from a caller: `if (!found) return std::move(found).unexpected();`.
  /// \pre no value
  Unexpected<E> unexpected() && { return {std::move(error())}; }

 private:
  T& checked() {
    TUTAVIA_ASSERT(has_value_);
    return value_;
  }
  void or_throw() const {
    if (!has_value_) {
      throw BadExpectedAccess("tutavia: value() of an Expected that holds an error");
    }
  }
  void take(Expected& other) {
    if (has_value_) {
      new (&value_) T(std::move(other.value_));
    } else {
      new (&error_) E(std::move(other.error_));
    }
  }
  void destroy() {
    if (has_value_) {
      value_.~T();
    } else {
      error_.~E();
    }
  }

  // Not std::variant, which would instantiate some sixty functions per value type in every file
  // that includes this header.
  union {
    T value_;
    E error_;
  };
  bool has_value_ = true;
};

namespace detail {

/// Stands for the value of an Expected<void, E>.
struct NoValue {};

}  // namespace detail

/// Success without a value, or an error.
template <class E>
class Expected<void, E> : public Expected<detail::NoValue, E> {
 public:
  Expected() : Expected<detail::NoValue, E>(detail::NoValue{}) {}
  using Expected<detail::NoValue, E>::Expected;
};

}  // namespace tutavia
