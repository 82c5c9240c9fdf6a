// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "tutavia/io/text/fields_json.hpp"
#include "tutavia/io/text/parse_error.hpp"
#include "tutavia/io/text/read_file.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/world/scene.hpp"

/// \file
/// parse_geo_json: workspaces from GeoJSON.

namespace tutavia {

namespace detail {

/// Collects the obstacles of a GeoJSON object (RFC 7946).
class GeoJsonReader {
 public:
  using Json = nlohmann::json;

  static SceneFile read(const Json& json) {
    namespace fields = json_fields;
    SceneFile file;
    Scene& scene = file.scene;
    GeoJsonReader reader(scene.workspace);
    scene.workspace.safety_radius = std::numeric_limits<double>::quiet_NaN();
    reader.object(json, "the file", 0, 0);
    if (json.contains("bbox")) scene.workspace.bounds = fields::box(json["bbox"], "bbox");
    if (json.contains("safety_radius")) {
      scene.workspace.safety_radius = fields::number(json["safety_radius"], "safety_radius");
    }
    fields::read_task(json, scene);
    return file;
  }

 private:
  explicit GeoJsonReader(Workspace& workspace) : out_(workspace) {}

  /// `radius` is the radius of points, from the feature that contains the object.
  void object(const Json& json, const std::string& name, double radius, int depth) {
    namespace fields = json_fields;
    constexpr int deepest = 16;
    fields::require(json.is_object(), name, "an object");
    fields::require(depth < deepest, name, "collections nested less than 16 deep");
    const std::string type = fields::string(fields::field(json, "type"), name + ".type");
    if (type == "FeatureCollection") {
      fields::each(fields::field(json, "features"), name + ".features",
                   [&](const Json& item, const std::string& item_name) {
                     object(item, item_name, 0, depth + 1);
                   });
    } else if (type == "GeometryCollection") {
      fields::each(fields::field(json, "geometries"), name + ".geometries",
                   [&](const Json& item, const std::string& item_name) {
                     object(item, item_name, radius, depth + 1);
                   });
    } else if (type == "Feature") {
      double own_radius = 0;
      if (json.contains("properties") && json["properties"].is_object() &&
          json["properties"].contains("radius")) {
        own_radius = fields::number(json["properties"]["radius"], name + ".properties.radius");
      }
      const Json& geometry = fields::field(json, "geometry");
      if (!geometry.is_null()) object(geometry, name + ".geometry", own_radius, depth + 1);
    } else {
      coordinates(fields::field(json, "coordinates"), type, name + ".coordinates", radius);
    }
  }

  void coordinates(const Json& json, const std::string& type, const std::string& name,
                   double radius) {
    namespace fields = json_fields;
    constexpr std::string_view multi = "Multi";
    if (type == "Point") {
      out_.obstacles.emplace_back(Disc{fields::point(json, name, true), radius});
    } else if (type == "LineString") {
      out_.obstacles.emplace_back(polyline_obstacle(fields::ring(json, name, true)));
    } else if (type == "Polygon") {
      Polygon polygon;
      fields::each(json, name, [&](const Json& item, const std::string& item_name) {
        Ring ring = fields::ring(item, item_name, true);
        if (item_name == name + "[0]") {
          polygon.outer = std::move(ring);
        } else {
          polygon.holes.push_back(std::move(ring));
        }
      });
      out_.obstacles.emplace_back(std::move(polygon));
    } else if (type == "MultiPoint" || type == "MultiLineString" || type == "MultiPolygon") {
      fields::each(json, name, [&](const Json& item, const std::string& item_name) {
        coordinates(item, type.substr(multi.size()), item_name, radius);
      });
    } else {
      throw ParseError{name + ": unknown geometry type \"" + type + "\""};
    }
  }

  Workspace& out_;
};

}  // namespace detail

/// Parses obstacles from GeoJSON (RFC 7946), coordinates in metres: polygons with holes, lines
/// (walls without thickness) and points; a feature's property `radius` turns its points into discs.
/// The top level may have further members: `safety_radius`, `name`, `start`, `goals`, `resolution`;
/// `bbox` gives the bounds. If they are missing, the bounds are empty and the radius is NaN, which
/// no space accepts: set them before use. Errors: `invalid_input` as for `parse_scene_json`.
/// Obstacles are not validated before a space is built.
inline Expected<SceneFile, Failure> parse_geo_json(std::string_view text) {
  return detail::json_fields::parse_json(text, detail::GeoJsonReader::read);
}

/// Reads a file with `parse_geo_json`; details of failures start with the file's name.
inline Expected<SceneFile, Failure> read_geo_json(const std::filesystem::path& path) {
  return detail::read_file(path, parse_geo_json);
}

}  // namespace tutavia
