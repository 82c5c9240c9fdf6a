// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The module motion: speed along a curve.

#include "tutavia/motion/speed_profile.hpp"
