// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The module core: what no standard library has yet.

#include "tutavia/core/assert.hpp"
#include "tutavia/core/budget.hpp"
#include "tutavia/core/expected.hpp"
#include "tutavia/core/random.hpp"
#include "tutavia/core/version.hpp"
