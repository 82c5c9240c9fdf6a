// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/plan/failure.hpp"

/// \file
/// AlgorithmText: algorithms and options as a user writes them.

namespace tutavia {

/// An option as a user writes it.
struct OptionText {
  std::string name;
  std::string text{};
};

/// An algorithm as a user writes it: "delta:join=paper,corner_threshold=0.4".
struct AlgorithmText {
  std::string text{};  ///< as written
  std::string name{};
  std::vector<OptionText> options{};
};

/// One algorithm, or a pipeline of several: "shortcut+bezier:trim=0.5".
struct PipelineText {
  std::string text{};                   ///< as written
  std::vector<AlgorithmText> stages{};  ///< at least one

  /// The names of the stages with a plus between them.
  std::string name() const {
    std::string joined;
    for (const AlgorithmText& stage : stages) {
      if (&stage != &stages.front()) joined.append("+");
      joined.append(stage.name);
    }
    return joined;
  }
};

namespace detail {

/// The parts of a text between the separators that `separates(position)` accepts.
template <class Separates>
std::vector<std::string> split_at(const std::string& text, char separator,
                                  const Separates& separates) {
  std::vector<std::string> parts(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == separator && separates(i)) {
      parts.emplace_back();
    } else {
      parts.back().push_back(text[i]);
    }
  }
  return parts;
}

inline Expected<AlgorithmText, Failure> parse_stage(const std::string& text) {
  const std::size_t colon = text.find(':');
  AlgorithmText stage{.text = text, .name = text.substr(0, colon)};
  if (colon == std::string::npos) {
    if (text.find('=') == std::string::npos) return stage;
    std::string detail = "expected NAME:OPTION=VALUE, got \"";
    return fail(PlanError::invalid_option, detail.append(text).append("\""));
  }
  const auto parts = split_at(text.substr(colon + 1), ',', [](std::size_t) { return true; });
  for (const std::string& part : parts) {
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos || equals == 0) {
      std::string detail = stage.name;
      detail.append(": expected OPTION=VALUE, got \"").append(part).append("\"");
      return fail(PlanError::invalid_option, std::move(detail));
    }
    stage.options.push_back({part.substr(0, equals), part.substr(equals + 1)});
  }
  return stage;
}

/// A plus before a digit belongs to a number such as 1e+5: no name begins with a digit.
inline Expected<PipelineText, Failure> parse_pipeline(const std::string& text) {
  PipelineText pipeline{.text = text};
  const auto joins_stages = [&](std::size_t plus) {
    return plus + 1 == text.size() || text[plus + 1] < '0' || text[plus + 1] > '9';
  };
  for (const std::string& stage : split_at(text, '+', joins_stages)) {
    auto parsed = parse_stage(stage);
    if (!parsed) return std::move(parsed).unexpected();
    pipeline.stages.push_back(std::move(*parsed));
  }
  return pipeline;
}

}  // namespace detail

/// Reads a comma list of algorithms and pipelines, each stage with its options:
///
///     astar:heuristic=euclidean,jps,rrt_star:max_iterations=5000,goal_bias=0.1
///     shortcut+bezier:trim=0.5,fullness=0.6,delta
///
/// A part with an equals sign, and no colon before it, belongs to the algorithm before it. Names
/// and values are not checked here: see make_search. Errors: `invalid_option` for an option without
/// an algorithm, without a name or without an equals sign.
inline Expected<std::vector<PipelineText>, Failure> parse_algorithms(const std::string& text) {
  std::vector<std::string> items;
  for (std::string& part : detail::split_at(text, ',', [](std::size_t) { return true; })) {
    const std::size_t sign = part.find_first_of(":=");
    if (sign == std::string::npos || part[sign] == ':') {
      items.push_back(std::move(part));
    } else if (items.empty() || items.back().find(':') == std::string::npos) {
      std::string detail = "expected NAME:OPTION=VALUE, got \"";
      if (!items.empty()) detail.append(items.back()).append(",");
      return fail(PlanError::invalid_option, detail.append(part).append("\""));
    } else {
      items.back().append(",").append(part);
    }
  }
  std::vector<PipelineText> pipelines;
  for (const std::string& item : items) {
    auto parsed = detail::parse_pipeline(item);
    if (!parsed) return std::move(parsed).unexpected();
    pipelines.push_back(std::move(*parsed));
  }
  return pipelines;
}

}  // namespace tutavia
