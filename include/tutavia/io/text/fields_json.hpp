// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/io/text/parse_error.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/world/scene.hpp"

/// \file
/// json_fields: helpers to read fields of JSON files.

/// Reads fields of JSON values. Each function throws a ParseError that names the field;
/// `parse_json` turns it into a failure.
namespace tutavia::detail::json_fields {

using Json = nlohmann::json;

inline void require(bool condition, const std::string& name, const std::string& expected) {
  if (!condition) throw ParseError{name + ": expected " + expected};
}

/// The name is not a std::string reference, because g++ would warn of a dangling reference.
inline const Json& field(const Json& json, const char* name) {
  if (!json.contains(name)) throw ParseError{"\"" + std::string(name) + "\" is missing"};
  return json[name];
}

inline double number(const Json& json, const std::string& name) {
  require(json.is_number(), name, "a number");
  return json.get<double>();
}

inline std::string string(const Json& json, const std::string& name) {
  require(json.is_string(), name, "a string");
  return json.get<std::string>();
}

/// [x, y]; with `at_least`, further numbers are ignored.
inline Point point(const Json& json, const std::string& name, bool at_least = false) {
  require(json.is_array() && (json.size() == 2 || (at_least && json.size() > 2)) &&
              json[0].is_number() && json[1].is_number(),
          name, "[x, y]");
  return {json[0].get<double>(), json[1].get<double>()};
}

inline Box box(const Json& json, const std::string& name) {
  require(json.is_array() && json.size() == 4, name, "[x0, y0, x1, y1]");
  for (const Json& value : json) require(value.is_number(), name, "[x0, y0, x1, y1]");
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

inline Ring ring(const Json& json, const std::string& name, bool at_least = false) {
  Ring result;
  each(json, name, [&](const Json& item, const std::string& item_name) {
    result.push_back(point(item, item_name, at_least));
  });
  return result;
}

/// The optional fields `name`, `start`, `goals` and `resolution` of a scene.
inline void read_task(const Json& json, Scene& scene) {
  if (json.contains("name")) scene.name = string(json["name"], "name");
  if (json.contains("start")) scene.start = point(json["start"], "start");
  if (json.contains("goals")) scene.goals = ring(json["goals"], "goals");
  if (json.contains("resolution")) scene.resolution = number(json["resolution"], "resolution");
}

/// Parses text and calls `read` with the result. Errors: `invalid_input` with line and column for
/// malformed JSON, and with the name of a field of the wrong type.
template <class Read>
Expected<SceneFile, Failure> parse_json(std::string_view text, Read read) {
  try {
    return read(Json::parse(text));
  } catch (const Json::exception& error) {
    const std::string what = error.what();  // "[json.exception...] parse error at line 3, ..."
    const std::size_t prefix = what.find("] ");
    return fail(PlanError::invalid_input,
                prefix == std::string::npos ? what : what.substr(prefix + 2));
  } catch (const ParseError& error) {
    return fail(error.code, error.what);
  }
}

}  // namespace tutavia::detail::json_fields
