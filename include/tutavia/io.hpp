// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The module io: files and pictures, without JSON (see the target tutavia::json).

#include "tutavia/io/moving_ai.hpp"
#include "tutavia/io/ros_map.hpp"
#include "tutavia/io/svg.hpp"
#include "tutavia/io/svg_options.hpp"
#include "tutavia/io/svg_search.hpp"
#include "tutavia/io/svg_smoothing.hpp"
#include "tutavia/io/wkt.hpp"
