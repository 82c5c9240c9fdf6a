// SPDX-License-Identifier: MIT
#include "job.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <variant>
#include <vector>

#include "result_row.hpp"
#include "tutavia/core/version.hpp"

namespace batch_program {

Digest& Digest::add(std::string_view bytes) {
  for (const char c : bytes) {
    state_ = (state_ ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  }
  return *this;
}

Digest& Digest::add(double value) {
  const auto bits = std::bit_cast<std::array<char, sizeof(double)>>(value);
  return add(std::string_view(bits.data(), bits.size()));
}

std::string Digest::text() const {
  std::array<char, 16> digits{};
  const char* const end = std::to_chars(digits.data(), digits.data() + 16, state_, 16).ptr;
  const std::string text(static_cast<const char*>(digits.data()), end);
  return std::string(16 - text.size(), '0') + text;
}

namespace {

void add_grid(Digest& digest, const OccupancyGrid& grid, const Frame& frame,
              MovementRule movement) {
  digest.add(double(grid.width())).add(double(grid.height()));
  const auto bytes = std::as_bytes(std::span(grid.words()));
  digest.add(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  digest.add(frame.origin.x()).add(frame.origin.y()).add(frame.resolution);
  digest.add(double(static_cast<int>(movement)));
}

void add_ring(Digest& digest, const Ring& ring) {
  digest.add(double(ring.size()));
  for (const Point& p : ring) digest.add(p.x()).add(p.y());
}

void add_obstacle(Digest& digest, const Obstacle& obstacle) {
  if (const Disc* disc = std::get_if<Disc>(&obstacle)) {
    digest.add("disc").add(disc->center.x()).add(disc->center.y()).add(disc->radius);
    return;
  }
  const Polygon& polygon = std::get<Polygon>(obstacle);
  digest.add("polygon").add(double(polygon.holes.size()));
  add_ring(digest, polygon.outer);
  for (const Ring& hole : polygon.holes) add_ring(digest, hole);
}

}  // namespace

std::string digest_of(const LatticeSpace& space) {
  Digest digest;
  add_grid(digest.add("lattice"), space.grid(), space.frame(), space.movement());
  const Box& bounds = space.bounds();
  digest.add(bounds.min.x()).add(bounds.min.y()).add(bounds.max.x()).add(bounds.max.y());
  digest.add(space.safety_radius());
  for (const Obstacle& obstacle : space.workspace().obstacles) add_obstacle(digest, obstacle);
  return digest.text();
}

std::string digest_of(const CellSpace& space) {
  Digest digest;
  add_grid(digest.add("cells"), space.cells(), space.frame(), space.movement());
  return digest.add(space.safety_radius()).text();
}

std::string digest_of(const CellCosts& costs) {
  Digest digest;
  digest.add(double(costs.width())).add(double(costs.height()));
  std::string row(static_cast<std::size_t>(costs.width()), '\0');
  for (int y = 0; y < costs.height(); ++y) {
    for (int x = 0; x < costs.width(); ++x) {
      row[static_cast<std::size_t>(x)] = static_cast<char>(costs[{x, y}]);
    }
    digest.add(row);
  }
  return digest.text();
}

std::string digest_of(std::span<const Query> queries) {
  Digest digest;
  for (const Query& query : queries) {
    digest.add(query.start.x()).add(query.start.y()).add(query.goal.x()).add(query.goal.y());
    for (const auto& heading : {query.start_heading, query.goal_heading}) {
      digest.add(heading ? "heading" : "any").add(heading.value_or(0));
    }
    digest.add(std::to_string(query.seed));
    digest.add(std::to_string(query.budget.max_expansions));
  }
  return digest.text();
}

std::string digest_of(const Vehicle& vehicle) {
  Digest digest;
  digest.add(vehicle.min_turning_radius).add(vehicle.reverse ? 1.0 : 0.0);
  for (const FootprintDisc& disc : vehicle.footprint) {
    digest.add(disc.offset.x()).add(disc.offset.y()).add(disc.radius);
  }
  return digest.text();
}

namespace {

void append_algorithm(std::string& text, const AlgorithmText& algorithm) {
  std::vector<OptionText> options = algorithm.options;
  std::sort(options.begin(), options.end(),
            [](const OptionText& a, const OptionText& b) { return a.name < b.name; });
  text.append(algorithm.name);
  for (std::size_t i = 0; i < options.size(); ++i) {
    text.append(i == 0 ? ":" : ",").append(options[i].name).append("=").append(options[i].text);
  }
}

}  // namespace

std::string algorithms_text(const AlgorithmText& search, std::span<const AlgorithmText> smoothers) {
  std::string text = "search ";
  append_algorithm(text, search);
  text.append(", smoother ");
  for (std::size_t i = 0; i < smoothers.size(); ++i) {
    if (i > 0) text.append("+");
    append_algorithm(text, smoothers[i]);
  }
  return text;
}

std::string describe_job(std::string_view algorithms, std::string_view space,
                         std::span<const Query> queries) {
  std::string line = "tutavia " + version_text();
  line.append(", ").append(algorithms).append(", space ").append(space);
  return line.append(", ")
      .append(std::to_string(queries.size()))
      .append(" queries ")
      .append(digest_of(queries));
}

namespace {

std::ptrdiff_t commas_of(std::string_view line) {
  return std::count(line.begin(), line.end(), ',');
}

}  // namespace

Expected<Progress, Failure> count_results(std::string_view text) {
  const auto is_other = [](std::size_t line) {
    return fail(PlanError::invalid_input,
                "line " + std::to_string(line) + ": this is no file of results");
  };
  Progress progress;
  std::size_t end = text.find('\n');
  if (end == std::string_view::npos) {
    const bool is_start = result_header.substr(0, text.size()) == text;
    return is_start ? Expected<Progress, Failure>(progress) : is_other(1);
  }
  if (text.substr(0, end) != result_header) return is_other(1);
  for (progress.bytes = end + 1;; ++progress.results, progress.bytes = end + 1) {
    end = text.find('\n', progress.bytes);
    if (end == std::string_view::npos) return progress;
    const std::string_view line = text.substr(progress.bytes, end - progress.bytes);
    const std::string number = std::to_string(progress.results) + ",";
    if (line.substr(0, number.size()) != number || commas_of(line) != commas_of(result_header)) {
      return is_other(progress.results + 2);
    }
  }
}

}  // namespace batch_program
