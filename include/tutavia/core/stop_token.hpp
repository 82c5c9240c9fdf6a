// SPDX-License-Identifier: MIT
#pragma once

#include <version>

#include "tutavia/core/parts/flag_stop_token.hpp"

#ifdef __cpp_lib_jthread
#include <stop_token>
#endif

/// \file
/// StopSource and StopToken: how a query is cancelled from another thread.

namespace tutavia {

#ifdef __cpp_lib_jthread
using StopSource = std::stop_source;
using StopToken = std::stop_token;
#else
using StopSource = detail::FlagStopSource;
using StopToken = detail::FlagStopToken;
#endif

}  // namespace tutavia
