// SPDX-License-Identifier: MIT
// The edges and corners that CellSpace visits.
#include "tutavia/space/cell_space.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>

#include "support/catch.hpp"
#include "support/cell_oracle.hpp"
#include "support/random_cells.hpp"
#include "support/scale.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::test;

TEST_CASE("every edge of the blocked cells that they do not share is visited once in a box") {
  std::size_t in_box = 0;
  on_random_cells({.seed = 7, .rounds = scaled(400), .large_every = 8}, [&](const CellTrial& t) {
    const auto [low, high] = random_box(t.random, t.squares);
    using Line = std::tuple<std::int64_t, std::int64_t, std::int64_t, std::int64_t>;
    std::map<Line, int> visits;
    bool are_lines = true;
    t.space.for_each_feature(
        {point_at(t.space, low), point_at(t.space, high)}, [&](const Segment& edge, double radius) {
          const auto a = place_of(t.space, edge.a), b = place_of(t.space, edge.b);
          const auto [first, last] = std::minmax(a, b);
          ++visits[{first.first, first.second, last.first, last.second}];
          are_lines = are_lines && radius == 0;
        });
    CHECK(are_lines);
    std::set<Line> real;
    std::size_t missed = 0;
    for (const CellEdge& e : t.squares.edges) {
      const Rectangle& r = e.line;
      const Line line{r.x0, r.y0, r.x1, r.y1};
      real.insert(line);
      if (r.x0 > high.x || r.x1 < low.x || r.y0 > high.y || r.y1 < low.y) continue;
      ++in_box;
      if (visits[line] != 1) ++missed;
    }
    CHECK(missed == 0);
    const bool invented = std::any_of(visits.begin(), visits.end(), [&](const auto& visit) {
      return visit.second > 1 || real.count(visit.first) == 0;
    });
    CHECK_FALSE(invented);
  });
  CHECK(in_box > scaled(400));
}

TEST_CASE("the convex corners of the blocked cells in a box are visited, each by one number") {
  std::size_t corners = 0;
  on_random_cells({.seed = 8, .rounds = scaled(400), .large_every = 8}, [&](const CellTrial& t) {
    // Convex: some blocked cell has it as a corner at which neither of its two sides goes on.
    std::set<std::pair<std::int64_t, std::int64_t>> convex;
    for (int y = 0; y < t.map.height(); ++y) {
      for (int x = 0; x < t.map.width(); ++x) {
        if (!is_blocked(t.map, x, y)) continue;
        for (const int dx : {0, 1}) {
          for (const int dy : {0, 1}) {
            const bool beside = is_blocked(t.map, x + (dx == 1 ? 1 : -1), y);
            const bool above = is_blocked(t.map, x, y + (dy == 1 ? 1 : -1));
            const bool across = is_blocked(t.map, x + (dx == 1 ? 1 : -1), y + (dy == 1 ? 1 : -1));
            const bool pinched = across && !beside && !above;
            if (!beside && !above && (!across || pinched)) {
              convex.insert({4 * (x + dx), 4 * (y + dy)});
            }
          }
        }
      }
    }
    std::map<std::uint32_t, std::pair<std::int64_t, std::int64_t>> numbers;
    for (int i = 0; i < 3; ++i) {
      const auto [low, high] = random_box(t.random, t.squares);
      auto expected = convex;
      std::erase_if(expected, [&, l = low, h = high](const auto& at) {
        return at.first < l.x || at.first > h.x || at.second < l.y || at.second > h.y;
      });
      std::set<std::pair<std::int64_t, std::int64_t>> visited;
      std::size_t visits = 0;
      bool as_documented = true;
      t.space.for_each_corner(
          {point_at(t.space, low), point_at(t.space, high)}, [&](const Corner& corner) {
            const auto at = place_of(t.space, corner.position);
            visited.insert(at);
            ++visits;
            as_documented = as_documented && corner.radius == 0 &&
                            corner.exterior_angle == Approx(std::numbers::pi / 2) &&
                            numbers.emplace(corner.id, at).first->second == at &&
                            corner.position == point_at(t.space, {at.first, at.second});
          });
      CHECK(visited == expected);
      CHECK(visits == expected.size());
      CHECK(as_documented);
      corners += visits;
    }
  });
  CHECK(corners > scaled(1000));
}

}  // namespace
