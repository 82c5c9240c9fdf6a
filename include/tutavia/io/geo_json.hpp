// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

#include "tutavia/io/text/geo_json_reader.hpp"
#include "tutavia/io/text/parse_error.hpp"
#include "tutavia/io/text/read_file.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/world/scene.hpp"

/// \file
/// parse_geo_json: workspaces from GeoJSON.

namespace tutavia {

/// Parses obstacles from GeoJSON (RFC 7946), coordinates in metres: polygons with holes, lines
/// (walls without thickness) and points; a feature's property `radius` turns its points into discs.
/// A geometry that is null or has empty coordinates is no obstacle. The text may also be a sequence
/// of objects (RFC 8142): each behind a record separator, or one a line.
///
/// The top level may have further members: `safety_radius`, `name`, `start`, `goals`, `resolution`;
/// `bbox`, of 4 or 6 numbers, gives the bounds. If they are missing, null or those of a sequence,
/// the bounds are empty and the radius is NaN, which no space accepts: set them before use.
///
/// The positions of a geometry have two to four ordinates, all as many; those after x and y are
/// dropped. A ring that does not end where it begins is closed, and `crs` is ignored. Each of these
/// gives one warning, and so do coordinates that look like degrees. Errors: `invalid_input` as for
/// `parse_scene_json`. Obstacles are not validated before a space is built.
inline Expected<SceneFile, Failure> parse_geo_json(std::string_view text) {
  return detail::parse_or_fail([&] { return detail::GeoJsonReader().read(text); });
}

/// Reads a file with `parse_geo_json`; details of failures start with the file's name.
inline Expected<SceneFile, Failure> read_geo_json(const std::filesystem::path& path) {
  return detail::read_file(path, parse_geo_json);
}

}  // namespace tutavia
