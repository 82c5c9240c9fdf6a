// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

/// \file
/// SvgStyle: the colours of pictures.

namespace tutavia::detail {

/// The SVG attributes of everything that a picture shows.
struct SvgStyle {
  static constexpr std::string_view visited = "#b3d9f5";  ///< a colour: squares and dots have it
  static constexpr std::string_view buffer = "fill=\"#8fc7ec\" shape-rendering=\"crispEdges\"";
  static constexpr std::string_view obstacle = "fill=\"#4a5763\"";
  static constexpr std::string_view zone = "fill=\"#f6d9b8\"";
  static constexpr std::string_view risk_zone = "fill=\"#cdd2d7\"";
  static constexpr std::string_view tree_path = "stroke=\"#000000\" stroke-width=\"1.8\"";
  static constexpr std::string_view route =
      "stroke=\"#7a8794\" stroke-width=\"1.2\" stroke-dasharray=\"4 3\"";
  static constexpr std::string_view path_node =
      "fill=\"#f07d00\" stroke=\"#ffffff\" stroke-width=\"0.8\"";
  static constexpr std::string_view piece_end =
      "fill=\"#ffffff\" stroke=\"#222b33\" stroke-width=\"1\"";
  static constexpr std::string_view least_clearance =
      "fill=\"#e31a8c\" fill-opacity=\"0.3\" stroke=\"#e31a8c\" stroke-width=\"1.2\"";
  static constexpr std::string_view halo =  ///< below a curve
      "stroke=\"#ffffff\" stroke-width=\"6\" stroke-opacity=\"0.7\"";
  static constexpr std::string_view forward_rectangle =
      "fill=\"#ffd84d\" fill-opacity=\"0.3\" stroke=\"#c9a000\" stroke-width=\"0.8\"";
  static constexpr std::string_view backward_rectangle =
      "fill=\"#5cb874\" fill-opacity=\"0.22\" stroke=\"#3d9455\" stroke-width=\"0.8\"";
  static constexpr std::string_view forward_passage =
      "stroke=\"#d4a000\" stroke-width=\"3\" stroke-linecap=\"round\"";
  static constexpr std::string_view backward_passage =
      "stroke=\"#1b7837\" stroke-width=\"3\" stroke-linecap=\"round\"";
  static constexpr std::string_view reverse = " stroke-dasharray=\"8 5\"";  ///< besides a curve's
  static constexpr std::string_view start_arrow = "#222b33";                ///< a colour
  static constexpr std::string_view outline = "stroke=\"#7a8794\" stroke-width=\"0.8\"";
  static constexpr std::string_view axis = "stroke=\"#33414e\" stroke-width=\"1\"";
  static constexpr std::string_view grid_line = "stroke=\"#e3e7eb\" stroke-width=\"1\"";
  static constexpr std::string_view radius_line =
      "stroke=\"#d98324\" stroke-width=\"1.4\" stroke-dasharray=\"6 3\"";

  static std::string tree(const std::string& width) {
    return "stroke=\"#6fa58f\" stroke-width=\"" + width + "\"";
  }

  /// The colour of curve i: twelve that differ, then the same again. The first six are after Okabe
  /// and Ito, for colour-blind readers.
  static std::string colour(std::size_t i) {
    constexpr std::array<const char*, 12> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                  "#56b4e9", "#a07400", "#8b1a1a", "#5e3c99",
                                                  "#7fbf2f", "#e31a8c", "#333333", "#00b3b3"};
    return colours[i % colours.size()];
  }
  static std::string footprint(const std::string& colour) {
    return "stroke=\"" + colour + "\" stroke-width=\"0.9\" stroke-opacity=\"0.45\"";
  }
  static std::string curve(const std::string& colour, const std::string& width = "3") {
    return "stroke=\"" + colour + "\" stroke-width=\"" + width + "\"";
  }
};

}  // namespace tutavia::detail
