// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "input.hpp"
#include "names.hpp"
#include "options.hpp"
#include "result.hpp"

/// \file
/// Tables on stdout.

namespace plan_program {

/// Prints the names on workspaces, those on grid maps and those for vehicles, for --list.
void print_names(const Names& lattice, const Names& cell, const Names& vehicle);

/// Prints the task before the tables.
void print_task(const Arguments& args, const Task& task);

/// One row per goal, each figure with its change against the search's own route. Vehicles have a
/// column of their changes of gear; so they do below, where figures that they lack are dashes.
void print_plans(const Group& group);

/// One row per group, which differ in the search; figures are sums over all goals.
void print_searches(std::span<const Group> groups);

/// One row per group, which differ in the smoother and have taut lengths; figures are sums over all
/// goals. A smoother that leaves the homotopy class of a route can be shorter than its taut string.
void print_smoothers(std::span<const Group> groups);

}  // namespace plan_program
