// SPDX-License-Identifier: MIT
#include "tutavia/geometry/piece.hpp"

#include <type_traits>
#include <vector>

#include "support/catch.hpp"

namespace {

using namespace tutavia;

static_assert(std::is_trivially_destructible_v<Piece>);
static_assert(std::is_trivially_destructible_v<Segment> && std::is_trivially_destructible_v<Arc> &&
              std::is_trivially_destructible_v<QuadraticBezier> &&
              std::is_trivially_destructible_v<CubicBezier> &&
              std::is_trivially_destructible_v<Clothoid>);

std::vector<Piece> one_of_each_kind() {
  return {Segment{{1, 2}, {3, 4}}, QuadraticBezier{{Point{1, 0}, Point{2, 0}, Point{3, 1}}},
          CubicBezier{{Point{1, 0}, Point{2, 0}, Point{3, 1}, Point{4, 5}}},
          Arc::around({1, 2}, 3, 0.5, -1), Clothoid::from({1, 2}, 0.3, 0.4, -0.5, 0.6)};
}

template <class P>
void check_is(const Piece& piece, const P& original) {
  REQUIRE(piece.holds<P>());
  CHECK(piece.get_if<P>()->start() == original.start());
  CHECK(piece.get_if<P>()->end() == original.end());
  CHECK(start_of(piece) == original.start());
  CHECK(end_of(piece) == original.end());
}

TEST_CASE("a piece is of the kind that it was made from, and of no other") {
  const auto pieces = one_of_each_kind();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& piece = pieces[i];
    CHECK(piece.index() == i);
    const std::vector<bool> kinds{piece.holds<Segment>(), piece.holds<QuadraticBezier>(),
                                  piece.holds<CubicBezier>(), piece.holds<Arc>(),
                                  piece.holds<Clothoid>()};
    for (std::size_t k = 0; k < kinds.size(); ++k) CHECK(kinds[k] == (k == i));
    piece.visit([&](const auto& p) { check_is(piece, p); });
  }
  CHECK(Piece().get_if<Arc>() == nullptr);
  CHECK(end_of(Piece()) == Point(0, 0));
}

TEST_CASE("a piece becomes a copy of any other, itself included") {
  const auto pieces = one_of_each_kind();
  for (const Piece& from : pieces) {
    for (const Piece& to : pieces) {
      Piece copy(from);
      copy = to;
      CHECK(copy.index() == to.index());
      to.visit([&](const auto& p) { check_is(copy, p); });
      const Piece& same = copy;
      copy = same;
      to.visit([&](const auto& p) { check_is(copy, p); });
    }
  }
}

}  // namespace
