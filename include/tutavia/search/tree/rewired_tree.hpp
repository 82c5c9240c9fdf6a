// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "tutavia/search/neighbours.hpp"
#include "tutavia/search/tree/tree_growth.hpp"

/// \file
/// RewiredTree: the tree of RRT*, which chooses the best parents and rewires neighbours.

namespace tutavia::detail {

/// Memory of a search with one rewired tree. Holds the tree of the last query.
struct RewiredTreeScratch : TreeScratch {
  /// A node near a new one: its distance, and a lower bound on the path cost through it.
  struct Near {
    double length, least_cost;
    SearchTree::Node node;
  };

  std::vector<PointBuckets::Neighbour> neighbours;
  std::vector<Near> near;
};

/// The size of the neighbourhood of a new node in a tree of n nodes.
struct NeighbourRule {
  Neighbours kind;
  double factor;

  std::size_t count(std::size_t n) const {
    const double bound = 1.5 * std::numbers::e * logarithm(n);
    return static_cast<std::size_t>(std::min(std::ceil(factor * bound), static_cast<double>(n)));
  }
  double radius(std::size_t n, double area, double step) const {
    const double share = logarithm(n) / static_cast<double>(n);
    return std::min(factor * 2 * std::sqrt(1.5 * area / std::numbers::pi * share), step);
  }

  Expected<void, Failure> check() const {
    if (factor > 0 && std::isfinite(factor)) return {};
    return fail(PlanError::invalid_option, "rewire_factor must be positive and finite");
  }

 private:
  static double logarithm(std::size_t n) { return std::log(static_cast<double>(n < 2 ? 2 : n)); }
};

/// The cost of edges: `cost(p, q, length)` is the cost of the straight edge from p to q, whose
/// length is given; at least the length.
template <class C>
concept EdgeCost = requires(const C& cost, const Point& p, double length) {
  { cost(p, p, length) } -> std::same_as<double>;
};

/// Edges cost their length.
struct LengthCost {
  double operator()(const Point&, const Point&, double length) const { return length; }
};

/// A tree of RRT* with edge costs by an EdgeCost.
template <EdgeCost CostOf, FreeSpace S, Observer O>
class RewiredTree {
 public:
  using Node = SearchTree::Node;

  RewiredTree(TreeGrowth<S, O>& growth, const NeighbourRule& rule, const CostOf& edge_cost,
              RewiredTreeScratch& scratch)
      : growth_(growth),
        rule_(rule),
        edge_cost_(edge_cost),
        scratch_(scratch),
        tree_(scratch.tree) {
    tree_.reset(growth.bounds(), growth.query().start);
  }

  bool has_path() const { return goal_ != SearchTree::none; }
  /// Cost of the best path; infinite without a path.
  double cost() const { return best_; }
  /// The best path. \pre has_path()
  std::vector<Point> path() const { return tree_.path_to(goal_); }

  const SearchTree& nodes() const { return tree_; }

  /// Takes one step towards a point, and adds the goal if it is within a step.
  void grow(const Point& target) {
    const Node nearest = tree_.points().nearest(target);
    const auto end = growth_.step_towards(tree_, nearest, target);
    if (!end) return;
    const Node node = insert(*end, nearest);
    const Point goal = growth_.query().goal;
    if (*end == goal) {
      goal_ = node;
    } else if (!has_path() && distance(*end, goal) <= growth_.step() &&
               growth_.space().segment_free(*end, goal)) {
      goal_ = insert(goal, node);
    }
    if (has_path() && tree_.cost(goal_) < best_) {
      best_ = tree_.cost(goal_);
      growth_.notify_improved(path(), best_);
    }
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// Adds a point that `parent` sees: chooses the best parent near it, then rewires its neighbours.
  Node insert(const Point& p, Node parent) {
    find_near(p);
    double edge = edge_cost_(tree_.position(parent), p, distance(tree_.position(parent), p));
    double cost = tree_.cost(parent) + edge;
    while (auto* candidate = cheapest_below(cost)) {
      candidate->least_cost = infinity;
      const Point from = tree_.position(candidate->node);
      if (!growth_.space().segment_free(from, p)) {
        candidate->length = infinity;
        continue;
      }
      const double other_edge = edge_cost_(from, p, candidate->length);
      if (!(tree_.cost(candidate->node) + other_edge < cost)) continue;
      parent = candidate->node;
      edge = other_edge;
      cost = tree_.cost(parent) + edge;
    }
    const Node node = growth_.add(tree_, parent, p, edge);
    // Sorts the few that remain: the order of the neighbours differs between compilers.
    std::erase_if(scratch_.near, [&](const auto& neighbour) {
      return !(cost + neighbour.length < tree_.cost(neighbour.node));
    });
    std::sort(scratch_.near.begin(), scratch_.near.end(),
              [](const auto& a, const auto& b) { return a.node < b.node; });
    for (const auto& neighbour : scratch_.near) rewire(neighbour, node, p);
    return node;
  }

  void find_near(const Point& p) {
    const std::size_t n = tree_.size();
    if (rule_.kind == Neighbours::k_nearest) {
      tree_.points().k_nearest(p, rule_.count(n), scratch_.neighbours);
    } else {
      const double area = growth_.bounds().width() * growth_.bounds().height();
      tree_.points().within(p, rule_.radius(n, area, growth_.step()), scratch_.neighbours);
    }
    scratch_.near.clear();
    for (const auto& [squared_distance, node] : scratch_.neighbours) {
      const double length = std::sqrt(squared_distance);
      scratch_.near.push_back({length, tree_.cost(node) + length, node});
    }
  }

  RewiredTreeScratch::Near* cheapest_below(double cost) {
    RewiredTreeScratch::Near* cheapest = nullptr;
    for (auto& candidate : scratch_.near) {
      const bool better = cheapest == nullptr ? candidate.least_cost < cost
                          : candidate.least_cost != cheapest->least_cost
                              ? candidate.least_cost < cheapest->least_cost
                              : candidate.node < cheapest->node;
      if (better) cheapest = &candidate;
    }
    return cheapest;
  }

  /// Makes a new node the parent of one near it, if that is cheaper.
  void rewire(const RewiredTreeScratch::Near& neighbour, Node node, const Point& p) {
    const double cost = tree_.cost(node), known = tree_.cost(neighbour.node);
    if (!(cost + neighbour.length < known)) return;
    const Point to = tree_.position(neighbour.node);
    if (!growth_.space().segment_free(p, to)) return;
    const double edge = edge_cost_(p, to, neighbour.length);
    if (cost + edge < known) tree_.rewire(neighbour.node, node, edge);
  }

  TreeGrowth<S, O>& growth_;
  NeighbourRule rule_;
  const CostOf& edge_cost_;
  RewiredTreeScratch& scratch_;
  SearchTree& tree_;
  Node goal_ = SearchTree::none;
  double best_ = infinity;
};

/// The options of a search with a RewiredTree; see RrtStar.
template <class T>
concept RewiredTreeOptions = TreeOptions<T> && requires(const T& options) {
  { options.goal_bias } -> std::same_as<const double&>;
  { options.neighbours } -> std::same_as<const Neighbours&>;
  { options.rewire_factor } -> std::same_as<const double&>;
};

/// Draws a point in the bounds for a tree that has a path.
template <class F, class... Arguments>
concept Sampler = requires(const F& sample, Arguments&... arguments) {
  { sample(arguments...) } -> std::same_as<Point>;
};

/// Grows a tree towards `options.max_iterations` samples and returns its best path, also if the
/// budget ends before that. Samples are uniform with `options.goal_bias` until there is a path;
/// after that they are `sample(cost of the best path)`.
template <RewiredTreeOptions Options, EdgeCost CostOf, FreeSpace S, Observer O,
          Sampler<double> Sample>
Expected<Route, Failure> grow(RewiredTree<CostOf, S, O>& tree, TreeGrowth<S, O>& growth,
                              const Options& options, const Sample& sample) {
  Failure end{.code = PlanError::budget_exhausted};
  for (std::uint32_t i = 0; i < options.max_iterations; ++i) {
    if (auto next = growth.next_iteration(); !next) {
      end = std::move(next.error());
      break;
    }
    tree.grow(tree.has_path() ? sample(tree.cost()) : growth.sample(options.goal_bias));
  }
  if (!tree.has_path() || end.code == PlanError::cancelled) {
    return Unexpected{growth.failure(std::move(end), tree.nodes())};
  }
  Route route;
  route.curve = Curve::polyline(tree.path());
  route.cost = tree.cost();
  route.stats = growth.stats();
  return route;
}

/// Checks the options of a search with a RewiredTree, then the query.
template <RewiredTreeOptions Options, FreeSpace S>
Expected<void, Failure> check_optimal_growth(const Options& options, const S& space,
                                             const Query& query) {
  const NeighbourRule rule{options.neighbours, options.rewire_factor};
  if (auto valid = rule.check(); !valid) return valid;
  return check_growth(options, space, query);
}

/// RRT* with a sampler: once there is a path, samples are `sample(growth, cost of the best path)`.
template <RewiredTreeOptions Options, FreeSpace S, Observer O,
          Sampler<TreeGrowth<S, O>, double> Sample>
Expected<Route, Failure> search_with_rewired_tree(const Options& options, const S& space,
                                                  const Query& query, RewiredTreeScratch& scratch,
                                                  O& observer, const Sample& sample) {
  if (auto valid = check_optimal_growth(options, space, query); !valid) {
    return std::move(valid).unexpected();
  }
  TreeGrowth growth(space, query, options.step, observer);
  const LengthCost length;
  RewiredTree tree(growth, {options.neighbours, options.rewire_factor}, length, scratch);
  if (auto straight = straight_route(space, query)) return std::move(*straight);
  return grow(tree, growth, options, [&](double cost) { return sample(growth, cost); });
}

}  // namespace tutavia::detail
