// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

#include "tutavia/registry/options/option_field.hpp"
#include "tutavia/search/informed_rrt_star.hpp"
#include "tutavia/search/neighbours.hpp"
#include "tutavia/search/rrt.hpp"
#include "tutavia/search/rrt_connect.hpp"
#include "tutavia/search/rrt_star.hpp"
#include "tutavia/search/safe_rrt_star.hpp"

/// \file
/// The option tables of the searches that grow random trees.

namespace tutavia::detail {

template <>
struct EnumNames<Neighbours> {
  static constexpr std::array<std::string_view, 2> names{"k_nearest", "radius"};
};

/// What several trees say of options that they share.
struct TreeSentences {
  static constexpr std::string_view step =
      "longest step; none: 1/25 of the longer side of the bounds";
  static constexpr std::string_view goal_bias =
      "share of iterations that grow towards the goal, from 0 to 1";
  static constexpr std::string_view iterations = "iterations at most";
  static constexpr std::string_view neighbours = "which nodes count as near a new one";
  static constexpr std::string_view rewire_factor =
      "factor of the bounds on near nodes; more than 1 for asymptotic optimality";
};

template <>
struct OptionTable<Rrt> {
  static constexpr std::string_view sentence = "The first path found by a random tree";
  static constexpr auto fields = option_fields<Rrt>(
      field<&Rrt::step>("step", "m", TreeSentences::step),
      field<&Rrt::goal_bias>("goal_bias", "", TreeSentences::goal_bias),
      field<&Rrt::max_iterations>("max_iterations", "", TreeSentences::iterations));
};

template <>
struct OptionTable<RrtStar> {
  static constexpr std::string_view sentence =
      "A random tree that keeps the cheapest parents, so its path shortens as it grows";
  static constexpr auto fields = option_fields<RrtStar>(
      field<&RrtStar::step>("step", "m", TreeSentences::step),
      field<&RrtStar::goal_bias>("goal_bias", "", TreeSentences::goal_bias),
      field<&RrtStar::max_iterations>("max_iterations", "", TreeSentences::iterations),
      field<&RrtStar::neighbours>("neighbours", "", TreeSentences::neighbours),
      field<&RrtStar::rewire_factor>("rewire_factor", "", TreeSentences::rewire_factor));
};

template <>
struct OptionTable<RrtConnect> {
  static constexpr std::string_view sentence = "Two random trees that grow towards each other";
  static constexpr auto fields = option_fields<RrtConnect>(
      field<&RrtConnect::step>("step", "m", TreeSentences::step),
      field<&RrtConnect::max_iterations>("max_iterations", "", TreeSentences::iterations));
};

template <>
struct OptionTable<InformedRrtStar> {
  static constexpr std::string_view sentence =
      "RRT* that samples only points that can shorten its path";
  static constexpr auto fields = option_fields<InformedRrtStar>(
      field<&InformedRrtStar::step>("step", "m", TreeSentences::step),
      field<&InformedRrtStar::goal_bias>("goal_bias", "", TreeSentences::goal_bias),
      field<&InformedRrtStar::max_iterations>("max_iterations", "", TreeSentences::iterations),
      field<&InformedRrtStar::neighbours>("neighbours", "", TreeSentences::neighbours),
      field<&InformedRrtStar::rewire_factor>("rewire_factor", "", TreeSentences::rewire_factor));
};

template <>
struct OptionTable<SafeRrtStar> {
  static constexpr std::string_view sentence = "RRT* that prefers to stay away from obstacles";
  static constexpr auto fields = option_fields<SafeRrtStar>(
      field<&SafeRrtStar::step>("step", "m", TreeSentences::step),
      field<&SafeRrtStar::goal_bias>("goal_bias", "", TreeSentences::goal_bias),
      field<&SafeRrtStar::max_iterations>("max_iterations", "", "iterations of each tree at most"),
      field<&SafeRrtStar::neighbours>("neighbours", "", TreeSentences::neighbours),
      field<&SafeRrtStar::rewire_factor>("rewire_factor", "", TreeSentences::rewire_factor),
      field<&SafeRrtStar::risk_width>("risk_width", "m",
                                      "width of the risk zones; none: the longest step"),
      field<&SafeRrtStar::risk_weight>("risk_weight", "",
                                       "metres of length that a metre at full risk costs"),
      field<&SafeRrtStar::keep_out>("keep_out", "",
                                    "whether to try a tree outside the risk zones first"),
      field<&SafeRrtStar::prune>("prune", "", "whether to remove redundant nodes"));
};

}  // namespace tutavia::detail
