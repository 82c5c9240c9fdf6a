// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "tutavia/plan/vehicle.hpp"
#include "tutavia/registry/options/option_field.hpp"
#include "tutavia/search/hybrid_astar.hpp"
#include "tutavia/smooth/continuous_curvature.hpp"
#include "tutavia/smooth/vehicle_shortcut.hpp"

/// \file
/// The option tables of what plans for vehicles.

namespace tutavia::detail {

/// What several algorithms say of options that they share.
struct VehicleSentences {
  static constexpr std::string_view reverse_weight = "cost of a metre in reverse, at least 1";
  static constexpr std::string_view cusp_cost = "cost of a change of gear";
  static constexpr std::string_view places =
      "between how many places drives are tried, from 2 to 1000";
};

template <>
struct OptionTable<Vehicle> {
  static constexpr auto fields = option_fields<Vehicle>(
      field<&Vehicle::min_turning_radius>("min_turning_radius", "m",
                                          "of the reference point; 0: turns on the spot"),
      field<&Vehicle::reverse>("reverse", "", "whether the vehicle may drive backwards"),
      data<&Vehicle::footprint>());
};

template <>
struct OptionTable<HybridAStar> {
  static constexpr std::string_view sentence =
      "A path for a vehicle with headings, a turning radius and a footprint";
  static constexpr auto fields = option_fields<HybridAStar>(
      field<&HybridAStar::vehicle>("vehicle", "", ""),
      field<&HybridAStar::reverse_weight>("reverse_weight", "", VehicleSentences::reverse_weight),
      field<&HybridAStar::cusp_cost>("cusp_cost", "m", VehicleSentences::cusp_cost),
      field<&HybridAStar::heuristic_weight>("heuristic_weight", "",
                                            "factor of the heuristic, at least 1"),
      field<&HybridAStar::headings>("headings", "", "directions in the first search"),
      field<&HybridAStar::searches>("searches", "",
                                    "searches at most, each with twice as many headings"));
};

template <>
struct OptionTable<VehicleShortcut> {
  static constexpr std::string_view sentence = "Shortens the path of a vehicle by shortest drives";
  static constexpr auto fields = option_fields<VehicleShortcut>(
      field<&VehicleShortcut::reverse_weight>("reverse_weight", "",
                                              VehicleSentences::reverse_weight),
      field<&VehicleShortcut::cusp_cost>("cusp_cost", "m", VehicleSentences::cusp_cost),
      field<&VehicleShortcut::places>("places", "", VehicleSentences::places));
};

template <>
struct OptionTable<ContinuousCurvature> {
  static constexpr std::string_view sentence =
      "Gives the path of a vehicle a curvature that never jumps";
  static constexpr auto fields = option_fields<ContinuousCurvature>(
      field<&ContinuousCurvature::max_sharpness>(
          "max_sharpness", "1/m^2",
          "change of curvature per metre; 0: one over the radius squared"),
      field<&ContinuousCurvature::reverse_weight>("reverse_weight", "",
                                                  VehicleSentences::reverse_weight),
      field<&ContinuousCurvature::cusp_cost>("cusp_cost", "m", VehicleSentences::cusp_cost),
      field<&ContinuousCurvature::places>("places", "", VehicleSentences::places));
};

}  // namespace tutavia::detail
