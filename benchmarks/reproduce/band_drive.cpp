// SPDX-License-Identifier: MIT
#include "band_drive.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../../examples/drive/encounters.hpp"
#include "../../examples/drive/global_planner.hpp"
#include "../../examples/drive/simulator.hpp"
#include "support/paper_maps.hpp"
#include "tutavia/io/text/svg_legend.hpp"
#include "tutavia/io/text/svg_map.hpp"
#include "tutavia/io/text/svg_paths.hpp"
#include "tutavia/io/text/svg_style.hpp"
#include "tutavia/io/text/svg_writer.hpp"
#include "tutavia/motion/local_planner.hpp"
#include "tutavia/search/jps_theta_star.hpp"
#include "tutavia/smooth/bezier_smoother.hpp"

namespace reproduce {

namespace {

using drive_program::DriveResult;
using drive_program::Encounters;
using drive_program::TraceRow;
using tutavia::detail::SvgLegend;
using tutavia::detail::SvgMap;
using tutavia::detail::SvgPaths;
using tutavia::detail::SvgStyle;
using tutavia::detail::SvgWriter;

constexpr double robot_radius = 0.3;    // [m]
constexpr double path_margin = 0.1;     // of the path, beyond the robot's radius [m]
constexpr double seen_from = 3;         // the obstacle appears at this distance [m]
constexpr double obstacle_at = 0.45;    // share of the path's length
constexpr double obstacle_aside = 0.1;  // to the left of the path [m]
constexpr double obstacle_radius = 0.7;

/// A LocalPlanner that lets an obstacle appear before the robot, and keeps some of its bands.
class WatchedPlanner {
 public:
  WatchedPlanner(const CellSpace& space, Encounters& encounters, const Disc* obstacle)
      : planner_(LocalPlanner<CellSpace>::build(space).value()),
        encounters_(encounters),
        obstacle_(obstacle) {}

  Expected<void, Failure> follow(Curve path) { return planner_.follow(std::move(path)); }

  DriveCommand step(const Pose& odometry, std::span<const MovingObstacle> observed) {
    const DriveCommand command = planner_.step(odometry, observed);
    const double period = planner_.options().control.period;
    ++steps_;
    if (obstacle_ != nullptr && appeared_at_ == 0 &&
        distance(odometry.position, obstacle_->center) <= seen_from) {
      appeared_at_ = steps_;
      encounters_.add({.obstacle = {*obstacle_}, .appears = period * double(steps_)});
    }
    if (appeared_at_ == 0) return command;
    constexpr std::array<std::size_t, 3> kept{0, 1, 50};
    if (std::find(kept.begin(), kept.end(), steps_ - appeared_at_) != kept.end()) {
      bands_.push_back(planner_.band());
    }
    return command;
  }

  std::vector<Band> take_bands() { return std::move(bands_); }

 private:
  LocalPlanner<CellSpace> planner_;
  Encounters& encounters_;
  const Disc* obstacle_;
  std::size_t steps_ = 0;
  std::size_t appeared_at_ = 0;  // the number of steps until then; 0: not yet
  std::vector<Band> bands_{};
};

std::size_t count_of(const DriveResult& result, DriveStatus status) {
  return static_cast<std::size_t>(
      std::count_if(result.trace.begin(), result.trace.end(),
                    [&](const TraceRow& row) { return row.status == status; }));
}

/// Draws one drive.
class BandPicture {
 public:
  BandPicture(const BandScene& scene, const BandDrive& drive)
      : scene_(scene),
        trace_(drive.result.trace),
        bands_(drive.bands),
        map_(drive_program::workspace_of(scene.space)),
        scale_(width / map_.bounds.width()),
        paths_{map_.bounds, scale_, {margin, margin}, false} {}

  std::string draw() {
    SvgMap map(svg_, map_, paths_);
    map.begin();
    map.safety_zones(robot_radius);
    map.obstacles();
    const Point at = paths_.pixel(scene_.obstacle.center);
    svg_.circle(at, (obstacle_radius + robot_radius) * scale_, SvgStyle::zone);
    svg_.circle(at, obstacle_radius * scale_, obstacle_style);
    robots();
    svg_.stroke(paths_.of_curve(scene_.path), path_style);
    driven_path();
    for (const Band& band : bands_) show(band, &band == bands_.data() ? first_band : later_bands);
    map.end();
    tutavia::detail::start_symbol(svg_, paths_.pixel(scene_.path.start()));
    tutavia::detail::goal_symbol(svg_, paths_.pixel(scene_.path.end()), colour);
    return svg_.finish(width + 2 * margin, legend());
  }

 private:
  static constexpr double margin = 16, width = 900;
  static constexpr std::size_t robot_stride = 40, path_stride = 5;  // [periods]
  static constexpr std::string_view colour = "#0072b2";
  static constexpr std::string_view driven_style = "stroke=\"#0072b2\" stroke-width=\"2.4\"";
  static constexpr std::string_view robot_style =
      "fill=\"#0072b2\" fill-opacity=\"0.12\" stroke=\"#0072b2\" stroke-width=\"0.8\"";
  static constexpr std::string_view path_style =
      "stroke=\"#4a5763\" stroke-width=\"1.6\" stroke-dasharray=\"6 4\"";
  static constexpr std::string_view obstacle_style = "fill=\"#8c3b2a\"";
  static constexpr const char* first_band = "#cc79a7";
  static constexpr const char* later_bands = "#d55e00";

  void robots() {
    for (std::size_t i = 0; i < trace_.size(); i += robot_stride) {
      svg_.circle(paths_.pixel(trace_[i].pose.position), robot_radius * scale_, robot_style);
    }
  }
  void driven_path() {
    std::string data;
    for (std::size_t i = 0; i < trace_.size(); i += path_stride) {
      data += (i == 0 ? "M" : "L") + paths_.at(trace_[i].pose.position);
    }
    svg_.stroke(data + "L" + paths_.at(trace_.back().pose.position), driven_style);
  }
  void show(const Band& band, const std::string& hue) {
    std::string data;
    for (const Pose& pose : band.poses) {
      data += (data.empty() ? "M" : "L") + paths_.at(pose.position);
    }
    svg_.stroke(data, SvgStyle::curve(hue, "1"));
    for (const Pose& pose : band.poses) {
      svg_.circle(paths_.pixel(pose.position), 1.8, "fill=\"" + hue + "\"");
    }
  }
  double legend() {
    const double y = margin + map_.bounds.height() * scale_ + 24;
    SvgLegend legend(svg_, {margin, y}, width);
    legend.line("path of JPS_Theta* and cubic Bezier", path_style);
    legend.line("driven path", driven_style);
    legend.entry("robot, every 4 s",
                 [&](const Point& p) { svg_.circle(p, robot_radius * scale_, robot_style); });
    legend.line("band before the obstacle appears", SvgStyle::curve(first_band, "2"));
    legend.line("bands after that", SvgStyle::curve(later_bands, "2"));
    legend.area("obstacle that appears", obstacle_style);
    legend.area("blocked cell", SvgStyle::obstacle);
    legend.area("safety zone, 0.3 m", SvgStyle::zone);
    return legend.bottom();
  }

  const BandScene& scene_;
  const std::vector<TraceRow>& trace_;
  const std::vector<Band>& bands_;
  Workspace map_;
  double scale_;  // pixels per metre
  SvgPaths paths_;
  SvgWriter svg_{};
};

}  // namespace

BandScene band_scene(const Options& options) {
  const test::PaperTask task = test::jps_theta_task();
  const auto wide = task.space.with_safety_radius(robot_radius + path_margin).value();
  const Run route = search(JpsThetaStar{}, wide, task.query, {options.seed, 0});
  const Run smoothed = smooth(BezierSmoother{}, wide, route, {options.seed, 0});
  const Curve& path = smoothed.route.curve;
  const CurvePoint at = path.at(obstacle_at * path.length());
  const Point left{-std::sin(at.heading), std::cos(at.heading)};
  return {task.space.with_safety_radius(robot_radius).value(), path,
          Disc{at.position + obstacle_aside * left, obstacle_radius}};
}

BandDrive drive_by_bands(const BandScene& scene, bool has_obstacle) {
  Encounters encounters({});
  WatchedPlanner planner(scene.space, encounters, has_obstacle ? &scene.obstacle : nullptr);
  drive_program::Simulator simulator(scene.space, planner, encounters, {.keeps_trace = true});
  const CurvePoint start = scene.path.at(0);
  BandDrive drive{.result = simulator.run({start.position, start.heading}, scene.path)};
  drive.bands = planner.take_bands();
  return drive;
}

Table band_table(const BandScene& scene, const BandDrive& without, const BandDrive& with) {
  Table table{
      .name = "drive",
      .title =
          "**A drive** along the path of JPS_Theta\\* and cubic Bezier on the raster with "
          "cells of 1 m: `LocalPlanner` with default options (0.4 m/s, bands of 3 m, a "
          "command every 0.1 s), a robot of radius 0.3 m, and a path that keeps 0.4 m. The "
          "obstacle, a disc of radius 0.7 m on the path, appears when the robot is 3 m "
          "away. *Clearance*: the least gap between the robot and anything, over "
          "continuous time. The last columns count commands by status; those that stop do so at "
          "the goal.",
      .header = {"drive", "path [m]", "driven [m]", "time [s]", "clearance [m]", "contacts",
                 "at goal", "driving", "slowed", "stopping", "emergency", "blocked"}};
  const auto row = [&](const char* name, const DriveResult& result) {
    std::vector<std::string> cells{name,
                                   fixed(scene.path.length(), 2),
                                   fixed(result.length, 2),
                                   fixed(result.time, 1),
                                   fixed(result.min_clearance, 2),
                                   std::to_string(result.own_contacts + result.driven_into),
                                   result.ending == drive_program::Ending::reached ? "yes" : "no"};
    for (const DriveStatus status :
         {DriveStatus::driving, DriveStatus::slowed, DriveStatus::stopping, DriveStatus::emergency,
          DriveStatus::blocked}) {
      cells.push_back(std::to_string(count_of(result, status)));
    }
    table.rows.push_back(std::move(cells));
  };
  row("without the obstacle", without.result);
  row("with the obstacle", with.result);
  return table;
}

Claim band_claim(const BandDrive& with) {
  const DriveResult& result = with.result;
  const bool is_good = result.ending == drive_program::Ending::reached &&
                       result.own_contacts + result.driven_into + result.limit_violations == 0;
  return {"The timed elastic band and the robot of figure 16",
          is_good ? Verdict::tendency : Verdict::not_so,
          "the method comes out: on the raster of table 1 the robot drives around an obstacle that "
          "is not on the map and reaches the goal without contact (table \"A drive\"). The paper's "
          "own map and parameters are not printed. Its equation (21) rewards the greatest speed "
          "and is corrected here, and a band alone promises no clearance: every command is proved "
          "before it is issued"};
}

Picture band_picture(const BandScene& scene, const BandDrive& drive) {
  return {"jps_theta_star-teb.svg",
          "The drive with the obstacle. Bands: of the last command before it appears, of the next "
          "one, and of the one 5 s later.",
          BandPicture(scene, drive).draw()};
}

}  // namespace reproduce
