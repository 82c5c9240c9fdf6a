// SPDX-License-Identifier: MIT
/// \file
/// tutavia-reproduce: every table of the five papers, as published and as this library has it.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "report.hpp"
#include "tutavia/io/text/write_file.hpp"

namespace {

using namespace reproduce;

struct Arguments {
  std::vector<std::string> only{};
  std::string output{}, check{}, csv{};
  Options options{};
};

struct Paper {
  std::string name;
  std::function<std::optional<Section>(const Options&, Progress&)> section;
};

const std::vector<Paper>& papers() {
  static const std::vector<Paper> all{{"dsp", dsp_section},
                                      {"rrt_star", rrt_star_section},
                                      {"ssa_astar", ssa_astar_section},
                                      {"city", city_section},
                                      {"jps_theta_star", jps_theta_star_section},
                                      {"rea_star", rea_star_section}};
  return all;
}

std::vector<Section> run_papers(const Arguments& args) {
  const auto is_chosen = [&](const std::string& name) {
    return args.only.empty() ||
           std::find(args.only.begin(), args.only.end(), name) != args.only.end();
  };
  std::vector<Section> sections;
  Progress progress;
  for (const Paper& paper : papers()) {
    if (!is_chosen(paper.name)) continue;
    auto section = paper.section(args.options, progress);
    progress.finish();
    if (section) {
      sections.push_back(std::move(*section));
    } else {
      std::fprintf(stderr, "tutavia-reproduce: %s is left out: set TUTAVIA_MOVINGAI_DIR\n",
                   paper.name.c_str());
    }
  }
  return sections;
}

void write(const std::filesystem::path& path, const std::string& text) {
  if (const auto written = tutavia::detail::write_file(path, text); !written) {
    throw std::runtime_error(written.error().detail);
  }
}

/// The first line in which two texts differ.
std::string first_difference(const std::string& a, const std::string& b) {
  const auto at = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  const auto line = [](const std::string& text, std::string::const_iterator position) {
    auto begin = position, end = position;
    while (begin != text.begin() && *(begin - 1) != '\n') --begin;
    while (end != text.end() && *end != '\n') ++end;
    return std::string(begin, end);
  };
  return "  is:     " + line(a, at.first) + "\n  should: " + line(b, at.second) + "\n";
}

/// Compares the files with those of a folder; times.md is not compared.
int check(const std::filesystem::path& folder, const std::vector<File>& files) {
  int differ = 0;
  for (const File& file : files) {
    if (file.name == "times.md") continue;
    std::ifstream stream(folder / file.name, std::ios::binary);
    const bool exists = stream.is_open();
    const std::string there{std::istreambuf_iterator<char>(stream), {}};
    if (exists && there == file.text) continue;
    ++differ;
    std::cout << (folder / file.name).string() << (exists ? " differs\n" : " is missing\n");
    if (exists) std::cout << first_difference(file.text, there);
  }
  std::cout << files.size() << " files, " << differ << " of them differ\n";
  return differ == 0 ? 0 : 1;
}

void print(const std::vector<Section>& sections) {
  for (const Section& section : sections) {
    std::cout << section.title << '\n';
    for (const Claim& claim : section.claims) {
      std::cout << "  [" << to_string(claim.verdict) << "] " << claim.text << "\n      "
                << claim.reason << '\n';
    }
  }
}

int run(Arguments args) {
  if (!args.check.empty()) args.options.rounds = 0;
  const std::vector<Section> sections = run_papers(args);
  const std::vector<File> files = files_of(sections, sections.size() == papers().size());
  if (!args.csv.empty()) write(args.csv, csv_of(sections));
  if (!args.check.empty()) return check(args.check, files);
  if (!args.output.empty()) {
    std::filesystem::create_directories(args.output);
    for (const File& file : files) write(std::filesystem::path(args.output) / file.name, file.text);
    std::cout << files.size() << " files written to " << args.output << '\n';
  } else if (args.csv.empty()) {
    print(sections);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments args;
  CLI::App app("The tables of the five papers, published figures beside ours", "tutavia-reproduce");
  std::vector<std::string> names;
  for (const Paper& paper : papers()) names.push_back(paper.name);
  app.add_option("--only", args.only,
                 "Of these papers: dsp, rrt_star, ssa_astar, city, "
                 "jps_theta_star, rea_star")
      ->delimiter(',')
      ->check(CLI::IsMember(names));
  app.add_option("--output", args.output, "Write the report into this folder");
  app.add_option("--check", args.check,
                 "Compare with the report in this folder; times are left out")
      ->excludes("--output");
  app.add_option("--csv", args.csv, "Write all figures to a file");
  app.add_option("--seed", args.options.seed, "Of the searches that draw random numbers")
      ->capture_default_str();
  app.add_option("--rounds", args.options.rounds, "Times are the least of so many runs")
      ->capture_default_str();
  try {
    app.parse(argc, argv);
    return run(args);
  } catch (const CLI::Success& request) {
    return app.exit(request);
  } catch (const std::exception& error) {
    std::cerr << "tutavia-reproduce: " << error.what() << '\n';
  }
  return 2;
}
