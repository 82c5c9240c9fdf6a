// SPDX-License-Identifier: MIT
#include "tutavia/io/svg_smoothing.hpp"

#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/text_count.hpp"
#include "tutavia/io/svg.hpp"

namespace {

using namespace tutavia;
using test::count;

const Workspace hall{.bounds = {{0, 0}, {8, 4}},
                     .safety_radius = 0.25,
                     .obstacles = {Polygon{{{3, 1}, {5, 1}, {5, 2}, {3, 2}}}}};

Plan plan_with(std::vector<Piece> pieces) {
  Plan plan;
  for (const Piece& piece : pieces) plan.curve.push_back(piece);
  const std::vector<Point> ends{plan.curve.start(), {4, 3.5}, plan.curve.end()};
  plan.route.curve = Curve::polyline(ends);
  return plan;
}

TEST_CASE("pieces show their ends, control polygons and radii in the colours of their kinds") {
  const Plan plan =
      plan_with({Segment{{0.5, 3}, {1, 3}}, CubicBezier{{{{1, 3}, {2, 3}, {2, 2}, {3, 2.5}}}},
                 Arc{{3, 2.5}, {4, 3.5}, {4, 2.5}, 1, std::numbers::pi, -std::numbers::pi / 2},
                 Clothoid::from({4, 3.5}, 0, 0, -0.5, 1)});
  const std::string svg = to_svg(hall, std::span(&plan, 1), {.pieces = true});
  const std::string thin = "\" stroke-width=\"0.9\"", thick = "\" stroke-width=\"2\"";
  const std::string bezier = "stroke=\"#d55e00", arc = "stroke=\"#009e73";
  // 100 pixels per metre, from (16, 16).
  CHECK(count(svg,
              "M116.00 116.00L216.00 116.00M216.00 116.00L216.00 216.00M216.00 216.00L316.00 "
              "166.00\" fill=\"none\" stroke-linejoin=\"round\" " +
                  bezier + thin) == 1);
  CHECK(count(svg,
              "M316.00 166.00L416.00 166.00M416.00 166.00L416.00 66.00\" fill=\"none\" "
              "stroke-linejoin=\"round\" " +
                  arc + thin) == 1);
  CHECK(count(svg, "fill=\"#d55e00\"") == 2);  // the inner control points
  CHECK(count(svg, "fill=\"#009e73\"") == 1);  // the centre
  for (const std::string colour : {"#0072b2", "#d55e00", "#009e73", "#8e2fb8"}) {
    INFO(colour);
    CHECK(count(svg, "stroke=\"" + colour + thick) == 1 + 1);  // and in the legend
  }
  CHECK(count(svg, std::string(detail::SvgStyle::piece_end)) == 5 + 1);
  CHECK(count(svg, ">end of a piece<") == 1);
  CHECK(count(to_svg(hall, std::span(&plan, 1)), "#8e2fb8") == 0);
}

TEST_CASE("the disc of least clearance touches the obstacle that comes nearest") {
  Plan plan = plan_with({Segment{{1, 2.5}, {7, 2.5}}});
  plan.certificate.point = {4, 2.5};
  plan.certificate.upper = 0.5;
  plan.certificate.parameter = 0.5;
  const SvgOptions options{.least_clearance = true};
  const std::string style(detail::SvgStyle::least_clearance);
  const std::string svg = to_svg(hall, std::span(&plan, 1), options);
  CHECK(count(svg, "<circle cx=\"416.00\" cy=\"166.00\" r=\"50.00\" " + style) == 1);
  CHECK(count(svg, ">least clearance, 0.500 m<") == 1);

  // A vehicle's second disc comes nearest: 0.2 m from the obstacle, below the path.
  plan.gears = {Gear::forward};
  plan.route.vehicle = Vehicle{1, true, {{{0, 0}, 0.25}, {{0.25, -0.2}, 0.1}}};
  plan.certificate.point = {4.25, 2.3};
  plan.certificate.upper = 0.2;
  CHECK(count(to_svg(hall, std::span(&plan, 1), options),
              "<circle cx=\"441.00\" cy=\"186.00\" r=\"30.00\" " + style) == 1);

  plan.certificate = {};  // without obstacles there is no such point
  CHECK(count(to_svg(hall, std::span(&plan, 1), options), style) == 0);
}

TEST_CASE("the magnified part lies where the curve turns most, within the map") {
  const Box map{{0, 0}, {8, 4}};
  const auto part_of = [&](const std::vector<Point>& points) {
    return detail::part_with_most_turns(Curve::polyline(points), map);
  };
  const Box zigzag =
      part_of({{0.5, 0.5}, {4, 0.5}, {6, 3}, {6.2, 2.8}, {6.4, 3}, {6.6, 2.8}, {7.5, 3.5}});
  CHECK(zigzag.width() == Approx(2));
  CHECK(zigzag.height() == Approx(1));
  for (const double x : {6.0, 6.2, 6.4, 6.6}) CHECK(zigzag.contains({x, 2.9}));
  CHECK(map.contains(part_of({{0, 0}, {0.1, 4}, {0.2, 0}})));
  // Without turns it is the middle of the curve.
  CHECK(part_of({{2, 2}, {6, 2}}).contains({4, 2}));
  CHECK(part_of({{2, 2}, {2, 2}}).contains({2, 2}));
}

TEST_CASE("smoothing is three pictures, with a profile and a legend below them") {
  Plan plan = plan_with(
      {Segment{{0.5, 2.5}, {6, 2.5}},
       Arc{{6, 2.5}, {6.5, 3}, {6, 3}, 0.5, -std::numbers::pi / 2, std::numbers::pi / 2}});
  plan.certificate.point = {4, 2.5};
  plan.certificate.upper = 0.5;
  SvgOptions options{.width = 300, .labels = {"astar, delta"}, .critical_corners = {{6, 2.5}}};
  const std::string svg = to_svg_smoothing(hall, plan, options);
  CHECK(count(svg, "<svg") == 1 + 2 * 3);
  CHECK(count(svg, "</svg>") == 1 + 2 * 3);
  CHECK(count(svg, ">obstacle<") == 1);
  CHECK(count(svg, ">astar, delta, 6.285 m<") == 1);
  CHECK(count(svg, "nan") == 0);
  // The dots of the route, then those of the curve; one in the legend.
  CHECK(count(svg, std::string(detail::SvgStyle::piece_end)) == 3 + 3 + 1);
  // The start lies outside of the second picture, and the legend shows one of each.
  const std::string start = "r=\"7.00\" fill=\"#ffffff\"", goal = "r=\"7.00\" fill=\"#0072b2\"";
  CHECK(count(svg, start) == 2 + 1);
  CHECK(count(svg, goal) == 3 + 1);
  // A disc and its centre in the last picture alone; critical corners in the second alone.
  CHECK(count(svg, std::string(detail::SvgStyle::least_clearance)) == 2 + 1);
  CHECK(count(svg, "#c1121f") == 1 + 1);
  CHECK(count(svg, "curvature") == 0);
  CHECK(count(svg, std::string(detail::SvgStyle::outline)) == 1);
  Plan drive = plan;  // of a vehicle, the second picture is whole, too
  drive.gears = {Gear::forward, Gear::forward};
  drive.route.gears = drive.gears;
  const std::string whole = to_svg_smoothing(hall, drive, options);
  CHECK(count(whole, start) == 3 + 1);
  CHECK(count(whole, std::string(detail::SvgStyle::outline)) == 0);
  options.profile = true;
  CHECK(count(to_svg_smoothing(hall, plan, options), ">curvature [1/m]<") == 1);
  options.legend = false;
  CHECK(count(to_svg_smoothing(hall, plan, options), ">obstacle<") == 0);
}

}  // namespace
