// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tutavia/world/workspace.hpp"

/// \file
/// reference_json: second readers of workspace files and GeoJSON.

namespace tutavia::test {

using ReferenceJson = nlohmann::json;
struct JsonRefused {};

inline void need(bool condition) {
  if (!condition) throw JsonRefused{};
}

/// Whether a JSON text has a number that is not 0 and that strtod makes 0.
inline bool has_vanishing_number(const std::string& text) {
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (in_string && text[i] == '\\') {
      ++i;
    } else if (text[i] == '"') {
      in_string = !in_string;
    } else if (!in_string && (text[i] == '-' || (text[i] >= '0' && text[i] <= '9'))) {
      const std::size_t end = std::min(text.find_first_not_of("+-.0123456789eE", i), text.size());
      const std::string number = text.substr(i, end - i);
      const std::string digits = number.substr(0, number.find_first_of("eE"));
      const bool is_zero = digits.find_first_of("123456789") == std::string::npos;
      if (!is_zero && std::strtod(number.c_str(), nullptr) == 0) return true;
      i = end - 1;
    }
  }
  return false;
}

inline ReferenceJson reference_json(const std::string& text) {
  std::vector<std::set<std::string>> keys(1);
  bool is_unique = true;
  const auto watch = [&](int, ReferenceJson::parse_event_t event, ReferenceJson& value) {
    if (event == ReferenceJson::parse_event_t::object_start) keys.emplace_back();
    if (event == ReferenceJson::parse_event_t::object_end) keys.pop_back();
    if (event == ReferenceJson::parse_event_t::key) {
      is_unique = keys.back().insert(value.get<std::string>()).second && is_unique;
    }
    return true;
  };
  need(text.find('\0') == std::string::npos);
  const ReferenceJson json = ReferenceJson::parse(text, watch, false);
  need(!json.is_discarded() && is_unique && !has_vanishing_number(text));
  return json;
}

inline std::vector<double> reference_numbers(const ReferenceJson& json) {
  need(json.is_array());
  std::vector<double> numbers;
  for (const ReferenceJson& item : json) {
    need(item.is_number());
    numbers.push_back(item.get<double>());
  }
  return numbers;
}
inline Point reference_pair(const ReferenceJson& json) {
  const auto xy = reference_numbers(json);
  need(xy.size() == 2);
  return {xy[0], xy[1]};
}
inline Ring reference_pairs(const ReferenceJson& json) {
  need(json.is_array());
  Ring ring;
  for (const ReferenceJson& item : json) ring.push_back(reference_pair(item));
  return ring;
}
/// Checks the members of a scene that say what to do in it. Missing and null are the same.
inline void check_reference_task(const ReferenceJson& json) {
  const auto given = [&](const char* key) { return json.contains(key) && !json[key].is_null(); };
  if (given("name")) need(json["name"].is_string());
  if (given("start")) reference_pair(json["start"]);
  if (given("goals")) reference_pairs(json["goals"]);
  if (given("resolution")) need(json["resolution"].is_number());
}

/// A workspace as parse_scene_json reads it, not validated, or nothing.
inline std::optional<Workspace> reference_scene(std::string text) {
  if (text.rfind("\xEF\xBB\xBF", 0) == 0) text.erase(0, 3);
  try {
    const ReferenceJson json = reference_json(text);
    need(json.is_object());
    for (const char* key : {"bounds", "safety_radius", "obstacles"}) need(json.contains(key));
    const auto b = reference_numbers(json["bounds"]);
    need(b.size() == 4 && json["safety_radius"].is_number() && json["obstacles"].is_array());
    Workspace workspace{.bounds = {{b[0], b[1]}, {b[2], b[3]}},
                        .safety_radius = json["safety_radius"].get<double>()};
    for (const ReferenceJson& item : json["obstacles"]) {
      need(item.is_object());
      need(item.count("polygon") + item.count("bbox") + item.count("center") == 1);
      if (item.contains("polygon")) {
        Polygon polygon{reference_pairs(item["polygon"])};
        if (item.contains("holes")) {
          need(item["holes"].is_array());
          for (const auto& hole : item["holes"]) polygon.holes.push_back(reference_pairs(hole));
        }
        workspace.obstacles.emplace_back(polygon);
      } else if (item.contains("bbox")) {
        const auto x = reference_numbers(item["bbox"]);
        need(x.size() == 4);
        workspace.obstacles.emplace_back(
            Polygon{{{x[0], x[1]}, {x[2], x[1]}, {x[2], x[3]}, {x[0], x[3]}}});
      } else {
        need(item.contains("radius") && item["radius"].is_number());
        workspace.obstacles.emplace_back(
            Disc{reference_pair(item["center"]), item["radius"].get<double>()});
      }
    }
    check_reference_task(json);
    return workspace;
  } catch (const JsonRefused&) {
    return std::nullopt;
  }
}

/// Walks over GeoJSON by the depth of its arrays.
class ReferenceGeoJson {
 public:
  static std::optional<std::vector<Obstacle>> read(std::string text) {
    if (text.rfind("\xEF\xBB\xBF", 0) == 0) text.erase(0, 3);
    try {
      ReferenceGeoJson walk;
      const std::vector<std::string> parts = split(text);
      for (const std::string& part : parts) {
        const ReferenceJson json = reference_json(part);
        walk.object(json, 0, 0);
        if (parts.size() == 1) check_members(json);
      }
      return walk.out_;
    } catch (const JsonRefused&) {
      return std::nullopt;
    }
  }

 private:
  /// The text by record separators or lines, if it is a sequence.
  static std::vector<std::string> split(const std::string& text) {
    const std::string blanks = " \t\n\r";
    const std::size_t first = text.find_first_not_of(blanks);
    char separator = 0;
    if (first != std::string::npos && text[first] == '\x1E') {
      separator = '\x1E';
    } else if (first != std::string::npos) {
      const std::size_t end = text.find('\n', first);
      const bool is_last = text.find_first_not_of(blanks, end) == std::string::npos;
      if (end != std::string::npos && !is_last &&
          ReferenceJson::accept(text.substr(first, end - first))) {
        separator = '\n';
      }
    }
    if (separator == 0) return {text};
    std::vector<std::string> parts{""};
    for (const char c : text) {
      if (c == separator) {
        parts.emplace_back();
      } else {
        parts.back() += c;
      }
    }
    std::vector<std::string> filled;
    for (const std::string& part : parts) {
      if (part.find_first_not_of(blanks) != std::string::npos) filled.push_back(part);
    }
    if (filled.empty()) filled.emplace_back();
    return filled;
  }

  static void check_members(const ReferenceJson& json) {
    const auto given = [&](const char* key) { return json.contains(key) && !json[key].is_null(); };
    if (given("bbox")) {
      const std::size_t size = reference_numbers(json["bbox"]).size();
      need(size == 4 || size == 6);
    }
    if (given("safety_radius")) need(json["safety_radius"].is_number());
    check_reference_task(json);
  }

  void object(const ReferenceJson& json, double radius, int depth) {
    need(json.is_object() && depth < 16 && json.contains("type") && json["type"].is_string());
    const auto type = json["type"].get<std::string>();
    const auto members = [&](const char* key, double inherited) {
      need(json.contains(key) && json[key].is_array());
      for (const ReferenceJson& item : json[key]) object(item, inherited, depth + 1);
    };
    if (type == "FeatureCollection") return members("features", 0);
    if (type == "GeometryCollection") return members("geometries", radius);
    if (type == "Feature") {
      double own = 0;
      if (json.contains("properties") && !json["properties"].is_null()) {
        need(json["properties"].is_object());
        const ReferenceJson properties = json["properties"];
        if (properties.contains("radius") && !properties["radius"].is_null()) {
          need(properties["radius"].is_number());
          own = properties["radius"].get<double>();
        }
      }
      need(json.contains("geometry"));
      if (!json["geometry"].is_null()) object(json["geometry"], own, depth + 1);
      return;
    }
    static const std::vector<std::string> types{"Point",           "MultiPoint", "LineString",
                                                "MultiLineString", "Polygon",    "MultiPolygon"};
    const auto known = std::find(types.begin(), types.end(), type);
    need(known != types.end() && json.contains("coordinates"));
    const auto index = known - types.begin();
    count_ = 0;
    geometry(json["coordinates"], static_cast<int>(index / 2), index % 2 == 1, radius);
  }

  /// `dimension` is 0 for points, 1 for lines and 2 for areas.
  void geometry(const ReferenceJson& json, int dimension, bool is_many, double radius) {
    need(json.is_array());
    if (is_many) {
      for (const ReferenceJson& item : json) geometry(item, dimension, false, radius);
    } else if (dimension == 0) {
      if (!json.empty()) out_.emplace_back(Disc{position(json), radius});
    } else if (dimension == 1) {
      const Ring points = positions(json);
      Ring wall = points;
      for (std::size_t i = points.size(); i > 1; --i) wall.push_back(points[i - 2]);
      if (!wall.empty()) out_.emplace_back(Polygon{wall});
    } else {
      std::vector<Ring> rings;
      for (const ReferenceJson& item : json) rings.push_back(positions(item));
      Polygon polygon;
      for (std::size_t i = 0; i < rings.size(); ++i) {
        if (i == 0) polygon.outer = rings[i];
        need(i == 0 || rings[i].empty() || !rings[0].empty());
        if (i > 0 && !rings[i].empty()) polygon.holes.push_back(rings[i]);
      }
      if (!polygon.outer.empty()) out_.emplace_back(polygon);
    }
  }
  Ring positions(const ReferenceJson& json) {
    need(json.is_array());
    Ring ring;
    for (const ReferenceJson& item : json) ring.push_back(position(item));
    return ring;
  }
  Point position(const ReferenceJson& json) {
    const auto numbers = reference_numbers(json);
    need(numbers.size() >= 2 && numbers.size() <= 4);
    if (count_ == 0) count_ = numbers.size();
    need(count_ == numbers.size());
    return {numbers[0], numbers[1]};
  }

  std::vector<Obstacle> out_;
  std::size_t count_ = 0;
};

}  // namespace tutavia::test
