// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/paper_maps.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/metrics/paper_metrics.hpp"
#include "tutavia/search/ssa_astar.hpp"
#include "tutavia/smooth/smoothing_spline.hpp"
#include "tutavia/smooth/two_stage_b_spline.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;

struct Measures {
  double md = 0, ad = 0, at = 0;
};

/// A row of table 5 of the SSA-A* paper: means over the maps of a set, of the routes of SSA-A*
/// after `shape(space, route)`; `at(curve)` is AT.
template <class Shape, class MeanTurn>
Measures table_row(const std::string& set, MovementRule rule, const Shape& shape,
                   const MeanTurn& at) {
  Measures sum;
  double count = 0;
  for (const auto& [allowing, query] : test::ssa_tasks(set)) {
    const auto space = CellSpace::build(allowing.grid(), {.movement = rule}).value();
    const auto route = test::search_once(SsaAStar{}, space, query);
    if (!route) continue;
    const Curve curve = shape(space, route->curve);
    const auto [md, ad] = obstacle_distances(space, curve, 0.05);
    sum = {sum.md + md, sum.ad + ad, sum.at + at(curve)};
    ++count;
  }
  return {sum.md / count, sum.ad / count, sum.at / count};
}

TEST_CASE("MD, AD and AT of the SSA-A* paper's kinds of paths") {
  struct Case {
    std::string set;
    MovementRule rule;
    Measures raw;  // computed independently, in advance
  };
  const std::vector<Case> cases{
      {"cluster_20", MovementRule::allow, {0.0032, 1.0144, 0.3474}},
      {"cluster_20", MovementRule::no_squeeze, {0.0036, 1.0108, 0.3302}},
      {"random_20", MovementRule::allow, {0.0022, 0.6628, 0.2979}},
      {"random_20", MovementRule::no_squeeze, {0.0020, 0.6695, 0.3278}},
  };
  const auto at_nodes = [](const Curve& curve) { return mean_turn(grid_nodes(curve, 1)); };
  const auto at_samples = [](const Curve& curve) { return mean_turn(curve); };
  for (const auto& [set, rule, expected] : cases) {
    const auto as_is = [](const auto&, const Curve& route) { return route; };
    const auto spline = [](const auto& space, const Curve& route) {
      return SmoothingSpline{}.smooth(space, route, {}).value();
    };
    const auto two_stage = [](const auto& space, const Curve& route) {
      return TwoStageBSpline{}.smooth(space, route, {}).value();
    };
    const Measures a = table_row(set, rule, as_is, at_nodes),
                   b = table_row(set, rule, spline, at_samples),
                   c = table_row(set, rule, two_stage, at_samples);
    CAPTURE(set, static_cast<int>(rule));
    CAPTURE(a.md, a.ad, a.at, b.md, b.ad, b.at, c.md, c.ad, c.at);
    CHECK(a.md == Approx(expected.md).margin(6e-5));
    CHECK(a.ad == Approx(expected.ad).margin(6e-5));
    CHECK(a.at == Approx(expected.at).margin(6e-5));
    // The orders of the published rows.
    CHECK((a.md < b.md && b.md < c.md));
    CHECK((a.ad < b.ad && b.ad < c.ad));
    CHECK((a.at > b.at && a.at > c.at));
  }
}

}  // namespace
