// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The module geometry: points, curves, polygons and exact predicates.

#include "tutavia/geometry/arc.hpp"
#include "tutavia/geometry/areal.hpp"
#include "tutavia/geometry/b_spline.hpp"
#include "tutavia/geometry/bezier.hpp"
#include "tutavia/geometry/box.hpp"
#include "tutavia/geometry/clothoid.hpp"
#include "tutavia/geometry/continuous_drives.hpp"
#include "tutavia/geometry/curvature.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/dubins.hpp"
#include "tutavia/geometry/natural_spline.hpp"
#include "tutavia/geometry/piece.hpp"
#include "tutavia/geometry/point.hpp"
#include "tutavia/geometry/polygon.hpp"
#include "tutavia/geometry/pose.hpp"
#include "tutavia/geometry/predicates.hpp"
#include "tutavia/geometry/reeds_shepp.hpp"
#include "tutavia/geometry/resample.hpp"
#include "tutavia/geometry/segment.hpp"
#include "tutavia/geometry/steering_word.hpp"
#include "tutavia/geometry/vehicle_path.hpp"
