// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The module metrics: measures of a curve.

#include "tutavia/metrics/paper_metrics.hpp"
#include "tutavia/metrics/path_metrics.hpp"
