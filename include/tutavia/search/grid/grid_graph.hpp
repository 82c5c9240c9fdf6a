// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <utility>
#include <vector>

#include "tutavia/search/grid/best_first.hpp"
#include "tutavia/search/grid/grid_query.hpp"
#include "tutavia/search/grid/search_grid.hpp"
#include "tutavia/search/grid/step_rule.hpp"

/// \file
/// GridGraph: a grid with a query's start and goal linked to it, as a SearchGraph.

namespace tutavia::detail {

/// The costs of steps on a grid: `step_cost(cell, step)` is the cost of a step from a cell, in 1 /
/// `scale` of the usual unit of cost.
template <class P>
concept StepCosts = requires(const P& costs, Cell cell, std::size_t step) {
  { P::scale } -> std::convertible_to<Cost>;
  { costs.step_cost(cell, step) } -> std::same_as<Cost>;
};

/// Steps cost their length.
struct PlainStepCosts {
  static constexpr Cost scale = 1;
  Cost step_cost(Cell, std::size_t step) const { return detail::step_cost(step); }
};

/// The graph of a grid's free cells (node = cell index), plus two nodes for start and goal. Links
/// cost their length.
template <GridSpace S, StepCosts Costs = PlainStepCosts>
class GridGraph {
 public:
  GridGraph(const S& space, const Query& query, const GridQuery& linked, const Costs& costs)
      : space_(space),
        grid_(space.grid().view()),
        cells_(space.grid().index_count()),
        steps_from_(space),
        query_(query),
        linked_(linked),
        costs_(costs) {}

  std::size_t size() const { return cells_ + 2; }
  NodeId source() const { return static_cast<NodeId>(cells_); }
  NodeId target() const { return source() + 1; }

  Point point(NodeId node) const {
    if (node == source()) return query_.start;
    if (node == target()) return query_.goal;
    return space_.frame().point(grid_.cell(node));
  }

  template <class Visit>
  void for_each_successor(NodeId node, Visit visit) const {
    if (node == source()) {
      for (const auto& [cell, cost] : linked_.starts) visit(id(cell), Costs::scale * cost);
      return;
    }
    const Cell cell = grid_.cell(node);
    for (unsigned left = steps_from_(node); left != 0; left &= left - 1) {
      const auto step = static_cast<std::size_t>(std::countr_zero(left));
      visit(id(cell + steps[step]), costs_.step_cost(cell, step));
    }
    if (const auto cost = linked_.exit_cost(cell)) visit(target(), Costs::scale * *cost);
  }

  Cell cell(NodeId node) const { return grid_.cell(node); }
  double in_metres(Cost cost) const {
    return tutavia::detail::in_metres(cost, space_.frame().resolution,
                                      Costs::scale * straight_cost);
  }

 private:
  NodeId id(Cell cell) const { return static_cast<NodeId>(grid_.index(cell)); }

  const S& space_;
  OccupancyGrid::View grid_;
  std::size_t cells_;
  StepRule steps_from_;
  const Query& query_;
  const GridQuery& linked_;
  const Costs& costs_;
};

/// Memory of searches on a GridGraph.
struct GridGraphScratch {
  BestFirstScratch best_first;
  std::vector<Cell> cells;
};

/// A graph of a grid's cells, with two more nodes at its end for start and goal. `cell(node)` is
/// the cell of any other node, `in_metres(cost)` a cost in metres.
template <class G>
concept CellGraph = SearchGraph<G> && requires(const G& graph, NodeId node, Cost cost) {
  { graph.cell(node) } -> std::same_as<Cell>;
  { graph.in_metres(cost) } -> std::same_as<double>;
};

/// Best-first search on a graph of cells. `estimate(cell)` estimates the cost from a cell to the
/// goal.
template <CellGraph Graph, std::invocable<Cell> Estimate, GridSpace S, Observer O,
          Tracking T = Untracked>
Expected<GridPath, Failure> search_cells(const Graph& graph, const Estimate& estimate,
                                         GridGraphScratch& scratch, SearchContext<S, O>& context,
                                         const T& tracking = {}) {
  const auto heuristic = [&](NodeId node) -> Cost {
    return node >= graph.source() ? 0 : estimate(graph.cell(node));
  };
  auto found = best_first(graph, heuristic, scratch.best_first, context, tracking);
  if (!found) return std::move(found).unexpected();
  const BestFirstScratch& labels = scratch.best_first;
  scratch.cells.clear();
  for (NodeId node = labels.find(graph.target())->parent; node != graph.source();
       node = labels.find(node)->parent) {
    append_cell(scratch.cells, graph.cell(node));
  }
  return GridPath{scratch.cells, graph.in_metres(labels.find(graph.target())->g)};
}

/// Best-first search on a GridGraph; see `graph_search`.
template <StepCosts Costs, std::invocable<const GridQuery&> MakeEstimate, Tracking T>
struct GraphSearch {
  const Costs& costs;
  const MakeEstimate& make_estimate;
  GridGraphScratch& scratch;
  T tracking;
  static constexpr bool takes_any_steps = true;

  template <GridSpace S, Observer O>
  Expected<GridPath, Failure> run(const GridQuery& linked, SearchContext<S, O>& context) const {
    const GridGraph<S, Costs> graph(context.space, context.query, linked, costs);
    return search_cells(graph, make_estimate(linked), scratch, context, tracking);
  }
};

/// Best-first search on a GridGraph. `make_estimate(linked)` returns a function that estimates the
/// cost from a cell to the goal. The route's cost is the path cost in metres. If steps cost their
/// length, the straight segment is tried first.
template <GridSpace S, StepCosts Costs, std::invocable<const GridQuery&> MakeEstimate, Observer O,
          Tracking T = Untracked>
Expected<Route, Failure> graph_search(const S& space, const Query& query, GridGraphScratch& scratch,
                                      O& observer, const Costs& costs,
                                      const MakeEstimate& make_estimate, const T& tracking = {}) {
  return search_grid(space, query, observer,
                     GraphSearch<Costs, MakeEstimate, T>{costs, make_estimate, scratch, tracking},
                     Costs::scale == 1 ? StraightSegment::tried_first : StraightSegment::ignored);
}

}  // namespace tutavia::detail
