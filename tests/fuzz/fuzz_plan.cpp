// SPDX-License-Identifier: MIT
/// \file
/// Any bytes as a world and a query: whatever the planner returns, the exact checker accepts.

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "support/exact_checker.hpp"
#include "support/registry.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/space/lattice_space.hpp"

namespace {

using namespace tutavia;

/// Reads numbers off the fuzzer's bytes; zeros when they have run out.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  std::uint8_t byte() { return next_ < size_ ? data_[next_++] : std::uint8_t{0}; }

  /// Mostly a multiple of 1/8 between 0 and 31.9, so that things coincide; at times any double.
  double coordinate() {
    const std::uint8_t first = byte();
    if (first != 0xff) return first / 8.0;
    std::array<std::uint8_t, 8> raw;
    for (std::uint8_t& b : raw) b = byte();
    double value = 0;
    std::memcpy(&value, raw.data(), sizeof value);
    return value;
  }
  Point point() {
    const double x = coordinate();
    return {x, coordinate()};
  }
  Ring ring() {
    Ring points;
    for (int count = 1 + byte() % 8; count > 0; --count) points.push_back(point());
    return points;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
  std::size_t next_ = 0;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  Workspace world{.bounds = {{0, 0}, {32, 32}}};
  const std::uint8_t radius = bytes.byte();
  world.safety_radius = radius < 128 ? radius / 16.0 : bytes.coordinate();
  Query query{.start = bytes.point(), .goal = bytes.point()};
  query.budget.max_expansions = 5000;
  for (int count = bytes.byte() % 8; count > 0; --count) {
    switch (bytes.byte() % 3) {
      case 0:
        world.obstacles.emplace_back(Disc{bytes.point(), bytes.coordinate()});
        break;
      case 1:
        world.obstacles.emplace_back(Polygon{bytes.ring()});
        break;
      default: {
        Polygon polygon{bytes.ring()};
        polygon.holes.push_back(bytes.ring());
        world.obstacles.emplace_back(std::move(polygon));
      }
    }
  }
  const auto space = LatticeSpace::build(world, {.resolution = 1});
  if (!space) return 0;
  const test::ExactChecker checker(world);
  for (const auto& smoother : all_smoothers<LatticeSpace>()) {
    Planner planner(AStar{}, smoother);
    const auto plan = planner.plan(*space, query);
    if (!plan) continue;
    const bool ends_exact = plan->curve.start() == query.start && plan->curve.end() == query.goal;
    if (!ends_exact || checker.check(plan->curve) == test::ExactVerdict::blocked) {
      std::fprintf(stderr, "an unsafe path by %s\n", std::string(smoother.name).c_str());
      std::abort();
    }
  }
  return 0;
}
