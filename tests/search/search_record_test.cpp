// SPDX-License-Identifier: MIT
#include "tutavia/search/search_record.hpp"

#include <cstddef>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/random_grids.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/search/rea_star.hpp"
#include "tutavia/search/sb_rea_star.hpp"
#include "tutavia/space/cell_space.hpp"

namespace {

using namespace tutavia;
using Kind = SearchRecord::Event::Kind;

static_assert(Observer<SearchRecord>);
static_assert(RectangleObserver<SearchRecord>);
static_assert(AnytimeObserver<SearchRecord>);

/// Observers of rectangles that take the side and that do not.
struct Simple : NoObserver {
  std::size_t rectangles = 0;
  void on_rectangle(const Segment&, const Box&) { ++rectangles; }
};
struct Sided : NoObserver {
  std::size_t from_start = 0, from_goal = 0;
  void on_rectangle(const Segment&, const Box&, SearchSide side) {
    ++(side == SearchSide::start ? from_start : from_goal);
  }
};
static_assert(RectangleObserver<Simple>);
static_assert(RectangleObserver<Sided>);
static_assert(!RectangleObserver<NoObserver>);

TEST_CASE("a record keeps what happened, in order") {
  SearchRecord record;
  record.generated({1, 2});
  record.expanded({3, 4});
  record.on_rectangle({{0, 0}, {2, 0}}, {{0, 0}, {2, 5}}, SearchSide::goal);
  record.edge({1, 1}, {2, 3});
  REQUIRE(record.events.size() == 5);
  const Kind kinds[] = {Kind::generated, Kind::expanded, Kind::interval, Kind::rectangle,
                        Kind::edge};
  for (std::size_t i = 0; i < 5; ++i) CHECK(record.events[i].kind == kinds[i]);
  CHECK(record.events[0].a == Point(1, 2));
  CHECK(record.events[2].b == Point(2, 0));
  CHECK(record.events[3].b == Point(2, 5));
  CHECK(record.events[4].b == Point(2, 3));
  CHECK(record.events[2].side == SearchSide::goal);
  CHECK(record.events[3].side == SearchSide::goal);
  record.on_rectangle({{0, 0}, {2, 0}}, {{0, 0}, {2, 5}});
  CHECK(record.events[5].side == SearchSide::start);
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

TEST_CASE("rectangles tell the side of the search from which they were reached") {
  auto grid = test::free_grid(12, 9);
  for (int y = 0; y < 7; ++y) grid.set({6, y}, false);
  const auto space = CellSpace::build(std::move(grid)).value();
  const Query query{.start = {0.5, 0.5}, .goal = {11.5, 0.5}};
  Sided sided;
  SbReaStar::Scratch scratch;
  REQUIRE(SbReaStar{}.search(space, query, scratch, sided));
  CHECK(sided.from_start > 0);
  CHECK(sided.from_goal > 0);
  Simple simple;
  REQUIRE(SbReaStar{}.search(space, query, scratch, simple));
  CHECK(simple.rectangles == sided.from_start + sided.from_goal);

  SearchRecord record{.keeps_nodes = false};
  REQUIRE(SbReaStar{}.search(space, query, scratch, record));
  // The first rectangles hold the ends of the query.
  REQUIRE(record.events.size() > 3);
  CHECK(record.events[1].side == SearchSide::start);
  CHECK(Box{record.events[1].a, record.events[1].b}.contains(query.start));
  CHECK(record.events[3].side == SearchSide::goal);
  CHECK(Box{record.events[3].a, record.events[3].b}.contains(query.goal));

  Sided one_sided;
  ReaStar::Scratch of_one_side;
  REQUIRE(ReaStar{}.search(space, query, of_one_side, one_sided));
  CHECK(one_sided.from_start > 0);
  CHECK(one_sided.from_goal == 0);
}

TEST_CASE("a record keeps the last of the improved paths of a tree") {
  SearchRecord record;
  CHECK(record.tree_path.empty());
  record.improved(Curve::polyline(std::vector<Point>{{0, 0}, {1, 3}, {2, 0}}), 7);
  record.improved(Curve::polyline(std::vector<Point>{{0, 0}, {1, 1}, {2, 0}}), 3);
  CHECK(waypoints(record.tree_path) == std::vector<Point>{{0, 0}, {1, 1}, {2, 0}});
}

}  // namespace
