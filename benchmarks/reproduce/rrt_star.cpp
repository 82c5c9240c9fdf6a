// SPDX-License-Identifier: MIT
/// \file
/// The improved RRT* of MM Science Journal, October 2023: tables 1 and 2.

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "published.hpp"
#include "report.hpp"
#include "runs.hpp"
#include "tutavia/io/svg.hpp"
#include "tutavia/search/risk_zone.hpp"
#include "tutavia/search/rrt.hpp"
#include "tutavia/search/safe_rrt_star.hpp"
#include "tutavia/search/tangent_graph.hpp"
#include "tutavia/smooth/b_spline_smoother.hpp"
#include "tutavia/smooth/redundant_node_removal.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/world/maps.hpp"

namespace reproduce {

namespace {

constexpr std::size_t seeds = 20;

/// One stage of the method over all seeds.
struct Stage {
  std::string name, paper_name;
  std::vector<double> lengths{}, micros{};
  double clearance = std::numeric_limits<double>::infinity();
  std::size_t proved = 0;

  void add(const Run& run, double before) {
    lengths.push_back(run.length());
    micros.push_back(run.micros + before);
    clearance = std::min(clearance, run.metrics.min_clearance);
    proved += run.is_proved;
  }
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

std::string table_of(const Scene& scene) {
  return scene.name == "rrt_scene_1" ? "Table1" : "Table2";
}

double printed(const Scene& scene, const std::string& stage, bool time) {
  const std::string scenario =
      scene.name == "rrt_scene_1" ? "scenario1_five_obstacles" : "scenario2_six_obstacles";
  const char* metric = time ? "time_processing_units_not_stated" : "path_length_units_not_stated";
  return published("RRTSTAR", table_of(scene), scenario, stage, metric)
      .value_or(std::numeric_limits<double>::quiet_NaN());
}

struct SceneRuns {
  std::vector<Stage> stages;
  Plan example;
  double shortest = 0;  // that keeps out of the risk zones
};

SceneRuns run_scene(const Scene& scene, const Options& options, Progress& progress) {
  const auto space = InflatedSpace::build(scene.workspace).value();
  const SafeRrtStar with_nodes{.prune = false};
  const RiskZone zone = with_nodes.zone(space);
  const auto wide = space.with_safety_radius(zone.width).value();
  SceneRuns result;
  result.stages = {{"RRT", "RRT"},
                   {"RRT*, outside the risk zones", ""},
                   {"the same without redundant nodes", "Improved RRT* (redundant points removed)"},
                   {"the same with the cubic B-spline", "Proposed RRT* (+B-spline)"},
                   {"library: SafeRrtStar and B-spline by Planner", ""}};
  for (std::size_t i = 0; i < seeds; ++i) {
    progress.say("rrt_star: " + scene.name + ", seed " + std::to_string(i + 1) + "/20");
    const Query query{.start = scene.start,
                      .goal = scene.goals[0],
                      .seed = options.seed + static_cast<std::uint64_t>(i)};
    const Run rrt = search(Rrt{}, space, query, options);
    const Run safe = search(with_nodes, space, query, options);
    const Run pruned = smooth(RedundantNodeRemoval{}, wide, safe, options);
    const Run spline = smooth(BSplineSmoother{.prune = false}, wide, pruned, options);
    result.stages[0].add(rrt, 0);
    result.stages[1].add(safe, 0);
    result.stages[2].add(pruned, safe.micros);
    result.stages[3].add(spline, safe.micros + pruned.micros);
    const Run whole = search(SafeRrtStar{}, space, query, options);
    result.stages[4].add(smooth(BSplineSmoother{}, wide, whole, options), whole.micros);
    if (i == 0) result.example = plan_of(safe, spline);
  }
  result.shortest =
      search(TangentGraph{}, wide, {.start = scene.start, .goal = scene.goals[0]}, options)
          .length();
  return result;
}

Table scene_table(const Scene& scene, const SceneRuns& runs) {
  Table table{
      .name = table_of(scene),
      .title = "**" + table_of(scene) + "** (" + scene.name +
               "): medians over 20 seeds. Published lengths have no unit (the straight line "
               "is 70.7 m), so both are shown as ratios to RRT. *Shortest*: the shortest "
               "path outside the risk zones, " +
               fixed(runs.shortest, 3) + " m.",
      .header = {"stage", "published", "published / RRT", "length [m]", "length / RRT",
                 "length / shortest", "least clearance [m]", "proved"}};
  for (const Stage& stage : runs.stages) {
    const double paper = printed(scene, stage.paper_name, false);
    const double own = median(stage.lengths);
    table.rows.push_back(
        {stage.name, fixed(paper, 2), fixed(paper / printed(scene, "RRT", false), 3), fixed(own, 2),
         fixed(own / median(runs.stages[0].lengths), 3), fixed(own / runs.shortest, 4),
         fixed(stage.clearance, 3), std::to_string(stage.proved) + " of 20"});
  }
  return table;
}

std::vector<Claim> claims_of(const std::vector<SceneRuns>& scenes) {
  const auto ratio = [&](const SceneRuns& scene) {
    return fixed(median(scene.stages[3].lengths) / median(scene.stages[0].lengths), 3);
  };
  bool pruned_longer = false, shorter = true;
  for (const SceneRuns& scene : scenes) {
    pruned_longer =
        pruned_longer || median(scene.stages[2].lengths) > median(scene.stages[0].lengths);
    shorter = shorter && median(scene.stages[3].lengths) < median(scene.stages[0].lengths);
  }
  return {
      {"The proposed path is shorter than RRT's (0.793 and 0.788 of it)",
       shorter ? Verdict::reproduced : Verdict::not_so,
       ratio(scenes[0]) + " and " + ratio(scenes[1]) + " here"},
      {"Without redundant nodes the path is longer than RRT's (1325 and 1276)", Verdict::wrong,
       std::string("a path cannot become longer when nodes are removed; the figures must come from "
                   "different trees. Here it is ") +
           (pruned_longer ? "longer" : "shorter") + " than RRT's on both scenes"},
      {"The lengths of about 1000 to 1325", Verdict::not_reproducible,
       "from (0, 0) to (50, 50) the straight line is 70.7; the unit is not given"},
      {"The proposed method takes a quarter of RRT's time", Verdict::not_so,
       "with N = 3000 iterations each, RRT\\* also looks for better parents and rewires, and RRT "
       "may "
       "stop at its first path (times.md). The paper does not say when its searches stop"},
      {"The robot must not enter the grey zone, and its smoothed path may", Verdict::wrong,
       "the paper says both. Here no smoothed path enters it where the route is outside: the least "
       "clearance is the width of the zone"},
      {"A robot that follows a path and avoids obstacles (figure 10)", Verdict::not_reproducible,
       "no map and no parameters; local planning is not part of the library so far"}};
}

}  // namespace

Section rrt_star_section(const Options& options, Progress& progress) {
  Section section{
      .name = "rrt_star",
      .title =
          "Improved RRT\\* with safety zones and B-splines (MM Science Journal, "
          "October 2023)",
      .introduction =
          "The scenes are reconstructions from the paper's pictures: 50 x 50 m, a point "
          "robot, N = 3000. The width of the risk zones is not given: 2 m here."};
  std::vector<SceneRuns> scenes;
  Table times{.name = "RRT* times",
              .title =
                  "**Improved RRT\\*, tables 1 and 2**: time over that of RRT, medians over 20 "
                  "seeds.",
              .header = {"scene and stage", "published", "here"}};
  for (const Scene& scene : {maps::rrt_scene_1(), maps::rrt_scene_2()}) {
    scenes.push_back(run_scene(scene, options, progress));
    section.tables.push_back(scene_table(scene, scenes.back()));
    section.pictures.push_back(
        {"rrt_star-" + scene.name + ".svg",
         "The path of RRT\\* (dashed), and the B-spline along it without "
         "redundant nodes, on " +
             scene.name + ":",
         to_svg(scene.workspace, std::vector<Plan>{scenes.back().example}, {.width = 500})});
    for (const Stage& stage : scenes.back().stages) {
      times.rows.push_back(
          {scene.name + ": " + stage.name,
           fixed(printed(scene, stage.paper_name, true) / printed(scene, "RRT", true), 3),
           fixed(median(stage.micros) / median(scenes.back().stages[0].micros), 3)});
    }
  }
  section.times.push_back(std::move(times));
  section.claims = claims_of(scenes);
  return section;
}

}  // namespace reproduce
