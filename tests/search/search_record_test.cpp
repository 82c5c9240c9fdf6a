// SPDX-License-Identifier: MIT
#include "tutavia/search/search_record.hpp"

#include <cstddef>

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/rea_star.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;
using Kind = SearchRecord::Event::Kind;

static_assert(Observer<SearchRecord>);
static_assert(RectangleObserver<SearchRecord>);

TEST_CASE("a record keeps what happened, in order") {
  SearchRecord record;
  record.generated({1, 2});
  record.expanded({3, 4});
  record.on_rectangle({{0, 0}, {2, 0}}, {{0, 0}, {2, 5}});
  record.edge({1, 1}, {2, 3});
  REQUIRE(record.events.size() == 5);
  const Kind kinds[] = {Kind::generated, Kind::expanded, Kind::interval, Kind::rectangle,
                        Kind::edge};
  for (std::size_t i = 0; i < 5; ++i) CHECK(record.events[i].kind == kinds[i]);
  CHECK(record.events[0].a == Point(1, 2));
  CHECK(record.events[2].b == Point(2, 0));
  CHECK(record.events[3].b == Point(2, 5));
  CHECK(record.events[4].b == Point(2, 3));
}

TEST_CASE("a record that keeps no nodes still keeps rectangles and edges") {
  SearchRecord record{.keeps_nodes = false};
  record.generated({1, 2});
  record.expanded({3, 4});
  CHECK(record.events.empty());
  record.edge({1, 1}, {2, 3});
  record.on_rectangle({{0, 0}, {2, 0}}, {{0, 0}, {2, 5}});
  CHECK(record.events.size() == 3);
}

TEST_CASE("a record of a search holds as many events as its statistics count") {
  const auto space = CellSpace::build(test::free_grid(12, 9)).value();
  const Query query{.start = {0.5, 0.5}, .goal = {8.5, 7.5}};
  SearchRecord record;
  AStar::Scratch scratch;
  const auto route = AStar{}.search(space, query, scratch, record).value();
  CHECK(record.events.size() == route.stats.expanded + route.stats.generated);
  SearchRecord rectangles{.keeps_nodes = false};
  ReaStar::Scratch of_rectangles;
  REQUIRE(ReaStar{}.search(space, query, of_rectangles, rectangles));
  CHECK_FALSE(rectangles.events.empty());
}

}  // namespace
