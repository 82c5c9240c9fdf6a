// SPDX-License-Identifier: MIT
#include "tutavia/search/mesh_on_demand.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "support/random_query.hpp"
#include "support/searcher_contract.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/search/any_angle.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;

CellSpace noise_space(std::uint64_t seed) {
  Random random(seed);
  return CellSpace::build(test::noise_grid(random, 40, 30, 0.2)).value();
}

TEST_CASE("a mesh on demand comes with the query asked for, and for one space alone") {
  const CellSpace space = noise_space(1), copy = space, other = noise_space(1);
  MeshOnDemand demand(3);
  CHECK(demand.next(space) == nullptr);
  CHECK(demand.next(copy) == nullptr);
  CHECK(demand.next(other) == nullptr);  // not counted: equal cells, but another space
  const NavigationMesh* mesh = demand.next(space);
  REQUIRE(mesh != nullptr);
  CHECK(mesh->width() == 40);
  CHECK(mesh->height() == 30);
  CHECK(demand.next(copy) == mesh);
  CHECK(demand.next(other) == nullptr);
  CHECK(MeshOnDemand(0).next(space) != nullptr);
  CHECK(MeshOnDemand(1).next(space) != nullptr);
}

TEST_CASE("threads that count queries together get one mesh") {
  const CellSpace space = noise_space(2);
  MeshOnDemand demand(50);
  std::atomic<std::size_t> without{0}, others{0};
  std::atomic<const NavigationMesh*> first{nullptr};
  const auto work = [&] {
    for (int i = 0; i < 100; ++i) {
      const NavigationMesh *mesh = demand.next(space), *none = nullptr;
      if (mesh == nullptr) {
        ++without;
      } else if (!first.compare_exchange_strong(none, mesh) && none != mesh) {
        ++others;
      }
    }
  };
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) threads.emplace_back(work);
  for (std::thread& thread : threads) thread.join();
  CHECK(first != nullptr);
  CHECK(others == 0);
  CHECK(without >= 49);
}

TEST_CASE("AnyAngle with a mesh on demand finds the same lengths before and after it") {
  const std::uint64_t seed = 3;
  Random random(seed);
  const CellSpace space = noise_space(4);
  const AnyAngle deferred = AnyAngle::prepare_after(10);
  std::size_t found = 0;
  for (int round = 0; round < 40; ++round) {
    INFO("seed " << seed << ", round " << round);
    const Query query = test::random_query(random, space);
    const auto expected = test::search_once(AnyAngle{}, space, query);
    const auto route = test::search_once(deferred, space, query);
    REQUIRE(route.has_value() == expected.has_value());
    if (!route) continue;
    ++found;
    CHECK(route->cost == Approx(expected->cost).epsilon(1e-9));
  }
  CHECK(found > 10);
  CHECK(deferred.mesh_on_demand->next(space) != nullptr);
}

}  // namespace
