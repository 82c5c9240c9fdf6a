// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What compilers offer beyond the standard, where they do.

/// For small functions in inner loops that compilers take for too large.
#if defined(__GNUC__)
#define TUTAVIA_ALWAYS_INLINE [[gnu::always_inline]] inline
#else
#define TUTAVIA_ALWAYS_INLINE inline
#endif

namespace tutavia::detail {

/// Says that memory is going to be written (or read) soon.
inline void prefetch([[maybe_unused]] const void* memory) {
#if defined(__GNUC__)
  __builtin_prefetch(memory, 1);
#endif
}

}  // namespace tutavia::detail
