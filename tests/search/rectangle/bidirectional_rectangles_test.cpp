// SPDX-License-Identifier: MIT
#include "tutavia/search/rectangle/bidirectional_rectangles.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <ostream>

#include "support/free_route.hpp"
#include "support/moving_ai_maps.hpp"
#include "support/random_grids.hpp"
#include "support/random_query.hpp"
#include "support/scale.hpp"
#include "tutavia/search/dijkstra.hpp"
#include "tutavia/search/improved_rea_star.hpp"
#include "tutavia/search/rea_star.hpp"
#include "tutavia/search/sb_rea_star.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

/// Length over the shortest on the grid.
struct Ratios {
  std::size_t paths = 0, rectangles = 0;
  double sum = 0, largest = 0;
};

/// Asks a search for a path where the shortest on the grid has a known length, or there is none.
template <class A>
void ask(const A& search, typename A::Scratch& scratch, const CellSpace& space, const Query& query,
         const std::optional<double>& shortest, Ratios& ratios) {
  NoObserver no_observer;
  const auto route = search.search(space, query, scratch, no_observer);
  REQUIRE(route.has_value() == shortest.has_value());
  if (!shortest) {
    CHECK(route.error().code == PlanError::unreachable_at_resolution);
    return;
  }
  CHECK(route->curve.start() == query.start);
  CHECK(route->curve.end() == query.goal);
  REQUIRE(test::is_free(space, *route));
  if (*shortest == 0) return;
  const double ratio = route->curve.length() / *shortest;
  ++ratios.paths;
  ratios.rectangles += route->stats.expanded;
  ratios.sum += ratio;
  ratios.largest = std::max(ratios.largest, ratio);
}

std::ostream& operator<<(std::ostream& out, const Ratios& ratios) {
  return out << ratios.paths << " paths, " << ratios.rectangles
             << " rectangles, length over the shortest on the grid "
             << ratios.sum / double(ratios.paths) << ", at most " << ratios.largest;
}

TEST_CASE("rectangles from both ends find a free path where there is one", "[soak]") {
  const std::uint64_t seed = 913;
  Random random(seed);
  const ImprovedReaStar improved, markers{.funnel = false},
      leg{.exit_cost = ExitCost::last_leg, .funnel = false}, on{.continue_after_contact = true};
  SbReaStar::Scratch sb_scratch;
  ImprovedReaStar::Scratch scratch;
  Dijkstra::Scratch reference;
  NoObserver no_observer;
  Ratios of_sb, of_improved, of_markers, of_leg, of_on;
  for (std::size_t round = 0; round < test::scaled(500); ++round) {
    INFO("seed " << seed << ", round " << round);
    const auto space =
        CellSpace::build(test::random_grid(random, round % 2 == 0 ? 12 : 60)).value();
    const Query query = test::random_query(random, space);
    const auto by_dijkstra = Dijkstra{}.search(space, query, reference, no_observer);
    std::optional<double> shortest;
    if (by_dijkstra) shortest = by_dijkstra->cost;
    if (!by_dijkstra && by_dijkstra.error().code != PlanError::unreachable_at_resolution) continue;
    ask(SbReaStar{}, sb_scratch, space, query, shortest, of_sb);
    ask(improved, scratch, space, query, shortest, of_improved);
    ask(markers, scratch, space, query, shortest, of_markers);
    ask(leg, scratch, space, query, shortest, of_leg);
    ask(on, scratch, space, query, shortest, of_on);
    if (!shortest) continue;
    const auto length = [&](const ImprovedReaStar& search) {
      return search.search(space, query, scratch, no_observer)->curve.length();
    };
    CHECK(length(improved) <= length(markers) * (1 + 1e-12));
  }
  CAPTURE(of_sb, of_improved, of_markers, of_leg, of_on);
  CHECK(of_sb.paths > test::scaled(100));
}

TEST_CASE("rectangle expansion on the MovingAI maps") {
  test::for_each_moving_ai_map(test::scaled(20), [](const test::MovingAiMap& map) {
    ReaStar::Scratch rea_scratch;
    SbReaStar::Scratch sb_scratch;
    ImprovedReaStar::Scratch scratch;
    NoObserver no_observer;
    Ratios of_rea, of_sb, of_improved;
    for (const ScenarioRow& row : map.rows) {
      INFO(map.name << " line " << row.line);
      const Query query = map.query(row);
      ask(ReaStar{}, rea_scratch, map.space, query, row.optimal_length, of_rea);
      ask(SbReaStar{}, sb_scratch, map.space, query, row.optimal_length, of_sb);
      ask(ImprovedReaStar{}, scratch, map.space, query, row.optimal_length, of_improved);
      const auto route = ReaStar{}.search(map.space, query, rea_scratch, no_observer);
      CHECK(route->cost == Approx(row.optimal_length).epsilon(1e-5).margin(0.02));
      CHECK(route->curve.length() <= route->cost * (1 + 1e-8));
    }
    CAPTURE(map.name, of_rea, of_sb, of_improved);
    CHECK(of_rea.paths * 2 > map.rows.size());
  });
}

}  // namespace
