// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "tutavia/certify/certificate.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/registry/option_value.hpp"

/// \file
/// Results in JSON: version 1 of the result file.

namespace tutavia {

/// The query and the algorithms of a result.
struct ResultHeader {
  std::string search;
  std::string smoother;
  Point start = Point::Zero();
  Point goal = Point::Zero();
  double safety_radius = 0;
  OptionSettings search_options{};
  std::vector<OptionSettings> smoother_options{};  ///< of each stage of a pipeline
};

namespace detail {

using ResultJson = nlohmann::ordered_json;

inline ResultJson to_json(const Point& p) { return {p.x(), p.y()}; }

inline ResultJson to_json(const Curve& curve) {
  ResultJson result = ResultJson::array();
  for (const Piece& any : curve.pieces()) {
    result.push_back(any.visit([](const auto& piece) -> ResultJson {
      if constexpr (std::is_same_v<std::decay_t<decltype(piece)>, Segment>) {
        return {{"type", "line"}, {"points", {to_json(piece.a), to_json(piece.b)}}};
      } else if constexpr (std::is_same_v<std::decay_t<decltype(piece)>, Arc>) {
        return {{"type", "arc"},
                {"points", {to_json(piece.a), to_json(piece.b)}},
                {"center", to_json(piece.center)},
                {"radius", piece.radius},
                {"start_angle", piece.start_angle},
                {"sweep", piece.sweep}};
      } else if constexpr (std::is_same_v<std::decay_t<decltype(piece)>, Clothoid>) {
        return {{"type", "clothoid"},
                {"points", {to_json(piece.a), to_json(piece.b)}},
                {"start", to_json(piece.a)},
                {"heading", piece.start_heading},
                {"curvature", piece.start_curvature},
                {"sharpness", piece.sharpness},
                {"length", piece.arc_length}};
      } else {
        ResultJson points = ResultJson::array();
        for (const Point& p : piece.points) points.push_back(to_json(p));
        return {{"type", "bezier"}, {"points", points}};
      }
    }));
  }
  return result;
}

inline ResultJson to_json(const Statistics& stats) {
  ResultJson json{{"expanded", stats.expanded},     {"generated", stats.generated},
                  {"search_us", stats.search_us},   {"smooth_us", stats.smooth_us},
                  {"certify_us", stats.certify_us}, {"seed", stats.seed}};
  if (stats.distinct) json["distinct"] = *stats.distinct;
  return json;
}

inline ResultJson to_json(const OptionSettings& settings) {
  ResultJson result = ResultJson::object();
  for (const OptionSetting& setting : settings) {
    result[setting.name] = std::visit(
        [](const auto& value) -> ResultJson {
          if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>) {
            return nullptr;
          } else {
            return value;
          }
        },
        setting.value);
  }
  return result;
}

/// The options of a smoother; for a pipeline an array with those of each stage.
inline ResultJson to_json(const std::vector<OptionSettings>& stages) {
  if (stages.size() <= 1) return to_json(stages.empty() ? OptionSettings{} : stages.front());
  ResultJson result = ResultJson::array();
  for (const OptionSettings& stage : stages) result.push_back(to_json(stage));
  return result;
}

inline ResultJson to_json(const Certificate& certificate) {
  return {{"status", to_string(certificate.status)},
          {"lower", certificate.lower},
          {"upper", certificate.upper},
          {"point", to_json(certificate.point)},
          {"piece", certificate.piece},
          {"parameter", certificate.parameter}};
}

inline ResultJson result_head(const ResultHeader& header, std::string_view status) {
  return {{"status", status},
          {"search", header.search},
          {"smoother", header.smoother},
          {"options",
           {{"search", to_json(header.search_options)},
            {"smoother", to_json(header.smoother_options)}}},
          {"fell_back", false},
          {"start", to_json(header.start)},
          {"goal", to_json(header.goal)},
          {"safety_radius", header.safety_radius}};
}

inline ResultJson to_json(const Vehicle& vehicle) {
  ResultJson discs = ResultJson::array();
  for (const FootprintDisc& disc : vehicle.footprint) {
    discs.push_back({{"offset", to_json(disc.offset)}, {"radius", disc.radius}});
  }
  return {{"min_turning_radius", vehicle.min_turning_radius},
          {"reverse", vehicle.reverse},
          {"footprint", std::move(discs)}};
}

/// What a vehicle's path has besides its curve: the gear of every piece, the headings at both ends
/// [rad] and the arc lengths at which the gear changes [m].
inline void add_driving(ResultJson& json, const VehiclePath& path) {
  ResultJson gears = ResultJson::array();
  for (const Gear gear : path.gears) gears.push_back(to_string(gear));
  json["gears"] = std::move(gears);
  json["start_heading"] = path.start().heading;
  json["goal_heading"] = path.end().heading;
  json["cusps"] = path.cusps();
}

}  // namespace detail

/// One entry of `results` for a plan. Numbers read back to the same double; infinite ones (the
/// clearance without obstacles, the curvature of a cusp, an option without a bound) become null, as
/// do options that are not given. `optimum` is the length of the shortest path, if known (see
/// find_optimum). `found_by` is there where several searches took part. The path of a vehicle has
/// the vehicle, the gear of every piece of `curve`, the headings at both ends [rad] and the arc
/// lengths of its cusps, where the gear changes [m].
inline nlohmann::ordered_json result_to_json(const ResultHeader& header, const Plan& plan,
                                             std::optional<double> optimum = std::nullopt) {
  auto json = detail::result_head(header, "success");
  const PathMetrics& m = plan.metrics;
  json["fell_back"] = plan.fell_back;
  if (!plan.route.found_by.empty()) json["found_by"] = plan.route.found_by;
  json["route"] = detail::to_json(plan.route.curve);
  json["curve"] = detail::to_json(plan.curve);
  if (!plan.gears.empty()) detail::add_driving(json, {plan.curve, plan.gears});
  if (plan.route.vehicle) json["vehicle"] = detail::to_json(*plan.route.vehicle);
  json["metrics"] = {{"length", m.length},
                     {"turning_points", m.turning_points},
                     {"turning_angle", m.turning_angle},
                     {"interior_angle_sum", m.interior_angle_sum},
                     {"max_joint_deflection", m.max_joint_deflection},
                     {"max_curvature", m.max_curvature},
                     {"max_curvature_jump", m.max_curvature_jump},
                     {"min_clearance", m.min_clearance}};
  if (m.mean_clearance) json["metrics"]["mean_clearance"] = *m.mean_clearance;
  json["certificate"] = detail::to_json(plan.certificate);
  if (optimum) {
    json["optimum"] = {{"length", *optimum}, {"ratio", *optimum > 0 ? m.length / *optimum : 1}};
  }
  json["stats"] = detail::to_json(plan.stats);
  return json;
}

/// One entry of `results` for a query without a plan: `status` is the error's code.
inline nlohmann::ordered_json result_to_json(const ResultHeader& header, const Failure& failure) {
  auto json = detail::result_head(header, to_string(failure.code));
  json["detail"] = failure.detail;
  if (failure.clearance) json["clearance"] = *failure.clearance;
  if (failure.obstacle) json["obstacle"] = *failure.obstacle;
  if (failure.nearest_safe_point) {
    json["nearest_safe_point"] = detail::to_json(*failure.nearest_safe_point);
  }
  json["stats"] = detail::to_json(failure.stats);
  return json;
}

/// The whole result file with its entries.
inline nlohmann::ordered_json result_file(nlohmann::ordered_json results) {
  return {{"tutavia", 1}, {"results", std::move(results)}};
}

}  // namespace tutavia
