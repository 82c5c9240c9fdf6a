// SPDX-License-Identifier: MIT
#include "planning.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "../../plan/result.hpp"
#include "../../plan/usage_error.hpp"
#include "../../plan/vehicle_arguments.hpp"
#include "samples.hpp"
#include "tutavia/core/version.hpp"
#include "tutavia/geometry/b_spline.hpp"
#include "tutavia/io/plan_json.hpp"
#include "tutavia/io/svg.hpp"
#include "tutavia/io/text/fields_json.hpp"
#include "tutavia/metrics/path_metrics.hpp"
#include "tutavia/plan/vehicle.hpp"
#include "tutavia/registry.hpp"

namespace playground {

using plan_program::ChosenPlanner;
using plan_program::UsageError;
using plan_program::VehicleArguments;
using Json = nlohmann::ordered_json;

namespace {

namespace fields = tutavia::detail::json_fields;

/// A search or a smoother as the page writes it. Throws UsageError.
PipelineText algorithm(const nlohmann::json& request, const char* kind) {
  const std::string text = fields::string(fields::field(request, kind), kind);
  auto list = plan_program::value_or_throw(parse_algorithms(text));
  if (list.size() != 1) throw UsageError{std::string(kind) + ": one is planned with at a time"};
  return std::move(list.front());
}

std::optional<double> optional_number(const nlohmann::json& json, const char* name) {
  const auto* const value = fields::optional_field(json, name);
  return value == nullptr ? std::nullopt : std::optional(fields::number(*value, name));
}

double required_number(const nlohmann::json& json, const char* name) {
  return fields::number(fields::field(json, name), name);
}

std::uint64_t count_of(const nlohmann::json& request, const char* name, std::uint64_t otherwise) {
  const auto* const value = fields::optional_field(request, name);
  if (value == nullptr) return otherwise;
  fields::require(value->is_number_unsigned(), name, "a whole number");
  return value->get<std::uint64_t>();
}

VehicleArguments vehicle_of(const nlohmann::json& request) {
  VehicleArguments arguments;
  const auto* const vehicle = fields::optional_field(request, "vehicle");
  if (vehicle == nullptr) return arguments;
  const double radius = required_number(*vehicle, "min_turning_radius");
  fields::require(radius == 0 || radius >= 1e-3, "min_turning_radius", "0, or 0.001 m at least");
  arguments.turning_radius = radius;
  arguments.reverse = vehicle->value("reverse", false);
  const auto* const car = fields::optional_field(*vehicle, "car");
  if (car == nullptr) return arguments;
  const double length = required_number(*car, "length"), width = required_number(*car, "width");
  const double wheelbase = required_number(*car, "wheelbase");
  const bool is_car = 0 < width && width <= length && 0 <= wheelbase && wheelbase <= length &&
                      length <= 100 * width;
  fields::require(is_car, "car", "0 < width <= length <= 100 widths and a wheelbase up to length");
  arguments.footprint = Vehicle::car(length, width, wheelbase, *arguments.turning_radius).footprint;
  return arguments;
}

/// One plan request, understood.
struct Task {
  PipelineText search, smoother;
  VehicleArguments vehicle;
  Query query;
  std::string key;  ///< of the planner
};

Task task_of(const nlohmann::json& request) {
  Task task{
      algorithm(request, "search"), algorithm(request, "smoother"), vehicle_of(request), {}, {}};
  task.query.start = fields::point(fields::field(request, "start"), "start");
  task.query.goal = fields::point(fields::field(request, "goal"), "goal");
  task.query.start_heading = optional_number(request, "start_heading");
  task.query.goal_heading = optional_number(request, "goal_heading");
  task.query.seed = count_of(request, "seed", 0);
  if (const auto limit = optional_number(request, "time_limit")) {
    task.query.budget = Budget::for_seconds(*limit);
  }
  constexpr std::uint64_t most = 3'000'000;  // a page has no memory for more
  task.query.budget.max_expansions = count_of(request, "max_expansions", most);
  task.key = task.search.text + " " + task.smoother.text + " " +
             request.value("vehicle", nlohmann::json{}).dump();
  return task;
}

const ChosenPlanner& planner_of(Stage& stage, const Task& task) {
  return stage.planner(task.key, [&] {
    const auto headings = plan_program::vehicle_names().searches;
    const bool plans_headings =
        std::find(headings.begin(), headings.end(), task.search.name()) != headings.end();
    plan_program::check_choices({plans_headings, {task.search}, {task.smoother}}, task.vehicle,
                                stage.has_cells());
    return plan_program::make_planner(stage.space(), {}, task.search, task.smoother, task.vehicle);
  });
}

/// A result as in a result file, in the frame of the map.
Json result_of(Stage& stage, const Task& task, const ChosenPlanner& planner,
               const Expected<Plan, Failure>& plan, std::optional<double> optimum) {
  const plan_program::UsedAlgorithms& used = planner.algorithms;
  const auto in_map = [&](const Point& p) {
    stage.frame().to_grid(p);
    return stage.frame().to_map(p);
  };
  const ResultHeader header{
      used.search,           used.smoother,       in_map(task.query.start), in_map(task.query.goal),
      stage.safety_radius(), used.search_options, used.smoother_options};
  const Expected<Plan, Failure> shown =
      stage.frame().is_turned() ? stage.frame().to_map(plan) : plan;
  return shown ? result_to_json(header, *shown, optimum) : result_to_json(header, shown.error());
}

Json judged(const Stage& stage, const Curve& curve, std::span<const Gear> gears,
            Certificate certificate, std::size_t samples) {
  certificate.point = stage.frame().to_map(certificate.point);
  return {{"curve", sampled(stage.space(), curve, gears, samples)},
          {"certificate", tutavia::detail::to_json(certificate)}};
}

SpeedLimits limits_of(const nlohmann::json& json) {
  SpeedLimits limits;
  limits.max_speed = required_number(json, "max_speed");
  limits.max_acceleration = required_number(json, "max_acceleration");
  limits.max_deceleration = required_number(json, "max_deceleration");
  limits.max_lateral_acceleration = required_number(json, "max_lateral_acceleration");
  if (const auto jerk = optional_number(json, "max_jerk")) limits.max_jerk = *jerk;
  return limits;
}

/// The cubic B-spline whose control points are the corners of a route, without a test of its
/// clearance.
Curve unchecked_spline(const Curve& route) {
  std::vector<Point> control = waypoints(route);
  while (control.size() < 4) {  // a straight route
    std::vector<Point> finer;
    for (std::size_t i = 0; i + 1 < control.size(); ++i) {
      finer.insert(finer.end(), {control[i], (control[i] + control[i + 1]) / 2});
    }
    finer.push_back(control.back());
    if (finer.size() == control.size()) return route;  // a single point
    control = std::move(finer);
  }
  Curve curve;
  for (const CubicBezier& piece : bezier_pieces(control)) curve.push_back(piece);
  return curve;
}

/// What the page draws of a plan, and of the curve that was refused for it.
void add_curves(Json& reply, const Stage& stage, const Task& task, const ChosenPlanner& planner,
                const Plan& plan, std::size_t samples) {
  const Route& route = plan.route;
  reply["route"] = sampled(stage.space(), route.curve, route.gears, samples);
  reply["curve"] = sampled(stage.space(), plan.curve, plan.gears, samples);
  if (route.vehicle) {
    reply["footprint"] = tutavia::detail::to_json(*route.vehicle)["footprint"];
  }
  if (!plan.fell_back) return;
  const auto refused = planner.smooth(route, task.query.budget);
  if (!refused) {
    reply["smoother_failure"] =
        std::string(to_string(refused.error().code)) + ": " + refused.error().detail;
  } else if (refused->certificate.status != ProofStatus::proved) {
    reply["refused"] = judged(stage, refused->curve, refused->gears, refused->certificate, samples);
  }
}

Json describe(const AlgorithmDescription& algorithm) {
  Json options = Json::array();
  for (const OptionDescription& option : algorithm.options) {
    options.push_back({{"name", option.name},
                       {"type", option.type},
                       {"unit", option.unit},
                       {"default_value", option.default_value},
                       {"sentence", option.sentence}});
  }
  return {
      {"name", algorithm.name}, {"sentence", algorithm.sentence}, {"options", std::move(options)}};
}

Json describe_all(const std::vector<AlgorithmDescription>& algorithms,
                  const std::vector<std::string>& on_workspace,
                  const std::vector<std::string>& on_cells,
                  const std::vector<std::string>& for_vehicles) {
  const auto has = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  Json list = Json::array();
  for (const AlgorithmDescription& algorithm : algorithms) {
    Json item = describe(algorithm);
    const bool plans_headings = has(for_vehicles, algorithm.name);
    item["on_workspace"] = plans_headings || has(on_workspace, algorithm.name);
    item["on_cells"] = plans_headings || has(on_cells, algorithm.name);
    item["for_vehicles"] = plans_headings;
    list.push_back(std::move(item));
  }
  return list;
}

}  // namespace

Json catalogue() {
  const auto lattice = plan_program::lattice_names(), cells = plan_program::cell_names();
  const auto vehicles = plan_program::vehicle_names();
  return {{"version", version_text()},
          {"searches",
           describe_all(describe_searches(), lattice.searches, cells.searches, vehicles.searches)},
          {"smoothers", describe_all(describe_smoothers(), lattice.smoothers, cells.smoothers,
                                     vehicles.smoothers)}};
}

Json plan(Stage& stage, const nlohmann::json& request) {
  const auto began = std::chrono::steady_clock::now();
  const Task task = task_of(request);
  const ChosenPlanner& planner = planner_of(stage, task);
  const auto events = static_cast<std::size_t>(count_of(request, "events", 0));
  const auto samples =
      static_cast<std::size_t>(std::min<std::uint64_t>(count_of(request, "samples", 300), 100000));
  SearchRecord record;
  auto plan = planner.plan(task.query, events > 0 ? &record : nullptr);
  std::optional<double> optimum;
  if (plan && request.value("optimum", false) && !plan->route.vehicle) {
    plan->metrics.mean_clearance = plan_program::mean_clearance_of(stage.space(), plan->curve);
    optimum = plan_program::optimum_of(stage.space(), task.query, plan->metrics.length);
  }
  Json reply{{"result", result_of(stage, task, planner, plan, optimum)}};
  if (plan && request.value("unchecked", false) && !plan->route.vehicle) {
    const Curve curve = unchecked_spline(plan->route.curve);
    reply["unchecked"] = judged(stage, curve, {}, stage.certify(curve), samples);
  }
  if (plan) {
    add_curves(reply, stage, task, planner, *plan, samples);
    if (const auto* const limits = fields::optional_field(request, "speed")) {
      reply["speed"] = sampled_motion(plan->curve, limits_of(*limits));
    }
  }
  if (events > 0) reply["events"] = events_to_json(record, events, stage.resolution());
  const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - began;
  reply["us"] = took.count();
  return reply;
}

Json draw(Stage& stage, const nlohmann::json& request) {
  SvgOptions options{
      .zones = true, .footprints = true, .cell_size = stage.resolution(), .y_down = stage.y_down()};
  std::vector<Plan> plans;
  fields::each(fields::field(request, "plans"), "plans",
               [&](const nlohmann::json& one, const std::string&) {
                 const Task task = task_of(one);
                 const std::string label = task.search.text + ", " + task.smoother.text;
                 auto plan = planner_of(stage, task).plan(task.query, nullptr);
                 if (!plan) {
                   options.notes.push_back(label + ": no plan (" +
                                           std::string(to_string(plan.error().code)) + ")");
                   return;
                 }
                 options.labels.push_back(label);
                 plans.push_back(std::move(*stage.frame().to_map(std::move(plan))));
               });
  return {{"svg", to_svg(stage.obstacles(), plans, options)}};
}

}  // namespace playground
