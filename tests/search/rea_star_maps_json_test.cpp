// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>

#include "support/catch.hpp"
#include "support/free_route.hpp"
#include "support/paper_maps.hpp"
#include "tutavia/search/improved_rea_star.hpp"
#include "tutavia/search/rea_star.hpp"
#include "tutavia/search/sb_rea_star.hpp"

namespace {

using namespace tutavia;

TEST_CASE("rectangle expansion on the maps of its paper, safety buffer included") {
  const std::array shortest{93.4558, 147.1127, 63.669};  // with the buffer, in cells
  const auto maps = test::rea_maps();
  REQUIRE(maps.size() == shortest.size());
  for (std::size_t i = 0; i < maps.size(); ++i) {
    INFO("map " << maps[i].name);
    CHECK(maps[i].buffered().exempted.empty());
    const test::PaperTask task = maps[i].task();
    NoObserver no_observer;
    const auto check = [&](const auto& search) {
      typename std::decay_t<decltype(search)>::Scratch scratch;
      const auto route = search.search(task.space, task.query, scratch, no_observer);
      REQUIRE(route);
      CHECK(test::is_free(task.space, *route));
      CHECK(route->curve.length() <= 1.25 * shortest[i]);
      return route->cost;
    };
    CHECK(check(ReaStar{}) == Approx(shortest[i]).margin(1e-3));
    check(SbReaStar{});
    check(ImprovedReaStar{});
  }
}

}  // namespace
