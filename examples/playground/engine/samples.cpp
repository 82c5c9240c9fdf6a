// SPDX-License-Identifier: MIT
#include "samples.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include "tutavia/geometry/segment.hpp"
#include "tutavia/motion/speed_profile.hpp"

namespace playground {

namespace {

/// The arc lengths at which a piece is sampled: `count` on the whole curve.
std::size_t steps_of(const Curve& curve, std::size_t piece, std::size_t count) {
  const double length = curve.length_before(piece + 1) - curve.length_before(piece);
  const double share = curve.length() > 0 ? length / curve.length() : 0;
  const std::size_t least = curve.pieces()[piece].holds<Segment>() ? 1 : 8;
  return std::max(least, static_cast<std::size_t>(std::ceil(share * static_cast<double>(count))));
}

/// Where a robot faces that moves in a direction [rad].
double facing(double direction, bool is_reverse) {
  if (!is_reverse) return direction;
  return direction > 0 ? direction - std::numbers::pi : direction + std::numbers::pi;
}

}  // namespace

nlohmann::ordered_json sampled(const plan_program::PlanningSpace& space, const Curve& curve,
                               std::span<const Gear> gears, std::size_t count) {
  std::vector<double> x, y, heading, along, curvature, clearance;
  std::vector<int> gear;
  std::vector<std::size_t> first_of_piece;
  const auto add = [&](double s, std::size_t piece) {
    const CurvePoint at = curve.at(s);
    x.push_back(at.position.x());
    y.push_back(at.position.y());
    heading.push_back(facing(at.heading, !gears.empty() && gears[piece] == Gear::reverse));
    along.push_back(s);
    curvature.push_back(at.curvature);
    clearance.push_back(
        std::visit([&](const auto& any) { return any.clearance(at.position); }, space));
    if (!gears.empty()) gear.push_back(gears[piece] == Gear::forward ? 1 : -1);
  };
  for (std::size_t piece = 0; piece < curve.pieces().size(); ++piece) {
    first_of_piece.push_back(x.size());
    const double from = curve.length_before(piece), to = curve.length_before(piece + 1);
    const std::size_t steps = steps_of(curve, piece, count);
    for (std::size_t i = 0; i < steps; ++i) {
      add(from + (to - from) * static_cast<double>(i) / static_cast<double>(steps), piece);
    }
  }
  if (!curve.empty()) add(curve.length(), curve.pieces().size() - 1);
  nlohmann::ordered_json json{{"x", x},
                              {"y", y},
                              {"heading", heading},
                              {"s", along},
                              {"curvature", curvature},
                              {"clearance", clearance}};
  if (!gear.empty()) json["gear"] = gear;
  json["pieces"] = first_of_piece;
  return json;
}

nlohmann::ordered_json sampled_motion(const Curve& curve, const SpeedLimits& limits) {
  constexpr int moments = 300;
  const auto profile = SpeedProfile::build(curve, limits);
  if (!profile) return {{"detail", profile.error().detail}};
  std::vector<double> time, along, speed, acceleration;
  const double duration = profile->duration();
  for (int i = 0; i <= moments; ++i) {
    const SpeedProfile::State state = profile->at(duration * i / moments);
    time.push_back(state.time);
    along.push_back(state.s);
    speed.push_back(state.speed);
    acceleration.push_back(state.acceleration);
  }
  return {{"duration", duration},
          {"time", time},
          {"s", along},
          {"speed", speed},
          {"acceleration", acceleration}};
}

nlohmann::ordered_json events_to_json(const SearchRecord& record, std::size_t most,
                                      double cell_size) {
  using Kind = SearchRecord::Event::Kind;
  std::string kinds;
  std::vector<double> coordinates;
  const std::size_t count = std::min(most, record.events.size());
  for (const SearchRecord::Event& event : std::span(record.events).first(count)) {
    const bool is_from_start = event.side == SearchSide::start;
    char letter = 't';
    if (event.kind == Kind::expanded) letter = 'e';
    if (event.kind == Kind::generated) letter = 'g';
    if (event.kind == Kind::interval) letter = is_from_start ? 'i' : 'I';
    if (event.kind == Kind::rectangle) letter = is_from_start ? 'r' : 'R';
    kinds.push_back(letter);
    coordinates.insert(coordinates.end(), {event.a.x(), event.a.y()});
    if (letter != 'e' && letter != 'g') {
      coordinates.insert(coordinates.end(), {event.b.x(), event.b.y()});
    }
  }
  return {{"kinds", kinds},
          {"coordinates", coordinates},
          {"left_out", record.events.size() - count},
          {"cell_size", cell_size}};
}

}  // namespace playground
