// SPDX-License-Identifier: MIT
#include "stage.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>

#include "../../plan/blocked_boxes.hpp"
#include "../../plan/usage_error.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/io/ros_map.hpp"
#include "tutavia/io/text/fields_json.hpp"
#include "tutavia/io/workspace_json.hpp"
#include "tutavia/registry/movement_name.hpp"

namespace playground {

namespace {

namespace fields = tutavia::detail::json_fields;
using plan_program::PlanningSpace;
using plan_program::UsageError;
using plan_program::value_or_throw;

MovementRule movement_of(const nlohmann::json& request) {
  const auto* const name = fields::optional_field(request, "movement");
  if (name == nullptr) return MovementRule::no_cut;
  return value_or_throw(parse_movement_rule(fields::string(*name, "movement")));
}

LatticeSpace lattice_of(const nlohmann::json& request) {
  constexpr std::int64_t most_nodes = std::int64_t{1} << 22;  // a page has no time for more
  const Scene scene = detail::read_scene(request["workspace"]).scene;
  return value_or_throw(LatticeSpace::build(
      scene.workspace,
      {.resolution = scene.resolution, .movement = movement_of(request), .max_nodes = most_nodes}));
}

int size_of(const nlohmann::json& cells, const char* name) {
  const auto& size = fields::field(cells, name);
  fields::require(size.is_number_integer() && size >= 1 && size <= 1 << 14, name,
                  "a whole number from 1 to 16384");
  return size.get<int>();
}

OccupancyGrid grid_of(const nlohmann::json& cells, std::string_view bytes) {
  const int width = size_of(cells, "width"), height = size_of(cells, "height");
  return value_or_throw(detail::make_grid(std::span(bytes.data(), bytes.size()), width, height,
                                          [](char byte) { return byte != 0; }));
}

CellSpace cells_of(const nlohmann::json& request, std::string_view bytes) {
  const auto& cells = request["cells"];
  const CellOptions options{
      .resolution = fields::number(fields::field(cells, "resolution"), "resolution"),
      .origin = fields::point(fields::field(cells, "origin"), "origin"),
      .safety_radius = fields::number(fields::field(cells, "safety_radius"), "safety_radius"),
      .movement = movement_of(request)};
  return value_or_throw(CellSpace::build(grid_of(cells, bytes), options));
}

PlanningSpace space_of(const nlohmann::json& request, std::string_view bytes) {
  if (request.contains("workspace")) return lattice_of(request);
  if (request.contains("cells")) return cells_of(request, bytes);
  throw UsageError{"a scene has \"workspace\" or \"cells\""};
}

}  // namespace

Stage::Stage(const nlohmann::json& request, std::string_view bytes)
    : space_(space_of(request, bytes)) {
  const auto* const cells = fields::optional_field(request, "cells");
  if (cells == nullptr) return;
  y_down_ = cells->value("y_down", false);
  if (const auto* const map = fields::optional_field(*cells, "map")) {
    RosMap turned;
    turned.origin = fields::point(fields::field(*map, "origin"), "map.origin");
    turned.yaw = fields::number(fields::field(*map, "yaw"), "map.yaw");
    frame_ = plan_program::MapFrame(turned);
  }
}

double Stage::resolution() const {
  return std::visit([](const auto& space) { return space.frame().resolution; }, space_);
}

double Stage::safety_radius() const {
  return std::visit([](const auto& space) { return space.safety_radius(); }, space_);
}

Certificate Stage::certify(const Curve& curve) const {
  return std::visit([&](const auto& space) { return tutavia::certify(space, curve); }, space_);
}

Workspace Stage::obstacles() const {
  if (const auto* const lattice = std::get_if<LatticeSpace>(&space_)) return lattice->workspace();
  const auto& cells = std::get<CellSpace>(space_);
  Workspace workspace;
  workspace.safety_radius = cells.safety_radius();
  for (const Point& corner : plan_program::corners_of(cells.bounds(), frame_)) {
    workspace.bounds.include(corner);
  }
  plan_program::add_blocked_cells(cells.cells(), cells.bounds().min, cells.frame().resolution,
                                  frame_, workspace);
  return workspace;
}

}  // namespace playground
