// SPDX-License-Identifier: MIT
#include "vehicle_arguments.hpp"

#include <cmath>
#include <numbers>
#include <string_view>

#include "text_arguments.hpp"
#include "usage_error.hpp"

namespace plan_program {

namespace {

using tutavia::FootprintDisc;

constexpr std::string_view disc_prefix = "disc:", car_prefix = "car:", discs_prefix = "discs:";
constexpr double most_times = 100;  // one side of a car the other: its cover has many discs

/// The numbers after a prefix, as many as asked for; none if the text is another one.
std::vector<double> numbers_of(std::string_view text, std::size_t count) {
  std::vector<double> numbers;
  for (const std::string& part : split(std::string(text), ',')) {
    const auto number = parse_number(part);
    if (!number || !std::isfinite(*number)) return {};
    numbers.push_back(*number);
  }
  return numbers.size() == count ? numbers : std::vector<double>{};
}

std::vector<FootprintDisc> parse_disc(std::string_view text) {
  const auto numbers = numbers_of(text, 1);
  if (numbers.empty() || numbers[0] < 0) return {};
  return {{Point::Zero(), numbers[0]}};
}

std::vector<FootprintDisc> parse_car(std::string_view text) {
  const auto numbers = numbers_of(text, 3);
  if (numbers.empty()) return {};
  const double length = numbers[0], width = numbers[1], wheelbase = numbers[2];
  const double longer = std::fmax(length, width), shorter = std::fmin(length, width);
  const bool is_size = 0 < shorter && longer <= most_times * shorter && std::isfinite(longer);
  if (!is_size || !(0 <= wheelbase && wheelbase <= length)) return {};
  return tutavia::Vehicle::car(length, width, wheelbase, 0).footprint;
}

std::vector<FootprintDisc> parse_discs(std::string_view text) {
  std::vector<FootprintDisc> discs;
  for (const std::string& part : split(std::string(text), ';')) {
    const auto numbers = numbers_of(part, 3);
    if (numbers.empty() || numbers[2] < 0) return {};
    discs.push_back({{numbers[0], numbers[1]}, numbers[2]});
  }
  return discs;
}

}  // namespace

std::optional<double> split_heading(const std::string& option, std::string& text) {
  constexpr const char* form = "X,Y or X,Y,DEG";
  if (split(text, ',').size() != 3) {
    parse_numbers(option, text, 2, form);
    return std::nullopt;
  }
  const double degrees = parse_numbers(option, text, 3, form)[2];
  text.erase(text.rfind(','));
  return std::remainder(degrees, 360) * std::numbers::pi / 180;
}

double parse_turning_radius(const std::string& text) {
  const auto radius = parse_number(text);
  if (radius && validate(tutavia::Vehicle::point(*radius))) return *radius;
  throw UsageError{
      "--turning-radius: expected R in metres, 0 or at least 1e-9, and finite, got \"" + text +
      "\""};
}

std::vector<FootprintDisc> parse_footprint(const std::string& text) {
  struct Form {
    std::string_view prefix;
    std::vector<FootprintDisc> (*parse)(std::string_view);
    const char* description;
  };
  std::string form = "disc:R, car:L,W,WB or discs:X,Y,R;X,Y,R;...";
  for (const auto& [prefix, parse, description] :
       {Form{disc_prefix, &parse_disc, "disc:R with R at least 0"},
        Form{car_prefix, &parse_car,
             "car:L,W,WB with L and W above 0, neither 100 times the other, and WB from 0 to L"},
        Form{discs_prefix, &parse_discs, "discs:X,Y,R;X,Y,R;... with every R at least 0"}}) {
    if (text.rfind(prefix, 0) != 0) continue;
    auto discs = parse(std::string_view(text).substr(prefix.size()));
    if (!discs.empty()) return discs;
    form = description;
  }
  throw UsageError{"--footprint: expected " + form + ", in metres, got \"" + text + "\""};
}

void check_vehicle(const VehicleArguments& vehicle) {
  const tutavia::Vehicle described{.min_turning_radius = vehicle.turning_radius.value_or(1),
                                   .footprint = vehicle.footprint};
  if (described.min_turning_radius > 0 || vehicle.footprint.empty()) return;
  if (described.is_centred_disc()) return;
  throw UsageError{
      "--turning-radius 0: expected R above 0 with this --footprint; only disc:R turns on the "
      "spot"};
}

}  // namespace plan_program
