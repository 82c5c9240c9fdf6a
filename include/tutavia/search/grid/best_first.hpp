// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "tutavia/grid/movement.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/grid/open_heap.hpp"
#include "tutavia/search/grid/search_context.hpp"
#include "tutavia/search/grid/stamped_labels.hpp"
#include "tutavia/search/query_checks.hpp"

/// \file
/// best_first: best-first search on a graph, for A* and its variants.

namespace tutavia::detail {

using NodeId = std::uint32_t;

/// A graph to search, with nodes 0 ... size() - 1, among them `source()` and `target()`.
/// `for_each_successor(node, visit)` calls `visit(successor, cost)` with costs >= 0. `point(node)`
/// is the node's position, for observers.
template <class G>
concept SearchGraph = requires(const G& g, NodeId n, void (*visit)(NodeId, Cost)) {
  { g.size() } -> std::convertible_to<std::size_t>;
  { g.source() } -> std::same_as<NodeId>;
  { g.target() } -> std::same_as<NodeId>;
  { g.point(n) } -> std::convertible_to<Point>;
  g.for_each_successor(n, visit);
};

/// Labels and open list of a best-first search, kept from one query to the next. A label carries
/// the number of the query that wrote it. So nothing is cleared between queries, and nothing is
/// allocated once the memory is large enough.
class BestFirstScratch {
 public:
  struct Label {
    Cost g = 0;
    NodeId parent = 0;
    std::uint32_t query = 0;
  };

  /// An entry of the open list, ordered by smaller f, then larger g (nearer to the goal), then
  /// insertion. The order never depends on the heap.
  struct Entry {
    Cost f;
    Cost g;
    std::uint64_t sequence;
    NodeId node;

    friend bool operator<(const Entry& a, const Entry& b) {  // worse < better
      if (a.f != b.f) return a.f > b.f;
      if (a.g != b.g) return a.g < b.g;
      return a.sequence > b.sequence;
    }
  };

  /// Starts to track which nodes are expanded.
  void reset_expanded(std::size_t size) { expanded_.reset(size); }
  bool is_expanded(NodeId node) const { return expanded_.find(node) != nullptr; }
  /// Marks a node as expanded; returns whether it is for the first time.
  bool mark_expanded(NodeId node) {
    const bool first = !is_expanded(node);
    expanded_.set(node, {});
    return first;
  }

  /// Memory for the points of the path while it is traced.
  std::vector<Point>& points() { return points_; }

  void reset(std::size_t size) {
    labels_.reset(size);
    open_.clear();
    sequence_ = 0;
  }

  /// The node's label; nullptr if this query has not reached it.
  const Label* find(NodeId node) const { return labels_.find(node); }

  /// Writes the label and pushes the node onto the open list.
  void push(NodeId node, NodeId parent, Cost g, Cost f) {
    labels_.set(node, {g, parent});
    open_.push({f, g, sequence_++, node});
  }

  /// The best entry that is still current; empty if there is none.
  std::optional<Entry> pop() {
    while (!open_.empty()) {
      const Entry entry = open_.pop();
      if (entry.g == labels_[entry.node].g) return entry;  // else a cheaper path was found
    }
    return std::nullopt;
  }

 private:
  struct Mark {
    std::uint32_t query = 0;
  };

  StampedLabels<Label> labels_;
  StampedLabels<Mark> expanded_;  // without memory in searches that do not track it
  OpenHeap<Entry> open_;
  std::vector<Point> points_;
  std::uint64_t sequence_ = 0;
};

/// What happens when a cheaper path to an expanded node is found.
enum class Reopening {
  allowed,  ///< the node is expanded again
  never,    ///< the path is ignored
};

/// Does not track which nodes are expanded: nodes are re-opened, and the search is a little faster.
struct Untracked {};
/// Tracks which nodes are expanded and counts them.
struct Tracked {
  Reopening reopening = Reopening::allowed;
};

template <class T>
concept Tracking = std::same_as<T, Untracked> || std::same_as<T, Tracked>;

/// Searches from the source to the target in the order of least g + heuristic(node). Stops when the
/// target is popped. If nodes are re-opened when a cheaper path to them is found, an admissible
/// heuristic gives a cheapest path even if it is not consistent. The labels' parents hold the path.
/// Errors: `unreachable` if the open list runs empty; those of the budget.
///
/// Source: Hart, Nilsson and Raphael 1968, "A formal basis for the heuristic determination of
/// minimum cost paths"; with heuristic 0: Dijkstra 1959.
template <SearchGraph Graph, std::invocable<NodeId> Heuristic, FreeSpace S, Observer O,
          Tracking T = Untracked>
Expected<void, Failure> best_first(const Graph& graph, const Heuristic& heuristic,
                                   BestFirstScratch& scratch, SearchContext<S, O>& context,
                                   [[maybe_unused]] const T& tracking = {}) {
  constexpr bool is_tracked = std::same_as<T, Tracked>;
  scratch.reset(graph.size());
  if constexpr (is_tracked) {
    scratch.reset_expanded(graph.size());
    context.statistics.distinct = 0;
  }
  const auto relax = [&](NodeId node, NodeId parent, Cost g) {
    const auto* label = scratch.find(node);
    if (label != nullptr && label->g <= g) return;
    if constexpr (is_tracked) {
      if (tracking.reopening == Reopening::never && scratch.is_expanded(node)) return;
    }
    scratch.push(node, parent, g, g + heuristic(node));
    context.count_generated(Point(graph.point(node)));
  };
  relax(graph.source(), graph.source(), 0);
  while (const auto entry = scratch.pop()) {
    if (entry->node == graph.target()) return {};
    if (auto within = context.check_budget(); !within) return within;
    context.count_expanded(Point(graph.point(entry->node)));
    if constexpr (is_tracked) {
      *context.statistics.distinct += scratch.mark_expanded(entry->node) ? 1 : 0;
    }
    graph.for_each_successor(entry->node, [&](NodeId successor, Cost cost) {
      relax(successor, entry->node, entry->g + cost);
    });
  }
  return fail(PlanError::unreachable);
}

}  // namespace tutavia::detail
