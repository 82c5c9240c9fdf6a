// SPDX-License-Identifier: MIT
#include "tutavia/io/text/svg_plot.hpp"

#include <limits>

#include "support/catch.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

std::string plotted(const std::vector<Point>& points) {
  SvgWriter svg;
  SvgPlot(svg, {{0, 0}, {100, 50}}, {10, 5}).curve(points, "");
  const std::string text = svg.finish(100, 50);
  const std::size_t begin = text.find("d=\"M");
  return begin == std::string::npos ? ""
                                    : text.substr(begin + 3, text.find('"', begin + 3) - begin - 3);
}

TEST_CASE("steps of axes are round numbers") {
  CHECK(tick_step(10, 10) == Approx(1));
  CHECK(tick_step(10, 9) == Approx(2));
  CHECK(tick_step(0.3, 5) == Approx(0.1));
  CHECK(tick_step(450, 10) == Approx(50));
  CHECK(tick_step(60, 6.5) == Approx(10));
  for (const double range : {1e-300, 0.07, 1e300}) {
    INFO(range);
    CHECK(range / tick_step(range, 5) <= 5 * (1 + 1e-9));
    CHECK(range / tick_step(range, 5) >= 2 * (1 - 1e-9));
  }
}

TEST_CASE("curves are clipped to the plot, without what is on a line or no number") {
  CHECK(plotted({{0, 0}, {5, 2.5}, {10, 5}}) == "M0.00 50.00L100.00 0.00");
  CHECK(plotted({{0, 0}, {5, 9}, {10, 0}}) == "M0.00 50.00L50.00 0.00L100.00 50.00");
  CHECK(plotted({{0, 1}, {5, 1}, {5, 3}, {10, 3}}) ==
        "M0.00 40.00L50.00 40.00L50.00 20.00L100.00 20.00");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(plotted({{0, 0}, {3, nan}, {10, 0}}) == "M0.00 50.00L100.00 50.00");
  CHECK(plotted({{0, nan}}).empty());
}

TEST_CASE("axes of any range end") {
  for (const double range : {0.0, 1e-320, 1.0, 1e308, std::numeric_limits<double>::infinity()}) {
    SvgWriter svg;
    SvgPlot(svg, {{0, 0}, {700, 100}}, {range, range}).axes("y", "");
    const std::string text = svg.finish(700, 100);
    CHECK(text.size() < 10000);
    CHECK(text.find("nan") == std::string::npos);
    CHECK(text.find("inf") == std::string::npos);
  }
}

}  // namespace
