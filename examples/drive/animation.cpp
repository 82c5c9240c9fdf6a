// SPDX-License-Identifier: MIT
#include "animation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "../plan/usage_error.hpp"
#include "tutavia/io/text/svg_legend.hpp"
#include "tutavia/io/text/svg_map.hpp"
#include "tutavia/io/text/svg_paths.hpp"
#include "tutavia/io/text/svg_writer.hpp"
#include "tutavia/io/text/write_file.hpp"

namespace drive_program {

namespace {

using plan_program::Task;
using tutavia::detail::SvgLegend;
using tutavia::detail::SvgMap;
using tutavia::detail::SvgPaths;
using tutavia::detail::SvgWriter;

constexpr std::array all_statuses{
    DriveStatus::driving, DriveStatus::slowed,  DriveStatus::stopping,     DriveStatus::emergency,
    DriveStatus::blocked, DriveStatus::arrived, DriveStatus::invalid_input};

/// After Okabe and Ito, for colour-blind readers.
std::string colour_of(DriveStatus status) {
  switch (status) {
    case DriveStatus::driving:
      return "#0072b2";
    case DriveStatus::slowed:
      return "#e69f00";
    case DriveStatus::stopping:
      return "#d55e00";
    case DriveStatus::emergency:
      return "#c1121f";
    case DriveStatus::blocked:
      return "#5e3c99";
    case DriveStatus::arrived:
      return "#009e73";
    case DriveStatus::invalid_input:
      return "#000000";
  }
  return "#000000";
}

/// What the legend says of a status.
std::string_view meaning_of(DriveStatus status) {
  switch (status) {
    case DriveStatus::driving:
      return "driving as it wants";
    case DriveStatus::slowed:
      return "slowed before an obstacle";
    case DriveStatus::stopping:
      return "stopping";
    case DriveStatus::emergency:
      return "emergency stop";
    case DriveStatus::blocked:
      return "standing, blocked";
    case DriveStatus::arrived:
      return "arrived";
    case DriveStatus::invalid_input:
      return "invalid input";
  }
  return "";
}

/// The map in its own frame, cells as rectangles.
Workspace drawn_map(const Task& task) {
  const auto* cells = std::get_if<CellSpace>(&task.space);
  if (cells == nullptr) return task.scene.workspace;
  Workspace workspace = workspace_of(*cells);
  if (!task.frame.is_turned()) return workspace;
  Box bounds;
  const Box& own = cells->bounds();
  for (const Point& corner :
       {own.min, Point(own.max.x(), own.min.y()), own.max, Point(own.min.x(), own.max.y())}) {
    bounds.include(task.frame.to_map(corner));
  }
  workspace.bounds = bounds;
  for (Obstacle& obstacle : workspace.obstacles) {
    for (Point& p : std::get<Polygon>(obstacle).outer) p = task.frame.to_map(p);
  }
  return workspace;
}

/// The keyTimes of an animation: shares of the loop. The last part of a loop shows the end.
class Clock {
 public:
  explicit Clock(double drive_time)
      : drive_time_(std::max(drive_time, 1e-9)),
        shown_(std::clamp(drive_time / 6, 6.0, 40.0)),
        loop_(shown_ + pause) {}

  std::string duration() const { return SvgWriter::number(loop_) + "s"; }
  /// The share of the loop at a time of the drive [s].
  std::string at(double time) const { return share(shown_ * time / drive_time_ / loop_); }
  static std::string share(double x) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.5f", std::clamp(x, 0.0, 1.0));
    return text.data();
  }

 private:
  static constexpr double pause = 2;  // at the end [s]

  double drive_time_, shown_, loop_;
};

/// Values at times, of which equal neighbours are left out.
class Track {
 public:
  explicit Track(const Clock& clock) : clock_(clock) {}

  void add(double time, const std::string& value) {
    values_.append(values_.empty() ? "" : ";").append(value);
    times_.append(times_.empty() ? "" : ";").append(clock_.at(time));
    last_ = value;
  }
  void add_change(double time, const std::string& value) {
    if (value != last_) add(time, value);
  }

  /// The markup: `what` is the element with its attributes, such as `animate attributeName="fill"`.
  std::string markup(std::string_view what, bool in_steps) const {
    std::string text("<");
    text.append(what).append(in_steps ? " calcMode=\"discrete\"" : "");
    // Times of steps may end early; others have to end at 1.
    text.append(" values=\"").append(values_).append(in_steps ? "" : ";" + last_);
    text.append("\" keyTimes=\"").append(times_).append(in_steps ? "" : ";1");
    text.append("\" dur=\"").append(clock_.duration());
    return text.append("\" repeatCount=\"indefinite\"/>");
  }

 private:
  const Clock& clock_;
  std::string values_{}, times_{}, last_{};
};

/// Draws one drive.
class Animation {
 public:
  Animation(const Task& task, const Drive& drive)
      : drive_(drive),
        trace_(drive.result.trace),
        map_(drawn_map(task)),
        title_(task.scene.name),
        y_down_(task.y_down),
        scale_(width / std::max({map_.bounds.width(), map_.bounds.height(), 1e-300})),
        paths_{map_.bounds, scale_, {margin, margin + 30}, task.y_down},
        clock_(drive.result.time) {}

  std::string draw() {
    svg_.text({margin, margin + 14}, title_ + ": " + std::string(to_string(drive_.result.ending)),
              "font-size=\"18\" font-weight=\"bold\"");
    draw_map();
    svg_.raw("<g clip-path=\"url(#bounds)\">\n");
    global_paths();
    driven_path();
    for (const Encounter& encounter : drive_.encounters) obstacle(encounter);
    svg_.raw("</g>\n");
    goal();
    robot();
    const double y = margin + 30 + map_.bounds.height() * scale_;
    time_line(y + 14);
    const double bottom = legend(y + 44);
    return svg_.finish(legend_width() + 2 * margin, bottom);
  }

 private:
  static constexpr double margin = 16, width = 800;
  static constexpr std::size_t most_keys = 400;
  static constexpr std::string_view obstacle_style =
      "fill=\"#8c3b2a\" stroke=\"#5a2217\" stroke-width=\"1\"";

  double legend_width() const { return std::max(map_.bounds.width() * scale_, 560.0); }
  std::size_t stride() const { return std::max<std::size_t>(1, trace_.size() / most_keys); }

  void draw_map() {
    SvgMap map(svg_, map_, paths_);
    map.begin();
    map.safety_zones(map_.safety_radius);
    map.obstacles();
    map.end();
  }

  /// Each path is shown while it is followed; without animation, the first one.
  void global_paths() {
    const std::vector<FollowedPath>& followed = drive_.result.paths;
    for (std::size_t i = 0; i < followed.size(); ++i) {
      Track shown(clock_);
      shown.add(0, i == 0 ? "1" : "0");
      shown.add(followed[i].time, "1");
      if (i + 1 < followed.size()) shown.add(followed[i + 1].time, "0");
      svg_.raw(std::string("<g opacity=\"") + (i == 0 ? "1" : "0") + "\">");
      svg_.raw(shown.markup("animate attributeName=\"opacity\"", true));
      svg_.stroke(paths_.of_curve(followed[i].curve), path_style);
      svg_.raw("</g>\n");
    }
  }

  /// Parts of at most two seconds in the colours of their states. They turn from pale to full when
  /// they are driven.
  void driven_path() {
    for (std::size_t i = 0; i + 1 < trace_.size();) {
      std::size_t end = i + 1;
      while (end + 1 < trace_.size() && trace_[end].status == trace_[i].status &&
             trace_[end].time - trace_[i].time < 2) {
        ++end;
      }
      std::string data = "M" + paths_.at(trace_[i].pose.position);
      for (std::size_t k = i + 1; k <= end; ++k) data += "L" + paths_.at(trace_[k].pose.position);
      Track opacity(clock_);
      opacity.add(0, "0.15");
      opacity.add(trace_[end].time, "1");
      svg_.raw("<g>" + opacity.markup("animate attributeName=\"opacity\"", true));
      svg_.stroke(data, "stroke=\"" + colour_of(trace_[i].status) +
                            "\" stroke-width=\"3.5\" stroke-linecap=\"round\"");
      svg_.raw("</g>\n");
      i = end;
    }
  }

  /// An obstacle, pale where nothing moves. It moves from where it appears.
  void obstacle(const Encounter& encounter) {
    const double vanishes = std::min(encounter.vanishes, drive_.result.time);
    Track opacity(clock_), moves(clock_);
    opacity.add(0, "0");
    opacity.add(encounter.appears, "0.9");
    if (encounter.vanishes < drive_.result.time) opacity.add(vanishes, "0");
    svg_.raw("<g opacity=\"0.45\">" + opacity.markup("animate attributeName=\"opacity\"", true));
    svg_.raw("<g>");
    if (!encounter.obstacle.stands()) {
      const Point by = (vanishes - encounter.appears) * scale_ * encounter.obstacle.velocity;
      moves.add(0, "0 0");
      moves.add(encounter.appears, "0 0");
      moves.add(vanishes, SvgWriter::pair({by.x(), y_down_ ? by.y() : -by.y()}));
      svg_.raw(
          moves.markup("animateTransform attributeName=\"transform\" type=\"translate\"", false));
    }
    if (const Disc* disc = std::get_if<Disc>(&encounter.obstacle.shape)) {
      svg_.circle(paths_.pixel(disc->center), disc->radius * scale_, obstacle_style);
    } else {
      svg_.path(paths_.of_ring(std::get<Polygon>(encounter.obstacle.shape).outer), obstacle_style);
    }
    svg_.raw("</g></g>\n");
  }

  void goal() {
    tutavia::detail::goal_symbol(svg_, paths_.pixel(drive_.path.curve.end()), "#009e73");
  }

  /// In degrees, as SVG turns: clockwise, because y points down there.
  std::string rotation(double heading) const {
    return SvgWriter::number((y_down_ ? heading : -heading) * 180 / std::numbers::pi);
  }

  void robot() {
    if (trace_.empty()) return;
    Track place(clock_), turn(clock_), fill(clock_);
    const std::size_t last = trace_.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
      const TraceRow& row = trace_[i];
      fill.add_change(row.time, colour_of(row.status));
      if (i % stride() != 0 && i != last) continue;
      place.add(row.time, SvgWriter::pair(paths_.pixel(row.pose.position)));
      turn.add(row.time, rotation(row.pose.heading));
    }
    const double radius = map_.safety_radius * scale_;
    const Pose& first = trace_.front().pose;
    svg_.raw("<g transform=\"translate(" + SvgWriter::pair(paths_.pixel(first.position)) + ")\">");
    svg_.raw(
        place.markup("animateTransform attributeName=\"transform\" type=\"translate\"", false));
    svg_.raw("<circle r=\"" + SvgWriter::number(radius) +
             "\" fill-opacity=\"0.75\" stroke=\"#222b33\" stroke-width=\"1.5\" fill=\"" +
             colour_of(trace_.front().status) + "\">");
    svg_.raw(fill.markup("animate attributeName=\"fill\"", true) + "</circle>\n");
    svg_.raw("<g transform=\"rotate(" + rotation(first.heading) + ")\">");
    svg_.raw(turn.markup("animateTransform attributeName=\"transform\" type=\"rotate\"", false));
    svg_.stroke("M0 0h" + SvgWriter::number(radius), "stroke=\"#ffffff\" stroke-width=\"3\"");
    svg_.raw("</g></g>\n");
  }

  /// A bar that grows with time.
  void time_line(double y) {
    const double full = map_.bounds.width() * scale_;
    svg_.rect({margin, y - 3}, {full, 6}, "fill=\"#e3e7eb\"");
    Track grows(clock_);
    grows.add(0, "0");
    grows.add(drive_.result.time, SvgWriter::number(full));
    svg_.raw("<rect x=\"" + SvgWriter::number(margin) + "\" y=\"" + SvgWriter::number(y - 3) +
             "\" height=\"6\" width=\"0\" fill=\"#33414e\">" +
             grows.markup("animate attributeName=\"width\"", false) + "</rect>\n");
  }

  double legend(double y) {
    SvgLegend legend(svg_, {margin, y}, legend_width());
    for (const DriveStatus status : all_statuses) {
      const bool is_there = std::any_of(trace_.begin(), trace_.end(),
                                        [&](const TraceRow& row) { return row.status == status; });
      if (!is_there) continue;
      legend.line(meaning_of(status), "stroke=\"" + colour_of(status) + "\" stroke-width=\"4\"");
    }
    legend.line("path as planned", path_style);
    if (!drive_.encounters.empty()) {
      legend.area("obstacle that appears", obstacle_style);
    }
    legend.area("safety zone", "fill=\"#f6d9b8\"");
    std::string note = SvgWriter::number(drive_.result.time) + " s, " +
                       SvgWriter::number(drive_.result.length) +
                       " m; contacts of its own: " + std::to_string(drive_.result.own_contacts);
    legend.note(note);
    if (!drive_.result.reason.empty()) legend.note(drive_.result.reason);
    return legend.bottom();
  }

  static constexpr std::string_view path_style =
      "stroke=\"#7a8794\" stroke-width=\"1.8\" stroke-dasharray=\"5 4\"";

  const Drive& drive_;
  const std::vector<TraceRow>& trace_;
  Workspace map_;
  std::string title_;
  bool y_down_;
  double scale_;  // pixels per metre
  SvgPaths paths_;
  Clock clock_;
  SvgWriter svg_{};
};

}  // namespace

void write_animation(const std::string& path, const Task& task, const Drive& drive) {
  plan_program::throw_failure(tutavia::detail::write_file(path, Animation(task, drive).draw()));
}

}  // namespace drive_program
