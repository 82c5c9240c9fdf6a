// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "tutavia/io/text/parse_error.hpp"

/// \file
/// YamlSubset: the part of YAML that the files of ROS maps need.

namespace tutavia::detail {

/// A flat YAML document: each key has a scalar or a list of scalars, plain or in quotes without
/// inner quotes or escapes. All members throw ParseError with the line of anything else.
class YamlSubset {
 public:
  explicit YamlSubset(std::string_view text) {
    for (; !text.empty(); ++line_) {
      content_ = text.substr(0, text.find('\n'));
      text.remove_prefix(std::min(text.size(), content_.size() + 1));
      read_line();
    }
  }

  bool has(std::string_view key) { return find(key) != nullptr; }
  /// The only value of a key.
  const std::string& value(const std::string& key) { return values(key, 1)[0]; }
  /// Value `i` of the `count` values of a key, a number from `low` to `high`.
  double number(const std::string& key, double low, double high, const std::string& what,
                std::size_t i = 0, std::size_t count = 1) {
    const std::string& text = values(key, count)[i];
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() ||
        !(low <= value && value <= high)) {
      reject(key + ": " + what, text);
    }
    return value;
  }
  /// A warning for each key that was never read.
  std::vector<std::string> warnings() const {
    std::vector<std::string> result;
    for (const Entry& entry : entries_) {
      if (entry.used) continue;
      result.push_back("line " + std::to_string(entry.line) + ": unknown key " + entry.key);
    }
    return result;
  }

  /// Throws an error about the line of the key that was read last.
  [[noreturn]] void reject(const std::string& expected, const std::string& found) const {
    throw ParseError{"line " + std::to_string(line_) + ": expected " + expected + ", found " +
                     found};
  }

 private:
  static constexpr std::size_t npos = std::string_view::npos;
  struct Entry {
    std::string key{};
    std::size_t line = 0;
    std::vector<std::string> values{};
    bool is_open = false;  ///< list items may follow
    bool used = false;
  };

  void read_line() {
    if (content_.ends_with('\r')) content_.remove_suffix(1);
    if (content_.find_first_of(std::string_view("\r\0", 2)) != npos) reject("text, LF or CRLF");
    for (std::size_t i = 0; i < content_.size(); ++i) {
      if (content_[i] == '#' && (i == 0 || is_blank(i - 1))) content_ = content_.substr(0, i);
    }
    const std::size_t indent = content_.find_first_not_of(" \t");
    content_ = trimmed(content_);
    if (content_.empty()) return;
    if (content_ == "---" && entries_.empty() && !std::exchange(has_marker_, true)) return;
    if (content_.front() == '-' && is_blank(1)) {
      read_item(indent);
    } else {
      read_entry(indent);
    }
  }

  /// Parses "- value", an item of the open list.
  void read_item(std::size_t indent) {
    if (entries_.empty() || !entries_.back().is_open) reject("key: value");
    if (entries_.back().values.empty()) indent_ = indent;
    if (indent != indent_) reject("list items one below the other");
    add(entries_.back(), content_.substr(1));
  }

  /// Parses "key: value", "key: [value, value]", or "key:" before a list.
  void read_entry(std::size_t indent) {
    const std::size_t colon = content_.find(':');
    Entry entry{std::string(trimmed(content_.substr(0, colon))), line_};
    const auto is_name = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
    if (indent != 0 || colon == npos || !is_blank(colon + 1) || entry.key.empty() ||
        !std::all_of(entry.key.begin(), entry.key.end(), is_name)) {
      reject("key: value, not indented");
    }
    if (has(entry.key)) reject("every key once");
    std::string_view value = trimmed(content_.substr(colon + 1));
    entry.is_open = value.empty();
    if (value.starts_with('[') && value.ends_with(']')) {
      value = value.substr(1, value.size() - 2);
      if (value.find_first_of("[]{}") != npos) reject("a list of scalars");
      for (std::size_t comma = value.find(','); comma != npos; comma = value.find(',')) {
        add(entry, value.substr(0, comma));
        value.remove_prefix(comma + 1);
      }
    }
    if (!entry.is_open) add(entry, value);
    entries_.push_back(std::move(entry));
  }

  void add(Entry& entry, std::string_view scalar) const {
    scalar = trimmed(scalar);
    const auto has = [&](std::string_view part) { return scalar.find(part) != npos; };
    if (scalar.empty()) reject("a value");
    const char first = scalar.front();
    if (first == '"' || first == '\'') {
      if (scalar.size() < 2 || scalar.back() != first) reject("quotes around all of a value");
      scalar = scalar.substr(1, scalar.size() - 2);
      if (scalar.find_first_of("\"'\\") != npos) reject("no quotes or escapes in quotes");
    } else if (std::string_view("[]{}&*!|>%@`,?:").find(first) != npos ||
               scalar.starts_with("- ") || has(": ") || has(":\t") || scalar.back() == ':') {
      reject("a plain value or a list in one line");
    }
    entry.values.emplace_back(scalar);
  }

  bool is_blank(std::size_t i) const {
    return i >= content_.size() || content_[i] == ' ' || content_[i] == '\t';
  }
  static std::string_view trimmed(std::string_view text) {
    text = text.substr(0, text.find_last_not_of(" \t") + 1);
    return text.substr(std::min(text.find_first_not_of(" \t"), text.size()));
  }

  Entry* find(std::string_view key) {
    const auto has_key = [&](const Entry& entry) { return entry.key == key; };
    const auto entry = std::find_if(entries_.begin(), entries_.end(), has_key);
    return entry == entries_.end() ? nullptr : &*entry;
  }
  const std::vector<std::string>& values(const std::string& key, std::size_t count) {
    Entry* const entry = find(key);
    if (entry == nullptr) throw ParseError{"the key " + key + " is missing"};
    entry->used = true;
    line_ = entry->line;
    const std::size_t found = entry->values.size();
    if (found != count) {
      reject(key + " with " + std::to_string(count) + (count == 1 ? " value" : " values"),
             std::to_string(found));
    }
    return entry->values;
  }

  /// Throws an error about the current line.
  [[noreturn]] void reject(const std::string& expected) const {
    reject(expected, '"' + std::string(content_.substr(0, 60)) + '"');
  }

  std::string_view content_;  // of the current line
  std::size_t line_ = 1;
  std::size_t indent_ = 0;  // of the items of a list
  bool has_marker_ = false;
  std::vector<Entry> entries_;
};

}  // namespace tutavia::detail
