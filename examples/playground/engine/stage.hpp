// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "../../plan/map_frame.hpp"
#include "../../plan/planning_space.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// Stage: the scene that is planned on.

namespace playground {

using namespace tutavia;

/// A space, and the planners that were used on it. The planners refer to the space, so a stage
/// stays where it is.
class Stage {
 public:
  /// The scene of a request. Throws UsageError and ParseError.
  Stage(const nlohmann::json& request, std::string_view bytes);
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  const plan_program::PlanningSpace& space() const { return space_; }
  plan_program::MapFrame& frame() { return frame_; }
  const plan_program::MapFrame& frame() const { return frame_; }
  bool has_cells() const { return space_.index() == 1; }
  double resolution() const;
  double safety_radius() const;
  Certificate certify(const Curve& curve) const;
  /// The obstacles in the frame of the map; blocked cells are polygons.
  Workspace obstacles() const;
  bool y_down() const { return y_down_; }

  /// The planner of a key. `make()` makes it at the first use.
  template <class Make>
  const plan_program::ChosenPlanner& planner(const std::string& key, const Make& make) {
    const auto known = planners_.find(key);
    if (known != planners_.end()) return known->second;
    if (planners_.size() > 100) planners_.clear();  // every value of an option is a key of its own
    return planners_.emplace(key, make()).first->second;
  }

 private:
  bool y_down_ = false;
  plan_program::MapFrame frame_{};
  plan_program::PlanningSpace space_;
  std::map<std::string, plan_program::ChosenPlanner> planners_{};
};

}  // namespace playground
