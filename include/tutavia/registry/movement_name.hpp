// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "tutavia/grid/movement.hpp"
#include "tutavia/plan/failure.hpp"
#include "tutavia/registry/options/movement_options.hpp"
#include "tutavia/registry/options/option_kind.hpp"

/// \file
/// parse_movement_rule: movement rules by their names.

namespace tutavia {

/// The movement rule of a name, such as "no_cut". Errors: `invalid_option` for any other text, with
/// all names.
inline Expected<MovementRule, Failure> parse_movement_rule(std::string_view text) {
  MovementRule rule{};
  if (detail::parse_option(text, rule)) return rule;
  std::string message = "expected ";
  message.append(detail::expected_text(detail::option_kind<MovementRule>))
      .append(", got \"")
      .append(text);
  return fail(PlanError::invalid_option, message.append("\""));
}

}  // namespace tutavia
