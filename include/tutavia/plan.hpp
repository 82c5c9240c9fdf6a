// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The module plan: queries, routes and failures.

#include "tutavia/plan/failure.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/plan/route.hpp"
#include "tutavia/plan/statistics.hpp"
#include "tutavia/plan/vehicle.hpp"
