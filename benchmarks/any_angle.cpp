// SPDX-License-Identifier: MIT
/// \file
/// tutavia-bench-any-angle: searches at any angle on MovingAI maps, beside a Theta* as in the
/// textbook. Lengths stand beside the optimum; every path is checked by the rules of the Grid-Based
/// Path Planning Competition, in integers.

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "../tests/support/corner_paths.hpp"
#include "map_benchmark.hpp"
#include "tutavia/search/any_angle.hpp"
#include "tutavia/search/jps_theta_star.hpp"
#include "tutavia/search/lazy_theta_star.hpp"
#include "tutavia/search/theta_star.hpp"

namespace {

using namespace map_benchmark;

Engines engines() {
  const auto bytes_with_columns = [](const CellSpace& s) {
    return grid_bytes(s) + s.columns().words().size() * 8;
  };
  const auto bytes_with_corners = [=](const CellSpace& s) {
    return bytes_with_columns(s) + s.corners().words().size() * 8;
  };
  return {
      {"any_angle", [](const CellSpace& s) { return engine(s, AnyAngle{}, grid_bytes(s)); }},
      {"any_angle_mesh",
       [](const CellSpace& s) {
         return prepared_engine<AnyAngle>(s, grid_bytes(s),
                                          [](const auto& mesh) { return AnyAngle{mesh}; });
       }},
      // On corners of cells, as the optimum is.
      {"theta_star",
       [=](const CellSpace& s) {
         return engine(s, ThetaStar{NodePlacement::cell_corner}, bytes_with_corners(s));
       }},
      {"lazy_theta_star",
       [=](const CellSpace& s) {
         return engine(s, LazyThetaStar{NodePlacement::cell_corner}, bytes_with_corners(s));
       }},
      {"textbook_theta_star",
       [](const CellSpace& s) { return baseline_engine<baseline::TextbookThetaStar>(s); }},
      // Between centres of cells: lengths are those of another problem, at least as long.
      {"theta_star_centre",
       [=](const CellSpace& s) { return engine(s, ThetaStar{}, bytes_with_columns(s)); }},
      {"lazy_theta_star_centre",
       [=](const CellSpace& s) { return engine(s, LazyThetaStar{}, bytes_with_columns(s)); }},
      {"jps_theta_star",
       [=](const CellSpace& s) {
         return engine(s, JpsThetaStar{}, bytes_with_columns(s) + plane_bytes(s));
       }},
  };
}

/// Lengths of the optimal paths, by the search on the prepared mesh.
std::function<double(const ScenarioRow&)> optimum(const CellSpace& space) {
  const AnyAngle algorithm{value_or_throw(AnyAngle::prepare(space))};
  auto scratch = std::make_shared<AnyAngle::Scratch>();
  return [&space, algorithm, scratch](const ScenarioRow& row) {
    NoObserver no_observer;
    const Query query{.start = space.frame().point(row.start),
                      .goal = space.frame().point(row.goal)};
    return value_or_throw(algorithm.search(space, query, *scratch, no_observer)).cost;
  };
}

/// Allowed by the rules, as long as it says, and never shorter than the optimum; the optimum where
/// that is promised.
bool is_right(const CellSpace& space, const std::string& search, const Engine::Answer& answer,
              double optimal) {
  const std::vector<test::Half> path = test::joints_in_halves(answer.curve);
  double length = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) length += test::length(path[i], path[i + 1]);
  const double tolerance = 1e-9 * (1 + optimal);
  return test::CornerRules(space.cells()).allows(path) &&
         std::abs(length - answer.cost) <= tolerance && answer.cost >= optimal - tolerance &&
         (!search.starts_with("any_angle") || answer.cost <= optimal + tolerance);
}

}  // namespace

int main(int argc, char** argv) {
  Benchmark benchmark;
  benchmark.name = "tutavia-bench-any-angle";
  benchmark.description = "Searches at any angle on MovingAI maps, paths checked";
  benchmark.engines = engines();
  benchmark.searches = {"textbook_theta_star", "theta_star", "lazy_theta_star", "any_angle",
                        "any_angle_mesh"};
  benchmark.compares_lengths = true;
  benchmark.optimum = optimum;
  benchmark.is_right = is_right;
  return map_benchmark::main(benchmark, argc, argv);
}
