// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/plan/query.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/grid/grid_query.hpp"
#include "tutavia/search/grid/open_heap.hpp"
#include "tutavia/search/query_checks.hpp"
#include "tutavia/search/rectangle/cell_set.hpp"
#include "tutavia/search/rectangle/free_rectangle.hpp"
#include "tutavia/search/rectangle/portal_chain.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// Two waves of free rectangles that meet: the search of SbReaStar and ImprovedReaStar.

namespace tutavia::detail {

/// Cells on the edge of a free rectangle whose neighbours beyond it are free: a way out of it. The
/// next rectangle grows from these cells over the edge, so that the two share them.
struct Passage {
  CellInterval cells;         ///< their side leads out; a root is a single cell
  std::uint32_t parent = 0;   ///< the passage that the rectangle grew from; a root's is itself
  CellRectangle rectangle{};  ///< that grew from this one, if it was expanded
  double g = 0;               ///< what the evaluation keeps
  std::uint32_t costs = 0;    ///< the same
  std::uint64_t asked = 0;    ///< in which expansion it was considered last
};

/// What passages cost to one wave of rectangles. It keeps memory of its own.
///
/// - `begin(goal, offset, grid)`: a query begins; the goal is where the wave goes to
/// - `root(passage, cost)`, `enter(passage, parent)`: the key of a new passage
/// - `place_before(passage, cell)`: where the way to a cell of its rectangle passes it
/// - `meet(passage, other evaluation, other's passage, joint)`: the length and the cell of the best
///   meeting in the cells `joint` of the other's passage, which lie in the rectangle that grew from
///   `passage`
template <class E>
concept PassageEvaluation = std::default_initializable<E> &&
    requires(E& evaluation, const E& other, Passage& passage, const Passage& from,
             const CellInterval& cells, Cell cell, Cost cost, const OccupancyGrid& grid) {
  evaluation.begin(cell, cost, grid);
  { evaluation.root(passage, cost) } -> std::same_as<double>;
  { evaluation.enter(passage, from) } -> std::same_as<double>;
  { evaluation.place_before(from, cell) } -> std::same_as<int>;
  { evaluation.meet(from, other, from, cells) } -> std::same_as<std::pair<double, Cell>>;
};

/// An evaluation that looks at cells from the passage expanded last: `expand(passage)` says that a
/// rectangle grows from it, or is looked at again; `reach(edge)` that its side `edge` is left next.
template <class E>
concept ReachEvaluation = PassageEvaluation<E> &&
    requires(E& evaluation, const Passage& from, const CellInterval& edge) {
  evaluation.expand(from);
  evaluation.reach(edge);
};

/// What a wave of rectangles keeps between queries: memory.
template <PassageEvaluation Evaluation>
struct RectangleWave {
  struct Entry {
    double key;
    std::uint32_t passage;
    friend bool operator<(const Entry& a, const Entry& b) {  // worse < better
      return a.key != b.key ? a.key > b.key : a.passage > b.passage;
    }
  };

  std::vector<Passage> passages;
  std::vector<std::uint32_t> expanded;
  OpenList<Entry> open;
  CellSet marked, covered;             // cells of passages, cells of rectangles
  std::vector<std::uint32_t> markers;  // of the cells that are marked: a passage that holds it
  Evaluation evaluation;
};

template <PassageEvaluation Evaluation>
struct RectangleWavesScratch {
  std::array<RectangleWave<Evaluation>, 2> waves;
  std::vector<CellRun> exits;
  std::vector<Rail> rails;
  std::vector<Cell> cells;
};

/// Rectangles grow from the start and from the goal by turns, in each wave from the passage with
/// the smallest key, until one holds cells of a passage of the other wave (or, if the search is to
/// go on, until no key is below the length of the best such meeting); until then a new passage with
/// cells in a rectangle of the other wave is a meeting, too. A passage whose next cells lie in
/// rectangles of its wave already leads nowhere new and is left out; a wave that comes to its end
/// has therefore seen all it can reach.
template <ColumnSpace S, PassageEvaluation Evaluation, Observer O>
class RectangleWaves {
 public:
  using Wave = RectangleWave<Evaluation>;

  RectangleWaves(const S& space, const Query& query, const LinkedQuery& linked,
                 RectangleWavesScratch<Evaluation>& scratch, O& observer, Statistics& stats)
      : space_(space),
        free_(space),
        query_(query),
        linked_(linked),
        scratch_(scratch),
        observer_(observer),
        stats_(stats) {}

  std::optional<Failure> run(bool continue_after_contact) {
    begin(scratch_.waves[0], linked_);
    begin(scratch_.waves[1], linked_.reversed());
    for (std::size_t turn = 0; continue_after_contact || !met(); turn = 1 - turn) {
      auto next = pop(scratch_.waves[turn]);
      if (!next) {
        if (!met()) return Failure{.code = PlanError::unreachable};
        turn = 1 - turn;
        next = pop(scratch_.waves[turn]);
        if (!next) break;
      }
      if (is_checked(query_.budget, stats_.expanded, 64)) {
        if (auto failure = exceeded(query_.budget, stats_.expanded)) return failure;
      }
      ++stats_.expanded;
      expand(turn, *next);
    }
    return std::nullopt;
  }

  /// The rails of the path that was found, from start to goal, the first and the last a root;
  /// `joint` is the one where the waves met. Nodes where the evaluation has them.
  void follow(std::vector<Rail>& rails, std::size_t& joint) {
    rails.clear();
    Wave &mine = scratch_.waves[best_.turn], &other = scratch_.waves[1 - best_.turn];
    rails.push_back({best_.joint, best_.joint.axis == 0 ? best_.cell.x : best_.cell.y});
    append_way(mine, best_.entry, rails);
    std::reverse(rails.begin(), rails.end());
    joint = rails.size() - 1;
    const Passage& passage = other.passages[best_.passage];
    if (!is_root(other, best_.passage)) append_way(other, passage.parent, rails);
    for (std::size_t i = joint; i < rails.size(); ++i) rails[i].cells.side *= -1;
    if (best_.turn == 0) return;
    std::reverse(rails.begin(), rails.end());
    for (Rail& rail : rails) rail.cells.side *= -1;
    joint = rails.size() - 1 - joint;
  }

 private:
  static constexpr bool looks_from_cells = ReachEvaluation<Evaluation>;

  struct Meeting {
    double length = std::numeric_limits<double>::max();
    Cell cell{};
    CellInterval joint{};
    std::size_t turn = 0;       // the wave whose rectangle it is
    std::uint32_t entry = 0;    // the passage that the rectangle grew from
    std::uint32_t passage = 0;  // of the other wave
  };

  /// Appends the rails from a passage back to its root, on the way from the last node.
  static void append_way(Wave& wave, std::uint32_t from, std::vector<Rail>& rails) {
    while (true) {
      const Passage& passage = wave.passages[from];
      const int place = wave.evaluation.place_before(passage, rails.back().node());
      rails.push_back({passage.cells, place});
      if (is_root(wave, from)) return;
      from = passage.parent;
    }
  }

  bool met() const { return best_.length < std::numeric_limits<double>::max(); }
  Point place(Cell cell) const { return space_.frame().point(cell); }

  void begin(Wave& wave, const LinkedQuery& there) {
    wave.passages.clear();
    wave.expanded.clear();
    wave.open.clear();
    const OccupancyGrid& grid = space_.grid();
    wave.marked.begin(grid);
    wave.covered.begin(grid);
    if (wave.markers.size() < grid.index_count()) wave.markers.resize(grid.index_count());
    wave.evaluation.begin(there.goal_cell, there.goal_offset, grid);
    for (const auto& [cell, cost] : there.starts) {
      Passage root{.cells = {0, cell.y, cell.x, cell.x, 1}, .parent = next(wave)};
      const double key = wave.evaluation.root(root, cost);
      push(wave, root, key);
    }
  }

  static std::uint32_t next(const Wave& wave) {
    return static_cast<std::uint32_t>(wave.passages.size());
  }

  void push(Wave& wave, const Passage& passage, double key) {
    const CellInterval& cells = passage.cells;
    for (int u = cells.first; u <= cells.last; ++u) {
      wave.marked.add(cells.cell(u));
      wave.markers[space_.grid().index(cells.cell(u))] = next(wave);
    }
    wave.open.push({key, next(wave)});
    wave.passages.push_back(passage);
    ++stats_.generated;
    observer_.generated(place(cells.middle()));
  }

  static bool is_root(const Wave& wave, std::uint32_t passage) {
    return wave.passages[passage].parent == passage;
  }

  /// The passage with the smallest key, of those that lead to cells that no rectangle of the wave
  /// holds, if that key is below the length of the best path.
  std::optional<std::uint32_t> pop(Wave& wave) {
    while (!wave.open.empty() && wave.open.top().key < best_.length) {
      const std::uint32_t passage = wave.open.pop().passage;
      const CellInterval& cells = wave.passages[passage].cells;
      if (is_root(wave, passage) || !wave.covered.holds(cells.beyond())) return passage;
    }
    return std::nullopt;
  }

  void expand(std::size_t turn, std::uint32_t from) {
    Wave& wave = scratch_.waves[turn];
    Wave& other = scratch_.waves[1 - turn];
    const CellInterval cells = wave.passages[from].cells;
    const bool had_met = met();
    observer_.expanded(place(cells.middle()));
    const bool root = is_root(wave, from);
    const CellRectangle r = root ? free_.grow_around(cells.cell(cells.first)) : free_.grow(cells);
    tell_of(observer_, space_, cells, r);
    wave.passages[from].rectangle = r;
    wave.expanded.push_back(from);
    wave.covered.add(r);
    if constexpr (looks_from_cells) wave.evaluation.expand(wave.passages[from]);
    other.marked.for_each_in(r, [&](Cell cell) {
      const std::uint32_t passage = other.markers[space_.grid().index(cell)];
      if (std::exchange(other.passages[passage].asked, stats_.expanded) != stats_.expanded) {
        consider(turn, from, passage);
      }
    });
    const std::uint32_t old = next(wave);
    for (const int side : {1, -1}) {
      for (const int axis : {cells.axis, 1 - cells.axis}) {
        const CellInterval edge = r.edge(axis, side);
        const bool entered = !root && axis == cells.axis && side == -cells.side;
        if (!entered) {
          leave(wave, from, edge);
        } else {  // beside the passage that it grew from
          CellInterval left = edge, right = edge;
          left.last = cells.first - 1;
          right.first = cells.last + 1;
          leave(wave, from, left);
          leave(wave, from, right);
        }
      }
    }
    for (std::uint32_t p = old; p < wave.passages.size() && !had_met; ++p) {
      if (!other.covered.meets(wave.passages[p].cells)) continue;
      for (const std::uint32_t entry : other.expanded) {
        const Passage& grown = other.passages[entry];
        if (grown.rectangle.clip(wave.passages[p].cells).run().size() <= 0) continue;
        if constexpr (looks_from_cells) other.evaluation.expand(grown);
        consider(1 - turn, entry, p);
      }
    }
  }

  /// Adds the passages out of a rectangle over an edge of it.
  void leave(Wave& wave, std::uint32_t from, const CellInterval& edge) {
    scratch_.exits.clear();
    const CellInterval beyond = edge.beyond();
    free_.append_free_runs(edge.axis, beyond.line, edge.run(), scratch_.exits);
    if (scratch_.exits.empty()) return;
    CellInterval asked = edge;
    asked.first = scratch_.exits.front().first;
    asked.last = scratch_.exits.back().last;
    bool reached = false;
    for (const auto& [first, last] : scratch_.exits) {
      const CellInterval cells{edge.axis, edge.line, first, last, edge.side};
      if (wave.covered.holds(cells.beyond())) continue;
      if (!std::exchange(reached, true)) {
        if constexpr (looks_from_cells) wave.evaluation.reach(asked);
      }
      Passage passage{.cells = cells, .parent = from};
      const double key = wave.evaluation.enter(passage, wave.passages[from]);
      push(wave, passage, key);
    }
  }

  /// Looks for a better path through the rectangle that grew from a passage of one wave, expanded
  /// last, and a passage of the other wave with cells in it.
  void consider(std::size_t turn, std::uint32_t entry, std::uint32_t passage) {
    Wave& mine = scratch_.waves[turn];
    const Wave& other = scratch_.waves[1 - turn];
    const Passage &from = mine.passages[entry], &to = other.passages[passage];
    const CellInterval joint = from.rectangle.clip(to.cells);
    const auto [length, cell] = mine.evaluation.meet(from, other.evaluation, to, joint);
    if (length < best_.length) best_ = {length, cell, joint, turn, entry, passage};
  }

  const S& space_;
  FreeRectangles free_;
  const Query& query_;
  const LinkedQuery& linked_;
  RectangleWavesScratch<Evaluation>& scratch_;
  O& observer_;
  Statistics& stats_;
  Meeting best_;
};

/// Searches by waves of rectangles; `lay_path(rails, joint, cells)` makes of the rails the cells of
/// the path's corners, from the last to the first.
template <PassageEvaluation Evaluation, ColumnSpace S,
          std::invocable<std::vector<Rail>&, std::size_t, std::vector<Cell>&> LayPath, Observer O>
Expected<Route, Failure> rectangle_waves(const S& space, const Query& query,
                                         RectangleWavesScratch<Evaluation>& scratch, O& observer,
                                         std::string_view name, bool continue_after_contact,
                                         LayPath lay_path) {
  if (auto failure = check_no_cut(space, name)) return Unexpected{std::move(*failure)};
  return search_grid(space, query, scratch.cells,
                     [&](const LinkedQuery& linked, std::vector<Cell>& cells,
                         Statistics& stats) -> std::optional<Failure> {
                       RectangleWaves<S, Evaluation, O> waves(space, query, linked, scratch,
                                                              observer, stats);
                       if (auto failure = waves.run(continue_after_contact)) return failure;
                       std::size_t joint = 0;
                       waves.follow(scratch.rails, joint);
                       lay_path(scratch.rails, joint, cells);
                       return std::nullopt;
                     });
}

}  // namespace tutavia::detail
