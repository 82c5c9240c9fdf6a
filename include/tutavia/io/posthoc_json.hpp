// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <variant>

#include "tutavia/geometry/curve.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/search_record.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// posthoc_trace: the events of a search for the visualiser Posthoc.

namespace tutavia {

/// Options of a trace for Posthoc.
struct PosthocOptions {
  double cell_size = 0.1;            ///< how large a node is drawn [m]
  std::size_t max_events = 200'000;  ///< later events are left out; the trace says how many
  bool y_down = false;               ///< y grows downwards, as on Posthoc's canvas
};

namespace detail {

using PosthocJson = nlohmann::ordered_json;

/// Writes the events of a trace: metres, with y downwards.
class PosthocTrace {
 public:
  explicit PosthocTrace(const PosthocOptions& options) : options_(options) {}

  PosthocJson events = PosthocJson::array();

  void obstacle(const Obstacle& obstacle) {
    if (const Disc* disc = std::get_if<Disc>(&obstacle)) {
      PosthocJson event = at("obstacle_disc", disc->center);
      event["radius"] = disc->radius;
      events.push_back(std::move(event));
      return;
    }
    const Polygon& polygon = std::get<Polygon>(obstacle);
    events.push_back({{"type", "obstacle"}, {"points", points(polygon.outer)}});
    for (const Ring& hole : polygon.holes) {
      events.push_back({{"type", "hole"}, {"points", points(hole)}});
    }
  }
  void node(const char* type, const Point& p) { events.push_back(at(type, p)); }
  void search_event(const SearchRecord::Event& event) {
    using Kind = SearchRecord::Event::Kind;
    switch (event.kind) {
      case Kind::expanded:
        return node("expanding", event.a);
      case Kind::generated:
        return node("generating", event.a);
      case Kind::rectangle: {
        const Ring corners{
            event.a, {event.b.x(), event.a.y()}, event.b, {event.a.x(), event.b.y()}};
        events.push_back({{"type", "rectangle"}, {"points", points(corners)}});
        return;
      }
      case Kind::interval:
        events.push_back({{"type", "interval"}, {"points", points({event.a, event.b})}});
        return;
      case Kind::edge:
        events.push_back({{"type", "edge"}, {"points", points({event.a, event.b})}});
        return;
    }
  }
  void path(const char* type, const Curve& curve) {
    if (curve.empty()) return;
    Ring along;
    for (const CurvePoint& p : curve.sample(std::max(curve.length() / 500, options_.cell_size))) {
      along.push_back(p.position);
    }
    events.push_back({{"type", type}, {"points", points(along)}});
  }

  /// How Posthoc draws the events: by type.
  PosthocJson views() const {
    const double side = options_.cell_size;
    const auto shape = [](const char* kind, const char* type, const char* colour) {
      return PosthocJson{{"$", kind},
                         {"$if", std::string("${{ $.type == '") + type + "' }}"},
                         {"fill", std::string("${{ color.") + colour + " }}"},
                         {"clear", false}};
    };
    const auto square = [&](const char* type, const char* colour) {
      PosthocJson view = shape("rect", type, colour);
      const std::string half = PosthocJson(side / 2).dump();
      view["x"] = "${{ $.x - " + half + " }}";
      view["y"] = "${{ $.y - " + half + " }}";
      view["width"] = view["height"] = side;
      return view;
    };
    const auto outline = [&](const char* kind, const char* type, const char* colour) {
      PosthocJson view = shape(kind, type, colour);
      view["points"] = "${{ $.points }}";
      if (kind == std::string("path")) view["line-width"] = side / 4;
      return view;
    };
    PosthocJson disc = shape("circle", "obstacle_disc", "grey");
    disc["x"] = "${{ $.x }}";
    disc["y"] = "${{ $.y }}";
    disc["radius"] = "${{ $.radius }}";
    PosthocJson rectangle = outline("polygon", "rectangle", "amber");
    rectangle["alpha"] = 0.3;
    return {
        {"main",
         {outline("polygon", "obstacle", "grey"), disc, square("generating", "lime"),
          square("expanding", "cyan"), rectangle, outline("path", "interval", "amber"),
          outline("path", "edge", "teal"), square("source", "green"), square("destination", "red"),
          outline("path", "route", "grey"), outline("path", "curve", "blue")}}};
  }

 private:
  PosthocJson point(const Point& p) const {
    return {{"x", p.x()}, {"y", options_.y_down ? p.y() : -p.y()}};
  }
  PosthocJson at(const char* type, const Point& p) const {
    PosthocJson event{{"type", type}, {"id", std::to_string(p.x()) + "," + std::to_string(p.y())}};
    event.update(point(p));
    return event;
  }
  PosthocJson points(const Ring& ring) const {
    PosthocJson result = PosthocJson::array();
    for (const Point& p : ring) result.push_back(point(p));
    return result;
  }

  const PosthocOptions& options_;
};

}  // namespace detail

/// A search trace in Posthoc's format 1.4.0 (posthoc.pathfinding.ai): the obstacles, start and
/// goal, every event of the search in order, its route and the proved curve. Coordinates are
/// metres, with y downwards. Holes of polygons are events, but not drawn. `plan`: none if there is
/// no path.
inline nlohmann::ordered_json posthoc_trace(const Workspace& workspace, const Point& start,
                                            const Point& goal, const SearchRecord& record,
                                            const Plan* plan, const PosthocOptions& options = {}) {
  detail::PosthocTrace trace(options);
  for (const Obstacle& obstacle : workspace.obstacles) trace.obstacle(obstacle);
  trace.node("source", start);
  trace.node("destination", goal);
  const std::size_t count = std::min(record.events.size(), options.max_events);
  for (std::size_t i = 0; i < count; ++i) trace.search_event(record.events[i]);
  if (count < record.events.size()) {
    trace.events.push_back({{"type", "cut"}, {"left_out", record.events.size() - count}});
  }
  if (plan != nullptr) {
    trace.path("route", plan->route.curve);
    trace.path("curve", plan->curve);
  }
  return {{"version", "1.4.0"}, {"views", trace.views()}, {"events", std::move(trace.events)}};
}

}  // namespace tutavia
