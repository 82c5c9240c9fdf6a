// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "tutavia/certify/certify_vehicle.hpp"
#include "tutavia/geometry/dubins.hpp"
#include "tutavia/geometry/reeds_shepp.hpp"
#include "tutavia/search/grid/search_context.hpp"
#include "tutavia/search/vehicle/distance_to_go.hpp"
#include "tutavia/search/vehicle/driving_costs.hpp"
#include "tutavia/search/vehicle/hybrid_states.hpp"

/// \file
/// HybridSearch: A* over the states of a vehicle, at one resolution.

namespace tutavia::detail {

/// Memory of a hybrid A* search.
struct HybridScratch {
  std::vector<HybridState> states;
  std::vector<HybridEntry> open;
  NumberSet closed;
};

/// A* over positions and headings of a vehicle.
///
/// States keep their exact positions. Of the states in one cell with one heading only the cheapest
/// is expanded. A state's move is proved when the state is taken from the open list, so moves that
/// are never taken cost nothing. From time to time the search tries to drive to the goal by a word
/// of Reeds and Shepp, or of Dubins; such a drive enters the open list like a state.
///
/// Source: Dolgov, Thrun, Montemerlo and Diebel 2010, "Path planning for autonomous vehicles in
/// unknown semi-structured environments", sections 2.1 and 2.2.
template <ClearanceSpace S, Observer O>
class HybridSearch {
 public:
  /// The query is that of the context or the same in the other direction.
  HybridSearch(SearchContext<S, O>& context, const Query& query, const Vehicle& vehicle,
               const DrivingCosts& costs, double heuristic_weight, HybridScratch& scratch)
      : context_(context),
        query_(query),
        vehicle_(vehicle),
        radius_(vehicle.min_turning_radius),
        costs_(costs),
        heuristic_weight_(heuristic_weight),
        footprint_(vehicle),
        states_(scratch.states),
        open_(scratch.open),
        closed_(scratch.closed) {}

  /// The cheapest free drive from the start pose to the goal, if both headings are given and it
  /// costs no more than the heuristic's factor times the shortest one. Needs no distances to go.
  std::optional<VehiclePath> drive_directly() {
    if (!query_.start_heading || !query_.goal_heading) return std::nullopt;
    set_resolution(1, 0);
    states_.assign(1, {.position = query_.start});
    open_.clear();
    best_ = {};
    shoot(0);
    const double shortest = length_to_goal(pose(state(0)));
    if (!(best_.cost <= heuristic_weight_ * shortest)) return std::nullopt;
    return path_to_goal();
  }

  /// Searches with `headings` directions and moves of at least `least_move` metres. Empty: there is
  /// no path at this resolution. Errors: those of the budget, unless a path is known.
  Expected<std::optional<VehiclePath>, Failure> run(DistanceToGo<S>& to_go, int headings,
                                                    double least_move) {
    to_go_ = &to_go;
    set_resolution(headings, least_move);
    states_.clear();
    open_.clear();
    closed_.clear();
    best_ = {};
    until_shot_ = 0;
    if (query_.start_heading) {
      add({.position = query_.start});
    } else {
      for (int i = 0; i < headings_; ++i) {
        add({.position = query_.start, .heading = static_cast<std::int16_t>(i)});
      }
    }
    while (!open_.empty()) {
      const HybridEntry entry = pop();
      if (entry.kind == Kind::to_goal) return std::optional(path_to_goal());
      if (auto within = context_.check_budget(16); !within) {
        const bool is_answer = best_.state != HybridState::none && !query_.budget.cancelled();
        if (is_answer) return std::optional(path_to_goal());
        return std::move(within).unexpected();
      }
      take(entry);
    }
    return std::optional<VehiclePath>();
  }

 private:
  using Kind = HybridEntry::Kind;

  /// The cheapest known drive to the goal.
  struct ToGoal {
    std::uint32_t state = HybridState::none;  // from which it starts
    double cost = std::numeric_limits<double>::infinity();
    SteeringWord word{};
    double goal_heading = 0;
    std::size_t order = 0;  // among the drives from that state
  };

  void set_resolution(int headings, double least_move) {
    headings_ = headings;
    const double step = 2 * std::numbers::pi / headings;
    const double first = query_.start_heading.value_or(0);
    angles_.resize(static_cast<std::size_t>(headings));
    directions_.resize(static_cast<std::size_t>(headings));
    for (int i = 0; i < headings; ++i) {
      const double angle = wrapped_angle(first + i * step);
      angles_[static_cast<std::size_t>(i)] = i == 0 ? first : angle;
      directions_[static_cast<std::size_t>(i)] = {std::cos(angle), std::sin(angle)};
    }
    const double length = std::fmax(radius_ * step, least_move);
    cell_ = length / std::numbers::sqrt2;
    moves_.clear();
    for (const Gear gear : {Gear::forward, Gear::reverse}) {
      if (gear == Gear::reverse && !vehicle_.reverse) continue;
      moves_.push_back({gear, Steering::straight, 0, length});
      for (const int turns : {1, 3, 6}) {  // sharper turns if the vehicle can make them in a move
        const double arc = radius_ * step * turns;
        if (turns > 1 && arc > length) break;
        for (const Steering steering : {Steering::left, Steering::right}) {
          const int side = static_cast<int>(steering) * (gear == Gear::forward ? 1 : -1);
          moves_.push_back({gear, steering, side * turns, std::fmax(0, length - arc)});
        }
      }
    }
  }

  const HybridState& state(std::uint32_t i) const { return states_[i]; }
  Pose pose(const HybridState& s) const {
    return {s.position, angles_[static_cast<std::size_t>(s.heading)]};
  }
  std::optional<Gear> gear(const HybridState& s) const {
    if (s.move < 0) return std::nullopt;
    return moves_[static_cast<std::size_t>(s.move)].gear;
  }
  static std::int64_t key_of(double cost) {
    return static_cast<std::int64_t>(std::fmin(std::ceil(cost * 0x1p20), 0x1p62));
  }
  std::uint64_t place(const HybridState& s) const {
    const auto index = [&](double from, double to) {
      return static_cast<std::uint64_t>(
          static_cast<std::int64_t>(std::floor((to - from) / cell_ + 0.5)) + (1 << 26));
    };
    const std::uint64_t x = index(query_.start.x(), s.position.x());
    const std::uint64_t y = index(query_.start.y(), s.position.y());
    return (x << 37 | y << 10) | static_cast<std::uint64_t>(s.heading);
  }

  void push(double cost, std::uint32_t state, Kind kind) {
    open_.push_back({key_of(cost), state, kind});
    std::push_heap(open_.begin(), open_.end());
  }
  HybridEntry pop() {
    std::pop_heap(open_.begin(), open_.end());
    const HybridEntry entry = open_.back();
    open_.pop_back();
    return entry;
  }

  /// Generates a state, unless a drive to the goal is known to be as cheap.
  void add(const HybridState& s) {
    const double estimate = (*to_go_)(s.position);
    if (!(s.cost + estimate < best_.cost)) return;
    if (closed_.contains(place(s))) return;
    states_.push_back(s);
    push(s.cost + heuristic_weight_ * estimate, static_cast<std::uint32_t>(states_.size() - 1),
         Kind::near_estimate);
    context_.count_generated(s.position);
  }

  /// Takes a state from the open list: completes its estimate, or proves its move and expands it.
  void take(const HybridEntry& entry) {
    const HybridState s = state(entry.state);
    if (closed_.contains(place(s))) return;
    if (entry.kind == Kind::near_estimate) {
      const double enough = (static_cast<double>(entry.key) * 0x1p-20 - s.cost) / heuristic_weight_;
      const double way = to_go_->refined(s.position, enough + 4 * cell_);
      const double estimate = std::fmax(way, length_to_goal(pose(s)));
      if (!(s.cost + estimate < best_.cost)) return;
      const double key = s.cost + heuristic_weight_ * estimate;
      if (key_of(key) > entry.key) {
        return push(key, entry.state, way > enough ? Kind::near_estimate : Kind::full_estimate);
      }
    }
    if (!is_free(s)) return;
    closed_.insert(place(s));
    context_.count_expanded(s.position);
    if (--until_shot_ <= 0) {
      shoot(entry.state);
      until_shot_ = 1 + static_cast<int>((*to_go_)(s.position) / (8 * cell_));
    }
    const std::optional<Gear> before = gear(s);
    for (std::size_t i = 0; i < moves_.size(); ++i) {
      const HybridMove& move = moves_[i];
      HybridState next = moved(s, move);
      const double length =
          radius_ * std::abs(move.turns) * 2 * std::numbers::pi / headings_ + move.straight;
      next.cost = s.cost + length * (move.gear == Gear::reverse ? costs_.reverse : costs_.forward) +
                  (before && *before != move.gear ? costs_.cusp : 0);
      next.parent = entry.state;
      next.move = static_cast<std::int16_t>(i);
      add(next);
    }
  }

  /// The length of the shortest drive to the goal without obstacles [m].
  double length_to_goal(const Pose& from) const {
    if (!query_.goal_heading) return distance(from.position, query_.goal);
    const Pose goal{query_.goal, *query_.goal_heading};
    return vehicle_.reverse ? reeds_shepp_length(from, goal, radius_)
                            : radius_ * dubins_word(from, goal, radius_).length();
  }

  /// Tries to drive from a state to the goal, by the cheapest words first.
  void shoot(std::uint32_t from) {
    const HybridState& s = state(from);
    const Pose near = pose(s);
    shots_.clear();
    const auto offer = [&](const SteeringWord& word, double heading) {
      const double cost = s.cost + cost_of(word, costs_, gear(s), [&](const SteeringMove& move) {
                            return driven_length(move, radius_);
                          });
      if (cost < best_.cost) shots_.push_back({from, cost, word, heading, shots_.size()});
    };
    for_each_goal_heading(near, [&](double heading) {
      const Pose goal{query_.goal, heading};
      if (vehicle_.reverse) {
        for_each_reeds_shepp_word(near, goal, radius_,
                                  [&](const SteeringWord& word) { offer(word, heading); });
      } else {
        offer(dubins_word(near, goal, radius_), heading);
      }
    });
    std::sort(shots_.begin(), shots_.end(), [](const ToGoal& a, const ToGoal& b) {
      return std::pair(key_of(a.cost), a.order) < std::pair(key_of(b.cost), b.order);
    });
    if (shots_.size() > most_shots) shots_.resize(most_shots);
    for (const ToGoal& shot : shots_) {
      const Pose goal{query_.goal, shot.goal_heading};
      if (!footprint_.is_free(context_.space, vehicle_path(shot.word, near, goal, radius_)))
        continue;
      best_ = shot;
      return push(shot.cost, from, Kind::to_goal);
    }
  }
  static constexpr std::size_t most_shots = 12;

  /// The heading at the goal, or eight around the direction towards it if any will do.
  template <class Visit>
  void for_each_goal_heading(const Pose& near, Visit visit) const {
    if (query_.goal_heading) return visit(*query_.goal_heading);
    const double ahead = heading(query_.goal - near.position);
    for (int i = 0; i < 8; ++i) visit(wrapped_angle(ahead + i * std::numbers::pi / 4));
  }

  /// The state after a move, without its cost.
  HybridState moved(const HybridState& s, const HybridMove& move) const {
    const int heading = ((s.heading + move.turns) % headings_ + headings_) % headings_;
    const Point& from = directions_[static_cast<std::size_t>(s.heading)];
    const Point& to = directions_[static_cast<std::size_t>(heading)];
    const double side = static_cast<double>(move.steering) * radius_;
    const double on = move.gear == Gear::forward ? move.straight : -move.straight;
    return {.position = {s.position.x() + side * (to.y() - from.y()) + on * to.x(),
                         s.position.y() - side * (to.x() - from.x()) + on * to.y()},
            .heading = static_cast<std::int16_t>(heading)};
  }

  /// Adds the pieces of `count` equal moves, one after the other, from `s` to `end`. Only a turn or
  /// a straight move may be repeated.
  void append(const HybridState& s, const HybridMove& move, int count, const HybridState& end,
              VehiclePath& path) const {
    const double angle = angles_[static_cast<std::size_t>(s.heading)];
    const double back = move.gear == Gear::forward ? 0 : std::numbers::pi;
    Point at = s.position;
    double after = angle;
    if (move.turns != 0) {
      const double turn = count * move.turns * 2 * std::numbers::pi / headings_;
      Arc arc = turn_from({s.position, angle},
                          {move.steering, static_cast<double>(move.steering) * turn}, radius_);
      if (move.straight == 0) arc.b = end.position;
      path.push_back(arc, move.gear);
      at = arc.b;
      after = angle + turn;
    }
    if (move.straight > 0)
      path.push_back(straight_piece(at, end.position, after + back), move.gear);
  }

  bool is_free(const HybridState& s) {
    if (s.parent == HybridState::none) return true;
    VehiclePath path;
    append(state(s.parent), moves_[static_cast<std::size_t>(s.move)], 1, s, path);
    return footprint_.is_free(context_.space, path);
  }

  /// The path from the start to where the best drive begins, and on to the goal. Equal moves are
  /// joined if the joined piece is proved as well.
  VehiclePath path_to_goal() {
    std::vector<std::uint32_t> chain;
    for (std::uint32_t i = best_.state; i != HybridState::none; i = state(i).parent) {
      chain.push_back(i);
    }
    std::reverse(chain.begin(), chain.end());
    VehiclePath path;
    for (std::size_t i = 0; i + 1 < chain.size();) {
      const HybridState& from = state(chain[i]);
      const std::int16_t index = state(chain[i + 1]).move;
      const HybridMove& move = moves_[static_cast<std::size_t>(index)];
      std::size_t end = i + 1;
      const auto can_join = [&] {
        return end + 1 < chain.size() && state(chain[end + 1]).move == index &&
               (move.turns == 0 || move.straight == 0) &&
               std::abs(move.turns) * static_cast<int>(end + 1 - i) < headings_;
      };
      while (can_join()) ++end;
      VehiclePath joined;
      append(from, move, static_cast<int>(end - i), state(chain[end]), joined);
      if (end > i + 1 && !footprint_.is_free(context_.space, joined)) {
        joined = {};
        for (std::size_t k = i; k < end; ++k) {
          append(state(chain[k]), move, 1, state(chain[k + 1]), joined);
        }
      }
      path.append(joined);
      i = end;
    }
    path.append(vehicle_path(best_.word, pose(state(best_.state)),
                             {query_.goal, best_.goal_heading}, radius_));
    return path;
  }

  SearchContext<S, O>& context_;
  const Query& query_;
  const Vehicle& vehicle_;
  double radius_;
  DrivingCosts costs_;
  double heuristic_weight_;
  DistanceToGo<S>* to_go_ = nullptr;
  FootprintTest footprint_;
  std::vector<HybridState>& states_;
  std::vector<HybridEntry>& open_;
  NumberSet& closed_;

  int headings_ = 0;
  double cell_ = 0;                // side of the cells of which each keeps one state [m]
  std::vector<double> angles_;     // of the headings [rad]
  std::vector<Point> directions_;  // of the headings
  std::vector<HybridMove> moves_;
  std::vector<ToGoal> shots_;
  ToGoal best_;
  int until_shot_ = 0;
};

}  // namespace tutavia::detail
