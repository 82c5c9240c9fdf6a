// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>

#include "tutavia/registry/options/option_kind.hpp"

/// \file
/// The table of an algorithm's options, as constant data.

namespace tutavia::detail {

/// The table of the aggregate A. Each specialisation has `sentence`, a phrase on the algorithm, and
/// `fields`, made by `option_fields`. Types and defaults are those of the aggregate itself.
template <class A>
struct OptionTable;

/// A member of an aggregate.
struct OptionField {
  std::string_view name;
  std::string_view unit{};      ///< empty for plain numbers
  std::string_view sentence{};  ///< for people: a phrase without a full stop
  const OptionKind* kind = nullptr;
  std::span<const OptionField> nested{};  ///< of a member that is an aggregate of options
  void* (*member)(void* object) = nullptr;
};

template <class A, class T>
A class_of(T A::*);
template <class A, class T>
T type_of(T A::*);

/// A field of the table in which it stands.
template <auto pointer>
struct FieldOf : OptionField {};

template <auto pointer>
void* member_of(void* object) {
  using A = decltype(class_of(pointer));
  return &(static_cast<A*>(object)->*pointer);
}

/// An option, or a nested aggregate of options that has a table of its own.
template <auto pointer>
constexpr FieldOf<pointer> field(std::string_view name, std::string_view unit,
                                 std::string_view sentence) {
  using T = decltype(type_of(pointer));
  OptionField made{name, unit, sentence};
  made.member = &member_of<pointer>;
  if constexpr (requires { OptionTable<T>::fields; }) {
    made.nested = OptionTable<T>::fields.all;
  } else {
    made.kind = &option_kind<T>;
  }
  return {made};
}

/// A member that no text can give, such as a prepared table. It is no option.
template <auto pointer>
constexpr FieldOf<pointer> data() {
  return {};
}

/// All members of an aggregate, in the order of their declaration.
template <auto... pointers>
struct OptionFields {
  std::array<OptionField, sizeof...(pointers)> all;
};

/// Whether A is initialised by these types and by no more values.
template <class A, class... Types>
constexpr bool has_members() {
  if constexpr (requires { A{std::declval<Types>()...}; }) {
    return !requires { A{std::declval<Types>()..., {}}; };
  } else {
    return false;
  }
}

template <auto first, auto second>
constexpr bool is_same_member() {
  if constexpr (std::is_same_v<decltype(first), decltype(second)>) return first == second;
  return false;
}
template <auto one, auto... pointers>
constexpr std::size_t occurrences() {
  return (std::size_t{0} + ... + std::size_t{is_same_member<one, pointers>()});
}

/// Whether these are all members of A, each once and in the order of declaration.
template <class A, auto... pointers>
constexpr bool is_complete() {
  return has_members<A, decltype(type_of(pointers))...>() &&
         (true && ... && (occurrences<pointers, pointers...>() == 1));
}

template <class A, auto... pointers>
constexpr OptionFields<pointers...> option_fields(const FieldOf<pointers>&... fields) {
  static_assert(is_complete<A, pointers...>(),
                "an option table has every member once, in the order of declaration");
  return {{fields...}};
}

}  // namespace tutavia::detail
