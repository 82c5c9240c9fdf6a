// SPDX-License-Identifier: MIT
#pragma once

#include <boost/geometry/core/access.hpp>
#include <boost/geometry/core/closure.hpp>
#include <boost/geometry/core/coordinate_dimension.hpp>
#include <boost/geometry/core/coordinate_system.hpp>
#include <boost/geometry/core/coordinate_type.hpp>
#include <boost/geometry/core/cs.hpp>
#include <boost/geometry/core/exterior_ring.hpp>
#include <boost/geometry/core/interior_rings.hpp>
#include <boost/geometry/core/point_order.hpp>
#include <boost/geometry/core/point_type.hpp>
#include <boost/geometry/core/ring_type.hpp>
#include <boost/geometry/core/tag.hpp>
#include <boost/geometry/core/tags.hpp>
#include <boost/mpl/int.hpp>
#include <boost/range/begin.hpp>
#include <boost/range/end.hpp>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "tutavia/geometry/areal.hpp"
#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/geometry/polygon.hpp"

/// \file
/// Point, Ring, Polygon and Box as models of Boost.Geometry, and its areal types as obstacles.
///
/// Not part of an umbrella, because it needs Boost (1.74 or later). Include it in every file that
/// uses these types with Boost.Geometry, before the first use; include the algorithms of
/// Boost.Geometry (<boost/geometry.hpp>) yourself.
///
/// All four types can be read and written: `read_wkt`, `convert`, `buffer`, `difference` and the
/// other algorithms take them as input and as output. `std::vector<Polygon>` is a multi-polygon.
///
/// A model of Boost.Geometry states at compile time how its rings run: Ring and Polygon are open
/// (the first point is not repeated) and counterclockwise, holes clockwise, as OGC and GeoJSON
/// prescribe; what Boost.Geometry writes into them is so. tutavia itself takes rings of either
/// orientation, closed or not. Call `boost::geometry::correct` before you pass rings of unknown
/// orientation to Boost.Geometry: without it, `area` of a clockwise ring is negative and `within`
/// is wrong, as for any of its models.
///
/// Point is Eigen::Vector2d. A program that already registers that type as a point must not include
/// this header.

namespace boost::geometry::traits {

template <>
struct tag<tutavia::Point> {
  using type = point_tag;
};
template <>
struct coordinate_type<tutavia::Point> {
  using type = double;
};
template <>
struct coordinate_system<tutavia::Point> {
  using type = cs::cartesian;
};
template <>
struct dimension<tutavia::Point> : boost::mpl::int_<2> {};
template <std::size_t Dimension>
struct access<tutavia::Point, Dimension> {
  static double get(const tutavia::Point& p) { return p[Dimension]; }
  static void set(tutavia::Point& p, double x) { p[Dimension] = x; }
};

template <>
struct tag<tutavia::Box> {
  using type = box_tag;
};
template <>
struct point_type<tutavia::Box> {
  using type = tutavia::Point;
};
template <std::size_t Dimension>
struct indexed_access<tutavia::Box, min_corner, Dimension> {
  static double get(const tutavia::Box& box) { return box.min[Dimension]; }
  static void set(tutavia::Box& box, double x) { box.min[Dimension] = x; }
};
template <std::size_t Dimension>
struct indexed_access<tutavia::Box, max_corner, Dimension> {
  static double get(const tutavia::Box& box) { return box.max[Dimension]; }
  static void set(tutavia::Box& box, double x) { box.max[Dimension] = x; }
};

template <>
struct tag<tutavia::Ring> {
  using type = ring_tag;
};
template <>
struct point_order<tutavia::Ring> {
  static constexpr order_selector value = counterclockwise;
};
template <>
struct closure<tutavia::Ring> {
  static constexpr closure_selector value = open;
};

template <>
struct tag<tutavia::Polygon> {
  using type = polygon_tag;
};
template <>
struct ring_const_type<tutavia::Polygon> {
  using type = const tutavia::Ring&;
};
template <>
struct ring_mutable_type<tutavia::Polygon> {
  using type = tutavia::Ring&;
};
template <>
struct interior_const_type<tutavia::Polygon> {
  using type = const std::vector<tutavia::Ring>&;
};
template <>
struct interior_mutable_type<tutavia::Polygon> {
  using type = std::vector<tutavia::Ring>&;
};
template <>
struct exterior_ring<tutavia::Polygon> {
  static tutavia::Ring& get(tutavia::Polygon& polygon) { return polygon.outer; }
  static const tutavia::Ring& get(const tutavia::Polygon& polygon) { return polygon.outer; }
};
template <>
struct interior_rings<tutavia::Polygon> {
  static std::vector<tutavia::Ring>& get(tutavia::Polygon& polygon) { return polygon.holes; }
  static const std::vector<tutavia::Ring>& get(const tutavia::Polygon& polygon) {
    return polygon.holes;
  }
};

template <>
struct tag<std::vector<tutavia::Polygon>> {
  using type = multi_polygon_tag;
};

}  // namespace boost::geometry::traits

namespace tutavia {

namespace detail {

template <class G>
using BoostTag = typename boost::geometry::tag<G>::type;

/// A geometry in the plane whose tag marks it as an area.
template <class G>
concept BoostAreal = std::is_base_of_v<boost::geometry::areal_tag, BoostTag<G>> &&
                         boost::geometry::dimension<G>::value == 2 &&
                     std::is_same_v<typename boost::geometry::coordinate_system<G>::type,
                                    boost::geometry::cs::cartesian>;

/// A ring of tutavia from a ring of any type; open, in the same order.
template <class R>
Ring ring_from_boost(const R& ring) {
  Ring result;
  for (auto it = boost::begin(ring); it != boost::end(ring); ++it) {
    result.emplace_back(static_cast<double>(boost::geometry::get<0>(*it)),
                        static_cast<double>(boost::geometry::get<1>(*it)));
  }
  if (result.size() > 1 && result.front() == result.back()) result.pop_back();
  return result;
}

template <class P>
Polygon polygon_from_boost(const P& polygon) {
  Polygon result{ring_from_boost(boost::geometry::exterior_ring(polygon))};
  const auto& holes = boost::geometry::interior_rings(polygon);
  for (auto it = boost::begin(holes); it != boost::end(holes); ++it) {
    result.holes.push_back(ring_from_boost(*it));
  }
  return result;
}

template <class B>
Box box_from_boost(const B& box) {
  namespace bg = boost::geometry;
  return {{static_cast<double>(bg::get<bg::min_corner, 0>(box)),
           static_cast<double>(bg::get<bg::min_corner, 1>(box))},
          {static_cast<double>(bg::get<bg::max_corner, 0>(box)),
           static_cast<double>(bg::get<bg::max_corner, 1>(box))}};
}

}  // namespace detail

/// Areas of Boost.Geometry in the plane with Cartesian coordinates: polygons, multi-polygons, rings
/// and boxes, of any coordinate type. Coordinates are rounded to double.
template <detail::BoostAreal G>
struct ArealTraits<G> {
  static std::vector<Polygon> polygons(const G& geometry) {
    using Tag = detail::BoostTag<G>;
    if constexpr (std::is_same_v<Tag, boost::geometry::multi_polygon_tag>) {
      std::vector<Polygon> result;
      for (auto it = boost::begin(geometry); it != boost::end(geometry); ++it) {
        result.push_back(detail::polygon_from_boost(*it));
      }
      return result;
    } else if constexpr (std::is_same_v<Tag, boost::geometry::polygon_tag>) {
      return {detail::polygon_from_boost(geometry)};
    } else if constexpr (std::is_same_v<Tag, boost::geometry::ring_tag>) {
      return {Polygon{detail::ring_from_boost(geometry)}};
    } else {
      return to_polygons(detail::box_from_boost(geometry));
    }
  }
};

}  // namespace tutavia
