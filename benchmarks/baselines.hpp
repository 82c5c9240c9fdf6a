// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <boost/graph/astar_search.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>
#include <vector>

#include "tutavia/geometry/point.hpp"
#include "tutavia/grid/occupancy_grid.hpp"

/// \file
/// What a C++ programmer would use without this library: Boost's graph searches, and A* and Theta*
/// as in the textbook. Octile costs in doubles; a diagonal needs both cells beside it.

namespace baseline {

using tutavia::Cell;
using tutavia::Point;

inline Point centre(Cell cell) { return {cell.x + 0.5, cell.y + 0.5}; }

struct Answer {
  double cost = std::numeric_limits<double>::infinity();
  std::vector<Point> path{};  ///< from the goal back to the start [cells]
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
        for (Cell c = goal; c != start; c = labels_[at(c)].parent) answer.path.push_back(centre(c));
        answer.path.push_back(centre(start));
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

/// Theta* on the corners of cells, from centre to centre: std::priority_queue with lazy deletion,
/// and lines of sight that look at one cell after the other.
class TextbookThetaStar {
 public:
  explicit TextbookThetaStar(const tutavia::OccupancyGrid& grid)
      : width_(grid.width()),
        height_(grid.height()),
        free_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)),
        labels_(static_cast<std::size_t>(width_ + 1) * static_cast<std::size_t>(height_ + 1) + 2) {
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) free_[at({x, y})] = grid.is_free(Cell{x, y});
    }
  }

  Answer operator()(Cell start_cell, Cell goal_cell) {
    ++query_;
    Answer answer;
    const Half start{2 * start_cell.x + 1, 2 * start_cell.y + 1};
    const Half goal{2 * goal_cell.x + 1, 2 * goal_cell.y + 1};
    if (sees(start, goal)) {
      answer.cost = length(start, goal);
      answer.path = {point(goal), point(start)};
      return answer;
    }
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    const auto reach = [&](Half node, Half parent, double g) {
      label(node) = {g, parent, query_, false};
      open.push({g + length(node, goal), g, node});
      ++answer.generated;
    };
    const auto relax = [&](Half node, Half next) {
      if (label(next).query == query_ && label(next).closed) return;
      const double known =
          label(next).query == query_ ? label(next).g : std::numeric_limits<double>::infinity();
      const Half parent = label(node).parent;
      if (sees(parent, next)) {
        const double g = label(parent).g + length(parent, next);
        if (g < known) reach(next, parent, g);
      } else {
        const double g = label(node).g + length(node, next);
        if (g < known) reach(next, node, g);
      }
    };
    reach(start, start, 0);
    while (!open.empty()) {
      const Half node = open.top().node;
      open.pop();
      if (label(node).closed) continue;
      label(node).closed = true;
      if (node == goal) {
        answer.cost = label(goal).g;
        for (Half h = goal; !(h == start); h = label(h).parent) answer.path.push_back(point(h));
        answer.path.push_back(point(start));
        break;
      }
      ++answer.expanded;
      const int reach_of = node == start ? 1 : 2;
      for (int dy = -reach_of; dy <= reach_of; dy += reach_of) {
        for (int dx = -reach_of; dx <= reach_of; dx += reach_of) {
          const Half next{node.x + dx, node.y + dy};
          if (next == node || next.x % 2 != 0 || next.y % 2 != 0) continue;
          if (next.x < 0 || next.y < 0 || next.x > 2 * width_ || next.y > 2 * height_) continue;
          if (!is_double(next) && sees(node, next)) relax(node, next);
        }
      }
      if (std::abs(goal.x - node.x) == 1 && std::abs(goal.y - node.y) == 1) relax(node, goal);
    }
    return answer;
  }

 private:
  /// Coordinates in half cells: corners are even, centres odd.
  struct Half {
    int x = 0, y = 0;
    bool operator==(const Half&) const = default;
  };
  struct Label {
    double g = 0;
    Half parent{};
    std::uint32_t query = 0;
    bool closed = false;
  };
  struct Entry {
    double f, g;
    Half node;
    bool operator>(const Entry& other) const { return f != other.f ? f > other.f : g < other.g; }
  };

  std::size_t at(Cell c) const {
    return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(c.x);
  }
  bool is_free(int x, int y) const {
    return x >= 0 && x < width_ && y >= 0 && y < height_ && free_[at({x, y})] != 0;
  }
  /// Of a corner, or (in the last two places) of the start and the goal.
  Label& label(Half h) {
    if (h.x % 2 == 0) {
      return labels_[static_cast<std::size_t>(h.y / 2) * static_cast<std::size_t>(width_ + 1) +
                     static_cast<std::size_t>(h.x / 2)];
    }
    Label& first = labels_[labels_.size() - 2];
    if (first.query != query_ || first.parent == h) return first;
    return labels_.back();
  }
  static Point point(Half h) { return {h.x / 2.0, h.y / 2.0}; }
  static double length(Half a, Half b) { return std::hypot(a.x - b.x, a.y - b.y) / 2; }

  bool is_double(Half corner) const {
    const int x = corner.x / 2, y = corner.y / 2;
    const bool ne = is_free(x, y), nw = is_free(x - 1, y), sw = is_free(x - 1, y - 1),
               se = is_free(x, y - 1);
    return ne == sw && nw == se && ne != nw;
  }

  bool sees(Half a, Half b) const {
    if (a.x > b.x) std::swap(a, b);
    const int dx = b.x - a.x, dy = b.y - a.y;
    if (dx == 0 || dy == 0) return sees_along(a, b);
    for (int column = a.x / 2; 2 * column < b.x; ++column) {
      // Where it enters and leaves the column, in half cells times dx.
      const auto height = [&](int x) {
        return std::int64_t{a.y} * dx + std::int64_t{dy} * (x - a.x);
      };
      const std::int64_t in = height(std::max(a.x, 2 * column));
      const std::int64_t out = height(std::min(b.x, 2 * column + 2));
      const std::int64_t low = std::min(in, out) / (2 * dx);
      const std::int64_t high = (std::max(in, out) + 2 * dx - 1) / (2 * dx);
      for (std::int64_t row = low; row < high; ++row) {
        if (!is_free(column, static_cast<int>(row))) return false;
      }
      if (2 * column > a.x && in % (2 * dx) == 0 &&
          is_double({2 * column, static_cast<int>(in / dx)})) {
        return false;
      }
    }
    return true;
  }
  /// The same along a row or a column, or between two.
  bool sees_along(Half a, Half b) const {
    const bool level = a.y == b.y;
    if (!level && a.y > b.y) std::swap(a, b);
    const int line = level ? a.y : a.x, from = level ? a.x : a.y, to = level ? b.x : b.y;
    const auto free_at = [&](int along, int across) {
      return level ? is_free(along, across) : is_free(across, along);
    };
    for (int i = from / 2; 2 * i < to; ++i) {
      const bool here = free_at(i, line / 2);
      if (line % 2 != 0 ? !here : !here && !free_at(i, line / 2 - 1)) return false;
      if (line % 2 == 0 && 2 * i > from &&
          is_double(level ? Half{2 * i, line} : Half{line, 2 * i})) {
        return false;
      }
    }
    return true;
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
        weights.push_back({tutavia::detail::is_diagonal(step) ? std::numbers::sqrt2 : 1.0});
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
      for (std::size_t v = target; v != source; v = parent_[v])
        answer.path.push_back(centre(cells_[v]));
      answer.path.push_back(centre(start));
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
