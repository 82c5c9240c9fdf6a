// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The module motion: speed along a curve.

#include "tutavia/motion/band.hpp"
#include "tutavia/motion/control_options.hpp"
#include "tutavia/motion/differential_drive.hpp"
#include "tutavia/motion/drive_command.hpp"
#include "tutavia/motion/local_planner.hpp"
#include "tutavia/motion/local_planner_options.hpp"
#include "tutavia/motion/motion_gate.hpp"
#include "tutavia/motion/path_follower.hpp"
#include "tutavia/motion/speed_limits.hpp"
#include "tutavia/motion/speed_profile.hpp"
#include "tutavia/motion/timed_elastic_band.hpp"
