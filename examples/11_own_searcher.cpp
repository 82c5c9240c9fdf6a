// SPDX-License-Identifier: MIT
// A searcher of your own: tries paths over one random via point. It needs no base class and no
// registration, and the planner proves its routes like those of the library.

#include <array>
#include <iomanip>
#include <iostream>
#include <string_view>
#include <tutavia/tutavia.hpp>

struct ViaPoint {
  static constexpr std::string_view name = "via_point";
  struct Scratch {};
  int tries = 10000;

  template <tutavia::FreeSpace S, tutavia::Observer O>
  tutavia::Expected<tutavia::Route, tutavia::Failure> search(const S& space,
                                                             const tutavia::Query& query, Scratch&,
                                                             O& observer) const {
    if (auto valid = tutavia::check_query(space, query); !valid) {
      return tutavia::Unexpected{valid.error()};
    }
    tutavia::Random random(query.seed);
    const tutavia::Box& box = space.bounds();
    tutavia::Statistics stats;
    for (int i = 0; i < tries; ++i) {
      if (const auto end = query.budget.exceeded()) return tutavia::fail(*end);
      if (stats.expanded == query.budget.max_expansions) break;
      ++stats.expanded;
      const tutavia::Point via{random.uniform(box.min.x(), box.max.x()),
                               random.uniform(box.min.y(), box.max.y())};
      observer.generated(via);
      if (!space.segment_free(query.start, via) || !space.segment_free(via, query.goal)) continue;
      const std::array points{query.start, via, query.goal};
      const auto curve = tutavia::Curve::polyline(points);
      return tutavia::Route{.curve = curve, .cost = curve.length(), .stats = stats};
    }
    return tutavia::fail(tutavia::PlanError::budget_exhausted, "no single bend found");
  }
};

static_assert(tutavia::Searcher<ViaPoint, tutavia::InflatedSpace>);

int main() {
  const tutavia::Scene scene = tutavia::maps::complex();
  const auto space = tutavia::InflatedSpace::build(scene.workspace).value();
  tutavia::Planner planner{ViaPoint{}};
  const auto plan = planner.plan(space, {.start = scene.start, .goal = scene.goals[0], .seed = 1});
  if (!plan) {
    std::cerr << plan.error() << '\n';
    return 1;
  }
  std::cout << std::fixed << std::setprecision(2) << "proved, " << plan->metrics.length << " m\n";
}
