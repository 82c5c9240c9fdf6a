// SPDX-License-Identifier: MIT
#include "tutavia/search/navigation_mesh.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "support/scale.hpp"

namespace {

using namespace tutavia;
using Piece = NavigationMesh::Piece;

Point place(Cell corner) { return {double(corner.x), double(corner.y)}; }

std::vector<Piece> around(const NavigationMesh& mesh, const Point& p) {
  std::vector<Piece> pieces;
  mesh.for_each_near({static_cast<int>(p.x()), static_cast<int>(p.y())}, [&](Piece piece) {
    if (mesh.holds(piece, p, place)) pieces.push_back(piece);
  });
  return pieces;
}

TEST_CASE("polygons cover every free cell and no blocked one") {
  const std::uint64_t seed = 650;
  Random random(seed);
  std::size_t merged = 0, cells = 0;
  for (std::size_t round = 0; round < test::scaled(100); ++round) {
    INFO("seed " << seed << ", round " << round);
    const OccupancyGrid grid = test::random_grid(random, 30);
    const NavigationMesh mesh = NavigationMesh::build(grid).value();
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        // Off all lines between lattice points this near: in one polygon at most.
        const Point p(x + 0.5 + 1e-6, y + 0.5 + 1e-9);
        const std::size_t inside = around(mesh, p).size();
        REQUIRE(inside == (grid.is_free(Cell{x, y}) ? 1 : 0));
      }
    }
    merged += mesh.size();
    cells += grid.count_free();
    // Sides are shared by two.
    for (Piece piece = 0; piece < mesh.size(); ++piece) {
      mesh.for_each_exit(piece, [&](Cell right, Cell left, Piece beyond) {
        bool back = false;
        mesh.for_each_exit(beyond, [&](Cell r, Cell l, Piece b) {
          back = back || (r == left && l == right && b == piece);
        });
        CHECK(back);
      });
    }
  }
  CHECK(merged < cells / 2);
}

TEST_CASE("dead ends lead out, and the rest is a web of rings") {
  const std::uint64_t seed = 651;
  Random random(seed);
  std::size_t dead_ends = 0, others = 0;
  for (std::size_t round = 0; round < test::scaled(100); ++round) {
    INFO("seed " << seed << ", round " << round);
    const NavigationMesh mesh = NavigationMesh::build(test::random_grid(random, 30)).value();
    for (Piece piece = 0; piece < mesh.size(); ++piece) {
      std::size_t ways = 0;
      bool is_neighbour = mesh.exit_of_dead_end(piece) == piece;
      mesh.for_each_exit(piece, [&](Cell, Cell, Piece beyond) {
        ways += mesh.is_dead_end(beyond) ? 0 : 1;
        is_neighbour = is_neighbour || beyond == mesh.exit_of_dead_end(piece);
      });
      if (mesh.is_dead_end(piece)) {
        ++dead_ends;
        CHECK(ways <= 1);
        CHECK(is_neighbour);
        // Out of the dead end, in fewer steps than there are polygons.
        Piece at = piece;
        std::size_t steps = 0;
        while (mesh.is_dead_end(at) && mesh.exit_of_dead_end(at) != at && steps <= mesh.size()) {
          at = mesh.exit_of_dead_end(at);
          ++steps;
        }
        CHECK(steps <= mesh.size());
      } else {
        ++others;
        CHECK(ways >= 2);
      }
    }
  }
  CHECK(dead_ends > 100);
  CHECK(others > 100);
}

TEST_CASE("a navigation mesh is kept as bytes, and refused where it does not fit") {
  Random random(652);
  int mended = 0, refusals = 0;
  for (int round = 0; round < 50; ++round) {
    const OccupancyGrid grid = test::random_grid(random, 20);
    const NavigationMesh mesh = NavigationMesh::build(grid).value();
    const std::string bytes = mesh.to_bytes();
    const auto again = NavigationMesh::from_bytes(bytes, grid);
    REQUIRE(again);
    CHECK(again->to_bytes() == bytes);
    CHECK(again->size() == mesh.size());

    // Every change of a byte is noticed, or gives another decomposition of the same cells.
    std::string damaged = bytes;
    const std::size_t at = random.below(static_cast<std::uint32_t>(bytes.size()));
    damaged[at] = static_cast<char>(damaged[at] ^ static_cast<char>(1 + random.below(255)));
    if (const auto other_mesh = NavigationMesh::from_bytes(damaged, grid)) {
      ++mended;
      for (int y = 0; y < grid.height(); ++y) {
        for (int x = 0; x < grid.width(); ++x) {
          const std::size_t inside =
              around(*other_mesh, Point(x + 0.5 + 1e-6, y + 0.5 + 1e-9)).size();
          CHECK(inside == (grid.is_free(Cell{x, y}) ? 1 : 0));
        }
      }
    }
    if (mesh.size() == 0) continue;
    ++refusals;
    CHECK_FALSE(NavigationMesh::from_bytes(bytes.substr(0, bytes.size() - 1), grid));
    OccupancyGrid other = grid;
    const Cell cell = test::random_cell(random, grid);
    other.set(cell, !grid.is_free(cell));
    const auto refused = NavigationMesh::from_bytes(bytes, other);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == PlanError::invalid_input);
  }
  CHECK(mended < 25);
  CHECK(refusals > 25);
  CHECK_FALSE(NavigationMesh::from_bytes("", OccupancyGrid()));
  CHECK_FALSE(NavigationMesh::from_bytes("tutavia jump table 2\n", OccupancyGrid()));
}

TEST_CASE("grids beyond the mesh's integers are refused") {
  const auto grid = OccupancyGrid::blocked(NavigationMesh::max_side + 1, 1).value();
  const auto mesh = NavigationMesh::build(grid);
  REQUIRE_FALSE(mesh);
  CHECK(mesh.error().code == PlanError::limit_exceeded);
  CHECK_FALSE(NavigationMesh::from_bytes("", grid));
  auto longest = OccupancyGrid::blocked(NavigationMesh::max_side, 2).value();
  longest.set_run(0, 0, NavigationMesh::max_side - 1, true);
  longest.set_run(1, 100, 200, true);
  CHECK(NavigationMesh::build(longest).value().size() == 2);
  CHECK(NavigationMesh::build(OccupancyGrid()).value().size() == 0);
}

}  // namespace
