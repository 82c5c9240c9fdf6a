// SPDX-License-Identifier: MIT
// What Python does, in C++: for tests that compare bits, and for benchmarks that compare times.
//
//   tutavia-python-reference plans COUNT            plans on the maze; the bits of every curve
//   tutavia-python-reference calls COUNT            mean time of a plan on the maze [us]
//   tutavia-python-reference batch COUNT            on a map of 1024 x 1024 cells, on all cores:
//                                                   seconds, those of all cores, plans

#include <bit>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <tutavia/tutavia.hpp>
#include <type_traits>
#include <vector>

namespace {

using namespace tutavia;

/// Numbers that Python draws in the same way (SplitMix64).
class Draws {
 public:
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

 private:
  std::uint64_t state_ = 27;
};

void print_number(double x) {
  std::printf(" %016llx", static_cast<unsigned long long>(std::bit_cast<std::uint64_t>(x)));
}

void print_piece(const Piece& piece) {
  const auto print = [](const Point& p) {
    print_number(p.x());
    print_number(p.y());
  };
  piece.visit([&]<class P>(const P& part) {
    if constexpr (std::is_same_v<P, QuadraticBezier> || std::is_same_v<P, CubicBezier>) {
      for (const Point& p : part.points) print(p);
    } else {
      print(part.a);
      print(part.b);
    }
    if constexpr (std::is_same_v<P, Arc>) {
      print(part.center);
      for (const double x : {part.radius, part.start_angle, part.sweep}) print_number(x);
    }
    if constexpr (std::is_same_v<P, Clothoid>) {
      for (const double x :
           {part.start_heading, part.start_curvature, part.sharpness, part.arc_length}) {
        print_number(x);
      }
    }
  });
}

Query draw(Draws& draws, double size) {
  Query query;
  query.start = {size * draws.unit(), 0};
  query.start.y() = size * draws.unit();
  query.goal = {size * draws.unit(), 0};
  query.goal.y() = size * draws.unit();
  return query;
}

LatticeSpace maze() {
  const Scene scene = maps::maze();
  return LatticeSpace::build(scene.workspace, {.resolution = 0.2}).value();
}

/// A plan a line: the code of its failure, or its bounds and pieces as bits.
int print_plans(int count) {
  const LatticeSpace space = maze();
  Planner planner{AStar{}, ClothoidSmoother{}};
  Draws draws;
  for (int i = 0; i < count; ++i) {
    const auto plan = planner.plan(space, draw(draws, 16));
    if (!plan) {
      std::printf("%s\n", to_string(plan.error().code).data());
      continue;
    }
    std::printf("planned");
    for (const double x : {plan->certificate.lower, plan->certificate.upper}) print_number(x);
    for (const Piece& piece : plan->curve.pieces()) print_piece(piece);
    std::printf("\n");
  }
  return 0;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

int time_calls(int count) {
  const LatticeSpace space = maze();
  Planner planner{AStar{}, ClothoidSmoother{}};
  const Query query{.start = {2, 1}, .goal = {1.5, 1.2}};
  for (int i = 0; i < 1000; ++i) (void)planner.plan(space, query);
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < count; ++i) {
    if (!planner.plan(space, query)) return 1;
  }
  std::printf("%.3f\n", 1e6 * seconds_since(start) / count);
  return 0;
}

/// Rectangles on a map of 1024 x 1024 cells.
CellSpace rooms(Draws& draws) {
  auto grid = OccupancyGrid::blocked(1024, 1024).value();
  for (int y = 0; y < 1024; ++y) grid.set_run(y, 0, 1023, true);
  for (int k = 0; k < 400; ++k) {
    const int x = static_cast<int>(draws.next() % 1024), y = static_cast<int>(draws.next() % 1024);
    const int w = 4 + static_cast<int>(draws.next() % 40);
    const int h = 4 + static_cast<int>(draws.next() % 40);
    for (int row = y; row < y + h; ++row) grid.set_run(row, x, x + w - 1, false);
  }
  return CellSpace::build(std::move(grid)).value();
}

int time_batch(int count) {
  Draws draws;
  const CellSpace space = rooms(draws);
  std::vector<Query> queries;
  for (int i = 0; i < count; ++i) queries.push_back(draw(draws, 1024));
  const Planner planner{Jps{}, ClothoidSmoother{}};
  const std::clock_t cpu_start = std::clock();
  const auto start = std::chrono::steady_clock::now();
  const auto plans = plan_batch(planner, space, queries);
  const double seconds = seconds_since(start);
  const double cpu_seconds = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
  std::size_t planned = 0;
  for (const auto& plan : plans) planned += plan ? 1 : 0;
  std::printf("%.3f %.3f %zu\n", seconds, cpu_seconds, planned);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc == 3 ? std::atoi(argv[2]) : 0;
  if (count > 0 && std::strcmp(argv[1], "plans") == 0) return print_plans(count);
  if (count > 0 && std::strcmp(argv[1], "calls") == 0) return time_calls(count);
  if (count > 0 && std::strcmp(argv[1], "batch") == 0) return time_batch(count);
  std::fputs("usage: tutavia-python-reference plans|calls|batch COUNT\n", stderr);
  return 2;
}
