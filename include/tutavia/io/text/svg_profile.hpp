// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "tutavia/geometry/vehicle_path.hpp"
#include "tutavia/io/text/svg_footprint.hpp"
#include "tutavia/io/text/svg_plot.hpp"
#include "tutavia/io/text/svg_samples.hpp"
#include "tutavia/io/text/svg_style.hpp"
#include "tutavia/io/text/svg_text.hpp"
#include "tutavia/io/text/svg_writer.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// SvgProfile: clearance and curvature of plans along their arc length.

namespace tutavia::detail {

/// Two plots, one below the other: clearance and curvature of every plan. The clearance of a
/// vehicle is that of its footprint.
class SvgProfile {
 public:
  static constexpr double height = 340;  ///< of both plots with their texts, in pixels

  /// `corner`: the upper left one, in pixels. Without a valid workspace no clearance is known.
  SvgProfile(SvgWriter& svg, const Point& corner, double width, const Workspace& workspace,
             std::span<const Plan> plans)
      : svg_(svg), corner_(corner), width_(width), radius_(workspace.safety_radius) {
    const auto space = InflatedSpace::build(workspace);
    const auto clearance_at = [&](const Point& p) {
      return space ? space->clearance(p) : std::numeric_limits<double>::quiet_NaN();
    };
    for (const Plan& plan : plans) {
      curves_.push_back(sample_curve(plan.curve, samples, clearance_at, plan.gears));
      if (!plan.gears.empty() && plan.route.vehicle) {
        measure_footprint(*plan.route.vehicle, {plan.curve, plan.gears}, clearance_at);
      }
      longest_ = std::max(longest_, plan.curve.length());
    }
    if (longest_ == 0) longest_ = 1;
  }

  void draw() {
    clearance();
    curvature();
  }

 private:
  /// Makes the clearances of the last curve those of the vehicle's discs.
  template <class ClearanceAt>
  void measure_footprint(const Vehicle& vehicle, const VehiclePath& path,
                         const ClearanceAt& clearance_at) {
    for (CurveSamples::Sample& sample : curves_.back().samples) {
      const Pose pose = path.at(sample.s);
      sample.clearance = std::numeric_limits<double>::infinity();
      for (const FootprintDisc& disc : vehicle.footprint) {
        const Point centre = placed(disc.offset, pose);
        sample.clearance = std::fmin(sample.clearance, clearance_at(centre) - disc.radius);
      }
    }
  }

  static constexpr std::size_t samples = 600;
  static constexpr double left = 44, top = 34, plot_height = 110, gap = 50;

  SvgPlot plot(double upper, double limit) {
    return SvgPlot(svg_,
                   {{corner_.x() + left, corner_.y() + upper},
                    {corner_.x() + width_, corner_.y() + upper + plot_height}},
                   {longest_, limit});
  }
  static std::string style(std::size_t i) {
    return SvgStyle::curve(SvgStyle::colour(i), "1.6") + " stroke-linecap=\"round\"";
  }

  void clearance() {
    const bool has_radius = radius_ > 0 && std::isfinite(radius_);
    const double most = std::max(clearance_limit(curves_), has_radius ? radius_ : 0);
    SvgPlot plot = this->plot(top, 1.05 * most);
    plot.axes("clearance [m]",
              has_radius ? "dashed: safety radius, " + trimmed(radius_) + " m" : std::string());
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      std::vector<Point> points;
      for (const CurveSamples::Sample& sample : curves_[i].samples) {
        points.emplace_back(sample.s, sample.clearance);
      }
      plot.curve(points, style(i));
    }
    if (has_radius) plot.level(radius_, SvgStyle::radius_line);
  }

  void curvature() {
    const double limit = curvature_limit(curves_);
    SvgPlot plot = this->plot(top + plot_height + gap, 1.05 * limit);
    std::size_t corners = 0;
    double most = 0;
    for (const CurveSamples& curve : curves_) {
      corners += curve.corners.size();
      for (const auto& sample : curve.samples) most = std::max(most, sample.curvature);
    }
    plot.axes("curvature [1/m]", clipping_note(corners > 0, most, 1.05 * limit));
    plot.name_horizontal("arc length [m]");
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      std::vector<Point> points;
      for (const CurveSamples::Sample& sample : curves_[i].samples) {
        points.emplace_back(sample.s, std::min(sample.curvature, 2 * limit));
      }
      plot.curve(points, style(i));
      for (const double s : curves_[i].corners) plot.spike(s, style(i));
    }
  }

  static std::string clipping_note(bool has_corners, double most, double limit) {
    std::string note = has_corners ? "corners: spikes to the top" : "";
    if (most <= limit) return note;
    if (has_corners) note += "; ";
    note += std::isfinite(most) ? "clipped, up to " + trimmed(most) + " 1/m" : "clipped at cusps";
    return note;
  }

  SvgWriter& svg_;
  Point corner_;
  double width_, radius_;
  std::vector<CurveSamples> curves_{};
  double longest_ = 0;  // arc length [m]
};

}  // namespace tutavia::detail
