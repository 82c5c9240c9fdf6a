// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>

/// \file
/// TUTAVIA_ASSERT: checks preconditions of the caller, never input data. Define it before the first
/// include to replace it.

#ifndef TUTAVIA_ASSERT
#define TUTAVIA_ASSERT(condition) assert(condition)
#endif
