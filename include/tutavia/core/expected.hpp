// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <utility>
#include <variant>

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
/// `operator*` and `operator->` require a value (asserted). `value()` throws BadExpectedAccess
/// where there is none: convenient in scripts, where a failure should end the program.
template <class T, class E>
class Expected {
 public:
  using value_type = T;
  using error_type = E;

  Expected(T value) : content_(std::in_place_index<0>, std::move(value)) {}  // NOLINT: implicit
  template <class G>
  Expected(Unexpected<G> unexpected)  // NOLINT: implicit
      : content_(std::in_place_index<1>, std::move(unexpected.error)) {}

  bool has_value() const noexcept { return content_.index() == 0; }
  explicit operator bool() const noexcept { return has_value(); }

  T& operator*() & { return checked(); }
  const T& operator*() const& { return const_cast<Expected*>(this)->checked(); }
  T&& operator*() && { return std::move(checked()); }
  T* operator->() { return &checked(); }
  const T* operator->() const { return &**this; }

  T& value() & { return or_throw(), **this; }
  const T& value() const& { return or_throw(), **this; }
  T&& value() && { return or_throw(), std::move(checked()); }

  E& error() {
    TUTAVIA_ASSERT(!has_value());
    return *std::get_if<1>(&content_);
  }
  const E& error() const { return const_cast<Expected*>(this)->error(); }

 private:
  T& checked() {
    TUTAVIA_ASSERT(has_value());
    return *std::get_if<0>(&content_);
  }
  void or_throw() const {
    if (!has_value())
      throw BadExpectedAccess("tutavia: value() of an Expected that holds an error");
  }

  std::variant<T, E> content_;
};

/// Success without a value, or an error.
template <class E>
class Expected<void, E> : public Expected<std::monostate, E> {
 public:
  Expected() : Expected<std::monostate, E>(std::monostate{}) {}
  using Expected<std::monostate, E>::Expected;
};

}  // namespace tutavia
