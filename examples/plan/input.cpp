// SPDX-License-Identifier: MIT
#include "input.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "input_options.hpp"
#include "map_input.hpp"
#include "ros_input.hpp"
#include "text_arguments.hpp"
#include "tutavia/grid/cell_costs.hpp"
#include "tutavia/grid/safety_buffer.hpp"
#include "tutavia/io/geo_json.hpp"
#include "tutavia/io/moving_ai.hpp"
#include "tutavia/io/ros_map.hpp"
#include "tutavia/io/text/read_file.hpp"
#include "tutavia/io/wkt.hpp"
#include "tutavia/io/workspace_json.hpp"
#include "tutavia/world/workspace_report.hpp"
#include "usage_error.hpp"

namespace plan_program {

namespace {

/// In lower case.
std::string extension(const std::string& path) {
  std::string text = std::filesystem::path(path).extension().string();
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

void print_warnings(const Arguments& args, const std::string& path,
                    const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    std::cerr << args.program << ": " << path << ": " << warning << '\n';
  }
}

SceneFile read_wkt(const Arguments& args) {
  WktObstacles read = value_or_throw(detail::read_file(args.workspace, [&](std::string_view text) {
    return parse_wkt(text, {.csv_column = args.wkt_column});
  }));
  SceneFile file{.scene = {}, .warnings = std::move(read.warnings)};
  file.scene.workspace.obstacles = std::move(read.obstacles);
  file.scene.workspace.safety_radius = std::numeric_limits<double>::quiet_NaN();
  return file;
}

SceneFile read_workspace(const Arguments& args) {
  const std::string& path = args.workspace;
  const std::string kind = extension(path);
  if (kind == ".csv" && args.wkt_column.empty()) {
    throw UsageError{path + ": name the column that holds WKT: give --wkt-column NAME"};
  }
  if (!args.wkt_column.empty() && kind != ".csv") {
    throw UsageError{"--wkt-column is for .csv files"};
  }
  if (kind == ".wkt" || kind == ".csv") return read_wkt(args);
  if (kind == ".json") return value_or_throw(read_scene_json(path));
  if (kind == ".geojson") return value_or_throw(read_geo_json(path));
  throw UsageError{path + ": unknown kind of file (.json, .geojson, .wkt or .csv)"};
}

/// Throws a UsageError that names the file and the obstacle, before bounds are made from them.
void check_obstacles(const std::string& path, Workspace& workspace) {
  Workspace obstacles_only{.bounds = {{0, 0}, {1, 1}}};
  std::swap(obstacles_only.obstacles, workspace.obstacles);
  const auto valid = validate(obstacles_only);
  std::swap(obstacles_only.obstacles, workspace.obstacles);
  if (!valid) throw UsageError{path + ": " + valid.error().detail};
}

Scene load_scene(const Arguments& args) {
  if (!args.workspace.empty()) {
    SceneFile file = read_workspace(args);
    print_warnings(args, args.workspace, file.warnings);
    check_obstacles(args.workspace, file.scene.workspace);
    return std::move(file.scene);
  }
  if (!args.wkt_column.empty()) throw UsageError{"--wkt-column is for --workspace"};
  if (auto scene = builtin_map(args.map.empty() ? "maze" : args.map)) return std::move(*scene);
  throw UsageError{"--map: unknown map \"" + args.map +
                   "\" (array, complex, maze, rrt_scene_1 or rrt_scene_2)"};
}

void override_start_and_goals(const Arguments& args, Scene& scene) {
  if (!args.start.empty()) scene.start = parse_point("--start", args.start);
  if (!args.goals.empty()) scene.goals.clear();
  for (const std::string& goal : args.goals) scene.goals.push_back(parse_point("--goal", goal));
  if (!detail::is_finite(scene.start)) throw UsageError{"no start: give --start X,Y"};
  if (scene.goals.empty()) throw UsageError{"no goal: give --goal X,Y"};
  if (args.time_limit && !(*args.time_limit >= 0)) {
    throw UsageError{"--time-limit must not be negative"};
  }
}

void override_workspace(const Arguments& args, Scene& scene) {
  Workspace& workspace = scene.workspace;
  if (args.radius) {
    workspace.safety_radius = *args.radius;
  } else if (std::isnan(workspace.safety_radius)) {
    throw UsageError{"no safety radius: give --radius R"};
  }
  if (!args.bounds.empty()) {
    const auto b = parse_numbers("--bounds", args.bounds, 4, "X0,Y0,X1,Y1");
    workspace.bounds = {{b[0], b[1]}, {b[2], b[3]}};
  } else if (!detail::is_finite(workspace.bounds.min)) {
    workspace.bounds = bounds_around(scene);
  }
  if (args.resolution) scene.resolution = *args.resolution;
}

void refuse_self_crossing(const std::string& path, const Workspace& workspace) {
  const auto& crossing = inspect(workspace).self_crossing;
  if (crossing.empty()) return;
  throw UsageError{(path.empty() ? path : path + ": ") + "obstacles[" +
                   std::to_string(crossing.front()) + "] crosses itself (--strict)"};
}

/// --unknown means nothing where no cell can be unknown.
void refuse_unknown(const Arguments& args) {
  if (args.unknown != "blocked") throw UsageError{"--unknown is for ROS maps (--grid FILE.yaml)"};
}

Task load_workspace(const Arguments& args) {
  refuse_unknown(args);
  if (args.buffer) {
    throw UsageError{"--buffer is for the cells of --grid; on a workspace give --radius R"};
  }
  if (args.terrain != "refused") throw UsageError{"--terrain is for the .map files of --grid"};
  Scene scene = load_scene(args);
  override_start_and_goals(args, scene);
  override_workspace(args, scene);
  throw_failure(validate(scene.workspace));
  if (args.strict) refuse_self_crossing(args.workspace, scene.workspace);
  LatticeSpace space = value_or_throw(LatticeSpace::build(
      scene.workspace,
      {.resolution = scene.resolution, .movement = args.movement, .edges = args.edges}));
  scene.resolution = space.frame().resolution;
  return {.scene = std::move(scene), .space = std::move(space)};
}

/// The cells of a grid map, and how they lie in the plane.
struct CellMap {
  OccupancyGrid cells;
  CellOptions options;
  MapFrame frame{};
  std::optional<RosMap> ros_map{};
  std::shared_ptr<const CellCosts> costs{};
  std::size_t blocked_unknown = 0;
};

/// Costs of unknown cells, times the length of a path there.
std::shared_ptr<const CellCosts> costs_of_unknown(const RosMap& map, const OccupancyGrid& cells,
                                                  double factor) {
  auto costs = std::make_shared<CellCosts>(cells);
  const auto extra = static_cast<std::uint8_t>(std::lround(32 * (factor - 1)));
  auto value = map.values.begin();
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      if (*value++ < 0) costs->set({x, y}, extra);
    }
  }
  return costs;
}

CellMap load_ros_map(const Arguments& args, CellOptions options) {
  RosMap map = load_ros_map_file(args.grid);
  print_warnings(args, args.grid, map.warnings);
  options.resolution = map.resolution;
  if (map.yaw == 0) options.origin = map.origin;  // else that of the grid's own frame
  const bool is_blocked = args.unknown == "blocked";
  CellMap cells{value_or_throw(to_grid(
                    map, is_blocked ? RosMap::UnknownCells::blocked : RosMap::UnknownCells::free)),
                options, MapFrame(map)};
  if (const auto factor = unknown_cost(args)) {
    cells.costs = costs_of_unknown(map, cells.cells, *factor);
  }
  if (is_blocked) {
    cells.blocked_unknown = static_cast<std::size_t>(
        std::count_if(map.values.begin(), map.values.end(), [](int value) { return value < 0; }));
  }
  map.values.clear();
  cells.ros_map = std::move(map);
  return cells;
}

CellMap load_cells(const Arguments& args) {
  if (!args.wkt_column.empty()) throw UsageError{"--wkt-column is for --workspace"};
  if (args.resolution || !args.bounds.empty()) {
    throw UsageError{"--grid brings its own resolution and bounds"};
  }
  if (args.edges != EdgeRule::uniform)
    throw UsageError{"--edges is for the lattice of a workspace"};
  const CellOptions options{.safety_radius = args.radius.value_or(0), .movement = args.movement};
  const std::string kind = extension(args.grid);
  if (args.terrain != "refused" && kind != ".map") throw UsageError{"--terrain is for .map files"};
  if (kind == ".yaml" || kind == ".yml") return load_ros_map(args, options);
  refuse_unknown(args);
  if (kind == ".pgm" || kind == ".png" || kind == ".bmp" || kind == ".jpg" || kind == ".jpeg") {
    throw UsageError{args.grid + ": give the .yaml file that names this image"};
  }
  if (kind != ".map") throw UsageError{args.grid + ": unknown kind of file (.map or .yaml)"};
  return {
      cells_or_throw(read_moving_ai_map(args.grid, moving_ai_options(args.terrain)), "--terrain"),
      options};
}

/// Adds the cells that contain a point: one, or all that meet there if it lies on their sides.
void add_cells_at(const CellMap& map, const Point& p, std::vector<Cell>& cells) {
  const Point u = (p - map.options.origin) / map.options.resolution;
  const double width = map.cells.width(), height = map.cells.height();
  if (!(u.x() >= 0 && u.x() <= width && u.y() >= 0 && u.y() <= height)) return;
  for (double y = std::ceil(u.y()) - 1; y <= std::floor(u.y()); ++y) {
    for (double x = std::ceil(u.x()) - 1; x <= std::floor(u.x()); ++x) {
      if (x < 0 || y < 0 || x >= width || y >= height) continue;
      cells.push_back({static_cast<int>(x), static_cast<int>(y)});
    }
  }
}

/// Blocks the safety buffer. The cells of start and goals in it stay free, which is said.
void add_buffer(const Arguments& args, const Scene& scene, CellMap& map) {
  std::vector<Cell> exempt;
  add_cells_at(map, map.frame.to_grid(scene.start), exempt);
  for (const Point& goal : scene.goals) add_cells_at(map, map.frame.to_grid(goal), exempt);
  auto buffered = with_safety_buffer(map.cells, exempt, *args.buffer);
  if (!buffered) throw UsageError{"--buffer: " + buffered.error().detail};
  map.cells = std::move(buffered->grid);
  for (const Cell& cell : buffered->exempted) {
    std::cerr << args.program << ": --buffer: cell (" << cell.x << ", " << cell.y
              << ") of the start or a goal lies in the buffer and stays free\n";
  }
}

Task load_grid(const Arguments& args) {
  CellMap map = load_cells(args);
  Scene scene;
  scene.name = std::filesystem::path(args.grid).filename().string();
  override_start_and_goals(args, scene);
  std::optional<OccupancyGrid> without_buffer;
  if (args.buffer) {
    without_buffer = map.cells;
    add_buffer(args, scene, map);
  }
  CellSpace space = value_or_throw(CellSpace::build(std::move(map.cells), map.options));
  scene.workspace = {.bounds = space.bounds(), .safety_radius = space.safety_radius()};
  return {.scene = std::move(scene),
          .space = std::move(space),
          .y_down = extension(args.grid) == ".map",
          .without_buffer = std::move(without_buffer),
          .frame = std::move(map.frame),
          .ros_map = std::move(map.ros_map),
          .costs = std::move(map.costs),
          .blocked_unknown = map.blocked_unknown};
}

}  // namespace

Task load_task(const Arguments& args) {
  return args.grid.empty() ? load_workspace(args) : load_grid(args);
}

}  // namespace plan_program
