// SPDX-License-Identifier: MIT
#include "report.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace reproduce {

namespace {

/// A paragraph in lines of at most 100 columns.
std::string paragraph(const std::string& text) {
  std::string result;
  std::size_t column = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    if (column > 0 && column + 1 + (end - begin) > 100) {
      result += '\n';
      column = 0;
    }
    if (column > 0) result += ' ';
    column += (column > 0 ? 1 : 0) + (end - begin);
    result.append(text, begin, end - begin);
    begin = end + 1;
  }
  return result + "\n\n";
}

void append_table(std::string& text, const Table& table) {
  text += paragraph(table.title);
  const auto line = [&](const std::vector<std::string>& cells) {
    text += "|";
    for (const std::string& cell : cells) text.append(" ").append(cell).append(" |");
    text += "\n";
  };
  line(table.header);
  text += "|---|";
  for (std::size_t i = 1; i < table.header.size(); ++i) text += "---:|";
  text += "\n";
  for (const auto& row : table.rows) line(row);
  text += "\n";
}

void append_claims(std::string& text, const std::vector<Claim>& claims) {
  if (claims.empty()) return;
  text += "## What the paper says, and what came out\n\n| claim | verdict | why |\n|---|---|---|\n";
  for (const Claim& claim : claims) {
    text.append("| ").append(claim.text).append(" | ").append(to_string(claim.verdict));
    text.append(" | ").append(claim.reason).append(" |\n");
  }
  text += "\n";
}

constexpr std::string_view written_by =
    "<!-- Written by tutavia-reproduce (benchmarks/reproduce); see README.md. -->\n\n";

std::string page_of(const Section& section) {
  std::string text(written_by);
  text.append("# ").append(section.title).append("\n\n");
  text += paragraph(section.introduction);
  append_claims(text, section.claims);
  text += "## Tables\n\n";
  for (const Table& table : section.tables) append_table(text, table);
  if (!section.pictures.empty()) text += "## Pictures\n\n";
  for (const Picture& picture : section.pictures) {
    text.append(paragraph(picture.caption)).append("![").append(picture.file).append("](");
    text.append(picture.file).append(")\n\n");
  }
  text.pop_back();
  return text;
}

std::string summary_of(const std::vector<Section>& sections) {
  std::string text(written_by);
  text +=
      "# The five papers, reproduced\n\n"
      "`tutavia-reproduce` writes this folder: every table of the five papers, each figure as\n"
      "published, by the paper's rules, by the library's, and the best that the library can do. "
      "The\n"
      "same command with the same seed writes the same files, but for `times.md`.\n\n"
      "```sh\n"
      "tutavia-reproduce --output docs/reproduction   # all of it\n"
      "tutavia-reproduce --only dsp --csv dsp.csv     # one paper, and its figures as CSV\n"
      "tutavia-reproduce --check docs/reproduction    # compares with what is there\n"
      "```\n\n"
      "The papers print no maps that can be read by a program. What stands for them, and what is\n"
      "uncertain for that reason, is said on each page. Lengths are metres among polygons and "
      "cells\n"
      "on grids. A path of the library is always proved: `proved` counts them nevertheless.\n\n";
  const auto first = std::find_if(sections.begin(), sections.end(),
                                  [](const Section& section) { return section.name == "dsp"; });
  if (first != sections.end()) append_table(text, first->tables.front());
  text += "| page | paper |\n|---|---|\n";
  for (const Section& section : sections) {
    text.append("| [").append(section.name).append("](").append(section.name);
    text.append(".md) | ").append(section.title).append(" |\n");
  }
  text += "| [times](times.md) | times, as ratios; of one machine |\n\n## All verdicts\n\n";
  text += "| paper | claim | verdict |\n|---|---|---|\n";
  for (const Section& section : sections) {
    for (const Claim& claim : section.claims) {
      text.append("| [").append(section.name).append("](").append(section.name);
      text.append(".md) | ").append(claim.text).append(" | ");
      text.append(to_string(claim.verdict)).append(" |\n");
    }
  }
  return text;
}

std::string times_of(const std::vector<Section>& sections) {
  std::string text(written_by);
  text +=
      "# Times\n\n"
      "Least times over several runs, as ratios to A\\* on the same tasks. Published times come "
      "from\n"
      "other machines and languages, so ratios alone can be compared.\n\n";
  for (const Section& section : sections) {
    for (const Table& table : section.times) append_table(text, table);
  }
  text.pop_back();
  return text;
}

}  // namespace

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::reproduced:
      return "reproduced";
    case Verdict::tendency:
      return "in tendency";
    case Verdict::not_reproducible:
      return "not reproducible";
    case Verdict::not_so:
      return "does not come out";
    case Verdict::wrong:
      break;
  }
  return "wrong in the paper";
}

std::vector<File> files_of(const std::vector<Section>& sections, bool is_whole) {
  std::vector<File> files;
  if (is_whole) files.push_back({"README.md", summary_of(sections)});
  for (const Section& section : sections) {
    files.push_back({section.name + ".md", page_of(section)});
    for (const Picture& picture : section.pictures) files.push_back({picture.file, picture.svg});
  }
  if (is_whole) files.push_back({"times.md", times_of(sections)});
  return files;
}

std::string csv_of(const std::vector<Section>& sections) {
  const auto quoted = [](const std::string& text) {
    std::string result = "\"";
    for (const char c : text) result.append(c == '"' ? 2 : 1, c);
    return result + "\"";
  };
  std::string csv = "paper,table,row,column,value\n";
  for (const Section& section : sections) {
    for (const auto* tables : {&section.tables, &section.times}) {
      for (const Table& table : *tables) {
        for (const auto& row : table.rows) {
          for (std::size_t i = 1; i < row.size(); ++i) {
            csv.append(section.name).append(",").append(quoted(table.name)).append(",");
            csv.append(quoted(row[0])).append(",").append(quoted(table.header[i]));
            csv.append(",").append(quoted(row[i])).append("\n");
          }
        }
      }
    }
  }
  return csv;
}

std::string fixed(double value, int decimals) {
  if (std::isnan(value)) return "-";
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*f", decimals, value);
  return buffer.data();
}

std::string fixed(const std::optional<double>& value, int decimals) {
  return value ? fixed(*value, decimals) : "-";
}

std::string change(double from, double to, int decimals) {
  if (std::isnan(from) || std::isnan(to)) return "-";
  const double percent = 100 * (to / from - 1);
  return std::string(percent >= 0 ? "+" : "") + fixed(percent, decimals) + " %";
}

std::string saving(double from, double to, int decimals) {
  if (std::isnan(from) || std::isnan(to)) return "-";
  return fixed(100 * (1 - to / from), decimals) + " %";
}

void Progress::say(const std::string& what) {
  if (::isatty(STDERR_FILENO) == 0) return;
  const std::size_t gap = width_ > what.size() ? width_ - what.size() : 0;
  std::fprintf(stderr, "\r%s%*s", what.c_str(), static_cast<int>(gap), "");
  std::fflush(stderr);
  width_ = what.size();
}

void Progress::finish() {
  say("");
  if (width_ == 0 && ::isatty(STDERR_FILENO) != 0) std::fputs("\r", stderr);
}

}  // namespace reproduce
