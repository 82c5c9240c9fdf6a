// SPDX-License-Identifier: MIT
#include "published.hpp"

#include <cstdlib>
#include <fstream>
#include <map>
#include <stdexcept>
#include <vector>

namespace reproduce {

namespace {

/// The fields of a line of CSV. Quotes enclose fields with commas; none contain quotes.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else if (c != '\r') {
      fields.back() += c;
    }
  }
  return fields;
}

using Figures = std::map<std::vector<std::string>, double>;

Figures read_figures() {
  std::ifstream file(TUTAVIA_PUBLISHED_FIGURES);
  if (!file) throw std::runtime_error(TUTAVIA_PUBLISHED_FIGURES ": cannot be read");
  Figures figures;
  std::string line;
  std::getline(file, line);  // the header
  while (std::getline(file, line)) {
    std::vector<std::string> fields = fields_of(line);
    if (fields.size() != 6) throw std::runtime_error("published.csv: " + line);
    const double value = std::strtod(fields.back().c_str(), nullptr);
    fields.pop_back();
    figures[fields] = value;
  }
  return figures;
}

}  // namespace

std::optional<double> published(const std::string& paper, const std::string& table,
                                const std::string& scenario, const std::string& algorithm,
                                const std::string& metric) {
  static const Figures figures = read_figures();
  const auto found = figures.find({paper, table, scenario, algorithm, metric});
  return found == figures.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace reproduce
