// SPDX-License-Identifier: MIT
// Observers receive the events of a running search: one of your own counts them, and SearchRecord
// keeps all for a trace, a picture, and an animated picture. Needs the target tutavia::json.

#include <fstream>
#include <iostream>
#include <string>
#include <tutavia/io/trace_json.hpp>
#include <tutavia/tutavia.hpp>

/// Models Observer, RectangleObserver and AnytimeObserver. A search calls the members that it
/// supports.
struct Counter {
  int nodes = 0, rectangles = 0, from_goal = 0, improvements = 0;

  void expanded(const tutavia::Point&) { ++nodes; }
  void generated(const tutavia::Point&) {}
  void on_rectangle(const tutavia::Segment&, const tutavia::Box&, tutavia::SearchSide side) {
    ++rectangles;
    if (side == tutavia::SearchSide::goal) ++from_goal;  // the side may be left out
  }
  void improved(const tutavia::Curve&, double) { ++improvements; }
};

int main() {
  using namespace tutavia;
  const Scene scene = maps::array();
  const auto space = LatticeSpace::build(scene.workspace, {.resolution = scene.resolution}).value();
  const Query query{.start = scene.start, .goal = scene.goals[1], .seed = 3};
  const auto count = [&](const auto& search) {
    Counter counter;
    const auto plan = Planner{search}.plan(space, query, counter);
    std::cout << search.name << ": " << counter.nodes << " nodes, " << counter.rectangles
              << " rectangles (" << counter.from_goal << " from the goal), " << counter.improvements
              << (plan ? " better paths\n" : " better paths, no plan\n");
  };
  count(AStar{});
  count(SbReaStar{});
  count(RrtStar{.max_iterations = 1000});

  SearchRecord record;
  const auto plan = Planner{AStar{}, DeltaSmoother{}}.plan(space, query, record);
  if (!plan) return 1;
  const ResultHeader header{.search = "astar",
                            .smoother = "delta",
                            .start = query.start,
                            .goal = query.goal,
                            .safety_radius = space.safety_radius()};
  std::string trace;
  append_trace(trace, header, "success", record);
  SvgOptions options{.title = "array"};
  add_search(options, record);
  const bool is_drawn = write_svg("search.svg", scene.workspace, *plan, options).has_value();
  std::ofstream animated("animated.svg"), lines("trace.jsonl");
  animated << to_animated_svg(scene.workspace, *plan, record);
  lines << trace;
  if (!is_drawn || !animated.flush() || !lines.flush()) return 1;
  std::cout << record.events.size() << " events in trace.jsonl, search.svg and animated.svg\n";
}
