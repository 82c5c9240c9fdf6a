// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <optional>
#include <utility>

#include "tutavia/geometry/areal.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/distance_field_space.hpp"
#include "tutavia/space/index/lattice_sampler.hpp"
#include "tutavia/space/lattice_space.hpp"
#include "tutavia/world/obstacles_from.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// GridBuilder: a space with a grid from any description of the obstacles.

namespace tutavia {

/// A function `bool(Point)`: whether a point is free of obstacles.
///
/// Example: examples/obstacle_sources.cpp.
template <class F>
concept PointPredicate = std::copy_constructible<F> &&
    std::regular_invocable<const F&, const Point&> && requires(const F& is_free, const Point& p) {
  { is_free(p) } -> std::same_as<bool>;
};

/// What describes the obstacles to a GridBuilder.
///
/// Example: examples/obstacle_sources.cpp.
template <class S>
concept ObstacleSource =
    std::same_as<S, Workspace> || Areal<S> || ClearanceFunction<S> || PointPredicate<S>;

/// Options of the grid.
struct GridOptions {
  /// Spacing of the nodes, or side of a cell [m]. Default: 1/200 of the larger side of the bounds.
  std::optional<double> resolution{};
  MovementRule movement = MovementRule::no_cut;
  std::int64_t max_nodes = std::int64_t{1} << 28;  ///< more than these: limit_exceeded
};

/// Builds the space with a grid that suits a description of the obstacles:
///
/// - a Workspace: a LatticeSpace; proofs hold for its obstacles;
/// - an area (Areal: Polygon, a polygon of Boost.Geometry, ...): a LatticeSpace; for the area;
/// - a ClearanceFunction, `double(Point)`: a DistanceFieldSpace; for obstacles that are nowhere
///   nearer than its values;
/// - a PointPredicate, `bool(Point)`: a CellSpace; for the cells.
///
/// **Lattices** (the first three). A node (i delta, j delta) is free iff its clearance is at least
/// sqrt(r^2 + delta^2 / 2), with a small margin for rounding. If an obstacle point is at least T
/// away from both ends of a segment of length L, then by Stewart's theorem its squared distance to
/// the segment is at least T^2 - L^2 / 4. So every step to one of the eight neighbours, at most
/// sqrt(2) delta long, keeps the safety radius, and no step needs a test.
///
/// **Cells** (a predicate). A cell is blocked if its centre is not free. The cells fill the bounds
/// from their lower left corner; a strip narrower than a cell may be left out at the other sides. A
/// path is proved to keep the safety radius from all blocked cells. That is no proof for obstacles
/// between the centres: a wall thinner than a cell can be missed. An obstacle of which no point is
/// more than h from the centre of a blocked cell is safe with a radius increased by h.
///
/// Other options of a space: call its own `build`.
///
/// Example: examples/obstacle_sources.cpp.
template <ObstacleSource Source>
class GridBuilder {
 public:
  explicit GridBuilder(Source workspace) requires std::same_as<Source, Workspace>
      : source_(std::move(workspace)),
        bounds_(source_.bounds),
        safety_radius_(source_.safety_radius) {}
  GridBuilder(Source source, const Box& bounds,
              double safety_radius) requires(!std::same_as<Source, Workspace>)
      : source_(std::move(source)), bounds_(bounds), safety_radius_(safety_radius) {}

  /// The space, for `Planner` and every search and smoother that it suits. Errors: `invalid_input`
  /// for obstacles, bounds or a radius that `validate` rejects, `invalid_option` for a resolution
  /// that is not positive and finite and for the movement rule `by_edge`, `limit_exceeded` for more
  /// than `max_nodes` nodes.
  auto build(const GridOptions& options = {}) const {
    if constexpr (std::same_as<Source, Workspace>) {
      return lattice(source_, options);
    } else if constexpr (Areal<Source>) {
      return lattice({bounds_, safety_radius_, obstacles_from(source_)}, options);
    } else if constexpr (ClearanceFunction<Source>) {
      return DistanceFieldSpace<Source>::build(source_, bounds_, safety_radius_,
                                               {.resolution = options.resolution,
                                                .movement = options.movement,
                                                .max_nodes = options.max_nodes});
    } else {
      return cells(options);
    }
  }

 private:
  static Expected<LatticeSpace, Failure> lattice(const Workspace& workspace,
                                                 const GridOptions& options) {
    return LatticeSpace::build(workspace, {.resolution = options.resolution,
                                           .movement = options.movement,
                                           .max_nodes = options.max_nodes});
  }

  Expected<CellSpace, Failure> cells(const GridOptions& options) const {
    if (const auto valid = validate(Workspace{bounds_, safety_radius_, {}}); !valid) {
      return Unexpected{valid.error()};
    }
    const double side = options.resolution.value_or(detail::default_resolution(bounds_));
    if (auto valid = detail::check_resolution(bounds_, side); !valid) {
      return Unexpected{valid.error()};
    }
    // Rounding must not cost a row of cells.
    const auto count = [&](double size) {
      return static_cast<std::int64_t>(std::floor(size / side * (1 + 0x1p-40)));
    };
    auto grid =
        OccupancyGrid::blocked(count(bounds_.width()), count(bounds_.height()), options.max_nodes);
    if (!grid) return Unexpected{grid.error()};
    for (int y = 0; y < grid->height(); ++y) {
      for (int x = 0; x < grid->width(); ++x) {
        const Point centre{bounds_.min.x() + side * (x + 0.5), bounds_.min.y() + side * (y + 0.5)};
        if (source_(centre)) grid->set({x, y}, true);
      }
    }
    return CellSpace::build(std::move(*grid), {.resolution = side,
                                               .origin = bounds_.min,
                                               .safety_radius = safety_radius_,
                                               .movement = options.movement});
  }

  Source source_;
  Box bounds_;
  double safety_radius_;
};

GridBuilder(Workspace)->GridBuilder<Workspace>;
template <class Source>
GridBuilder(Source, const Box&, double) -> GridBuilder<Source>;

}  // namespace tutavia
