// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

#include "tutavia/registry/options/option_field.hpp"
#include "tutavia/search/ant_colony.hpp"
#include "tutavia/search/any_angle.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/auto_search.hpp"
#include "tutavia/search/bidirectional_astar.hpp"
#include "tutavia/search/canonical_astar.hpp"
#include "tutavia/search/dijkstra.hpp"
#include "tutavia/search/heuristic.hpp"
#include "tutavia/search/improved_rea_star.hpp"
#include "tutavia/search/jps.hpp"
#include "tutavia/search/jps_plus.hpp"
#include "tutavia/search/jps_theta_star.hpp"
#include "tutavia/search/lazy_theta_star.hpp"
#include "tutavia/search/node_placement.hpp"
#include "tutavia/search/penalty_astar.hpp"
#include "tutavia/search/rea_star.hpp"
#include "tutavia/search/sb_rea_star.hpp"
#include "tutavia/search/ssa_astar.hpp"
#include "tutavia/search/tangent_graph.hpp"
#include "tutavia/search/theta_star.hpp"
#include "tutavia/search/weighted_astar.hpp"

/// \file
/// The option tables of the searches on grids, cells and tangents.

namespace tutavia::detail {

template <>
struct EnumNames<HeuristicKind> {
  static constexpr std::array<std::string_view, 4> names{"octile", "euclidean", "chebyshev",
                                                         "manhattan"};
};

template <>
struct EnumNames<AStar::Successors> {
  static constexpr std::array<std::string_view, 2> names{"canonical", "all"};
};

template <>
struct EnumNames<NodePlacement> {
  static constexpr std::array<std::string_view, 2> names{"cell_centre", "cell_corner"};
};

template <>
struct EnumNames<JpsThetaStar::LineOfSight> {
  static constexpr std::array<std::string_view, 3> names{"never", "after_search", "in_search"};
};

template <>
struct EnumNames<AntColony::DeadEnds> {
  static constexpr std::array<std::string_view, 2> names{"step_back", "discard"};
};

template <>
struct EnumNames<ExitCost> {
  static constexpr std::array<std::string_view, 2> names{"cumulative", "last_leg"};
};

template <>
struct EnumNames<ExitTarget> {
  static constexpr std::array<std::string_view, 2> names{"goal", "newest_exit"};
};

template <>
struct OptionTable<Dijkstra> {
  static constexpr std::string_view sentence = "A* without a heuristic";
  static constexpr auto fields = option_fields<Dijkstra>(data<&Dijkstra::costs>());
};

template <>
struct OptionTable<AStar> {
  static constexpr std::string_view sentence = "A cheapest path on a grid, guided by a heuristic";
  static constexpr auto fields = option_fields<AStar>(
      field<&AStar::heuristic>(
          "heuristic", "",
          "estimate of the distance to the goal; manhattan overestimates diagonals"),
      field<&AStar::successors>("successors", "",
                                "steps from a cell: those of one of many equal paths, or all"),
      data<&AStar::costs>());
};

template <>
struct OptionTable<WeightedAStar> {
  static constexpr std::string_view sentence = "A* whose path may be longer by a bounded factor";
  static constexpr auto fields = option_fields<WeightedAStar>(
      field<&WeightedAStar::weight>("weight", "",
                                    "factor of the heuristic, and bound on the path's "
                                    "length in shortest paths, from 1 to 1000"));
};

template <>
struct OptionTable<CanonicalAStar> {
  static constexpr std::string_view sentence = "A* that generates one of many equal paths";
  static constexpr auto fields = option_fields<CanonicalAStar>();
};

template <>
struct OptionTable<BidirectionalAStar> {
  static constexpr std::string_view sentence = "A* from the start and from the goal at once";
  static constexpr auto fields = option_fields<BidirectionalAStar>();
};

template <>
struct OptionTable<PenaltyAStar> {
  static constexpr std::string_view sentence = "A* with a cost for turning";
  static constexpr auto fields = option_fields<PenaltyAStar>(field<&PenaltyAStar::turn_penalty>(
      "turn_penalty", "m per rad", "lambda, the cost of a turn, up to 1000"));
};

template <>
struct OptionTable<Jps> {
  static constexpr std::string_view sentence = "Jump point search without preprocessing";
  static constexpr auto fields = option_fields<Jps>();
};

template <>
struct OptionTable<JpsPlus> {
  static constexpr std::string_view sentence = "Jump point search with a table of all jumps";
  static constexpr auto fields = option_fields<JpsPlus>(data<&JpsPlus::table>());
};

template <>
struct OptionTable<ThetaStar> {
  static constexpr std::string_view sentence = "A* whose paths bend by any angle";
  static constexpr auto fields = option_fields<ThetaStar>(field<&ThetaStar::nodes>(
      "nodes", "", "where paths bend; corners are for grid maps at safety radius 0"));
};

template <>
struct OptionTable<LazyThetaStar> {
  static constexpr std::string_view sentence = "Theta* with fewer line-of-sight tests";
  static constexpr auto fields = option_fields<LazyThetaStar>(field<&LazyThetaStar::nodes>(
      "nodes", "", "where paths bend; corners are for grid maps at safety radius 0"));
};

template <>
struct OptionTable<JpsThetaStar> {
  static constexpr std::string_view sentence =
      "Weighted jump point search with line-of-sight tests";
  static constexpr auto fields = option_fields<JpsThetaStar>(
      field<&JpsThetaStar::far_weight>(
          "far_weight", "", "factor of the heuristic farther than switch_distance from the goal"),
      field<&JpsThetaStar::near_weight>("near_weight", "", "factor of the heuristic nearer by"),
      field<&JpsThetaStar::switch_distance>("switch_distance", "cells",
                                            "distance from the goal at which the weight changes"),
      field<&JpsThetaStar::lines_of_sight>("lines_of_sight", "",
                                           "when bends are removed by lines of sight"));
};

template <>
struct OptionTable<SsaAStar::Weights> {
  static constexpr auto fields = option_fields<SsaAStar::Weights>(
      field<&SsaAStar::Weights::chebyshev>("chebyshev", "", "w1, factor of the Chebyshev distance"),
      field<&SsaAStar::Weights::euclidean>("euclidean", "", "w2, factor of the Euclidean distance"),
      field<&SsaAStar::Weights::density>(
          "density", "cells", "w3, factor of the share of blocked cells among the neighbours"));
};

template <>
struct OptionTable<SsaAStar> {
  static constexpr std::string_view sentence = "A* with a heuristic tuned by a salp swarm";
  static constexpr auto fields = option_fields<SsaAStar>(
      field<&SsaAStar::weights>("weights", "", ""),
      field<&SsaAStar::reopen>(
          "reopen", "", "whether a cell is expanded again when a cheaper path to it is found"));
};

template <>
struct OptionTable<AntColony> {
  static constexpr std::string_view sentence = "Repeated random walks guided by pheromone";
  static constexpr auto fields = option_fields<AntColony>(
      field<&AntColony::ants>("ants", "", "ants per round, at least 1"),
      field<&AntColony::iterations>("iterations", "", "rounds, at least 1"),
      field<&AntColony::pheromone_exponent>("pheromone_exponent", "", "alpha, from 0 to 100"),
      field<&AntColony::distance_exponent>(
          "distance_exponent", "", "beta, the exponent of 1 / distance to the goal, from 0 to 100"),
      field<&AntColony::evaporation>("evaporation", "",
                                     "rho, the share of pheromone lost per round, less than 1"),
      field<&AntColony::dead_ends>("dead_ends", "", "what an ant does without a step left"),
      field<&AntColony::deposit>("deposit", "", "Q: an ant deposits Q / length in cells"));
};

template <>
struct OptionTable<ReaStar> {
  static constexpr std::string_view sentence = "A* over free rectangles";
  static constexpr auto fields = option_fields<ReaStar>();
};

template <>
struct OptionTable<SbReaStar> {
  static constexpr std::string_view sentence =
      "Rectangle expansion from both ends, with nodes that slide along their portals";
  static constexpr auto fields = option_fields<SbReaStar>();
};

template <>
struct OptionTable<ImprovedReaStar> {
  static constexpr std::string_view sentence =
      "Rectangle expansion from both ends, with exits evaluated at their midpoints";
  static constexpr auto fields = option_fields<ImprovedReaStar>(
      field<&ImprovedReaStar::exit_cost>("exit_cost", "", "how the cost of an exit is summed"),
      field<&ImprovedReaStar::target>("target", "",
                                      "towards what the rest of the way from an exit is estimated"),
      field<&ImprovedReaStar::continue_after_contact>(
          "continue_after_contact", "",
          "whether to go on after the two searches have met, for a shorter path"),
      field<&ImprovedReaStar::funnel>(
          "funnel", "",
          "whether to return the shortest path through the exits instead of the paper's nodes"));
};

template <>
struct OptionTable<AnyAngle> {
  static constexpr std::string_view sentence =
      "The shortest path of a point among blocked cells, at any angle";
  static constexpr auto fields =
      option_fields<AnyAngle>(data<&AnyAngle::mesh>(), data<&AnyAngle::mesh_on_demand>());
};

template <>
struct OptionTable<AutoSearch> {
  static constexpr std::string_view sentence =
      "On workspaces A*, and tangent_graph where the lattice has no path; on cells jump points";
  static constexpr auto fields = option_fields<AutoSearch>();
};

template <>
struct OptionTable<TangentGraph> {
  static constexpr std::string_view sentence =
      "The shortest path of a disc or a point among polygons and discs, or among cells";
  static constexpr auto fields = option_fields<TangentGraph>(
      field<&TangentGraph::bound>("bound", "m", "longer paths are not searched"),
      data<&TangentGraph::tangents>());
};

}  // namespace tutavia::detail
