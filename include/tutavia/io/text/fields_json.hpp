// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "tutavia/io/text/parse_error.hpp"
#include "tutavia/world/scene.hpp"

/// \file
/// json_fields: helpers to read fields of JSON files.

/// Reads fields of JSON values. Each function throws a ParseError that names the field.
namespace tutavia::detail::json_fields {

using Json = nlohmann::json;

inline void require(bool condition, const std::string& name, const std::string& expected) {
  if (!condition) throw ParseError{name + ": expected " + expected};
}

/// The names are not std::string references, because g++ would warn of a dangling reference.
inline const Json& field(const Json& json, const char* name, std::string_view owner = {}) {
  if (!json.contains(name)) {
    std::string message = owner.empty() ? std::string() : std::string(owner).append(": ");
    throw ParseError{message.append("\"").append(name).append("\" is missing")};
  }
  return json[name];
}

/// A field that may be missing or null: nullptr then.
inline const Json* optional_field(const Json& json, const char* name) {
  const auto found = json.find(name);
  return found == json.end() || found->is_null() ? nullptr : &*found;
}

inline double number(const Json& json, const std::string& name) {
  require(json.is_number(), name, "a number");
  return json.get<double>();
}

inline std::string string(const Json& json, const std::string& name) {
  require(json.is_string(), name, "a string");
  return json.get<std::string>();
}

/// Whether a value is an array of numbers alone.
inline bool is_numbers(const Json& json) {
  return json.is_array() &&
         std::all_of(json.begin(), json.end(), [](const Json& item) { return item.is_number(); });
}

/// [x, y].
inline Point point(const Json& json, const std::string& name) {
  require(is_numbers(json) && json.size() == 2, name, "[x, y]");
  return {json[0].get<double>(), json[1].get<double>()};
}

inline Box box(const Json& json, const std::string& name) {
  require(is_numbers(json) && json.size() == 4, name, "[x0, y0, x1, y1]");
  return {{json[0].get<double>(), json[1].get<double>()},
          {json[2].get<double>(), json[3].get<double>()}};
}

/// Calls `visit(item, name)` for every item of an array; names are "name[0]", "name[1]", ...
template <class Visit>
void each(const Json& json, const std::string& name, Visit visit) {
  require(json.is_array(), name, "an array");
  for (std::size_t i = 0; i < json.size(); ++i) {
    visit(json[i], name + "[" + std::to_string(i) + "]");
  }
}

inline Ring ring(const Json& json, const std::string& name) {
  Ring result;
  each(json, name, [&](const Json& item, const std::string& item_name) {
    result.push_back(point(item, item_name));
  });
  return result;
}

/// The optional fields `name`, `start`, `goals` and `resolution` of a scene.
inline void read_task(const Json& json, Scene& scene) {
  if (const Json* name = optional_field(json, "name")) scene.name = string(*name, "name");
  if (const Json* start = optional_field(json, "start")) scene.start = point(*start, "start");
  if (const Json* goals = optional_field(json, "goals")) scene.goals = ring(*goals, "goals");
  if (const Json* resolution = optional_field(json, "resolution")) {
    scene.resolution = number(*resolution, "resolution");
  }
}

}  // namespace tutavia::detail::json_fields
