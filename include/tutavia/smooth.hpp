// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The module smooth: every smoother.

#include "tutavia/smooth/b_spline_smoother.hpp"
#include "tutavia/smooth/bezier_smoother.hpp"
#include "tutavia/smooth/clothoid_smoother.hpp"
#include "tutavia/smooth/concepts.hpp"
#include "tutavia/smooth/continuous_curvature.hpp"
#include "tutavia/smooth/delta_smoother.hpp"
#include "tutavia/smooth/homotopy_refine.hpp"
#include "tutavia/smooth/no_smoothing.hpp"
#include "tutavia/smooth/pipeline.hpp"
#include "tutavia/smooth/redundant_node_removal.hpp"
#include "tutavia/smooth/shortcut.hpp"
#include "tutavia/smooth/smoothing_spline.hpp"
#include "tutavia/smooth/string_pull.hpp"
#include "tutavia/smooth/taut_string.hpp"
#include "tutavia/smooth/two_stage_b_spline.hpp"
#include "tutavia/smooth/vehicle_shortcut.hpp"
