// SPDX-License-Identifier: MIT
#include "tutavia/plan/vehicle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/catch.hpp"

namespace {

using namespace tutavia;

bool covers(const Vehicle& vehicle, const Point& p) {
  return std::any_of(vehicle.footprint.begin(), vehicle.footprint.end(),
                     [&](const auto& disc) { return distance(p, disc.offset) <= disc.radius; });
}

TEST_CASE("the discs of a car cover it and stay within the margin") {
  struct Car {
    double length, width, wheelbase, margin;
    std::size_t most;
  };
  for (const Car& car : {Car{4.5, 1.8, 2.7, 0.1, 9}, Car{4.5, 1.8, 2.7, 0.05, 14},
                         Car{0.9, 0.6, 0, 0.05, 9}, Car{1, 2, 0.5, 0.1, 13}, Car{2, 2, 2, 1, 1},
                         Car{12, 2.5, 6, 0.02, 43}, Car{4.5, 1.8, 2.7, 0.3, 7}}) {
    INFO(car.length << " x " << car.width << ", margin " << car.margin);
    const Vehicle vehicle = Vehicle::car(car.length, car.width, car.wheelbase, 5, true, car.margin);
    CHECK(vehicle.footprint.size() <= car.most);
    const double middle = car.wheelbase / 2;
    int open = 0;
    for (int i = 0; i <= 400; ++i) {
      for (int j = 0; j <= 400; ++j) {
        const Point p{middle + car.length * (i / 400.0 - 0.5), car.width * (j / 400.0 - 0.5)};
        if (!covers(vehicle, p)) ++open;
      }
    }
    CHECK(open == 0);
    for (const FootprintDisc& disc : vehicle.footprint) {
      const double x = std::abs(disc.offset.x() - middle), y = std::abs(disc.offset.y());
      CHECK(x + disc.radius <= car.length / 2 + car.margin * (1 + 1e-9));
      CHECK(y + disc.radius <= car.width / 2 + car.margin * (1 + 1e-9));
    }
  }
}

TEST_CASE("the reach of a footprint is that of its farthest point") {
  CHECK(Vehicle::point().reach() == 0);
  CHECK(Vehicle::disc(0.4).reach() == 0.4);
  const double corner = std::hypot(1.35 + 2.25, 0.9);
  const double reach = Vehicle::car(4.5, 1.8, 2.7, 5).reach();
  CHECK(reach >= corner);
  CHECK(reach <= corner + 0.1);
}

TEST_CASE("an invalid vehicle is refused by the name of its option") {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto refused = [](const Vehicle& vehicle, const char* name) {
    const auto valid = validate(vehicle);
    REQUIRE_FALSE(valid);
    CHECK(valid.error().code == PlanError::invalid_option);
    INFO(valid.error().detail);
    CHECK(valid.error().detail.find(name) != std::string::npos);
  };
  for (const double bad : {-1.0, infinity, std::nan("")}) {
    refused(Vehicle::point(bad), "min_turning_radius");
    refused({1, true, {{{0, 0}, 1}, {{0, 0}, bad}}}, "disc 1 of the footprint");
    if (bad != -1) refused({1, true, {{{bad, 0}, 1}}}, "disc 0 of the footprint");
  }
  for (const double tiny : {1e-300, 9.9e-10}) {
    refused(Vehicle::point(tiny), "min_turning_radius must be at least 1e-9 m");
  }
  CHECK(validate(Vehicle::point(1e-9)));
  refused({1, true, {}}, "footprint");
  refused({0, true, {{{0, 0}, 1}, {{1, 0}, 1}}}, "min_turning_radius");
  CHECK(validate(Vehicle::point()));
  CHECK(validate(Vehicle::disc(1)));
  CHECK(validate(Vehicle::car(4.5, 1.8, 2.7, 5)));
}

}  // namespace
