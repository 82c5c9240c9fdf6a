// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "tutavia/io/text/degrees.hpp"
#include "tutavia/io/text/fields_json.hpp"
#include "tutavia/io/text/json_text.hpp"
#include "tutavia/io/text/parse_error.hpp"
#include "tutavia/io/text/read_file.hpp"
#include "tutavia/io/text/source_text.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/world/scene.hpp"

/// \file
/// parse_scene_json: workspaces and scenes from JSON.

namespace tutavia {

namespace detail {

inline Obstacle read_obstacle(const nlohmann::json& json, const std::string& name) {
  namespace fields = json_fields;
  fields::require(json.is_object(), name, "an object");
  const auto has = [&](const char* key) { return json.contains(key) ? 1 : 0; };
  fields::require(has("polygon") + has("bbox") + has("center") <= 1, name,
                  "one of \"polygon\", \"bbox\" and \"center\"");
  if (json.contains("polygon")) {
    Polygon polygon{fields::ring(json["polygon"], name + ".polygon")};
    if (json.contains("holes")) {
      fields::each(json["holes"], name + ".holes", [&](const auto& item, const std::string& hole) {
        polygon.holes.push_back(fields::ring(item, hole));
      });
    }
    return polygon;
  }
  if (json.contains("bbox")) {
    const Box b = fields::box(json["bbox"], name + ".bbox");
    return Polygon{{b.min, {b.max.x(), b.min.y()}, b.max, {b.min.x(), b.max.y()}}};
  }
  fields::require(json.contains("center") && json.contains("radius"), name,
                  "\"polygon\", \"bbox\" or \"center\" and \"radius\"");
  return Disc{fields::point(json["center"], name + ".center"),
              fields::number(json["radius"], name + ".radius")};
}

inline SceneFile read_scene(const nlohmann::json& json) {
  namespace fields = json_fields;
  SceneFile file;
  Scene& scene = file.scene;
  fields::require(json.is_object(), "the file", "an object");
  scene.workspace.bounds = fields::box(fields::field(json, "bounds"), "bounds");
  scene.workspace.safety_radius =
      fields::number(fields::field(json, "safety_radius"), "safety_radius");
  fields::each(fields::field(json, "obstacles"), "obstacles",
               [&](const auto& item, const std::string& name) {
                 scene.workspace.obstacles.push_back(read_obstacle(item, name));
               });
  fields::read_task(json, scene);

  constexpr std::array<std::string_view, 7> known{"bounds", "safety_radius", "obstacles", "name",
                                                  "start",  "goals",         "resolution"};
  for (const auto& [key, value] : json.items()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      file.warnings.push_back("unknown key \"" + printable_line(key) + "\" ignored");
    }
  }
  warn_of_degrees(scene, file.warnings);
  return file;
}

}  // namespace detail

/// Parses a workspace or scene: `bounds [x0,y0,x1,y1]`, `safety_radius`, `obstacles` (each
/// `{"polygon":[[x,y],...],"holes":[...]}`, `{"center":[x,y],"radius":R}` or
/// `{"bbox":[x0,y0,x1,y1]}`), optional `name`, `start`, `goals`, `resolution`; metres. Unknown keys
/// are ignored; each at top level gives a warning, and so do coordinates that look like degrees.
/// Errors: `invalid_input` with line and column, in bytes, for malformed JSON, a key that stands
/// twice and a number too large or too small for a double; with the field for a value of the wrong
/// type; and those of `validate`.
inline Expected<SceneFile, Failure> parse_scene_json(std::string_view text) {
  auto file =
      detail::parse_or_fail([&] { return detail::read_scene(detail::parse_json_text(text)); });
  if (!file) return file;
  if (const auto valid = validate(file->scene.workspace); !valid) return Unexpected{valid.error()};
  return file;
}

/// Reads a file with `parse_scene_json`; details of failures start with the file's name.
inline Expected<SceneFile, Failure> read_scene_json(const std::filesystem::path& path) {
  return detail::read_file(path, parse_scene_json);
}

/// A scene as JSON. `parse_scene_json` reads it back to an equal scene.
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
  if (scene.resolution) json["resolution"] = *scene.resolution;
  if (detail::is_finite(scene.start)) json["start"] = point(scene.start);
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
