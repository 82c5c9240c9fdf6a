// SPDX-License-Identifier: MIT
#pragma once

#include <boost/graph/astar_search.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>
#include <vector>

#include "tutavia/grid/occupancy_grid.hpp"

/// \file
/// What a C++ programmer would use without this library: Boost's graph searches and an A* as in the
/// textbook. Octile costs in doubles; a diagonal needs both cells beside it.

namespace baseline {

using tutavia::Cell;

struct Answer {
  double cost = std::numeric_limits<double>::infinity();
  std::vector<Cell> path{};
  std::uint64_t expanded = 0;
  std::uint64_t generated = 0;
};

inline double octile(Cell a, Cell b) {
  const double dx = std::abs(a.x - b.x), dy = std::abs(a.y - b.y);
  return std::fmax(dx, dy) + (std::numbers::sqrt2 - 1) * std::fmin(dx, dy);
}

/// A* with std::priority_queue and lazy deletion over a byte map. Labels carry the number of their
/// query, so that nothing is cleared in between.
class TextbookAStar {
 public:
  explicit TextbookAStar(const tutavia::OccupancyGrid& grid)
      : width_(grid.width()), height_(grid.height()), free_(size()), labels_(size()) {
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) free_[at({x, y})] = grid.is_free(Cell{x, y});
    }
  }

  Answer operator()(Cell start, Cell goal) {
    ++query_;
    Answer answer;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    const auto reach = [&](Cell cell, Cell parent, double g) {
      Label& label = labels_[at(cell)];
      if (label.query == query_ && label.g <= g) return;
      label = {g, parent, query_};
      open.push({g + octile(cell, goal), g, cell});
      ++answer.generated;
    };
    reach(start, start, 0);
    while (!open.empty()) {
      const Entry top = open.top();
      open.pop();
      if (top.g > labels_[at(top.cell)].g) continue;
      if (top.cell == goal) {
        answer.cost = top.g;
        for (Cell c = goal; c != start; c = labels_[at(c)].parent) answer.path.push_back(c);
        answer.path.push_back(start);
        break;
      }
      ++answer.expanded;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const Cell next = top.cell + Cell{dx, dy};
          if ((dx == 0 && dy == 0) || !is_free(next)) continue;
          if (dx != 0 && dy != 0) {
            if (!is_free({next.x, top.cell.y}) || !is_free({top.cell.x, next.y})) continue;
          }
          reach(next, top.cell, top.g + (dx != 0 && dy != 0 ? std::numbers::sqrt2 : 1.0));
        }
      }
    }
    return answer;
  }

 private:
  struct Label {
    double g = 0;
    Cell parent{};
    std::uint32_t query = 0;
  };
  struct Entry {
    double f, g;
    Cell cell;
    bool operator>(const Entry& other) const { return f != other.f ? f > other.f : g < other.g; }
  };

  std::size_t size() const {
    return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  }
  std::size_t at(Cell c) const {
    return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(c.x);
  }
  bool is_free(Cell c) const {
    return c.x >= 0 && c.x < width_ && c.y >= 0 && c.y < height_ && free_[at(c)] != 0;
  }

  int width_, height_;
  std::vector<std::uint8_t> free_;
  std::vector<Label> labels_;
  std::uint32_t query_ = 0;
};

/// boost::astar_search and boost::dijkstra_shortest_paths on a compressed sparse row graph.
class BoostSearch {
 public:
  /// `stop_at_goal`: false searches the whole map, by Dijkstra's algorithm.
  BoostSearch(const tutavia::OccupancyGrid& grid, bool use_heuristic, bool stop_at_goal = true)
      : use_heuristic_(use_heuristic),
        stop_at_goal_(stop_at_goal),
        grid_(grid),
        vertex_(grid.index_count(), 0) {
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        if (!grid.is_free(Cell{x, y})) continue;
        vertex_[grid.index({x, y})] = cells_.size();
        cells_.push_back({x, y});
      }
    }
    std::vector<std::pair<std::size_t, std::size_t>> edges;
    std::vector<Edge> weights;
    for (std::size_t v = 0; v < cells_.size(); ++v) {
      for (std::size_t step = 0; step < tutavia::steps.size(); ++step) {
        if (!grid.can_step(cells_[v], step, tutavia::MovementRule::no_cut)) continue;
        edges.emplace_back(v, vertex_[grid.index(cells_[v] + tutavia::steps[step])]);
        weights.push_back({tutavia::is_diagonal(step) ? std::numbers::sqrt2 : 1.0});
      }
    }
    graph_ =
        Graph(boost::edges_are_sorted, edges.begin(), edges.end(), weights.begin(), cells_.size());
    parent_.resize(cells_.size());
    distance_.resize(cells_.size());
    rank_.resize(cells_.size());
    color_.resize(cells_.size());
  }

  Answer operator()(Cell start, Cell goal) {
    Answer answer;
    const std::size_t source = vertex_[grid_.index(start)], target = vertex_[grid_.index(goal)];
    const auto index = boost::get(boost::vertex_index, graph_);
    const auto map = [&](auto& values) {
      return boost::make_iterator_property_map(values.begin(), index);
    };
    try {
      if (use_heuristic_) {
        boost::astar_search(graph_, source, Octile{cells_, goal},
                            boost::predecessor_map(map(parent_))
                                .distance_map(map(distance_))
                                .rank_map(map(rank_))
                                .color_map(map(color_))
                                .weight_map(boost::get(&Edge::weight, graph_))
                                .visitor(Stop<boost::default_astar_visitor>{{}, target, &answer}));
      } else {
        boost::dijkstra_shortest_paths(
            graph_, source,
            boost::predecessor_map(map(parent_))
                .distance_map(map(distance_))
                .color_map(map(color_))
                .weight_map(boost::get(&Edge::weight, graph_))
                .visitor(Stop<boost::default_dijkstra_visitor>{
                    {}, stop_at_goal_ ? target : cells_.size(), &answer}));
        if (!stop_at_goal_ && parent_[target] != target) throw Found{};
      }
    } catch (const Found&) {
      answer.cost = distance_[target];
      for (std::size_t v = target; v != source; v = parent_[v]) answer.path.push_back(cells_[v]);
      answer.path.push_back(start);
    }
    return answer;
  }

 private:
  struct Edge {
    double weight;
  };
  struct Found {};
  using Graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, Edge>;

  struct Octile : boost::astar_heuristic<Graph, double> {
    Octile(const std::vector<Cell>& cells, Cell goal) : cells_(&cells), goal_(goal) {}
    double operator()(std::size_t v) const { return octile((*cells_)[v], goal_); }
    const std::vector<Cell>* cells_;
    Cell goal_;
  };
  template <class Base>
  struct Stop : Base {
    Stop(Base base, std::size_t target_vertex, Answer* counts)
        : Base(base), target(target_vertex), answer(counts) {}
    template <class G>
    void examine_vertex(std::size_t v, const G&) {
      if (v == target) throw Found{};
      ++answer->expanded;
    }
    template <class E, class G>
    void edge_relaxed(const E&, const G&) {
      ++answer->generated;
    }
    std::size_t target;
    Answer* answer;
  };

  bool use_heuristic_;
  bool stop_at_goal_;
  const tutavia::OccupancyGrid& grid_;
  std::vector<std::size_t> vertex_;
  std::vector<Cell> cells_;
  Graph graph_;
  std::vector<std::size_t> parent_;
  std::vector<double> distance_, rank_;
  std::vector<boost::default_color_type> color_;
};

}  // namespace baseline
