// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The version of the library; CMake reads it from here.

#define TUTAVIA_VERSION_MAJOR 0
#define TUTAVIA_VERSION_MINOR 2
#define TUTAVIA_VERSION_PATCH 0

#ifdef __FAST_MATH__
#error "tutavia proves its paths with IEEE 754 arithmetic: compile without -ffast-math"
#endif
