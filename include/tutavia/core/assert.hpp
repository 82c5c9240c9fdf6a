// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>

/// \file
/// TUTAVIA_ASSERT: catches programming errors (broken preconditions), never bad input.
/// Define it before the first include to route it elsewhere.

#ifndef TUTAVIA_ASSERT
#define TUTAVIA_ASSERT(condition) assert(condition)
#endif
