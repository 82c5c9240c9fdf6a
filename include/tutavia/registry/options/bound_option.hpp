// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/plan/failure.hpp"
#include "tutavia/registry/algorithm_text.hpp"
#include "tutavia/registry/nearest_name.hpp"
#include "tutavia/registry/option_value.hpp"
#include "tutavia/registry/options/option_field.hpp"
#include "tutavia/registry/options/option_kind.hpp"

/// \file
/// The options of one object: read and set by their table. Nothing here depends on its type.

namespace tutavia::detail {

/// An option of an object that outlives it. Options of a nested aggregate are called
/// "weights.density".
struct BoundOption {
  std::string name;
  const OptionField* field;
  void* member;

  OptionValue value() const { return field->kind->read(member); }
};

inline void append_options(void* object, std::span<const OptionField> fields,
                           const std::string& prefix, std::vector<BoundOption>& options) {
  for (const OptionField& field : fields) {
    if (field.member == nullptr) continue;
    std::string name = prefix;
    name.append(field.name);
    void* const member = field.member(object);
    if (field.kind == nullptr) {
      append_options(member, field.nested, name.append("."), options);
    } else {
      options.push_back({std::move(name), &field, member});
    }
  }
}

/// The options of an object, in the order of declaration. \pre the fields are those of its type
inline std::vector<BoundOption> bind_options(void* object, std::span<const OptionField> fields) {
  std::vector<BoundOption> options;
  append_options(object, fields, {}, options);
  return options;
}

/// "did you mean NAME?" if there is a near one, else all names.
inline std::string hint(std::string_view word, std::span<const std::string> names) {
  if (const auto nearest = nearest_name(word, names)) return "did you mean " + *nearest + "?";
  std::string text = "known:";
  for (const std::string& name : names) text.append(" ").append(name);
  return text;
}

inline std::string unknown_option(const std::string& name,
                                  const std::vector<BoundOption>& options) {
  std::string message = "unknown option \"" + name + "\"; ";
  if (options.empty()) return message.append("there are none");
  std::vector<std::string> names;
  names.reserve(options.size());
  for (const BoundOption& option : options) names.push_back(option.name);
  return message.append(hint(name, names));
}

/// Sets options from texts. Errors: `invalid_option` for an unknown or repeated option and for a
/// text that is no value of its type. Ranges are the algorithm's own business.
inline Expected<void, Failure> set_options(std::string_view algorithm,
                                           const std::vector<BoundOption>& options,
                                           std::span<const OptionText> texts) {
  const auto invalid = [&](const std::string& detail) {
    std::string message(algorithm);
    return fail(PlanError::invalid_option, message.append(": ").append(detail));
  };
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const OptionText& given = texts[i];
    const auto has_name = [&](const auto& other) { return other.name == given.name; };
    const auto option = std::find_if(options.begin(), options.end(), has_name);
    if (option == options.end()) return invalid(unknown_option(given.name, options));
    const auto before = texts.first(i);
    if (std::any_of(before.begin(), before.end(), has_name)) {
      return invalid("option \"" + given.name + "\" is given twice");
    }
    const OptionKind& kind = *option->field->kind;
    if (kind.parse(given.text, option->member)) continue;
    std::string detail = given.name;
    detail.append(": expected ").append(expected_text(kind)).append(", got \"");
    return invalid(detail.append(given.text).append("\""));
  }
  return {};
}

/// Sets the options of an object and keeps all of them as values.
class OptionSetter {
 public:
  OptionSetter(std::string_view algorithm, std::span<const OptionField> fields,
               std::span<const OptionText> texts)
      : algorithm_(algorithm), fields_(fields), texts_(texts) {}

  /// \pre the fields are those of the object's type
  void set(void* object) {
    const std::vector<BoundOption> options = bind_options(object, fields_);
    result_ = set_options(algorithm_, options, texts_);
    for (const BoundOption& option : options) settings_.push_back({option.name, option.value()});
  }
  const Expected<void, Failure>& result() const { return result_; }
  const OptionSettings& settings() const { return settings_; }

 private:
  std::string_view algorithm_;
  std::span<const OptionField> fields_;
  std::span<const OptionText> texts_;
  Expected<void, Failure> result_;
  OptionSettings settings_;
};

}  // namespace tutavia::detail
