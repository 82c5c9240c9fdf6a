// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/core/error.hpp"
#include "tutavia/world/scene.hpp"

/// \file
/// Workspaces and scenes in JSON.

namespace tutavia {

/// A scene as read, and what the reader passed over.
struct SceneFile {
  Scene scene;
  std::vector<std::string> warnings;  ///< one line each
};

namespace detail {

/// Reads the fields of a scene; the first thing that is wrong is thrown as a string that says
/// where.
class SceneReader {
 public:
  using Json = nlohmann::json;

  static SceneFile read(const Json& json) {
    SceneFile file;
    Scene& scene = file.scene;
    require(json.is_object(), "the file", "an object");
    scene.workspace.bounds = box(field(json, "bounds"), "bounds");
    scene.workspace.safety_radius = number(field(json, "safety_radius"), "safety_radius");
    each(field(json, "obstacles"), "obstacles", [&](const Json& item, const std::string& name) {
      scene.workspace.obstacles.push_back(obstacle(item, name));
    });
    if (json.contains("name")) {
      require(json["name"].is_string(), "name", "a string");
      scene.name = json["name"].get<std::string>();
    }
    if (json.contains("start")) scene.start = point(json["start"], "start");
    if (json.contains("goals")) {
      each(json["goals"], "goals", [&](const Json& item, const std::string& name) {
        scene.goals.push_back(point(item, name));
      });
    }
    if (json.contains("resolution")) scene.resolution = number(json["resolution"], "resolution");

    constexpr std::array<std::string_view, 7> known{"bounds", "safety_radius", "obstacles", "name",
                                                    "start",  "goals",         "resolution"};
    for (const auto& [key, value] : json.items()) {
      if (std::find(known.begin(), known.end(), key) == known.end()) {
        file.warnings.push_back("unknown key \"" + key + "\" ignored");
      }
    }
    return file;
  }

 private:
  static void require(bool condition, const std::string& name, const std::string& expected) {
    if (!condition) throw name + ": expected " + expected;
  }

  static const Json& field(const Json& json, const std::string& name) {
    if (!json.contains(name)) throw "\"" + name + "\" is missing";
    return json[name];
  }

  static double number(const Json& json, const std::string& name) {
    require(json.is_number(), name, "a number");
    return json.get<double>();
  }

  static Point point(const Json& json, const std::string& name) {
    require(json.is_array() && json.size() == 2 && json[0].is_number() && json[1].is_number(), name,
            "[x, y]");
    return {json[0].get<double>(), json[1].get<double>()};
  }

  static Box box(const Json& json, const std::string& name) {
    require(json.is_array() && json.size() == 4, name, "[x0, y0, x1, y1]");
    for (const Json& value : json) require(value.is_number(), name, "[x0, y0, x1, y1]");
    return {{json[0].get<double>(), json[1].get<double>()},
            {json[2].get<double>(), json[3].get<double>()}};
  }

  template <class Visit>
  static void each(const Json& json, const std::string& name, Visit visit) {
    require(json.is_array(), name, "an array");
    for (std::size_t i = 0; i < json.size(); ++i) {
      visit(json[i], name + "[" + std::to_string(i) + "]");
    }
  }

  static Ring ring(const Json& json, const std::string& name) {
    Ring result;
    each(json, name, [&](const Json& item, const std::string& item_name) {
      result.push_back(point(item, item_name));
    });
    return result;
  }

  static Obstacle obstacle(const Json& json, const std::string& name) {
    require(json.is_object(), name, "an object");
    if (json.contains("polygon")) {
      Polygon polygon{ring(json["polygon"], name + ".polygon")};
      if (json.contains("holes")) {
        each(json["holes"], name + ".holes", [&](const Json& item, const std::string& item_name) {
          polygon.holes.push_back(ring(item, item_name));
        });
      }
      return polygon;
    }
    if (json.contains("bbox")) {
      const Box b = box(json["bbox"], name + ".bbox");
      return Polygon{{b.min, {b.max.x(), b.min.y()}, b.max, {b.min.x(), b.max.y()}}};
    }
    require(json.contains("center") && json.contains("radius"), name,
            "\"polygon\", \"bbox\" or \"center\" and \"radius\"");
    return Disc{point(json["center"], name + ".center"), number(json["radius"], name + ".radius")};
  }
};

/// The parser's complaint without its internal prefix: "parse error at line 3, column 5: ...".
inline std::string json_complaint(const nlohmann::json::exception& error) {
  const std::string what = error.what();
  const std::size_t end = what.find("] ");
  return end == std::string::npos ? what : what.substr(end + 2);
}

}  // namespace detail

/// Parses a workspace or scene: `bounds [x0,y0,x1,y1]`, `safety_radius`, `obstacles` (each
/// `{"polygon":[[x,y],...],"holes":[...]}`, `{"center":[x,y],"radius":R}` or
/// `{"bbox":[x0,y0,x1,y1]}`), optional `name`, `start`, `goals`, `resolution`; metres. Unknown keys
/// are ignored, with a warning each for those at top level. `invalid_input` with line and column
/// for malformed JSON, with the field for a value of the wrong kind, and with what `validate`
/// finds.
inline Expected<SceneFile, Failure> parse_scene_json(std::string_view text) {
  try {
    SceneFile file = detail::SceneReader::read(nlohmann::json::parse(text));
    if (const auto valid = validate(file.scene.workspace); !valid) return Unexpected{valid.error()};
    return file;
  } catch (const nlohmann::json::exception& error) {
    return fail(PlanError::invalid_input, detail::json_complaint(error));
  } catch (const std::string& complaint) {
    return fail(PlanError::invalid_input, complaint);
  }
}

/// Reads a file with `parse_scene_json`; details begin with the file's name.
inline Expected<SceneFile, Failure> read_scene_json(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file.is_open() || file.bad()) {
    return fail(PlanError::invalid_input, path.string() + ": cannot be read");
  }
  auto result = parse_scene_json(text);
  if (!result) result.error().detail = path.string() + ": " + result.error().detail;
  return result;
}

/// A scene as JSON that `parse_scene_json` reads back to the same scene.
inline nlohmann::ordered_json scene_to_json(const Scene& scene) {
  using Json = nlohmann::ordered_json;
  const auto point = [](const Point& p) { return Json{p.x(), p.y()}; };
  const auto points = [&](const auto& list) {
    Json result = Json::array();
    for (const Point& p : list) result.push_back(point(p));
    return result;
  };
  const Box& b = scene.workspace.bounds;
  Json json;
  if (!scene.name.empty()) json["name"] = scene.name;
  json["bounds"] = {b.min.x(), b.min.y(), b.max.x(), b.max.y()};
  json["safety_radius"] = scene.workspace.safety_radius;
  if (scene.resolution > 0) json["resolution"] = scene.resolution;
  if (is_finite(scene.start)) json["start"] = point(scene.start);
  if (!scene.goals.empty()) json["goals"] = points(scene.goals);
  json["obstacles"] = Json::array();
  for (const Obstacle& obstacle : scene.workspace.obstacles) {
    Json item;
    if (const Disc* disc = std::get_if<Disc>(&obstacle)) {
      item["center"] = point(disc->center);
      item["radius"] = disc->radius;
    } else {
      const Polygon& polygon = std::get<Polygon>(obstacle);
      item["polygon"] = points(polygon.outer);
      for (const Ring& hole : polygon.holes) item["holes"].push_back(points(hole));
    }
    json["obstacles"].push_back(std::move(item));
  }
  return json;
}

}  // namespace tutavia
