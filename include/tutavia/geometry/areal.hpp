// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <vector>

#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/polygon.hpp"

/// \file
/// Areal: types that describe areas, and their conversion to polygons.

namespace tutavia {

/// How a type that describes an area becomes polygons. Specialise it for a type of your own, with
/// `static std::vector<Polygon> polygons(const G& geometry)`. geometry/boost_adapt.hpp does so for
/// the areal types of Boost.Geometry.
template <class G>
struct ArealTraits {};

template <>
struct ArealTraits<Polygon> {
  static std::vector<Polygon> polygons(const Polygon& polygon) { return {polygon}; }
};

template <>
struct ArealTraits<std::vector<Polygon>> {
  static std::vector<Polygon> polygons(const std::vector<Polygon>& polygons) { return polygons; }
};

template <>
struct ArealTraits<Ring> {
  static std::vector<Polygon> polygons(const Ring& ring) { return {Polygon{ring}}; }
};

template <>
struct ArealTraits<Box> {
  static std::vector<Polygon> polygons(const Box& box) {
    return {Polygon{{box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}}}};
  }
};

/// A type that describes an area: a polygon, a ring, a box, several polygons, or a type with
/// `ArealTraits`.
///
/// Example: examples/obstacle_sources.cpp.
template <class G>
concept Areal = requires(const G& geometry) {
  { ArealTraits<G>::polygons(geometry) } -> std::same_as<std::vector<Polygon>>;
};

/// The polygons of an area.
template <Areal G>
std::vector<Polygon> to_polygons(const G& geometry) {
  return ArealTraits<G>::polygons(geometry);
}

}  // namespace tutavia
