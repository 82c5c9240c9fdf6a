// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// \file
/// The parts of the report on the five papers, and its texts.

namespace reproduce {

/// A table of texts. The first column is aligned left, the others right.
struct Table {
  std::string name;   ///< for the CSV file
  std::string title;  ///< a sentence above it
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows{};
};

/// What became of a claim of a paper.
enum class Verdict {
  reproduced,        ///< the figure or order comes out
  tendency,          ///< the sign comes out, the size does not
  not_reproducible,  ///< the paper does not say enough
  not_so,            ///< it does not come out
  wrong,             ///< it contradicts the paper's own figures
};

struct Claim {
  std::string text;
  Verdict verdict;
  std::string reason;
};

struct Picture {
  std::string file;
  std::string caption;
  std::string svg;
};

/// What the report says of one paper. Everything but `times` is the same in every run.
struct Section {
  std::string name;  ///< of its file and for --only
  std::string title;
  std::string introduction;
  std::vector<Table> tables{};
  std::vector<Table> times{};
  std::vector<Claim> claims{};
  std::vector<Picture> pictures{};
};

/// A file of the report.
struct File {
  std::string name;
  std::string text;
};

std::string_view to_string(Verdict verdict);

/// The report's files: one per section with its pictures, README.md if `is_whole`, and times.md.
std::vector<File> files_of(const std::vector<Section>& sections, bool is_whole);

/// All tables, one figure a line.
std::string csv_of(const std::vector<Section>& sections);

/// The number with so many decimals; "-" for NaN and for nothing.
std::string fixed(double value, int decimals);
std::string fixed(const std::optional<double>& value, int decimals);
/// The change from `from` to `to`, such as "-3.4 %".
std::string change(double from, double to, int decimals = 1);
/// 100 (1 - to / from), such as "6.4 %".
std::string saving(double from, double to, int decimals = 1);

/// A line on stderr that says what is under way, if that is a terminal.
class Progress {
 public:
  void say(const std::string& what);
  void finish();

 private:
  std::size_t width_ = 0;
};

struct Options {
  std::uint64_t seed = 1;
  std::size_t rounds = 5;  ///< times are the least over so many runs; 0: no times
};

Section dsp_section(const Options& options, Progress& progress);
Section rrt_star_section(const Options& options, Progress& progress);
Section ssa_astar_section(const Options& options, Progress& progress);
/// Empty without the map.
std::optional<Section> city_section(const Options& options, Progress& progress);
Section jps_theta_star_section(const Options& options, Progress& progress);
Section rea_star_section(const Options& options, Progress& progress);

}  // namespace reproduce
