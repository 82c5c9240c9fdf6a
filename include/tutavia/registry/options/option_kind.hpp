// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "tutavia/core/parts/number_text.hpp"
#include "tutavia/core/parts/read_number.hpp"
#include "tutavia/registry/option_value.hpp"

/// \file
/// How the options of each type are read from text and written.

namespace tutavia::detail {

/// The names of an enum's values: each specialisation has `names`, in the order of declaration, for
/// values that count from 0.
template <class E>
struct EnumNames;

/// What is known of the type of an option.
struct OptionKind {
  enum class Type { choice, whole_number, number };
  Type type = Type::number;
  bool is_optional = false;
  std::span<const std::string_view> names{};  ///< of a choice
  std::int64_t least = 0;                     ///< of a whole number
  std::uint64_t greatest = 0;
  bool (*parse)(std::string_view text, void* member) = nullptr;  ///< false, without effect, for
                                                                 ///< texts that are no value
  OptionValue (*read)(const void* member) = nullptr;
};

template <class T>
struct OptionalOf {
  using Value = T;
  static constexpr bool is_optional = false;
};
template <class T>
struct OptionalOf<std::optional<T>> {
  using Value = T;
  static constexpr bool is_optional = true;
};

inline constexpr std::array<std::string_view, 2> switch_names{"false", "true"};

/// The whole text as a number; not NaN, nor what no T can hold. `inf` is a number.
template <class T>
bool parse_number(std::string_view text, T& result) {
  const std::optional<T> value = read_whole_text<T>(text);
  if (!value) return false;
  if constexpr (std::floating_point<T>) {
    if (std::isnan(*value)) return false;
  }
  result = *value;
  return true;
}

template <class T>
constexpr std::span<const std::string_view> names_of() {
  if constexpr (std::same_as<T, bool>) {
    return switch_names;
  } else if constexpr (std::is_enum_v<T>) {
    return EnumNames<T>::names;
  } else {
    return {};
  }
}

/// The value that a text stands for. False, without effect, if it stands for none.
template <class T>
bool parse_option(std::string_view text, T& result) {
  if constexpr (OptionalOf<T>::is_optional) {
    typename OptionalOf<T>::Value value{};
    const bool is_value = parse_option(text, value);
    if (!is_value && text != "none") return false;
    result = is_value ? T(value) : T{};
    return true;
  } else if constexpr (std::same_as<T, bool> || std::is_enum_v<T>) {
    for (std::size_t i = 0; i < names_of<T>().size(); ++i) {
      if (names_of<T>()[i] != text) continue;
      result = static_cast<T>(i);
      return true;
    }
    return false;
  } else {
    return parse_number(text, result);
  }
}

template <class T>
OptionValue to_value(const T& value) {
  if constexpr (OptionalOf<T>::is_optional) {
    return value ? to_value(*value) : OptionValue{};
  } else if constexpr (std::is_enum_v<T>) {
    return std::string(names_of<T>()[static_cast<std::size_t>(value)]);
  } else if constexpr (std::same_as<T, bool> || std::floating_point<T>) {
    return value;
  } else if constexpr (std::is_signed_v<T>) {
    return std::int64_t{value};
  } else {
    return std::uint64_t{value};
  }
}

template <class T>
constexpr OptionKind make_kind() {
  using Value = typename OptionalOf<T>::Value;
  OptionKind kind;
  kind.is_optional = OptionalOf<T>::is_optional;
  kind.names = names_of<Value>();
  if constexpr (std::same_as<Value, bool> || std::is_enum_v<Value>) {
    kind.type = OptionKind::Type::choice;
  } else if constexpr (std::integral<Value>) {
    kind.type = OptionKind::Type::whole_number;
    kind.least = std::int64_t{std::numeric_limits<Value>::min()};
    kind.greatest = std::uint64_t{std::numeric_limits<Value>::max()};
  } else {
    static_assert(std::floating_point<Value>, "no option is of this type: is it data?");
  }
  kind.parse = [](std::string_view text, void* member) {
    return parse_option(text, *static_cast<T*>(member));
  };
  kind.read = [](const void* member) { return to_value(*static_cast<const T*>(member)); };
  return kind;
}

template <class T>
inline constexpr OptionKind option_kind = make_kind<T>();

/// Names with separators between them: "a, b or c".
inline std::string join(std::span<const std::string_view> names, std::string_view separator,
                        std::string_view last_separator) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text.append(i + 1 < names.size() ? separator : last_separator);
    text.append(names[i]);
  }
  return text;
}

/// The type of an option: "number", "whole number" or "a|b|c"; with "|none" if it is optional.
inline std::string type_text(const OptionKind& kind) {
  using Type = OptionKind::Type;
  std::string text = kind.type == Type::choice ? join(kind.names, "|", "|") : "number";
  if (kind.type == Type::whole_number) text = "whole number";
  return kind.is_optional ? text + "|none" : text;
}

/// What a text has to be, for messages.
inline std::string expected_text(const OptionKind& kind) {
  using Type = OptionKind::Type;
  std::string text = kind.type == Type::choice ? join(kind.names, ", ", " or ") : "a number";
  if (kind.type == Type::whole_number) {
    text = "a whole number from ";
    text.append(std::to_string(kind.least)).append(" to ").append(std::to_string(kind.greatest));
  }
  return kind.is_optional ? text + " or none" : text;
}

/// The shortest text that reads back to the same value.
inline std::string to_text(const OptionValue& value) {
  if (std::holds_alternative<std::monostate>(value)) return "none";
  if (const auto* is_on = std::get_if<bool>(&value)) return *is_on ? "true" : "false";
  if (const auto* name = std::get_if<std::string>(&value)) return *name;
  if (const auto* number = std::get_if<double>(&value)) return number_text(*number);
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  return std::to_string(std::get<std::uint64_t>(value));
}

}  // namespace tutavia::detail
