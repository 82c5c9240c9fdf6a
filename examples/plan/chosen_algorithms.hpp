// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "registry.hpp"
#include "tutavia/core/parts/number_text.hpp"
#include "tutavia/planner.hpp"
#include "usage_error.hpp"
#include "vehicle_arguments.hpp"

/// \file
/// make_search_on, make_smoother_on: the algorithms that a command line chooses.

namespace plan_program {

using namespace tutavia;

/// A message on an algorithm that could not be made: "--search rrt_star: unknown option ...".
inline UsageError unusable(const std::string& option, const std::string& name,
                           const Failure& failure) {
  const bool names_algorithm = failure.detail.rfind(name + ":", 0) == 0;
  return {option + (names_algorithm ? " " : ": ") + failure.detail};
}

/// Lets an algorithm to which the user gave options answer `invalid_option` by a UsageError.
template <class Any>
Any refusing(Any algorithm, const std::string& option, const AlgorithmText& text) {
  if (text.options.empty()) return algorithm;
  const auto refuse = [where = option + " " + text.text](auto& run) {
    if (!run) return;
    run = [run, where](auto&&... arguments) {
      auto result = run(arguments...);
      if (!result && result.error().code == PlanError::invalid_option) {
        throw UsageError{where + ": " + result.error().detail};
      }
      return result;
    };
  };
  refuse(algorithm.run);
  if constexpr (requires { algorithm.run_for_vehicle; }) refuse(algorithm.run_for_vehicle);
  return algorithm;
}

inline constexpr const char *radius_option = "vehicle.min_turning_radius",
                            *reverse_option = "vehicle.reverse";

inline bool has_option(const std::vector<OptionText>& options, std::string_view name) {
  return std::any_of(options.begin(), options.end(),
                     [&](const OptionText& option) { return option.name == name; });
}

/// The options of a search for vehicles: those of its name, and what the command line says beside.
/// A vehicle that the command line describes does not drive backwards unless it says so.
inline std::vector<OptionText> options_for(const VehicleArguments& vehicle,
                                           const AlgorithmText& search) {
  std::vector<OptionText> options = search.options;
  const auto add = [&](const char* option, const char* name, bool is_given, std::string text) {
    const bool is_there = has_option(search.options, name);
    if (is_given && is_there) {
      throw UsageError{std::string(option) + ": --search " + search.text + " says it, too"};
    }
    if (!is_there) options.push_back({name, std::move(text)});
  };
  if (const auto radius = vehicle.turning_radius) {
    add("--turning-radius", radius_option, true, detail::number_text(*radius));
  }
  if (vehicle.is_given()) {
    add("--reverse", reverse_option, vehicle.reverse, vehicle.reverse ? "true" : "false");
  }
  return options;
}

template <class Value>
Value value_of(const OptionSettings& settings, std::string_view name) {
  const auto has_name = [&](const OptionSetting& setting) { return setting.name == name; };
  return std::get<Value>(std::find_if(settings.begin(), settings.end(), has_name)->value);
}

/// The same search for a vehicle with this footprint.
template <class S>
AnySearch<S> with_footprint(AnySearch<S> search, const std::vector<FootprintDisc>& footprint) {
  if (footprint.empty()) return search;
  OptionSettings options = std::move(search.options);
  search = search.for_vehicle({value_of<double>(options, radius_option),
                               value_of<bool>(options, reverse_option), footprint});
  search.options = std::move(options);
  return search;
}

template <class S>
AnySearch<S> make_search_on(const Algorithms<S>& all, const PipelineText& search,
                            const VehicleArguments& vehicle,
                            [[maybe_unused]] const std::shared_ptr<const CellCosts>& costs = {}) {
  const AlgorithmText& text = search.stages.front();
  const bool is_for_vehicle =
      std::any_of(all.vehicle_searches.begin(), all.vehicle_searches.end(),
                  [&](const AnySearch<S>& known) { return known.name == text.name; });
  auto made = [&] {
    if (is_for_vehicle) return all.make_search(text.name, options_for(vehicle, text));
    if constexpr (std::is_same_v<S, CellSpace>) {
      if (costs != nullptr) return make_search_with_costs(text.name, text.options, costs);
    }
    return all.make_search(text.name, text.options);
  }();
  if (!made) throw unusable("--search", text.name, made.error());
  if (is_for_vehicle) *made = with_footprint(std::move(*made), vehicle.footprint);
  return refusing(std::move(*made), "--search", text);
}

template <class S>
AnySmoother<S> make_smoother_on(const Algorithms<S>& all, const PipelineText& smoother) {
  std::optional<AnySmoother<S>> pipeline;
  for (const AlgorithmText& text : smoother.stages) {
    auto made = all.make_smoother(text.name, text.options);
    if (!made) throw unusable("--smoother", text.name, made.error());
    AnySmoother<S> stage = refusing(std::move(*made), "--smoother", text);
    pipeline = pipeline ? detail::chain(*pipeline, stage) : std::move(stage);
  }
  return *pipeline;
}

}  // namespace plan_program
