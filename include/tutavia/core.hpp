// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The module core: Expected, budgets and random numbers.

#include "tutavia/core/assert.hpp"
#include "tutavia/core/budget.hpp"
#include "tutavia/core/expected.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/core/stop_token.hpp"
#include "tutavia/core/version.hpp"
