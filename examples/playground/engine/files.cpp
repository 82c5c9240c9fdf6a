// SPDX-License-Identifier: MIT
#include "files.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "../../plan/map_input.hpp"
#include "../../plan/usage_error.hpp"
#include "tutavia/io/geo_json.hpp"
#include "tutavia/io/moving_ai.hpp"
#include "tutavia/io/ros_map.hpp"
#include "tutavia/io/text/fields_json.hpp"
#include "tutavia/io/text/image_stb.hpp"
#include "tutavia/io/text/ros_map_values.hpp"
#include "tutavia/io/text/ros_settings.hpp"
#include "tutavia/io/wkt.hpp"
#include "tutavia/io/workspace_json.hpp"

namespace playground {

using namespace tutavia;
using plan_program::UsageError;
using plan_program::value_or_throw;
using Json = nlohmann::ordered_json;

namespace {

namespace fields = tutavia::detail::json_fields;

/// A scene without bounds or radius gets those that a page can begin with.
Reply reply_with(Scene scene, std::vector<std::string> warnings) {
  Workspace& workspace = scene.workspace;
  if (std::isnan(workspace.safety_radius)) workspace.safety_radius = 0;
  if (!detail::is_finite(workspace.bounds.min)) {
    workspace.bounds = plan_program::bounds_around(scene);
    warnings.emplace_back("the file says no bounds: a box around its obstacles is taken");
  }
  plan_program::throw_failure(validate(workspace));
  return {Json{{"warnings", std::move(warnings)}, {"workspace", scene_to_json(scene)}}.dump()};
}

Reply reply_with(const OccupancyGrid& grid, Json cells, const std::vector<std::string>& warnings) {
  std::string bytes;
  bytes.reserve(static_cast<std::size_t>(grid.width()) * static_cast<std::size_t>(grid.height()));
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) bytes.push_back(grid.is_free({x, y}) ? 1 : 0);
  }
  cells["width"] = grid.width();
  cells["height"] = grid.height();
  cells["safety_radius"] = 0;
  return {Json{{"warnings", warnings}, {"cells", std::move(cells)}}.dump(), std::move(bytes)};
}

Reply open_wkt(std::string_view text, const nlohmann::json& request) {
  const auto* const column = fields::optional_field(request, "wkt_column");
  WktObstacles read = value_or_throw(parse_wkt(
      text, {.csv_column = column == nullptr ? "" : fields::string(*column, "wkt_column")}));
  Scene scene;
  scene.workspace.obstacles = std::move(read.obstacles);
  scene.workspace.safety_radius = 0;
  return reply_with(std::move(scene), std::move(read.warnings));
}

Reply open_moving_ai(std::string_view text, const nlohmann::json& request,
                     const std::string& name) {
  const std::string terrain = request.value("terrain", "refused");
  const OccupancyGrid grid = plan_program::cells_or_throw(
      parse_moving_ai_map(text, plan_program::moving_ai_options(terrain)), "terrain");
  return reply_with(grid, {{"name", name}, {"resolution", 1}, {"origin", {0, 0}}, {"y_down", true}},
                    {});
}

detail::YamlDocument yaml_of(const nlohmann::json& nodes) {
  using Kind = detail::YamlNode::Kind;
  detail::YamlDocument document;
  fields::each(nodes, "yaml", [&](const nlohmann::json& item, const std::string& name) {
    const std::string kind = fields::string(fields::field(item, "kind", name), name + ".kind");
    detail::YamlNode node{.kind = kind == "scalar" ? Kind::scalar
                                  : kind == "list" ? Kind::list
                                  : kind == "map"  ? Kind::map
                                                   : Kind::nothing,
                          .line = item.value("line", std::size_t{0}),
                          .text = item.value("text", ""),
                          .children = item.value("children", std::vector<std::size_t>{})};
    for (const std::size_t child : node.children) {
      fields::require(child < nodes.size(), name + ".children", "indices of nodes");
    }
    document.push_back(std::move(node));
  });
  fields::require(!document.empty(), "yaml", "a root");
  return document;
}

}  // namespace

Reply builtin_scene(const nlohmann::json& request) {
  const std::string name = fields::string(fields::field(request, "name"), "name");
  if (auto scene = plan_program::builtin_map(name)) return reply_with(std::move(*scene), {});
  throw UsageError{"no built-in map is named " + name};
}

Reply open_file(const nlohmann::json& request, std::string_view bytes) {
  const std::string name = fields::string(fields::field(request, "name"), "name");
  std::string lower = name;
  for (char& c : lower) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  const auto opened = [&](Expected<SceneFile, Failure> read) {
    SceneFile file = value_or_throw(std::move(read));
    return reply_with(std::move(file.scene), std::move(file.warnings));
  };
  if (lower.ends_with(".json")) return opened(parse_scene_json(bytes));
  if (lower.ends_with(".geojson")) return opened(parse_geo_json(bytes));
  if (lower.ends_with(".wkt") || lower.ends_with(".csv")) return open_wkt(bytes, request);
  if (lower.ends_with(".map")) return open_moving_ai(bytes, request, name);
  throw UsageError{name +
                   ": unknown kind of file (.json, .geojson, .wkt, .csv, .map, .scen, or .yaml "
                   "together with its image)"};
}

Reply open_ros_map(const nlohmann::json& request, std::string_view bytes) {
  const bool blocks_unknown = request.value("unknown", "blocked") != "free";
  const auto settings = value_or_throw(detail::parse_or_fail(
      [&] { return detail::RosSettingsReader(yaml_of(fields::field(request, "yaml"))).read(); }));
  const RosMap map = detail::make_ros_map(
      settings, value_or_throw(detail::parse_image(bytes, detail::alpha_rule(settings.mode))));
  Json cells{{"name", request.value("name", "")}, {"resolution", map.resolution}};
  if (map.yaw == 0) {
    cells["origin"] = {map.origin.x(), map.origin.y()};
  } else {
    cells["origin"] = {0, 0};
    cells["map"] = {{"origin", {map.origin.x(), map.origin.y()}}, {"yaw", map.yaw}};
  }
  return reply_with(value_or_throw(to_grid(map, blocks_unknown ? RosMap::UnknownCells::blocked
                                                               : RosMap::UnknownCells::free)),
                    std::move(cells), map.warnings);
}

Reply open_scenarios(std::string_view bytes) {
  Json rows = Json::array();
  for (const ScenarioRow& row : value_or_throw(parse_moving_ai_scenario(bytes))) {
    // A path leads from the middle of a cell to that of another.
    rows.push_back({{"map", row.map},
                    {"start", {row.start.x + 0.5, row.start.y + 0.5}},
                    {"goal", {row.goal.x + 0.5, row.goal.y + 0.5}},
                    {"optimum", row.optimal_length}});
  }
  return {Json{{"scenarios", std::move(rows)}}.dump()};
}

}  // namespace playground
