// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <new>
#include <type_traits>

#include "tutavia/geometry/arc.hpp"
#include "tutavia/geometry/bezier.hpp"
#include "tutavia/geometry/clothoid.hpp"
#include "tutavia/geometry/segment.hpp"

/// \file
/// Piece: one part of a curve, of any kind.

namespace tutavia {

namespace detail {

/// The kinds of pieces. Every kind has start(), end(), point(t), derivative(t),
/// second_derivative(t), start_direction(), end_direction(), length(), length_to(t), box(),
/// is_finite(), part(from, to), reversed() and nearest_parameter(p); Bezier pieces and clothoids
/// also have deviation() and halves().
template <class P>
concept PieceKind = std::same_as<P, Segment> || std::same_as<P, QuadraticBezier> ||
    std::same_as<P, CubicBezier> || std::same_as<P, Arc> || std::same_as<P, Clothoid>;

}  // namespace detail

/// One part of a curve. It stands for std::variant<Segment, QuadraticBezier, CubicBezier, Arc,
/// Clothoid>, which would instantiate some six hundred functions in every file that includes this
/// header, because Eigen's vectors are not trivially copyable.
class Piece {
 public:
  Piece() : Piece(Segment{}) {}
  Piece(const Segment& piece) : index_(0), segment_(piece) {}            // NOLINT: implicit
  Piece(const QuadraticBezier& piece) : index_(1), quadratic_(piece) {}  // NOLINT: implicit
  Piece(const CubicBezier& piece) : index_(2), cubic_(piece) {}          // NOLINT: implicit
  Piece(const Arc& piece) : index_(3), arc_(piece) {}                    // NOLINT: implicit
  Piece(const Clothoid& piece) : index_(4), clothoid_(piece) {}          // NOLINT: implicit

  Piece(const Piece& other) : index_(other.index_) { copy(other); }
  Piece& operator=(const Piece& other) {
    if (this == &other) return *this;
    index_ = other.index_;
    copy(other);
    return *this;
  }
  ~Piece() = default;

  /// The kind of the piece, numbered in the order of the constructors.
  std::size_t index() const { return index_; }

  /// The piece as a P, or nullptr if it is of another kind.
  template <detail::PieceKind P>
  const P* get_if() const {
    if constexpr (std::is_same_v<P, Segment>) return index_ == 0 ? &segment_ : nullptr;
    if constexpr (std::is_same_v<P, QuadraticBezier>) return index_ == 1 ? &quadratic_ : nullptr;
    if constexpr (std::is_same_v<P, CubicBezier>) return index_ == 2 ? &cubic_ : nullptr;
    if constexpr (std::is_same_v<P, Arc>) return index_ == 3 ? &arc_ : nullptr;
    if constexpr (std::is_same_v<P, Clothoid>) return index_ == 4 ? &clothoid_ : nullptr;
  }
  template <detail::PieceKind P>
  bool holds() const {
    return get_if<P>() != nullptr;
  }

  /// Calls `f` with the piece in its own type.
  template <class F>
  decltype(auto) visit(F&& f) const {
    switch (index_) {
      case 0:
        return f(segment_);
      case 1:
        return f(quadratic_);
      case 2:
        return f(cubic_);
      case 3:
        return f(arc_);
      default:
        return f(clothoid_);
    }
  }

 private:
  void copy(const Piece& other) {
    switch (index_) {
      case 0:
        new (&segment_) Segment(other.segment_);
        break;
      case 1:
        new (&quadratic_) QuadraticBezier(other.quadratic_);
        break;
      case 2:
        new (&cubic_) CubicBezier(other.cubic_);
        break;
      case 3:
        new (&arc_) Arc(other.arc_);
        break;
      default:
        new (&clothoid_) Clothoid(other.clothoid_);
    }
  }

  std::size_t index_;
  union {  // all trivially destructible
    Segment segment_;
    QuadraticBezier quadratic_;
    CubicBezier cubic_;
    Arc arc_;
    Clothoid clothoid_;
  };
};

/// Start of a piece of any kind.
inline Point start_of(const Piece& piece) {
  return piece.visit([](const auto& p) -> Point { return p.start(); });
}

/// End of a piece of any kind.
inline Point end_of(const Piece& piece) {
  return piece.visit([](const auto& p) -> Point { return p.end(); });
}

}  // namespace tutavia
