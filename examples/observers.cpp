// SPDX-License-Identifier: MIT
// Observers: the events of a running search.

#include <iostream>
#include <tutavia/tutavia.hpp>

using namespace tutavia;

/// Models Observer, RectangleObserver and AnytimeObserver. A search calls the members that it
/// supports.
struct Counter {
  int nodes = 0, rectangles = 0, from_goal = 0, improvements = 0;

  void expanded(const Point&) { ++nodes; }
  void generated(const Point&) {}
  void on_rectangle(const Segment&, const Box&, SearchSide side) {  // the side may be left out
    ++rectangles;
    if (side == SearchSide::goal) ++from_goal;
  }
  void improved(const Curve&, double) { ++improvements; }
};

int main() {
  const Scene scene = maps::array();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = scene.resolution}).value();
  const Query query{.start = scene.start, .goal = scene.goals[1], .seed = 3};
  const auto show = [&](const auto& search) {
    Counter counter;
    typename std::decay_t<decltype(search)>::Scratch scratch;
    const auto route = search.search(space, query, scratch, counter);
    std::cout << search.name << ": " << counter.nodes << " nodes, " << counter.rectangles
              << " rectangles (" << counter.from_goal << " from the goal), " << counter.improvements
              << " better paths on the way" << (route ? "\n" : ", no path\n");
  };
  show(AStar{});
  show(SbReaStar{});
  show(RrtStar{.max_iterations = 1000});
}
