// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>

#include "support/random_grids.hpp"
#include "tutavia/grid/bitboard/transposed.hpp"
#include "tutavia/search/concepts.hpp"
#include "tutavia/space/concepts.hpp"

/// \file
/// One minimal model per space concept, with exactly its operations. An algorithm that uses more
/// than its constraint requires does not compile with it. All models are the same world: a box
/// without obstacles, with nodes a metre apart.

namespace tutavia::test {

inline constexpr int archetype_side = 8;  // of the box [m]

/// Models FreeSpace. It is not copyable, because no algorithm may copy a space.
class FreeArchetype {
 public:
  FreeArchetype() = default;
  FreeArchetype(const FreeArchetype&) = delete;
  FreeArchetype& operator=(const FreeArchetype&) = delete;

  bool is_free(const Point& p) const { return bounds_.contains(p); }
  bool segment_free(const Point& p, const Point& q) const { return is_free(p) && is_free(q); }
  const Box& bounds() const { return bounds_; }

 private:
  Box bounds_{{0, 0}, {archetype_side, archetype_side}};
};

template <class Base>
class WithClearance : public Base {
 public:
  double clearance(const Point&) const { return std::numeric_limits<double>::infinity(); }
  NearestObstacle nearest(const Segment&, double cap) const { return {.distance = cap}; }
  NearestObstacle nearest(const Arc&, double cap) const { return {.distance = cap}; }
  bool is_inside(const Point&) const { return false; }
  double safety_radius() const { return 0.25; }
  double distance_error_bound() const { return 1e-12; }
  double largest_coordinate() const { return archetype_side; }
};

template <class Base>
class WithFeatures : public Base {
 public:
  template <class Visit>
  void for_each_feature(const Box&, const Visit&) const {}
};

template <class Base>
class WithCorners : public Base {
 public:
  template <class Visit>
  void for_each_corner(const Box&, const Visit&) const {}
};

template <class Base>
class WithWorkspace : public Base {
 public:
  const Workspace& workspace() const { return workspace_; }

 private:
  Workspace workspace_{{{0, 0}, {archetype_side, archetype_side}}, 0.25, {}};
};

template <class Base>
class WithLinks : public Base {
 public:
  const Frame& frame() const { return frame_; }
  EndpointLinks links(const Point& p) const {
    const Cell cell = frame_.nearest_cell(p);
    EndpointLinks links;
    links.push_back({cell, distance(p, frame_.point(cell))});
    return links;
  }

 private:
  Frame frame_{};
};

template <class Base>
class WithNodes : public Base {
 public:
  const OccupancyGrid& grid() const { return grid_; }

 private:
  OccupancyGrid grid_ = free_grid(archetype_side + 1, archetype_side + 1);
};

template <class Base>
class WithMovement : public Base {
 public:
  MovementRule movement() const { return MovementRule::no_cut; }
};

template <class Base>
class WithSteps : public Base {
 public:
  StepSet successors(std::size_t index) const {
    const auto around = Base::grid().view().neighbourhood(index);
    return detail::all_successors(MovementRule::no_cut)[around];
  }
};

template <class Base>
class WithColumns : public Base {
 public:
  const OccupancyGrid& columns() const { return columns_; }

 private:
  OccupancyGrid columns_ = detail::transposed(Base::grid());
};

template <class Base>
class WithJumps : public Base {
 public:
  const detail::StopPlanes& stop_planes() const { return stops_; }
  const detail::TurnPlanes& turn_planes() const { return turns_; }

 private:
  detail::StopPlanes stops_{Base::grid()};
  detail::TurnPlanes turns_{Base::grid(), stops_};
};

template <class Base>
class WithSight : public Base {
 public:
  bool line_of_sight(Cell, Cell) const { return true; }
};

using ClearanceArchetype = WithClearance<FreeArchetype>;
using FeatureArchetype = WithFeatures<ClearanceArchetype>;
using CornerArchetype = WithCorners<ClearanceArchetype>;
using WorkspaceArchetype = WithWorkspace<FeatureArchetype>;
using LinkedArchetype = WithLinks<FreeArchetype>;
using GridArchetype = WithMovement<WithNodes<LinkedArchetype>>;
using ColumnArchetype = WithColumns<GridArchetype>;
using JumpArchetype = WithJumps<GridArchetype>;
using StepArchetype = WithSteps<WithNodes<LinkedArchetype>>;
using SightArchetype = WithSight<GridArchetype>;
using StepSightArchetype = WithSight<StepArchetype>;
using ColumnSightArchetype = WithSight<ColumnArchetype>;
using JumpSightArchetype = WithSight<JumpArchetype>;
using ClearanceGridArchetype = WithClearance<GridArchetype>;

static_assert(FreeSpace<FreeArchetype>);
static_assert(!ClearanceSpace<FreeArchetype> && !LinkedSpace<FreeArchetype>);
static_assert(ClearanceSpace<ClearanceArchetype>);
static_assert(!FeatureSpace<ClearanceArchetype> && !CornerSpace<ClearanceArchetype>);
static_assert(FeatureSpace<FeatureArchetype>);
static_assert(!CornerSpace<FeatureArchetype> && !WorkspaceSpace<FeatureArchetype>);
static_assert(CornerSpace<CornerArchetype> && !FeatureSpace<CornerArchetype>);
static_assert(WorkspaceSpace<WorkspaceArchetype> && !CornerSpace<WorkspaceArchetype>);
static_assert(LinkedSpace<LinkedArchetype>);
static_assert(!GridSpace<LinkedArchetype> && !StepSpace<LinkedArchetype>);
static_assert(GridSpace<GridArchetype> && SteppedSpace<GridArchetype>);
static_assert(!ColumnSpace<GridArchetype> && !JumpSpace<GridArchetype>);
static_assert(!StepSpace<GridArchetype> && !LineOfSightSpace<GridArchetype>);
static_assert(ColumnSpace<ColumnArchetype> && !detail::ColumnLineOfSightSpace<ColumnArchetype>);
static_assert(JumpSpace<JumpArchetype> && !detail::JumpLineOfSightSpace<JumpArchetype>);
static_assert(StepSpace<StepArchetype> && SteppedSpace<StepArchetype>);
static_assert(!GridSpace<StepArchetype> && !LineOfSightSpace<StepArchetype>);
static_assert(LineOfSightSpace<SightArchetype> && !StepSpace<SightArchetype>);
static_assert(!detail::ColumnLineOfSightSpace<SightArchetype> &&
              !detail::JumpLineOfSightSpace<SightArchetype>);
static_assert(LineOfSightSpace<StepSightArchetype> && !GridSpace<StepSightArchetype>);
static_assert(detail::ColumnLineOfSightSpace<ColumnSightArchetype> &&
              !JumpSpace<ColumnSightArchetype>);
static_assert(detail::JumpLineOfSightSpace<JumpSightArchetype> && !ColumnSpace<JumpSightArchetype>);
static_assert(ClearanceGridSpace<ClearanceGridArchetype>);
static_assert(!FeatureSpace<ClearanceGridArchetype> && !LineOfSightSpace<ClearanceGridArchetype>);

/// Models Observer.
struct ObserverArchetype {
  ObserverArchetype() = default;
  ObserverArchetype(const ObserverArchetype&) = delete;
  ObserverArchetype& operator=(const ObserverArchetype&) = delete;

  void expanded(const Point&) { ++told; }
  void generated(const Point&) { ++told; }

  std::size_t told = 0;
};
static_assert(Observer<ObserverArchetype>);

}  // namespace tutavia::test
