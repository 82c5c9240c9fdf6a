// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

/// \file
/// The figures that the papers print (published.csv).

namespace reproduce {

/// A figure of a paper's table; nothing if the table has none. Throws if the file is not there.
std::optional<double> published(const std::string& paper, const std::string& table,
                                const std::string& scenario, const std::string& algorithm,
                                const std::string& metric);

}  // namespace reproduce
