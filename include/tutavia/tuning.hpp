// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The module tuning: parameters found by a swarm.

#include "tutavia/tuning/salp_swarm.hpp"
#include "tutavia/tuning/ssa_tuning.hpp"
