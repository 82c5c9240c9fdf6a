// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tutavia/geometry/point.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/io/text/parse_error.hpp"
#include "tutavia/io/text/pgm.hpp"
#include "tutavia/io/text/read_file.hpp"
#include "tutavia/io/text/yaml_subset.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// ROS maps: the YAML and PGM files of map_server and nav2_map_server, and nav2's costmaps.

namespace tutavia {

/// A map as ROS publishes it (nav_msgs/OccupancyGrid).
struct RosMap {
  /// How to treat unknown cells.
  enum class UnknownCells { blocked, free };

  int width = 0;   ///< [cells]
  int height = 0;  ///< [cells]
  /// Row by row, row 0 is the BOTTOM of the map: -1 unknown, 0 free, ..., 100 occupied.
  std::vector<std::int8_t> values{};
  double resolution = 1;                ///< side of a cell [m]
  Point origin = Point::Zero();         ///< lower left corner of the map, in the map frame [m]
  double yaw = 0;                       ///< of the map's rows in the map frame, left positive [rad]
  std::vector<std::string> warnings{};  ///< ignored parts of the file, one line each
};

namespace detail {

/// The contents of the YAML file of a map. Size and values of `map` come from the image.
struct RosMapYaml {
  RosMap map{};
  std::string image{}, mode = "trinary";
  bool negate = false;
  double occupied_thresh = 0, free_thresh = 0;
};

inline RosMapYaml read_ros_map_yaml(YamlSubset& file) {
  constexpr double max = std::numeric_limits<double>::max();
  RosMapYaml yaml;
  yaml.image = file.value("image");
  yaml.map.resolution = file.number("resolution", 5e-324, max, "a number above 0");
  const auto origin = [&](std::size_t i) {
    return file.number("origin", -max, max, "x, y and yaw", i, 3);
  };
  yaml.map.origin = {origin(0), origin(1)};
  yaml.map.yaw = origin(2);
  const std::string& negate = file.value("negate");
  yaml.negate = negate == "1" || negate == "true";
  if (!yaml.negate && negate != "0" && negate != "false") file.reject("negate: 0 or 1", negate);
  yaml.occupied_thresh = file.number("occupied_thresh", 0, 1, "a number from 0 to 1");
  yaml.free_thresh =
      file.number("free_thresh", 0, yaml.occupied_thresh, "a number from 0 to occupied_thresh");
  if (file.has("mode")) yaml.mode = file.value("mode");
  if (yaml.mode != "trinary" && yaml.mode != "scale" && yaml.mode != "raw") {
    file.reject("mode: trinary, scale or raw", yaml.mode);
  }
  yaml.map.warnings = file.warnings();
  if (yaml.negate && yaml.mode == "raw") {
    yaml.map.warnings.emplace_back("negate changes nothing in raw mode");
  }
  return yaml;
}

inline Expected<RosMapYaml, Failure> parse_ros_map_yaml(std::string_view text) {
  return parse_or_fail([&] {
    YamlSubset file(text);
    return read_ros_map_yaml(file);
  });
}

inline RosMap make_ros_map(const RosMapYaml& yaml, const PgmImage& image) {
  RosMap map = yaml.map;
  map.width = image.width;
  map.height = image.height;
  const bool raw = yaml.mode == "raw", trinary = yaml.mode == "trinary";
  const double white = image.max_value, free = yaml.free_thresh, occupied = yaml.occupied_thresh;
  const auto value = [&](int pixel) -> long {
    if (raw) {
      const long shade = std::lround(255 * pixel / white);
      return shade <= 100 ? shade : -1;
    }
    const double occupancy = (yaml.negate ? pixel : white - pixel) / white;
    if (occupancy > occupied) return 100;
    if (occupancy < free) return 0;
    if (trinary) return -1;
    return free == occupied ? 100 : std::lrint((occupancy - free) / (occupied - free) * 100);
  };
  map.values.reserve(image.pixels.size());
  for (std::ptrdiff_t row = image.height; row-- > 0;) {
    for (std::ptrdiff_t column = 0; column < image.width; ++column) {
      const auto i = static_cast<std::size_t>(row * image.width + column);
      map.values.push_back(static_cast<std::int8_t>(value(image.pixels[i])));
    }
  }
  return map;
}

/// The grid whose cells are free where `is_free` holds for their value.
template <class Value, class IsFree>
Expected<OccupancyGrid, Failure> make_grid(std::span<const Value> values, int width, int height,
                                           IsFree is_free) {
  const auto cells = static_cast<std::int64_t>(width) * height;
  if (width >= 0 && height >= 0 && values.size() != static_cast<std::size_t>(cells)) {
    return fail(PlanError::invalid_input, "expected " + std::to_string(width) + " x " +
                                              std::to_string(height) + " values, found " +
                                              std::to_string(values.size()));
  }
  auto grid = OccupancyGrid::blocked(width, height);
  if (!grid) return grid;
  auto value = values.begin();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) grid->set({x, y}, is_free(*value++));
  }
  return grid;
}

}  // namespace detail

/// Parses a map from its YAML text and its image. Every key is required except `mode` (default:
/// trinary); unknown keys become warnings.
///
/// With occupancy = 1 - pixel / white, or pixel / white with `negate`:
/// - trinary: 100 above `occupied_thresh`, 0 below `free_thresh`, unknown otherwise
/// - scale: the same, but linear in between, rounded to whole numbers
/// - raw: the pixel itself, on a scale with white = 255, up to 100; unknown above. `negate`
///   changes nothing.
///
/// This follows nav2 up to Humble and, in trinary mode, ROS 1. Later versions of nav2 treat a pixel
/// exactly at a threshold as occupied or free; here it is unknown.
///
/// The supported subset of YAML is one scalar or list per key. Errors: `invalid_input` with the
/// line of anything else, or the byte of the image; `limit_exceeded` as in `parse_pgm`.
inline Expected<RosMap, Failure> parse_ros_map(std::string_view yaml, std::string_view pgm) {
  const auto head = detail::parse_ros_map_yaml(yaml);
  if (!head) return Unexpected{head.error()};
  const auto image = detail::parse_pgm(pgm);
  if (!image) return Unexpected{image.error()};
  return detail::make_ros_map(*head, *image);
}

/// Reads a YAML file and its image with `parse_ros_map`. A relative image path starts at the folder
/// of the YAML file. Details of failures start with the file's name.
inline Expected<RosMap, Failure> read_ros_map(const std::filesystem::path& yaml_path) {
  const auto head = detail::read_file(yaml_path, detail::parse_ros_map_yaml);
  if (!head) return Unexpected{head.error()};
  const auto image = detail::read_file(yaml_path.parent_path() / head->image, detail::parse_pgm);
  if (!image) return Unexpected{image.error()};
  return detail::make_ros_map(*head, *image);
}

/// The map as a grid; row 0 is the map's bottom row. In the grid frame, cell (x, y) is the square
/// from (x, y) to (x + 1, y + 1), times the resolution.
///
/// Cells with values of `occupied_at` or more are blocked. 100 is the value of nav2's static layer;
/// for a map in scale mode it blocks only cells of full certainty. Errors: `invalid_option` for an
/// `occupied_at` outside 1 to 100; `invalid_input` if the values are not width x height, or one is
/// outside -1 to 100.
inline Expected<OccupancyGrid, Failure> to_grid(const RosMap& map, RosMap::UnknownCells unknown,
                                                int occupied_at = 100) {
  if (occupied_at < 1 || occupied_at > 100) {
    return fail(PlanError::invalid_option,
                "occupied_at: expected 1 to 100, found " + std::to_string(occupied_at));
  }
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    if (map.values[i] >= -1 && map.values[i] <= 100) continue;
    return fail(PlanError::invalid_input, "values[" + std::to_string(i) +
                                              "]: expected -1 to 100, found " +
                                              std::to_string(map.values[i]));
  }
  return detail::make_grid(std::span(map.values), map.width, map.height, [&](int value) {
    return value < 0 ? unknown == RosMap::UnknownCells::free : value < occupied_at;
  });
}

/// Converts a point from the map frame to the grid frame, both in metres. The grid frame has its
/// origin at the lower left corner of the map's image, x along the rows to the right and y upwards.
inline Point to_grid_frame(const RosMap& map, const Point& in_map) {
  const double c = std::cos(map.yaw), s = std::sin(map.yaw);
  const double dx = in_map.x() - map.origin.x(), dy = in_map.y() - map.origin.y();
  return {c * dx + s * dy, c * dy - s * dx};
}

/// The inverse of `to_grid_frame`.
inline Point to_map_frame(const RosMap& map, const Point& in_grid) {
  const double c = std::cos(map.yaw), s = std::sin(map.yaw);
  return {map.origin.x() + c * in_grid.x() - s * in_grid.y(),
          map.origin.y() + s * in_grid.x() + c * in_grid.y()};
}

/// A costmap of nav2 (nav2_costmap_2d) as a grid; row 0 is the bottom row, 255 is unknown.
///
/// Cells of cost `blocked_at` or more are blocked: use 254 (lethal: an obstacle) if the planner
/// keeps its own safety radius, 253 (inscribed: a robot centred here collides) if it keeps none.
/// Lower costs are dropped; for soft costs see clearance_costs. Example: examples/ros_costmap.cpp.
/// Errors: `invalid_option` for a `blocked_at` outside 1 to 254; `invalid_input` if there are not
/// width x height values.
inline Expected<OccupancyGrid, Failure> grid_from_costmap(std::span<const std::uint8_t> costs,
                                                          int width, int height, int blocked_at,
                                                          RosMap::UnknownCells unknown) {
  if (blocked_at < 1 || blocked_at > 254) {
    return fail(PlanError::invalid_option,
                "blocked_at: expected 1 to 254, found " + std::to_string(blocked_at));
  }
  return detail::make_grid(costs, width, height, [&](int cost) {
    return cost == 255 ? unknown == RosMap::UnknownCells::free : cost < blocked_at;
  });
}

}  // namespace tutavia
