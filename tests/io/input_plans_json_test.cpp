// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "tutavia/io/moving_ai.hpp"
#include "tutavia/io/workspace_json.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/search/auto_search.hpp"
#include "tutavia/search/tangent_graph.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/lattice_space.hpp"

// Plans on worlds rebuilt from reports to path planners and geometry libraries, of which
// inputs_test checks the reading.

namespace {

using namespace tutavia;

const std::string folder = std::string(TUTAVIA_TEST_DATA).append("/inputs/");

/// The answer for one goal: the length of the shortest path [m], or why there is none.
struct Answer {
  double optimum = std::numeric_limits<double>::quiet_NaN();
  PlanError code = PlanError::invalid_input;

  Answer(double length) : optimum(length) {}
  Answer(PlanError error) : code(error) {}
};

struct WorldRow {
  std::string file;
  std::vector<Answer> answers;            // for each goal
  std::optional<double> safety_radius{};  // instead of the file's [m]
};

const std::vector<WorldRow> worlds{
    {"17-epf84/r0.json", {699.683763371}},
    {"17-epf84/r0.5.json", {700.968058682}},
    {"17-epf84/r5.json", {712.60138613}},
    // The bar touches the hole's sides: a point slides along them, a disc cannot.
    {"18-epf23/r0.json", {11.4841843207}},
    {"18-epf23/r01.json", {PlanError::unreachable}},
    {"19-epf102/r0.json", {197.931049032}},
    {"19-epf102/r0.5.json", {198.675926038}},
    {"19-epf102/r2.json", {200.943705321}},
    {"19-epf102/r0.json", {203.1051696493}, 3.4},
    // The goal is rounded into the wall by less than 1e-12 m.
    {"20-epf12/ccw.json", {PlanError::goal_blocked}},
    {"20-epf12/cw.json", {PlanError::goal_blocked}},
    {"20-epf12/close.json", {6431.79338894}},
    {"21-nav2d26/r1.json", {PlanError::start_blocked}},
    {"21-nav2d26/r2.json", {PlanError::start_blocked}},
    {"21-nav2d26/r5.json", {PlanError::start_blocked}},
    {"21-nav2d26/r1.json", {1945.8999290244}, 0.5},
    {"22-pvg39/r0.json", {7.82842712475}},
    {"22-pvg39/r02.json", {PlanError::start_blocked}},
    // Two triangles that touch at a vertex: a point passes between them.
    {"23-p2t90/r0.json", {64159.9710432}},
    {"23-p2t90/r100.json", {249849.991295}},
    {"23-p2t90/r1000.json", {252894.42149}},
    {"23-p2t90/small_r0.json", {2.67912462644}},
    {"23-p2t90/small_r0.1.json", {6.64097434835}},
    {"24-earcut45/pocket.json", {2.15406592285, PlanError::unreachable, PlanError::unreachable}},
    {"25-earcut52/obstacle.json", {1775.40041991, PlanError::unreachable}},
    {"25-earcut52/r0.json", {1124.15032026, 1121.5014745}},
    {"25-earcut52/r1.json", {1124.5503721, 1121.96327118}},
    {"25-earcut52/r3.json", {1125.37931939, 1122.99851517}},
    {"31-link/slot.json", {6.65345198467}},
    {"33-touch/adjacent.json", {6.0}},
    {"33-touch/adjacent_r.json", {12.2462139029}},
    {"33-touch/tjunction.json", {6.0}},
    {"33-touch/earcut161.json",
     {PlanError::unreachable, 0.00170293863659, PlanError::goal_blocked}},
    {"33-touch/p2t17.json",
     {PlanError::unreachable, 5.0, PlanError::unreachable, PlanError::goal_blocked}},
};

TEST_CASE("on reported worlds a path is found wherever there is one, and the shortest is known") {
  for (const WorldRow& row : worlds) {
    Scene scene = read_scene_json(folder + row.file).value().scene;
    if (row.safety_radius) scene.workspace.safety_radius = *row.safety_radius;
    const auto space =
        LatticeSpace::build(scene.workspace, {.resolution = scene.resolution}).value();
    REQUIRE(scene.goals.size() == row.answers.size());
    for (std::size_t i = 0; i < row.answers.size(); ++i) {
      INFO(row.file << ", goal " << i);
      const Query query{.start = scene.start, .goal = scene.goals[i]};
      const Answer& expected = row.answers[i];
      const auto exact = Planner(TangentGraph{}).plan(space, query);
      const auto plan = Planner(AutoSearch{}, DeltaSmoother{}).plan(space, query);
      if (std::isnan(expected.optimum)) {
        REQUIRE_FALSE(exact);
        REQUIRE_FALSE(plan);
        CHECK(exact.error().code == expected.code);
        CHECK(plan.error().code == expected.code);
      } else {
        REQUIRE(exact);
        REQUIRE(plan);
        CHECK(exact->metrics.length == Approx(expected.optimum).epsilon(1e-8));
        CHECK(plan->metrics.length >= expected.optimum * (1 - 1e-8));
      }
    }
  }
}

/// A query between the centres of two cells, and the length of the shortest path on the grid.
struct MapRow {
  std::string file;
  Point start, goal;
  std::optional<double> length;  // [cells]; none: there is no path
};

const std::vector<MapRow> cell_maps{
    {"13-jps-gap/row.map", {0.5, 0.5}, {2.5, 0.5}, 2},
    {"13-jps-gap/row.map", {0.5, 0.5}, {4.5, 0.5}, std::nullopt},
    {"13-jps-gap/column.map", {0.5, 0.5}, {0.5, 4.5}, std::nullopt},
    {"13-jps-gap/diag.map", {0.5, 0.5}, {1.5, 1.5}, std::nullopt},
    {"16-pf170/g.map", {0.5, 0.5}, {0.5, 5.5}, 13.242640687119286},
    {"31-link/corridor.map", {0.5, 2.5}, {11.5, 3.5}, 11.414213562373096},
};

TEST_CASE("on reported maps of cells the path is the shortest on the grid") {
  for (const MapRow& row : cell_maps) {
    INFO(row.file);
    const auto space = CellSpace::build(read_moving_ai_map(folder + row.file).value()).value();
    const auto plan = Planner(AutoSearch{}).plan(space, {.start = row.start, .goal = row.goal});
    REQUIRE(plan.has_value() == row.length.has_value());
    if (plan) CHECK(plan->route.cost == Approx(*row.length));
  }
}

}  // namespace
