// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

#include "tutavia/registry/options/option_field.hpp"
#include "tutavia/smooth/b_spline_smoother.hpp"
#include "tutavia/smooth/bezier_smoother.hpp"
#include "tutavia/smooth/clothoid_smoother.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "tutavia/smooth/homotopy_refine.hpp"
#include "tutavia/smooth/no_smoothing.hpp"
#include "tutavia/smooth/redundant_node_removal.hpp"
#include "tutavia/smooth/shortcut.hpp"
#include "tutavia/smooth/smoothing_spline.hpp"
#include "tutavia/smooth/string_pull.hpp"
#include "tutavia/smooth/taut_string.hpp"
#include "tutavia/smooth/two_stage_b_spline.hpp"

/// \file
/// The option tables of the smoothers. "spacing" is the unit of lengths in spacings of the grid.

namespace tutavia::detail {

template <>
struct EnumNames<DeltaSmoother::Join> {
  static constexpr std::array<std::string_view, 2> names{"paper", "tangent"};
};

template <>
struct EnumNames<ClothoidSmoother::Spirals> {
  static constexpr std::array<std::string_view, 2> names{"clothoids", "cubic_beziers"};
};

template <>
struct EnumNames<RedundantNodeRemoval::Scan> {
  static constexpr std::array<std::string_view, 2> names{"forward", "from_far_end"};
};

template <>
struct OptionTable<NoSmoothing> {
  static constexpr std::string_view sentence = "The route, unchanged";
  static constexpr auto fields = option_fields<NoSmoothing>();
};

template <>
struct OptionTable<Shortcut> {
  static constexpr std::string_view sentence = "Straight lines between waypoints in sight";
  static constexpr auto fields = option_fields<Shortcut>();
};

template <>
struct OptionTable<RedundantNodeRemoval> {
  static constexpr std::string_view sentence = "Removes redundant nodes of a route";
  static constexpr auto fields =
      option_fields<RedundantNodeRemoval>(field<&RedundantNodeRemoval::scan>(
          "scan", "", "from which end the next kept node is sought"));
};

template <>
struct OptionTable<DeltaSmoother> {
  static constexpr std::string_view sentence =
      "Wide arcs where the path turns near corners, long straight lines in between";
  static constexpr auto fields = option_fields<DeltaSmoother>(
      field<&DeltaSmoother::corner_threshold>(
          "corner_threshold", "m",
          "largest distance between the path and the safety zone of a critical corner"),
      field<&DeltaSmoother::arc_initial_offset>("arc_initial_offset", "m",
                                                "first distance tried between the control point of "
                                                "an arc and the safety zone of its corner"),
      field<&DeltaSmoother::arc_max_offset>("arc_max_offset", "m", "largest such distance"),
      field<&DeltaSmoother::arc_growth_step>("arc_growth_step", "m",
                                             "step between such distances, positive"),
      field<&DeltaSmoother::min_exterior_angle>(
          "min_exterior_angle", "rad", "corners that turn by less are facets of a round obstacle"),
      field<&DeltaSmoother::join>("join", "",
                                  "how lines and arcs meet: in one direction, or as in the paper"));
};

template <>
struct OptionTable<BezierSmoother> {
  static constexpr std::string_view sentence = "Corners rounded by cubic Bezier pieces";
  static constexpr auto fields = option_fields<BezierSmoother>(
      field<&BezierSmoother::trim>("trim", "spacing", "largest length taken of each leg"),
      field<&BezierSmoother::fullness>(
          "fullness", "",
          "position of the inner control points between leg and corner, in (0, 1]"));
};

template <>
struct OptionTable<BSplineSmoother> {
  static constexpr std::string_view sentence = "A cubic B-spline along the pruned route";
  static constexpr auto fields = option_fields<BSplineSmoother>(
      field<&BSplineSmoother::reach>(
          "reach", "spacing", "distance of the auxiliary control points from a corner, positive"),
      field<&BSplineSmoother::prune>("prune", "", "whether redundant nodes are removed first"));
};

template <>
struct OptionTable<SmoothingSpline> {
  static constexpr std::string_view sentence = "A least-squares cubic spline near the route";
  static constexpr auto fields = option_fields<SmoothingSpline>(
      field<&SmoothingSpline::smoothing>("smoothing", "spacing^2",
                                         "bound s on the sum of squared distances from the nodes"),
      field<&SmoothingSpline::output_points>(
          "output_points", "", "points of the spline on the whole route, from 2 to a million"));
};

template <>
struct OptionTable<TwoStageBSpline> {
  static constexpr std::string_view sentence =
      "A cubic B-spline on nodes moved away from obstacles by f(d) = 1 / (a + b e^(c d))";
  static constexpr auto fields = option_fields<TwoStageBSpline>(
      field<&TwoStageBSpline::a>("a", "", "a in f(d)"),
      field<&TwoStageBSpline::b>("b", "", "b in f(d)"),
      field<&TwoStageBSpline::c>("c", "per cell", "c in f(d)"),
      field<&TwoStageBSpline::d0>("d0", "cells", "range of influence of blocked cells, up to 100"),
      field<&TwoStageBSpline::passes>("passes", "", "how often nodes are moved"));
};

template <>
struct OptionTable<TautString> {
  static constexpr std::string_view sentence =
      "The shortest path that leaves the obstacles on the same sides as the route";
  static constexpr auto fields = option_fields<TautString>();
};

template <>
struct OptionTable<ClothoidSmoother> {
  static constexpr std::string_view sentence = "A path of continuous curvature";
  static constexpr auto fields = option_fields<ClothoidSmoother>(
      field<&ClothoidSmoother::clearance_budget>(
          "clearance_budget", "safety radii",
          "largest distance by which the path is moved away from the safety zones; at safety "
          "radius 0 in spacings"),
      field<&ClothoidSmoother::min_turning_radius>(
          "min_turning_radius", "m", "lower bound on the turning radius, or a failure"),
      field<&ClothoidSmoother::spirals>("spirals", "",
                                        "the pieces along which the curvature changes"));
};

template <>
struct OptionTable<HomotopyRefine> {
  static constexpr std::string_view sentence =
      "The shortest path of all, if it is shorter than the route";
  static constexpr auto fields =
      option_fields<HomotopyRefine>(field<&HomotopyRefine::max_expansions>(
          "max_expansions", "", "expansions of the search at most"));
};

template <>
struct OptionTable<StringPull> {
  static constexpr std::string_view sentence =
      "The shortest path of a point on cells that leaves them on the same sides as the route";
  static constexpr auto fields = option_fields<StringPull>();
};

}  // namespace tutavia::detail
