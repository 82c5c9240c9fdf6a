// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/geometry/vehicle_path.hpp"
#include "tutavia/io/text/svg_footprint.hpp"
#include "tutavia/io/text/svg_map.hpp"
#include "tutavia/io/text/svg_style.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// How a curve is built from pieces, and where it comes nearest to an obstacle.

namespace tutavia::detail {

/// How pieces of one kind are drawn.
struct PieceStyle {
  const char* label;
  const char* colour;
};

inline constexpr std::array<PieceStyle, 4> piece_styles{
    PieceStyle{"line", "#0072b2"}, PieceStyle{"Bezier with control polygon", "#d55e00"},
    PieceStyle{"arc with radii", "#009e73"}, PieceStyle{"clothoid", "#8e2fb8"}};

/// The index of a piece's style: that of both degrees of Bezier pieces is the same.
inline std::size_t style_index(const Piece& piece) {
  constexpr std::array<std::size_t, 5> by_kind{0, 1, 1, 2, 3};
  return by_kind[piece.index()];
}

/// The lines that define a piece: the control polygon of a Bezier piece, or the radii at both ends
/// of an arc.
inline std::vector<Segment> construction_lines(const Piece& any) {
  std::vector<Segment> lines;
  any.visit([&]<class P>(const P& piece) {
    if constexpr (std::is_same_v<P, Arc>) {
      lines = {{piece.a, piece.center}, {piece.center, piece.b}};
    } else if constexpr (requires { piece.points; }) {
      for (std::size_t i = 1; i < piece.points.size(); ++i) {
        lines.push_back({piece.points[i - 1], piece.points[i]});
      }
    }
  });
  return lines;
}

/// Draws the pieces of a curve in the colours of their kinds, dashed in reverse, with the lines
/// that define them and a dot at each end of a piece. `gears`: one per piece, or none.
inline void draw_pieces(SvgMap& map, const Curve& curve, std::span<const Gear> gears) {
  map.line(curve, SvgStyle::halo);
  for (const Piece& piece : curve.pieces()) {
    const std::string colour = piece_styles[style_index(piece)].colour;
    const std::vector<Segment> lines = construction_lines(piece);
    map.lines(lines, SvgStyle::curve(colour, "0.9"));
    for (std::size_t i = 1; i < lines.size(); ++i) {
      map.dots({lines[i].a}, 1.8, "fill=\"" + colour + "\"");
    }
  }
  for (std::size_t i = 0; i < curve.pieces().size(); ++i) {
    const Piece& piece = curve.pieces()[i];
    std::string style = SvgStyle::curve(piece_styles[style_index(piece)].colour, "2");
    if (!gears.empty() && gears[i] == Gear::reverse) style.append(SvgStyle::reverse);
    Curve part;
    part.push_back(piece);
    map.line(part, style);
  }
  map.dots(waypoints(curve), 2.2, SvgStyle::piece_end);
}

/// The disc around the point of least clearance that touches the nearest obstacle; nothing without
/// obstacles. On a vehicle's path, around the centre of the disc of the footprint that comes
/// nearest.
inline std::optional<Disc> touching_disc(const Plan& plan) {
  const Certificate& certificate = plan.certificate;
  if (!std::isfinite(certificate.upper)) return std::nullopt;
  Disc result{certificate.point, certificate.upper};
  if (plan.gears.empty() || !plan.route.vehicle) return result;
  const Pose pose =
      VehiclePath{plan.curve, plan.gears}.pose(certificate.piece, certificate.parameter);
  double nearest = std::numeric_limits<double>::infinity();
  for (const FootprintDisc& disc : plan.route.vehicle->footprint) {
    const double gap = distance(placed(disc.offset, pose), certificate.point);
    if (gap >= nearest) continue;
    nearest = gap;
    result.radius = disc.radius + certificate.upper;
  }
  return result;
}

inline void draw_least_clearance(SvgMap& map, const Plan& plan) {
  const std::optional<Disc> disc = touching_disc(plan);
  if (!disc) return;
  map.disc(*disc, SvgStyle::least_clearance);
  map.dots({disc->center}, 2.2, SvgStyle::least_clearance);
}

}  // namespace tutavia::detail
