// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The whole library, except JSON (see the target tutavia::json) and the selection by name
/// (any_algorithm.hpp, registry.hpp).

#include "tutavia/batch.hpp"
#include "tutavia/certify.hpp"
#include "tutavia/core.hpp"
#include "tutavia/geometry.hpp"
#include "tutavia/grid.hpp"
#include "tutavia/io.hpp"
#include "tutavia/metrics.hpp"
#include "tutavia/motion.hpp"
#include "tutavia/optimum.hpp"
#include "tutavia/plan.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/repair.hpp"
#include "tutavia/search.hpp"
#include "tutavia/smooth.hpp"
#include "tutavia/space.hpp"
#include "tutavia/tuning.hpp"
#include "tutavia/world.hpp"
