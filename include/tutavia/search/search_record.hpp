// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/search/concepts.hpp"

/// \file
/// SearchRecord: an observer that records the events of a search.

namespace tutavia {

/// The events of a search, in order; for pictures and traces.
///
/// Example: examples/09_observer.cpp.
struct SearchRecord {
  /// One event of a search.
  struct Event {
    enum class Kind : std::uint8_t {
      expanded,   ///< a node, at `a`
      generated,  ///< a node, at `a`
      interval,   ///< the cells from `a` to `b`, from which the next rectangle grows
      rectangle,  ///< of free cells, from the lower corner `a` to the upper corner `b`
      edge,       ///< of a tree, from `a` to `b`
    };
    Kind kind;
    Point a, b;
    SearchSide side = SearchSide::start;  ///< of an interval or a rectangle
  };

  bool keeps_nodes = true;  ///< whether single nodes, which may be many, are recorded
  std::vector<Event> events{};
  /// The best path that a random tree found, before redundant nodes are removed; empty without one.
  Curve tree_path{};

  void expanded(const Point& p) { add_node(Event::Kind::expanded, p); }
  void generated(const Point& p) { add_node(Event::Kind::generated, p); }
  void on_rectangle(const Segment& interval, const Box& rectangle,
                    SearchSide side = SearchSide::start) {
    events.push_back({Event::Kind::interval, interval.a, interval.b, side});
    events.push_back({Event::Kind::rectangle, rectangle.min, rectangle.max, side});
  }
  void improved(const Curve& path, double) { tree_path = path; }
  void edge(const Point& a, const Point& b) { events.push_back({Event::Kind::edge, a, b}); }

 private:
  void add_node(Event::Kind kind, const Point& p) {
    if (keeps_nodes) events.push_back({kind, p, p});
  }
};

}  // namespace tutavia
