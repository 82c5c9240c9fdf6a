// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Compiler extensions, with portable fallbacks.

/// For small functions in inner loops that compilers do not inline by themselves.
#if defined(__GNUC__)
#define TUTAVIA_ALWAYS_INLINE [[gnu::always_inline]] inline
#else
#define TUTAVIA_ALWAYS_INLINE inline
#endif

namespace tutavia::detail {

/// Prefetches memory that will soon be written.
inline void prefetch([[maybe_unused]] const void* memory) {
#if defined(__GNUC__)
  __builtin_prefetch(memory, 1);
#endif
}

/// Prefetches memory that will soon be read, and leaves it to other threads as well.
inline void prefetch_for_reading([[maybe_unused]] const void* memory) {
#if defined(__GNUC__)
  __builtin_prefetch(memory, 0);
#endif
}

}  // namespace tutavia::detail
