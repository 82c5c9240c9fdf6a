// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "support/exact_checker.hpp"
#include "support/random_worlds.hpp"
#include "support/registry.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/space/nearest_free.hpp"

/// \file
/// WorldJudge: plans through a random world with every smoother, before the exact checker.

namespace tutavia::test {

struct NumberedWorld {
  Workspace world;
  Query query;
};

/// World number k: it depends on k alone.
inline NumberedWorld numbered_world(std::uint64_t number) {
  WorldGenerator worlds(number);
  NumberedWorld drawn{worlds.workspace(), {}};
  drawn.query.start = worlds.point(drawn.world);
  drawn.query.goal = worlds.point(drawn.world);
  return drawn;
}

/// What the checker said of the plans of some worlds. Verdicts are those at the safety radius.
struct Tally {
  std::uint64_t plans = 0, pieces = 0, free = 0, unknown = 0, blocked = 0;
  std::vector<std::string> findings;

  void add(const Tally& other) {
    plans += other.plans;
    pieces += other.pieces;
    free += other.free;
    unknown += other.unknown;
    blocked += other.blocked;
    findings.insert(findings.end(), other.findings.begin(), other.findings.end());
  }
};

/// A world with those obstacles alone that may come within the safety radius of an arc. The box of
/// the arc's ends, grown by half of its length, contains it.
inline Workspace near_arc(const Workspace& world, const Arc& arc) {
  const double reach = world.safety_radius + 0.5 * arc.radius * std::abs(arc.sweep);
  const Box box = Box::around({arc.a, arc.b});
  const Box zone = box.inflated(1.001 * reach + 1e-9 * (1 + box.largest_coordinate()));
  Workspace near{.bounds = world.bounds, .safety_radius = world.safety_radius};
  for (const Obstacle& obstacle : world.obstacles) {
    Box extent;
    if (const Disc* disc = std::get_if<Disc>(&obstacle)) {
      extent = Box::around({disc->center, disc->center}).inflated(disc->radius);
    } else {
      for (const Point& p : std::get<Polygon>(obstacle).outer) extent.include(p);
    }
    const bool is_near = (extent.min.array() <= zone.max.array()).all() &&
                         (zone.min.array() <= extent.max.array()).all();
    if (is_near) near.obstacles.push_back(obstacle);
  }
  return near;
}

/// The exact verdict on a curve. The checker compares arcs with every edge in a hundred digits,
/// which takes four tenths of all time: only those near an arc are left to it.
inline ExactVerdict exact_verdict(const Workspace& world, const Curve& curve) {
  const ExactChecker checker(world);
  bool is_free = true;
  for (const Piece& piece : curve.pieces()) {
    const ExactVerdict verdict = piece.visit([&]<class P>(const P& p) {
      if constexpr (std::is_same_v<P, Arc>) {
        const Workspace near = near_arc(world, p);
        return ExactChecker(near).check(piece);
      } else {
        return checker.check(Piece(p));
      }
    });
    if (verdict == ExactVerdict::blocked) return verdict;
    is_free = is_free && verdict == ExactVerdict::free;
  }
  return is_free && !curve.empty() ? ExactVerdict::free : ExactVerdict::unknown;
}

/// Judges the curve of a plan, whose certificate says that its clearance is at least `lower`.
/// `name` begins the lines of findings.
inline void judge_curve(const Workspace& world, const Query& query, const Curve& curve,
                        double lower, std::string_view name, Tally& tally) {
  const auto found = [&](std::string_view what) {
    tally.findings.push_back(std::string(name).append(": ").append(what));
  };
  ++tally.plans;
  tally.pieces += curve.pieces().size();
  if (curve.empty() || curve.start() != query.start || curve.end() != query.goal) {
    found("the ends are not exact");
  }
  // A curve that keeps more than the safety radius keeps the safety radius, too.
  ExactVerdict verdict = ExactVerdict::unknown;
  if (lower > world.safety_radius) {
    Workspace wider = world;
    wider.safety_radius = std::min(lower, 1e9);  // infinite without obstacles
    verdict = exact_verdict(wider, curve);
    if (verdict == ExactVerdict::blocked) found("the certificate says more than the clearance");
  }
  if (verdict != ExactVerdict::free) verdict = exact_verdict(world, curve);
  if (verdict == ExactVerdict::blocked) found("the curve is blocked");
  ++(verdict == ExactVerdict::free      ? tally.free
     : verdict == ExactVerdict::unknown ? tally.unknown
                                        : tally.blocked);
}

/// A searcher whose answer is a route that was found before.
struct KnownRoute {
  static constexpr std::string_view name = "known_route";
  struct Scratch {};
  Route route{};

  template <class S, Observer O>
  Expected<Route, Failure> search(const S&, const Query&, Scratch&, O&) const {
    return route;
  }
};

/// One judge per thread.
class WorldJudge {
 public:
  /// Plans one query through a world by AutoSearch, and judges the plan of every smoother. A third
  /// of the starts is where the answer is hardest: at the very edge of free space.
  Tally judge(std::uint64_t number) {
    Tally tally;
    auto [world, query] = numbered_world(number);
    const auto space =
        LatticeSpace::build(world, {.resolution = world.bounds.width() / 30}).value();
    if (number % 3 == 0) query.start = nearest_free_point(space, query.start).value_or(query.start);
    NoObserver observer;
    const auto route = search_.search(space, query, scratch_, observer);
    if (!route) return tally;
    for (const auto& smoother : smoothers_) {
      const std::string name =
          std::string("world ").append(std::to_string(number)).append(", ").append(smoother.name);
      const auto plan = Planner(KnownRoute{*route}, smoother).plan(space, query);
      if (plan) {
        judge_curve(world, query, plan->curve, plan->certificate.lower, name, tally);
      } else {
        tally.findings.push_back(
            std::string(name).append(": no plan: ").append(plan.error().detail));
      }
    }
    return tally;
  }

 private:
  AnySearch<LatticeSpace> search_ = make_search<LatticeSpace>("auto", {}).value();
  AnySearch<LatticeSpace>::Scratch scratch_;
  std::vector<AnySmoother<LatticeSpace>> smoothers_ = all_smoothers<LatticeSpace>();
};

}  // namespace tutavia::test
