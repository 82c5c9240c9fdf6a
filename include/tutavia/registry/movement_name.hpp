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
/// parse_movement_rule and parse_edge_rule: rules by their names.

namespace tutavia {

namespace detail {

template <class Rule>
Expected<Rule, Failure> parse_rule(std::string_view text) {
  Rule rule{};
  if (parse_option(text, rule)) return rule;
  std::string message = "expected ";
  message.append(expected_text(option_kind<Rule>)).append(", got \"").append(text);
  return fail(PlanError::invalid_option, message.append("\""));
}

}  // namespace detail

/// The movement rule of a name, such as "no_cut". Errors: `invalid_option` for any other text, with
/// all names; also for "by_edge", which an edge rule brings with it.
inline Expected<MovementRule, Failure> parse_movement_rule(std::string_view text) {
  return detail::parse_rule<MovementRule>(text);
}

/// The edge rule of a name, such as "uniform". Errors: `invalid_option` for any other text, with
/// all names.
inline Expected<EdgeRule, Failure> parse_edge_rule(std::string_view text) {
  return detail::parse_rule<EdgeRule>(text);
}

}  // namespace tutavia
