// SPDX-License-Identifier: MIT
#include <limits>
#include <string>
#include <variant>

#include "support/catch.hpp"
#include "tutavia/world/workspace.hpp"

namespace {

using namespace tutavia;

const double inf = std::numeric_limits<double>::infinity();
const double nan = std::numeric_limits<double>::quiet_NaN();

/// One polygon with two holes and one disc.
Workspace valid() {
  Workspace workspace{{{0, 0}, {10, 8}}, 0.3};
  workspace.obstacles.push_back(Polygon{{{1, 1}, {5, 1}, {5, 5}, {1, 5}},
                                        {{{2, 2}, {3, 2}, {3, 3}}, {{4, 4}, {4.5, 4}, {4, 4.5}}}});
  workspace.obstacles.push_back(Disc{{7, 4}, 1});
  return workspace;
}

Polygon& polygon(Workspace& workspace) { return std::get<Polygon>(workspace.obstacles[0]); }
Disc& disc(Workspace& workspace) { return std::get<Disc>(workspace.obstacles[1]); }

/// Applies `change` to a valid workspace: what does validate() say to it?
template <class Change>
std::string complaint_after(Change change) {
  Workspace workspace = valid();
  change(workspace);
  const auto result = validate(workspace);
  if (result) return "valid";
  CHECK(result.error().code == PlanError::invalid_input);
  return result.error().detail;
}

bool starts_with(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

TEST_CASE("a sound workspace is valid, also where obstacles overlap or lie outside", "[world]") {
  CHECK(complaint_after([](Workspace&) {}) == "valid");
  CHECK(complaint_after([](Workspace& w) { disc(w).center = {2, 2}; }) == "valid");
  CHECK(complaint_after([](Workspace& w) { disc(w).center = {-50, 4}; }) == "valid");
  CHECK(complaint_after([](Workspace& w) { disc(w).radius = 0; }) == "valid");
  CHECK(complaint_after([](Workspace& w) { w.safety_radius = 0; }) == "valid");
  CHECK(complaint_after([](Workspace& w) { w.obstacles.clear(); }) == "valid");
  CHECK(complaint_after([](Workspace& w) { w.bounds = {{3, 3}, {3, 3}}; }) == "valid");
  CHECK(complaint_after([](Workspace& w) { polygon(w).outer = {{1, 1}}; }) == "valid");
}

TEST_CASE("a bad coordinate is named with its obstacle, ring and index", "[world]") {
  for (const double bad : {nan, inf, -inf, 0x1p401, -0x1p-401}) {
    CAPTURE(bad);
    CHECK(starts_with(complaint_after([&](Workspace& w) { polygon(w).outer[2].y() = bad; }),
                      "obstacles[0].polygon[2] "));
    CHECK(starts_with(complaint_after([&](Workspace& w) { polygon(w).holes[1][0].x() = bad; }),
                      "obstacles[0].holes[1][0] "));
    CHECK(starts_with(complaint_after([&](Workspace& w) { disc(w).center.x() = bad; }),
                      "obstacles[1].center "));
    CHECK(starts_with(complaint_after([&](Workspace& w) { disc(w).radius = bad; }),
                      "obstacles[1].radius "));
    CHECK(starts_with(complaint_after([&](Workspace& w) { w.bounds.max.y() = bad; }), "bounds "));
    CHECK(starts_with(complaint_after([&](Workspace& w) { w.bounds.min.x() = bad; }), "bounds "));
    CHECK(starts_with(complaint_after([&](Workspace& w) { w.safety_radius = bad; }),
                      "safety_radius "));
  }
}

TEST_CASE("a negative radius is refused", "[world]") {
  CHECK(complaint_after([](Workspace& w) { disc(w).radius = -1; }) ==
        std::string("obstacles[1].radius must not be negative, and ") + detail::coordinate_rule);
  CHECK(complaint_after([](Workspace& w) { w.safety_radius = -0.3; }) ==
        std::string("safety_radius must not be negative, and ") + detail::coordinate_rule);
}

TEST_CASE("a ring without points is named", "[world]") {
  CHECK(complaint_after([](Workspace& w) { polygon(w).outer.clear(); }) ==
        "obstacles[0].polygon has no points");
  CHECK(complaint_after([](Workspace& w) { polygon(w).holes[1].clear(); }) ==
        "obstacles[0].holes[1] has no points");
}

TEST_CASE("bounds without a point are refused", "[world]") {
  CHECK(starts_with(complaint_after([](Workspace& w) { w.bounds.max.x() = -1; }), "bounds "));
  CHECK(starts_with(complaint_after([](Workspace& w) { w.bounds.min.y() = 9; }), "bounds "));
  CHECK(starts_with(complaint_after([](Workspace& w) { w.bounds = Box{}; }), "bounds "));
}

TEST_CASE("coordinates too large for the safety radius are refused at 32 u M", "[world]") {
  const double limit = 0.3 * 1e-3 / (32 * 0x1p-53);
  const auto with = [&](double coordinate) {
    return complaint_after([&](Workspace& w) { polygon(w).holes[0][1].x() = -coordinate; });
  };
  CHECK(with(0.999 * limit) == "valid");
  CHECK(starts_with(with(1.001 * limit), "coordinates are too large"));
  CHECK(starts_with(complaint_after([&](Workspace& w) { w.bounds.max.x() = 1.001 * limit; }),
                    "coordinates are too large"));
  CHECK(starts_with(complaint_after([&](Workspace& w) { disc(w).radius = 1.001 * limit; }),
                    "coordinates are too large"));
  CHECK(complaint_after([&](Workspace& w) {
          w.safety_radius = 0;  // then there is nothing that rounding could eat up
          w.bounds.max.x() = 0x1p400;
        }) == "valid");
}

TEST_CASE("the magnitude is the largest coordinate of bounds, rings, holes and discs", "[world]") {
  Workspace workspace = valid();
  CHECK(workspace.largest_coordinate() == 10);
  polygon(workspace).outer[0] = {-11, 1};
  CHECK(workspace.largest_coordinate() == 11);
  polygon(workspace).holes[1][2] = {1, 12};
  CHECK(workspace.largest_coordinate() == 12);
  disc(workspace) = {{-7, 4}, 6};
  CHECK(workspace.largest_coordinate() == 13);
  disc(workspace) = {{7, 4}, 7};
  CHECK(workspace.largest_coordinate() == 14);
  workspace.bounds.min = {0, -15};
  CHECK(workspace.largest_coordinate() == 15);
}

}  // namespace
