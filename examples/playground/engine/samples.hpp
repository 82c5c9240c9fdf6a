// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "../../plan/planning_space.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/geometry/vehicle_path.hpp"
#include "tutavia/motion/speed_limits.hpp"
#include "tutavia/search/search_record.hpp"

/// \file
/// What the page draws, as lists of numbers.

namespace playground {

using namespace tutavia;

/// About `count` samples of a curve, at least both ends of every piece. The gears may be empty.
nlohmann::ordered_json sampled(const plan_program::PlanningSpace& space, const Curve& curve,
                               std::span<const Gear> gears, std::size_t count);

/// The motion along a curve, or why there is none.
nlohmann::ordered_json sampled_motion(const Curve& curve, const SpeedLimits& limits);

/// The first `most` events of a search.
nlohmann::ordered_json events_to_json(const SearchRecord& record, std::size_t most,
                                      double cell_size);

}  // namespace playground
