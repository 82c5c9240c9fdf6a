// SPDX-License-Identifier: MIT
/// \file
/// tutavia-plan: plans on the built-in maps, on a workspace file or on the cells of a grid map,
/// from the command line.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/io/geo_json.hpp"
#include "tutavia/io/plan_json.hpp"
#include "tutavia/io/read_file.hpp"
#include "tutavia/io/trace_json.hpp"
#include "tutavia/io/wkt.hpp"
#include "tutavia/io/workspace_json.hpp"
#include "tutavia/registry.hpp"
#include "tutavia/tutavia.hpp"

namespace {

using namespace tutavia;

/// Bad usage or bad input: one line on stderr, exit code 2.
struct UsageError {
  std::string message;
};

struct Arguments {
  std::string map, workspace, grid, unknown = "blocked", start, bounds, search = "astar",
                                    smoother = "delta", json, svg, trace;
  std::vector<std::string> goals;
  std::optional<double> radius, resolution, time_limit;
  std::uint64_t seed = 0;
  bool compare = false, list = false, strict = false;
};

/// One query and its answer.
struct Result {
  ResultHeader header;
  Expected<Plan, Failure> plan;
  SearchRecord record{};  ///< what the search grew, where it is to be drawn
  /// Length of the shortest path there is, on workspaces, for tables and files that show it.
  std::optional<double> optimum{};
};

/// What one search with one smoother made of every goal.
using Group = std::vector<Result>;

void define_options(CLI::App& app, Arguments& args) {
  auto* map = app.add_option("--map", args.map,
                             "Built-in map: array, complex, maze, rrt_scene_1 or rrt_scene_2");
  app.add_option("--workspace", args.workspace, "Workspace file (.json, .geojson or .wkt)")
      ->excludes(map);
  app.add_option("--grid", args.grid, "Grid map: MovingAI (.map) or ROS map_server (.yaml)")
      ->excludes(map)
      ->excludes("--workspace");
  app.add_option("--unknown", args.unknown, "Unknown cells of a ROS map: blocked or free")
      ->capture_default_str()
      ->check(CLI::IsMember({"blocked", "free"}));
  app.add_option("--start", args.start, "Start, as X,Y in metres");
  app.add_option("--goal", args.goals, "Goal, as X,Y; may be repeated. Default: every goal given")
      ->allow_extra_args(false);
  app.add_option("--radius", args.radius, "Safety radius in metres");
  app.add_option("--bounds", args.bounds, "Bounds as X0,Y0,X1,Y1 in metres");
  app.add_flag("--strict", args.strict, "Refuse polygons that cross themselves");
  app.add_option("--resolution", args.resolution, "Lattice spacing in metres");
  app.add_option("--search", args.search, "Search, or a comma list of them (any_angle: on grids)")
      ->capture_default_str();
  app.add_option("--smoother", args.smoother,
                 "Smoother, or a comma list of them; A+B is a pipeline: B smooths what A made")
      ->capture_default_str();
  app.add_option("--seed", args.seed, "Seed for searches that draw random numbers");
  app.add_option("--time-limit", args.time_limit, "Seconds per query");
  app.add_option("--json", args.json, "Write the results as JSON; - for stdout");
  app.add_option("--svg", args.svg, "Draw the plans");
  app.add_option("--trace", args.trace,
                 "Write what the searches did, a line of JSON for each step");
  app.add_flag("--compare", args.compare,
               "All searches with the smoother, and all smoothers with the search");
  app.add_flag("--list", args.list, "Print the names of searches and smoothers");
}

/// The parts of a text between separators, empty ones among them.
std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

std::optional<double> parse_number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// The numbers of a comma list.
std::vector<double> parse_numbers(const std::string& option, const std::string& text,
                                  std::size_t count, const char* form) {
  const std::vector<std::string> parts = split(text, ',');
  std::vector<double> numbers;
  for (const std::string& part : parts) {
    const auto number = parse_number(part);
    if (number && std::isfinite(*number)) numbers.push_back(*number);
  }
  if (parts.size() == count && numbers.size() == count) return numbers;
  throw UsageError{option + ": expected " + form + " with finite numbers, got \"" + text + "\""};
}

Point parse_point(const std::string& option, const std::string& text) {
  const std::vector<double> numbers = parse_numbers(option, text, 2, "X,Y");
  return {numbers[0], numbers[1]};
}

template <class T>
T value_or_usage_error(Expected<T, Failure> result) {
  if (!result) throw UsageError{result.error().detail};
  return std::move(*result);
}

SceneFile load_file(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension == ".json") return value_or_usage_error(read_scene_json(path));
  if (extension == ".geojson") return value_or_usage_error(read_geo_json(path));
  if (extension == ".wkt") {
    WktObstacles read = value_or_usage_error(read_file(path, parse_wkt));
    SceneFile file{.scene = {}, .warnings = std::move(read.warnings)};
    file.scene.workspace.obstacles = std::move(read.obstacles);
    file.scene.workspace.safety_radius = std::numeric_limits<double>::quiet_NaN();
    return file;
  }
  throw UsageError{path + ": unknown kind of file (.json, .geojson or .wkt)"};
}

Scene load_scene(const Arguments& args) {
  if (!args.workspace.empty()) {
    SceneFile file = load_file(args.workspace);
    for (const std::string& warning : file.warnings) {
      std::cerr << "tutavia-plan: " << args.workspace << ": " << warning << '\n';
    }
    return std::move(file.scene);
  }
  if (args.map.empty() || args.map == "maze") return maps::maze();
  if (args.map == "array") return maps::array();
  if (args.map == "complex") return maps::complex();
  if (args.map == "rrt_scene_1") return maps::rrt_scene_1();
  if (args.map == "rrt_scene_2") return maps::rrt_scene_2();
  throw UsageError{"--map: unknown map \"" + args.map +
                   "\" (array, complex, maze, rrt_scene_1 or rrt_scene_2)"};
}

/// For files without bounds: a box around everything in the scene, a tenth larger and with room for
/// the robot to pass outside.
Box bounds_around(const Scene& scene) {
  Box box = scene.workspace.extent();
  box.include(scene.start);
  for (const Point& goal : scene.goals) box.include(goal);
  return box.inflated(
      std::max(0.1 * std::max(box.width(), box.height()), 4 * scene.workspace.safety_radius));
}

/// Start and goals as the command line has them.
void override_task(const Arguments& args, Scene& scene) {
  if (!args.start.empty()) scene.start = parse_point("--start", args.start);
  if (!args.goals.empty()) scene.goals.clear();
  for (const std::string& goal : args.goals) scene.goals.push_back(parse_point("--goal", goal));
  if (!is_finite(scene.start)) throw UsageError{"no start: give --start X,Y"};
  if (scene.goals.empty()) throw UsageError{"no goal: give --goal X,Y"};
  if (args.time_limit && !(*args.time_limit >= 0)) {
    throw UsageError{"--time-limit must not be negative"};
  }
}

/// The scene with everything that the command line overrides.
Scene configured_scene(const Arguments& args) {
  Scene scene = load_scene(args);
  Workspace& workspace = scene.workspace;
  override_task(args, scene);
  if (args.radius) {
    workspace.safety_radius = *args.radius;
  } else if (std::isnan(workspace.safety_radius)) {
    throw UsageError{"no safety radius: give --radius R"};
  }
  if (!args.bounds.empty()) {
    const auto b = parse_numbers("--bounds", args.bounds, 4, "X0,Y0,X1,Y1");
    workspace.bounds = {{b[0], b[1]}, {b[2], b[3]}};
  } else if (!is_finite(workspace.bounds.min)) {
    workspace.bounds = bounds_around(scene);
  }
  const Box& bounds = workspace.bounds;
  if (args.resolution) {
    scene.resolution = *args.resolution;
  } else if (scene.resolution == 0) {
    scene.resolution = std::max(bounds.width(), bounds.height()) / 200;
  }
  if (const auto valid = validate(workspace); !valid) throw UsageError{valid.error().detail};
  if (args.strict) {
    if (const auto& crossing = inspect(workspace).self_crossing; !crossing.empty()) {
      throw UsageError{"obstacles[" + std::to_string(crossing.front()) +
                       "] crosses itself (--strict)"};
    }
  }
  return scene;
}

/// A grid map, ready to plan on.
CellSpace load_grid(const Arguments& args) {
  if (args.resolution || !args.bounds.empty()) {
    throw UsageError{"--grid brings its own resolution and bounds"};
  }
  CellOptions options{.safety_radius = args.radius.value_or(0)};
  const std::string extension = std::filesystem::path(args.grid).extension().string();
  if (extension == ".map") {
    return value_or_usage_error(
        CellSpace::build(value_or_usage_error(read_moving_ai_map(args.grid)), options));
  }
  if (extension != ".yaml" && extension != ".yml") {
    throw UsageError{args.grid + ": unknown kind of file (.map or .yaml)"};
  }
  const RosMap map = value_or_usage_error(read_ros_map(args.grid));
  for (const std::string& warning : map.warnings) {
    std::cerr << "tutavia-plan: " << args.grid << ": " << warning << '\n';
  }
  if (map.yaw != 0) {
    throw UsageError{args.grid +
                     ": a map turned by its origin's yaw is not read here (turn the "
                     "points with to_grid_frame of the library)"};
  }
  options.resolution = map.resolution;
  options.origin = map.origin;
  const auto unknown = args.unknown == "free" ? UnknownCells::free : UnknownCells::blocked;
  return value_or_usage_error(
      CellSpace::build(value_or_usage_error(to_grid(map, unknown)), options));
}

/// The blocked cells as rectangles (runs of equal extent in neighbouring rows joined), to be drawn.
std::vector<Obstacle> blocked_rectangles(const CellSpace& space) {
  struct Run {
    int first, last, from_row;
  };
  std::vector<Obstacle> rectangles;
  std::vector<Run> open;
  const double side = space.frame().resolution;
  const OccupancyGrid& cells = space.cells();
  for (int y = 0; y <= cells.height(); ++y) {
    std::vector<Run> row;
    if (y < cells.height()) {
      cells.for_each_run(y, false, [&](int first, int last) { row.push_back({first, last, y}); });
    }
    for (const Run& run : open) {
      const auto same = std::find_if(row.begin(), row.end(), [&](const Run& r) {
        return r.first == run.first && r.last == run.last;
      });
      if (same != row.end()) {
        same->from_row = run.from_row;
        continue;
      }
      const Point low = space.bounds().min + side * Point(run.first, run.from_row);
      const Point high = space.bounds().min + side * Point(run.last + 1, y);
      rectangles.emplace_back(
          Polygon{{low, Point{high.x(), low.y()}, high, Point{low.x(), high.y()}}});
    }
    open = std::move(row);
  }
  return rectangles;
}

/// The algorithms that a list names.
template <class Algorithm>
std::vector<Algorithm> select(const std::vector<Algorithm>& all, const std::string& option,
                              const std::string& names, char separator = ',') {
  std::vector<Algorithm> selected;
  for (const std::string& name : split(names, separator)) {
    const auto found = std::find_if(
        all.begin(), all.end(), [&](const Algorithm& candidate) { return candidate.name == name; });
    if (found == all.end()) {
      std::string message = option;
      message.append(": unknown name \"").append(name).append("\"; known:");
      for (const Algorithm& candidate : all) message.append(" ").append(candidate.name);
      throw UsageError{message};
    }
    selected.push_back(*found);
  }
  return selected;
}

/// The smoothers and pipelines of them that a comma list names.
template <class S>
std::vector<AnySmoother<S>> select_smoothers(const Arguments& args) {
  const auto all = all_smoothers<S>();
  std::vector<AnySmoother<S>> selected;
  for (const std::string& pipeline : split(args.smoother, ',')) {
    const auto stages = select(all, "--smoother", pipeline, '+');
    selected.push_back(std::accumulate(stages.begin() + 1, stages.end(), stages.front(), chain<S>));
  }
  return selected;
}

/// The file of --trace, if there is to be one: written as the searches go, each search once however
/// many smoothers follow it.
class TraceFile {
 public:
  explicit TraceFile(const std::string& path) : path_(path) {
    if (path.empty()) return;
    file_.open(path, std::ios::binary | std::ios::trunc);
    check();
  }

  /// Whether a search is to be written.
  bool takes(std::string_view search) {
    return !path_.empty() && searches_.insert(std::string(search)).second;
  }
  void write(const ResultHeader& header, std::string_view status, const SearchRecord& record) {
    std::string text;
    append_trace(text, header, status, record);
    file_ << text;
    check();
  }
  void close() {
    if (path_.empty()) return;
    file_.close();
    check();
  }

 private:
  void check() const {
    if (!file_) throw UsageError{"cannot write " + path_ + ": " + std::strerror(errno)};
  }

  std::string path_;
  std::ofstream file_;
  std::set<std::string> searches_;
};

template <class S>
Group run(const S& space, const Scene& scene, const Arguments& args, TraceFile& trace,
          const AnySearch<S>& search, const AnySmoother<S>& smoother) {
  const bool is_drawn = !args.svg.empty() && !args.compare;
  const bool is_traced = trace.takes(search.name);
  SearchRecord record{.keeps_nodes = is_traced};
  Planner planner(search, smoother);
  const bool wants_all_figures = args.compare || !args.json.empty();
  Group results;
  for (const Point& goal : scene.goals) {
    Query query{.start = scene.start, .goal = goal, .seed = args.seed};
    if (args.time_limit) query.budget = Budget::for_seconds(*args.time_limit);
    results.push_back(
        {{std::string(search.name), smoother.name, scene.start, goal,
          scene.workspace.safety_radius},
         is_drawn || is_traced ? planner.plan(space, query, record) : planner.plan(space, query)});
    Result& result = results.back();
    if (result.plan && wants_all_figures) {
      result.plan->metrics.mean_clearance = mean_clearance(space, result.plan->curve);
      // On workspaces results say how much longer they are than the shortest path.
      if constexpr (requires { space.workspace(); }) {
        const auto optimum = find_optimum(space, query, result.plan->metrics.length);
        if (optimum) result.optimum = *optimum;
      }
    }
    if (is_traced) {
      trace.write(result.header, result.plan ? "success" : to_string(result.plan.error().code),
                  record);
    }
    if (is_drawn) {
      std::erase_if(record.events, [](const SearchEvent& event) {
        return event.kind == SearchEvent::Kind::expanded ||
               event.kind == SearchEvent::Kind::generated;
      });
      results.back().record.events = std::move(record.events);
    }
    record.events.clear();
  }
  return results;
}

std::string to_text(const Point& p) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "(%g, %g)", p.x(), p.y());
  return buffer.data();
}

/// "-12.3 %": by how much `after` differs from `before`; for counts that stay 0, "0.0 %".
std::string change(double before, double after) {
  if (before == 0 && after != 0) return "new";
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%+.1f %%",
                before == 0 ? 0.0 : 100 * (after - before) / before);
  return buffer.data();
}

constexpr double degrees(double radians) { return radians * 180 / std::numbers::pi; }

/// One row per goal, each figure with its change against the search's own route.
void print_plans(const Group& results) {
  std::printf("%-16s %10s %9s %6s %9s %9s %9s %10s  %-8s %9s\n", "goal", "length m", "change",
              "turns", "change", "angle deg", "change", "clear >= m", "proof", "ms");
  for (const Result& result : results) {
    const std::string goal = to_text(result.header.goal);
    if (!result.plan) {
      const Failure& failure = result.plan.error();
      std::printf("%-16s %s: %s\n", goal.c_str(), std::string(to_string(failure.code)).c_str(),
                  failure.detail.c_str());
      continue;
    }
    const Plan& plan = *result.plan;
    const PathMetrics &m = plan.metrics, before = measure(plan.route.curve);
    const double ms = (plan.stats.search_us + plan.stats.smooth_us + plan.stats.certify_us) / 1000;
    std::printf(
        "%-16s %10.4f %9s %6zu %9s %9.2f %9s %10.4f  %-8s %9.3f%s\n", goal.c_str(), m.length,
        change(before.length, m.length).c_str(), m.turning_points,
        change(static_cast<double>(before.turning_points), static_cast<double>(m.turning_points))
            .c_str(),
        degrees(m.turning_angle), change(before.turning_angle, m.turning_angle).c_str(),
        m.min_clearance, std::string(to_string(plan.certificate.status)).c_str(), ms,
        plan.fell_back ? "  (fell back to the route)" : "");
  }
}

/// The figures of a group: sums over the goals that are planned, or the largest or least.
struct Summary {
  std::size_t planned = 0, goals = 0;
  double length = 0, angle = 0, max_curvature = 0, max_joint_deflection = 0;
  double min_clearance = std::numeric_limits<double>::infinity();
  double mean_clearance = 0;  ///< mean over the goals
  double search_us = 0, smooth_us = 0, certify_us = 0;
  double optimum = 0;   ///< lengths of the shortest paths there are
  double travel_s = 0;  ///< with default SpeedLimits; NaN where a path cannot be driven
  std::size_t turns = 0, evaluations = 0, fell_back = 0, with_optimum = 0;
  std::uint64_t expanded = 0;

  std::string travel() const {
    if (std::isnan(travel_s)) return "-";
    std::array<char, 32> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.2f", travel_s);
    return buffer.data();
  }
  /// The ratio to the shortest paths there are, where they are known.
  std::string over_optimum() const {
    if (planned == 0 || with_optimum < planned) return "-";
    std::array<char, 32> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.4f", optimum > 0 ? length / optimum : 1);
    return buffer.data();
  }
  std::string share_planned() const {
    return std::to_string(planned) + "/" + std::to_string(goals);
  }
};

Summary summary_of(const Group& group) {
  Summary sum{.goals = group.size()};
  for (const Result& result : group) {
    if (!result.plan) continue;
    const PathMetrics& m = result.plan->metrics;
    const Statistics& s = result.plan->stats;
    ++sum.planned;
    sum.length += m.length;
    sum.angle += m.turning_angle;
    sum.max_curvature = std::max(sum.max_curvature, m.max_curvature);
    sum.max_joint_deflection = std::max(sum.max_joint_deflection, m.max_joint_deflection);
    sum.min_clearance = std::min(sum.min_clearance, m.min_clearance);
    sum.mean_clearance += m.mean_clearance.value_or(std::numeric_limits<double>::quiet_NaN());
    sum.search_us += s.search_us;
    sum.smooth_us += s.smooth_us;
    sum.certify_us += s.certify_us;
    const auto profile = SpeedProfile::build(result.plan->curve, {});
    sum.travel_s += profile ? profile->duration() : std::numeric_limits<double>::quiet_NaN();
    sum.turns += m.turning_points;
    sum.evaluations += result.plan->certificate.evaluations;
    sum.fell_back += result.plan->fell_back ? 1 : 0;
    sum.expanded += s.expanded;
    if (result.optimum) {
      ++sum.with_optimum;
      sum.optimum += *result.optimum;
    }
  }
  if (sum.planned > 0) sum.mean_clearance /= static_cast<double>(sum.planned);
  return sum;
}

/// One row per search, figures added up over all goals.
void print_searches(std::span<const Group> groups) {
  std::printf("%-20s %9s %10s %6s %9s %10s %10s %10s %9s %10s\n", "search", "planned", "length m",
              "turns", "angle deg", "max curv.", "clear >= m", "expanded", "ms", "/ optimum");
  for (const Group& group : groups) {
    const Summary s = summary_of(group);
    std::printf("%-20s %9s %10.4f %6zu %9.2f %10.4f %10.4f %10llu %9.3f %10s\n",
                group.front().header.search.c_str(), s.share_planned().c_str(), s.length, s.turns,
                degrees(s.angle), s.max_curvature, s.min_clearance,
                static_cast<unsigned long long>(s.expanded),
                (s.search_us + s.smooth_us + s.certify_us) / 1000, s.over_optimum().c_str());
  }
}

/// The lengths of the routes of a group when pulled taut, added up; NaN where one cannot be.
template <class S>
double taut_length(const S& space, const Group& group) {
  double length = 0;
  for (const Result& result : group) {
    if (!result.plan) continue;
    const auto taut = TautString{}.smooth(space, result.plan->route.curve, {});
    length += taut ? taut->length() : std::numeric_limits<double>::quiet_NaN();
  }
  return length;
}

/// One row per smoother, figures added up over all goals. A smoother that leaves the homotopy class
/// of a route may come out shorter than its taut string.
template <class S>
void print_smoothers(const S& space, std::span<const Group> groups) {
  std::printf("%-22s %7s %10s %8s %13s %9s %9s %10s %12s %8s %10s %8s %10s\n", "smoother",
              "planned", "length m", "/ taut", "max curv. 1/m", "angle deg", "joint deg",
              "clear >= m", "clear mean m", "travel s", "us", "proofs", "/ optimum");
  for (const Group& group : groups) {
    const Summary s = summary_of(group);
    std::printf("%-22s %7s", group.front().header.smoother.c_str(), s.share_planned().c_str());
    if (s.planned > 0) {
      const double taut = taut_length(space, group);
      std::printf(" %10.4f %8.4f %13.4f %9.2f %9.2f %10.4f %12.4f %8s %10.1f %8zu %10s", s.length,
                  s.length == taut ? 1 : s.length / taut, s.max_curvature, degrees(s.angle),
                  degrees(s.max_joint_deflection), s.min_clearance, s.mean_clearance,
                  s.travel().c_str(), s.smooth_us, s.evaluations, s.over_optimum().c_str());
    }
    if (s.fell_back > 0) std::printf("  (%zu fell back to the route)", s.fell_back);
    std::printf("\n");
  }
}

/// Draws all plans, and takes them for it.
template <class S>
void draw(const std::string& path, const Scene& scene, const S& space, bool y_down,
          std::vector<Group> groups) {
  SvgOptions options{.title = scene.name, .y_down = y_down};
  std::vector<Plan> plans;
  const DeltaSmoother delta;
  for (Group& group : groups) {
    for (Result& result : group) {
      for (const auto& [kind, a, b] : result.record.events) {
        if (kind == SearchEvent::Kind::edge) options.tree.push_back({a, b});
        if (kind == SearchEvent::Kind::rectangle) options.rectangles.push_back({a, b});
        if (kind == SearchEvent::Kind::interval) options.intervals.push_back({a, b});
      }
      if (!result.plan) continue;
      plans.push_back(std::move(*result.plan));
      if (result.header.smoother != DeltaSmoother::name) continue;
      for (const Corner& corner :
           critical_corners(space, joints(plans.back().route.curve), delta.corner_threshold,
                            delta.min_exterior_angle)) {
        options.critical_corners.push_back(corner.position);
      }
    }
  }
  if (const auto written = write_svg(path, scene.workspace, plans, options); !written) {
    throw UsageError{written.error().detail};
  }
}

void write_results(const std::string& path, const std::vector<Group>& groups) {
  nlohmann::ordered_json results = nlohmann::ordered_json::array();
  for (const Group& group : groups) {
    for (const Result& result : group) {
      results.push_back(result.plan ? result_to_json(result.header, *result.plan, result.optimum)
                                    : result_to_json(result.header, result.plan.error()));
    }
  }
  const std::string text = result_file(std::move(results)).dump(1) + "\n";
  if (path == "-") {
    std::cout << text << std::flush;
    if (!std::cout) throw UsageError{"cannot write to stdout"};
  } else if (const auto written = write_file(path, text); !written) {
    throw UsageError{written.error().detail};
  }
}

/// All searches with the smoother, and all smoothers with the search, which finds the same routes
/// each time; a pipeline that is asked for takes part.
template <class S>
std::vector<Group> compare(const S& space, const Scene& scene, const Arguments& args,
                           TraceFile& trace, bool table) {
  const auto searches = all_searches<S>();
  const auto search = select(searches, "--search", args.search).front();
  const auto smoother = select_smoothers<S>(args).front();
  auto smoothers = all_smoothers<S>();
  if (smoother.name.find('+') != std::string::npos) smoothers.push_back(smoother);
  std::vector<Group> groups;
  groups.reserve(searches.size() + smoothers.size());
  for (const auto& other : searches)
    groups.push_back(run(space, scene, args, trace, other, smoother));
  if (table) {
    std::printf("\nall searches, smoother %s; sums over %zu goals\n", args.smoother.c_str(),
                scene.goals.size());
    print_searches(groups);
  }
  for (const auto& other : smoothers)
    groups.push_back(run(space, scene, args, trace, search, other));
  if (table) {
    std::printf("\nall smoothers, search %s, on the same routes; sums over %zu goals\n",
                args.search.c_str(), scene.goals.size());
    print_smoothers(space, std::span<const Group>(groups).subspan(searches.size()));
  }
  return groups;
}

/// The searches and smoothers asked for in every combination.
template <class S>
std::vector<Group> combine(const S& space, const Scene& scene, const Arguments& args,
                           TraceFile& trace, bool table) {
  const auto smoothers = select_smoothers<S>(args);
  std::vector<Group> groups;
  for (const auto& search : select(all_searches<S>(), "--search", args.search)) {
    for (const auto& smoother : smoothers) {
      groups.push_back(run(space, scene, args, trace, search, smoother));
      if (!table) continue;
      std::printf("\nsearch %s, smoother %s; changes against the route of the search\n",
                  std::string(search.name).c_str(), smoother.name.c_str());
      print_plans(groups.back());
    }
  }
  return groups;
}

/// Plans everything asked for and reports it. `y_down` is for pictures.
template <class S>
int plan_in(const S& space, const Scene& scene, const Arguments& args, bool draw_default,
            bool y_down) {
  const bool table = args.json != "-";
  TraceFile trace(args.trace);
  std::vector<Group> groups = args.compare ? compare(space, scene, args, trace, table)
                                           : combine(space, scene, args, trace, table);
  std::fflush(stdout);
  const bool complete = std::all_of(groups.begin(), groups.end(), [](const Group& group) {
    return std::all_of(group.begin(), group.end(),
                       [](const Result& result) { return result.plan.has_value(); });
  });

  if (!args.json.empty()) write_results(args.json, groups);
  trace.close();
  const std::string picture = args.svg.empty() && draw_default ? "maze.svg" : args.svg;
  if (!picture.empty()) {
    draw(picture, scene, space, y_down, std::move(groups));
    if (table) std::printf("\npicture: %s\n", picture.c_str());
  }
  return complete ? 0 : 1;
}

int plan_on_grid(const Arguments& args) {
  const CellSpace space = load_grid(args);
  Scene scene;
  scene.name = std::filesystem::path(args.grid).filename().string();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  scene.start = {nan, nan};
  override_task(args, scene);
  scene.workspace = {.bounds = space.bounds(), .safety_radius = space.safety_radius()};
  if (!args.svg.empty()) scene.workspace.obstacles = blocked_rectangles(space);
  if (args.json != "-") {
    std::printf("%s: %d x %d cells of %g m, safety radius %g m, start %s\n", scene.name.c_str(),
                space.cells().width(), space.cells().height(), space.frame().resolution,
                space.safety_radius(), to_text(scene.start).c_str());
  }
  const bool y_down = std::filesystem::path(args.grid).extension() == ".map";
  return plan_in(space, scene, args, false, y_down);
}

int plan_in_workspace(const Arguments& args, bool draw_default) {
  const Scene scene = configured_scene(args);
  const auto space =
      value_or_usage_error(LatticeSpace::build(scene.workspace, {.resolution = scene.resolution}));
  if (args.json != "-") {
    std::printf("%s: safety radius %g m, lattice %g m, start %s\n",
                scene.name.empty() ? args.workspace.c_str() : scene.name.c_str(),
                scene.workspace.safety_radius, scene.resolution, to_text(scene.start).c_str());
    if (const WorkspaceReport report = inspect(scene.workspace); !report.empty()) {
      std::fflush(stdout);
      std::cout << "workspace: " << report << std::endl;
    }
  }
  return plan_in(space, scene, args, draw_default, false);
}

/// Refuses names that are none before anything is loaded or printed.
template <class S>
void check_names(const Arguments& args) {
  const std::size_t searches = select(all_searches<S>(), "--search", args.search).size();
  const std::size_t smoothers = select_smoothers<S>(args).size();
  if (args.compare && (searches > 1 || smoothers > 1)) {
    throw UsageError{"--compare takes one --search and one --smoother to hold the others against"};
  }
}

int plan(const Arguments& args, bool draw_default) {
  if (args.list) {
    std::cout << "search:";
    for (const auto& search : all_searches<CellSpace>()) std::cout << ' ' << search.name;
    std::cout << "\nsmoother:";
    for (const auto& smoother : all_smoothers<CellSpace>()) std::cout << ' ' << smoother.name;
    std::cout << "\npipeline: A+B smooths with A, then with B\n";
    return 0;
  }
  if (args.grid.empty()) {
    check_names<LatticeSpace>(args);
  } else {
    check_names<CellSpace>(args);
  }
  return args.grid.empty() ? plan_in_workspace(args, draw_default) : plan_on_grid(args);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Plans safe, smooth, short paths for a disc-shaped robot; every path is proved.",
               "tutavia-plan"};
  Arguments args;
  define_options(app, args);
  try {
    app.parse(argc, argv);
    return plan(args, argc == 1);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help
    std::cerr << "tutavia-plan: " << error.what() << '\n';
  } catch (const UsageError& error) {
    std::cerr << "tutavia-plan: " << error.message << '\n';
  }
  return 2;
}
