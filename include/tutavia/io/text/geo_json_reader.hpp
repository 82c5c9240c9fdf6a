// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/io/text/degrees.hpp"
#include "tutavia/io/text/fields_json.hpp"
#include "tutavia/io/text/json_text.hpp"
#include "tutavia/io/text/parse_error.hpp"
#include "tutavia/io/text/source_text.hpp"
#include "tutavia/world/scene.hpp"

/// \file
/// GeoJsonReader: the parser behind parse_geo_json.

namespace tutavia::detail {

/// Collects the obstacles of GeoJSON objects (RFC 7946).
class GeoJsonReader {
 public:
  using Json = nlohmann::json;

  GeoJsonReader() {
    file_.scene.workspace.safety_radius = std::numeric_limits<double>::quiet_NaN();
  }

  /// Reads one object, or a sequence of them (RFC 8142). Throws ParseError.
  SceneFile read(std::string_view text) {
    text = without_byte_order_mark(text);
    const std::vector<Part> parts = parts_of(text);
    for (const Part& part : parts) {
      const Json json = parse_json_text(text, part.begin, part.end);
      if (parts.size() == 1) {
        object(json, "the file", 0, 0);
        read_members(json);
      } else {
        const std::string line = std::to_string(line_number(text, part.begin));
        object(json, std::string("line ").append(line).append(": the object"), 0, 0);
      }
      warn_of_crs(json);
    }
    warn_of_degrees(file_.scene, file_.warnings);
    return std::move(file_);
  }

 private:
  /// The bytes [begin, end) of a text.
  struct Part {
    std::size_t begin = 0, end = 0;
  };

  /// The objects of a text: what follows each record separator, else each line if the first line
  /// is a whole object, else all of it.
  static std::vector<Part> parts_of(std::string_view text) {
    constexpr char record_separator = '\x1E';
    const std::size_t first = skip_blanks(text, 0);
    if (first == text.size()) return {{0, text.size()}};
    if (text[first] == record_separator) return split(text, first + 1, record_separator);
    const std::size_t line_end = std::min(text.find('\n', first), text.size());
    if (skip_blanks(text, line_end) == text.size() ||
        !Json::accept(text.substr(first, line_end - first))) {
      return {{0, text.size()}};
    }
    return split(text, first, '\n');
  }
  /// The parts between separators that are not blank; the whole rest if all are.
  static std::vector<Part> split(std::string_view text, std::size_t from, char separator) {
    std::vector<Part> parts;
    for (std::size_t begin = from; begin < text.size();) {
      const std::size_t end = std::min(text.find(separator, begin), text.size());
      const std::size_t filled = skip_blanks(text.substr(0, end), begin);
      if (filled < end) parts.push_back({filled, end});
      begin = end + 1;
    }
    if (parts.empty()) parts.push_back({from, text.size()});
    return parts;
  }
  /// Skips the white space of JSON, which has fewer characters than that of ASCII.
  static std::size_t skip_blanks(std::string_view text, std::size_t at) {
    return std::min(text.find_first_not_of(" \t\r\n", at), text.size());
  }

  /// Members of the top level beside those of its type.
  void read_members(const Json& json) {
    namespace fields = json_fields;
    Scene& scene = file_.scene;
    if (const Json* box = fields::optional_field(json, "bbox")) {
      fields::require(fields::is_numbers(*box) && (box->size() == 4 || box->size() == 6), "bbox",
                      "4 or 6 numbers");
      const std::size_t max = box->size() / 2;  // two or three minima, then as many maxima
      scene.workspace.bounds = {{(*box)[0].get<double>(), (*box)[1].get<double>()},
                                {(*box)[max].get<double>(), (*box)[max + 1].get<double>()}};
    }
    if (const Json* radius = fields::optional_field(json, "safety_radius")) {
      scene.workspace.safety_radius = fields::number(*radius, "safety_radius");
    }
    fields::read_task(json, scene);
  }

  void warn_of_crs(const Json& json) {
    const Json* crs = json_fields::optional_field(json, "crs");
    if (crs == nullptr) return;
    const Json* name = nullptr;
    if (crs->is_object()) {
      const Json* properties = json_fields::optional_field(*crs, "properties");
      if (properties != nullptr && properties->is_object()) {
        name = json_fields::optional_field(*properties, "name");
      }
    }
    warn_once(crs_,
              "crs " +
                  (name != nullptr && name->is_string() ? printable_line(name->get<std::string>())
                                                        : "of unknown form") +
                  " is ignored; coordinates are taken as metres");
  }

  /// `radius` is the radius of points, from the feature that contains the object.
  void object(const Json& json, const std::string& name, double radius, int depth) {
    namespace fields = json_fields;
    constexpr int deepest = 16;
    fields::require(json.is_object(), name, "an object");
    fields::require(depth < deepest, name, "collections nested less than 16 deep");
    const std::string type = fields::string(fields::field(json, "type", name), name + ".type");
    if (type == "FeatureCollection") {
      fields::each(fields::field(json, "features", name), name + ".features",
                   [&](const Json& item, const std::string& item_name) {
                     object(item, item_name, 0, depth + 1);
                   });
    } else if (type == "GeometryCollection") {
      fields::each(fields::field(json, "geometries", name), name + ".geometries",
                   [&](const Json& item, const std::string& item_name) {
                     object(item, item_name, radius, depth + 1);
                   });
    } else if (type == "Feature") {
      const double own_radius = radius_of(json, name);
      const Json& geometry = fields::field(json, "geometry", name);
      if (!geometry.is_null()) object(geometry, name + ".geometry", own_radius, depth + 1);
    } else {
      ordinates_ = 0;
      coordinates(fields::field(json, "coordinates", name), type, name + ".coordinates", radius);
    }
  }

  /// The property `radius` of a feature, or 0.
  static double radius_of(const Json& feature, const std::string& name) {
    namespace fields = json_fields;
    const Json* properties = fields::optional_field(feature, "properties");
    if (properties == nullptr) return 0;
    fields::require(properties->is_object(), name + ".properties", "an object or null");
    const Json* radius = fields::optional_field(*properties, "radius");
    return radius == nullptr ? 0 : fields::number(*radius, name + ".properties.radius");
  }

  void coordinates(const Json& json, const std::string& type, const std::string& name,
                   double radius) {
    namespace fields = json_fields;
    constexpr std::string_view multi = "Multi";
    std::vector<Obstacle>& obstacles = file_.scene.workspace.obstacles;
    if (type == "Point") {
      fields::require(json.is_array(), name, "an array");
      if (!json.empty()) obstacles.emplace_back(Disc{position(json, name), radius});
    } else if (type == "LineString") {
      Ring points = positions(json, name);
      if (!points.empty()) obstacles.emplace_back(polyline_obstacle(std::move(points)));
    } else if (type == "Polygon") {
      polygon(json, name);
    } else if (type == "MultiPoint" || type == "MultiLineString" || type == "MultiPolygon") {
      fields::each(json, name, [&](const Json& item, const std::string& item_name) {
        coordinates(item, type.substr(multi.size()), item_name, radius);
      });
    } else {
      throw ParseError{name + ": unknown geometry type " + shown_text(type)};
    }
  }

  void polygon(const Json& json, const std::string& name) {
    Polygon polygon;
    bool is_outer = true;
    json_fields::each(json, name, [&](const Json& item, const std::string& item_name) {
      Ring ring = positions(item, item_name);
      if (!ring.empty() && ring.front() != ring.back()) {
        warn_once(open_, item_name + ": a ring that does not end where it begins is closed");
      }
      if (is_outer) {
        polygon.outer = std::move(ring);
      } else if (!ring.empty()) {
        json_fields::require(!polygon.outer.empty(), item_name, "no hole without an outer ring");
        polygon.holes.push_back(std::move(ring));
      }
      is_outer = false;
    });
    if (!polygon.outer.empty()) {
      file_.scene.workspace.obstacles.emplace_back(std::move(polygon));
    }
  }

  Ring positions(const Json& json, const std::string& name) {
    Ring result;
    json_fields::each(json, name, [&](const Json& item, const std::string& item_name) {
      result.push_back(position(item, item_name));
    });
    return result;
  }

  /// Reads x and y; a third and a fourth ordinate are dropped.
  Point position(const Json& json, const std::string& name) {
    json_fields::require(json_fields::is_numbers(json) && json.size() >= 2 && json.size() <= 4,
                         name, "2 to 4 numbers");
    if (ordinates_ == 0) ordinates_ = json.size();
    if (json.size() != ordinates_) {
      throw ParseError{name + ": a position of " + std::to_string(json.size()) +
                       " ordinates in a geometry of " + std::to_string(ordinates_)};
    }
    if (ordinates_ > 2) warn_once(dropped_, name + ": ordinates beyond x and y are dropped");
    return {json[0].get<double>(), json[1].get<double>()};
  }

  void warn_once(bool& is_said, std::string warning) {
    if (!is_said) file_.warnings.push_back(std::move(warning));
    is_said = true;
  }

  SceneFile file_;
  std::size_t ordinates_ = 0;  // per position of the current geometry; 0 before its first
  bool dropped_ = false, open_ = false, crs_ = false;  // said already
};

}  // namespace tutavia::detail
