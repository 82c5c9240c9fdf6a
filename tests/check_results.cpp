// SPDX-License-Identifier: MIT
/// \file
/// Judges the paths of a result file in exact arithmetic, without the library's own certificates:
///
///     tutavia-check-results SCENE.json RESULTS.json
///
/// A path is right if it leads from the start to the goal of its result without a gap, and keeps
/// the safety radius of the scene. Paths of vehicles are judged as those of their reference point.

#include <array>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "support/exact_checker.hpp"
#include "support/reference_json.hpp"

namespace {

using namespace tutavia;
using nlohmann::json;

std::string content_of(const char* path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(std::string("cannot read ") + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

Point point(const json& pair) { return {pair.at(0).get<double>(), pair.at(1).get<double>()}; }

Piece piece_of(const json& item) {
  const std::string type = item.at("type");
  const json& points = item.at("points");
  const auto number = [&](const char* name) { return item.at(name).get<double>(); };
  if (type == "line") return Segment{point(points.at(0)), point(points.at(1))};
  if (type == "arc") {
    return Arc{point(points.at(0)), point(points.at(1)),   point(item.at("center")),
               number("radius"),    number("start_angle"), number("sweep")};
  }
  if (type == "clothoid") {
    return Clothoid{point(points.at(0)), point(points.at(1)), number("heading"),
                    number("curvature"), number("sharpness"), number("length")};
  }
  if (type != "bezier") throw std::runtime_error("unknown piece " + type);
  if (points.size() == 3) {
    return QuadraticBezier{{point(points[0]), point(points[1]), point(points[2])}};
  }
  return CubicBezier{
      {point(points.at(0)), point(points.at(1)), point(points.at(2)), point(points.at(3))}};
}

/// What is wrong with a path; empty if nothing is.
std::string fault_of(const json& result, const test::ExactChecker& checker) {
  Curve curve;
  for (const json& item : result.at("curve")) {
    const Piece piece = piece_of(item);
    if (!curve.empty() && curve.end() != start_of(piece)) return "it has a gap";
    curve.push_back(piece);
  }
  if (curve.empty()) return "it is empty";
  if (curve.start() != point(result.at("start"))) return "it does not begin at the start";
  if (curve.end() != point(result.at("goal"))) return "it does not end at the goal";
  constexpr std::array verdicts{"", "it is not safe", "no verdict"};
  return verdicts[static_cast<std::size_t>(checker.check(curve))];
}

int check(const char* scene_path, const char* results_path) {
  const auto workspace = test::reference_scene(content_of(scene_path));
  if (!workspace) throw std::runtime_error(std::string(scene_path) + " is no scene");
  const test::ExactChecker checker(*workspace);
  std::size_t paths = 0, faults = 0;
  const json file = json::parse(content_of(results_path));
  for (const json& result : file.at("results")) {
    if (result.at("status") != "success") continue;
    ++paths;
    const std::string fault = fault_of(result, checker);
    if (fault.empty()) continue;
    ++faults;
    std::printf("%s, %s: %s\n", result.at("search").get<std::string>().c_str(),
                result.at("smoother").get<std::string>().c_str(), fault.c_str());
  }
  std::printf("%zu paths, %zu of them wrong\n", paths, faults);
  return paths > 0 && faults == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: tutavia-check-results SCENE.json RESULTS.json\n", stderr);
    return 2;
  }
  try {
    return check(argv[1], argv[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tutavia-check-results: %s\n", error.what());
    return 2;
  }
}
