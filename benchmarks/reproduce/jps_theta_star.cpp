// SPDX-License-Identifier: MIT
/// \file
/// Yang et al., "Improved A* based on fused Theta*": tables 1 and 2.

#include <string>
#include <utility>
#include <vector>

#include "band_drive.hpp"
#include "published.hpp"
#include "report.hpp"
#include "runs.hpp"
#include "support/paper_maps.hpp"
#include "tutavia/search/any_angle.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/jps.hpp"
#include "tutavia/search/jps_theta_star.hpp"
#include "tutavia/smooth/bezier_smoother.hpp"
#include "tutavia/smooth/taut_string.hpp"

namespace reproduce {

namespace {

std::optional<double> printed(const std::string& search, const std::string& metric) {
  return published("JPSTHETA", "Table1", "raster_20x30", search, metric);
}

struct Row {
  std::string name;
  Run run;
};

Table table_1(const std::vector<Row>& rows, double shortest) {
  Table table{.name = "table 1",
              .title =
                  "**Table 1**, a raster of 20 x 30 cells (a reconstruction with the published "
                  "shortest length of 25 + 11 sqrt(2) cells). Brackets: published. *Ratio*: "
                  "to the shortest path at any angle.",
              .header = {"search", "length [cells]", "turns", "nodes", "total turning [deg]",
                         "ratio", "proved"}};
  for (const auto& [name, run] : rows) {
    const auto pair = [&](double own, const char* metric, int decimals) {
      const auto paper = printed(name, metric);
      return fixed(own, decimals) + (paper ? " (" + fixed(*paper, decimals) + ")" : "");
    };
    table.rows.push_back({name, pair(run.length(), "track_length_cm_as_printed(cells)", 2),
                          pair(run.turns(), "turns", 0), pair(run.expanded(), "search_nodes", 0),
                          fixed(run.turning(), 0), fixed(run.length() / shortest, 4),
                          run.is_proved ? "yes" : "no"});
  }
  return table;
}

Table table_2() {
  Table table{.name = "table 2",
              .title =
                  "**Table 2**, a map of a Gazebo world: the map is not published, so nothing "
                  "stands beside. Its lengths contradict themselves: JPS finds paths of the "
                  "same length as A\\*.",
              .header = {"search", "length [m]", "time [ms]"}};
  for (const char* search : {"A*", "JPS", "JPS_Theta*"}) {
    const auto figure = [&](const char* metric) {
      return fixed(published("JPSTHETA", "Table2", "gazebo_map", search, metric), 2);
    };
    table.rows.push_back({search, figure("trajectory_length_m"), figure("plan_time_ms")});
  }
  return table;
}

std::vector<Claim> claims_of(const Run& astar, const Run& jps, const Run& theta,
                             const Run& any_angle) {
  return {
      {"JPS_Theta\\* is 4.34 % shorter than A\\*",
       theta.length() < astar.length() ? Verdict::reproduced : Verdict::not_so,
       saving(astar.length(), theta.length(), 2) +
           " here. The figure of 4.34 % follows from the printed lengths; the shortest path at any "
           "angle is " +
           saving(astar.length(), any_angle.length(), 2) + " shorter on this raster"},
      {"JPS_Theta\\* takes 76.9 % less time than A\\*", Verdict::tendency,
       "the order comes out (times.md); the figure follows from the printed times, which are those "
       "of MATLAB"},
      {"JPS searches 67.4 % fewer nodes than A\\*",
       jps.expanded() < astar.expanded() ? Verdict::reproduced : Verdict::not_so,
       saving(astar.expanded(), jps.expanded(), 1) +
           " fewer here. The library's JPS passes cells at which a diagonal only turns and expands "
           "fewer nodes than the paper's"},
      {"JPS_Theta\\* turns less often than A\\* (7 instead of 8)",
       theta.turns() < astar.turns() ? Verdict::tendency : Verdict::not_so,
       fixed(theta.turns(), 0) + " instead of " + fixed(astar.turns(), 0) +
           ". A\\*'s count depends on ties: some of its shortest paths on this raster turn 5 "
           "times"},
      {"Bezier curves remove the inflection points", Verdict::wrong,
       "rounding a corner keeps the sense of its turn: the path bends left and right as often as "
       "before"},
      {"JPS: 8.65 m where A\\* has 9.75 m (table 2)", Verdict::wrong,
       "JPS is A\\* without symmetric paths, and as long; another weighting or another map was "
       "used"}};
}

}  // namespace

Section jps_theta_star_section(const Options& options, Progress& progress) {
  progress.say("jps_theta_star: table 1");
  const test::PaperTask task = test::jps_theta_task();
  const Run astar =
      search(AStar{.heuristic = HeuristicKind::euclidean}, task.space, task.query, options);
  const Run jps = search(Jps{}, task.space, task.query, options);
  const Run theta = search(JpsThetaStar{}, task.space, task.query, options);
  const Run in_search = search(JpsThetaStar{.lines_of_sight = JpsThetaStar::LineOfSight::in_search},
                               task.space, task.query, options);
  const Run bezier = smooth(BezierSmoother{}, task.space, theta, options);
  const Run any_angle = search(AnyAngle{}, task.space, task.query, options);
  const std::vector<Row> rows{{"A*", astar},
                              {"JPS", jps},
                              {"JPS_Theta*", theta},
                              {"JPS_Theta*, lines of sight in the search", in_search},
                              {"JPS_Theta* and cubic Bezier", bezier},
                              {"best: shortest at any angle", any_angle}};
  Section section{
      .name = "jps_theta_star",
      .title = "JPS_Theta\\*: Improved A\\* based on fused Theta\\* (Yang et al.)",
      .introduction =
          "Diagonal steps keep off both cells beside them (`no_cut`); the heuristic is "
          "the weighted Chebyshev distance of the paper. The paper's \"cm\" are cells."};
  section.tables = {table_1(rows, any_angle.length()), table_2()};
  Table times{.name = "JPS_Theta* times",
              .title = "**JPS_Theta\\*, table 1**: time over that of A\\*.",
              .header = {"search", "published", "here"}};
  for (const Row& row : rows) {
    const auto paper = printed(row.name, "time_s");
    times.rows.push_back({row.name,
                          paper ? fixed(*paper / printed("A*", "time_s").value(), 3) : "-",
                          fixed(row.run.micros / astar.micros, 3)});
  }
  section.times.push_back(std::move(times));
  section.claims = claims_of(astar, jps, theta, any_angle);

  progress.say("jps_theta_star: drive");
  const BandScene scene = band_scene(options);
  const BandDrive without = drive_by_bands(scene, false), with = drive_by_bands(scene, true);
  section.tables.push_back(band_table(scene, without, with));
  section.claims.push_back(band_claim(with));
  section.pictures.push_back(band_picture(scene, with));
  return section;
}

}  // namespace reproduce
