// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/core/parts/read_number.hpp"
#include "tutavia/io/text/parse_error.hpp"
#include "tutavia/io/text/ros_map_values.hpp"
#include "tutavia/io/text/source_text.hpp"
#include "tutavia/io/text/yaml_node.hpp"

/// \file
/// RosSettingsReader: the keys of a ROS map.

namespace tutavia::detail {

/// Reads the keys of a ROS map from the nodes of its YAML document, whatever parsed it. Throws
/// ParseError with the line.
class RosSettingsReader {
 public:
  explicit RosSettingsReader(YamlDocument document) : nodes_(std::move(document)) {
    const YamlNode& root = nodes_.front();
    if (root.kind == Kind::nothing) return;
    if (root.kind != Kind::map) reject(root.line, "a map of keys", shown(root));
    for (std::size_t i = 0; i + 1 < root.children.size(); i += 2) add_key(root.children, i);
  }

  RosMapSettings read() {
    constexpr double max = std::numeric_limits<double>::max();
    const YamlNode& image = require("image");
    settings_.image = scalar(image, "image: the name of a file");
    if (settings_.image.empty()) reject(image.line, "image: the name of a file", shown(image));
    settings_.map.resolution =
        number("resolution", require("resolution"), std::numeric_limits<double>::denorm_min(), max,
               "a number above 0");
    read_origin(max);
    read_negate();
    settings_.occupied_thresh = threshold("occupied_thresh", 0.65, 1, "a number from 0 to 1");
    settings_.free_thresh = threshold("free_thresh", 0.25, settings_.occupied_thresh,
                                      "a number from 0 to occupied_thresh");
    read_mode();
    for (const auto& [line, key] : unknown_) {
      warn(std::string("line ").append(std::to_string(line)).append(": unknown key ") + key);
    }
    return std::move(settings_);
  }

 private:
  using Kind = YamlNode::Kind;
  using Mode = RosMapSettings::Mode;
  static constexpr std::array<std::string_view, 7> known{
      "image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh", "mode"};

  void add_key(const std::vector<std::size_t>& children, std::size_t i) {
    const YamlNode& key = nodes_[children[i]];
    // yaml-cpp places a missing value where the next key begins.
    YamlNode& value = nodes_[children[i + 1]];
    if (value.kind == Kind::nothing) value.line = key.line;
    const std::string name = key.kind == Kind::scalar ? key.text : shown(key);
    const auto [entry, is_new] = values_.insert({name, {key.line, children[i + 1]}});
    if (!is_new) {
      reject(key.line, "every key once",
             shown_text(name) + " again, first in line " + std::to_string(entry->second.line));
    }
    const bool is_known = std::find(known.begin(), known.end(), name) != known.end();
    if (!is_known) unknown_.emplace_back(key.line, shown_text(name));
  }

  void read_origin(double max) {
    const YamlNode& list = require("origin");
    if (list.kind != Kind::list || list.children.size() != 3) {
      reject(list.line, "origin with 3 values", shown(list));
    }
    const std::string what = "x, y and yaw";
    const auto item = [&](std::size_t i) -> const YamlNode& { return nodes_[list.children[i]]; };
    const double x = number("origin", item(0), -max, max, what);
    settings_.map.origin = {x, number("origin", item(1), -max, max, what)};
    if (is_nan(item(2))) {
      warn(at(list.line) + "the yaw of origin is not a number: 0 is assumed");
    } else {
      settings_.map.yaw = number("origin", item(2), -max, max, what);
    }
  }

  /// As map_server does: a whole number, or else a truth value of YAML 1.1.
  void read_negate() {
    const YamlNode* const node = find("negate");
    if (node == nullptr) return warn("the key negate is missing: 0 is assumed");
    const std::string text = scalar(*node, "negate: 0 or 1");
    const auto number = read_whole_text<std::int64_t>(without_plus(text));
    const std::optional<bool> truth = number ? std::optional(*number != 0) : truth_of(text);
    if (!truth) reject(node->line, "negate: 0 or 1", shown(*node));
    settings_.negate = *truth;
    if (number && *number != 0 && *number != 1) {
      warn(at(node->line) + "negate: " + std::to_string(*number) + " counts as 1");
    }
  }

  void read_mode() {
    const std::string modes = "mode: trinary, scale or raw";
    const YamlNode* const node = find("mode");
    const std::string mode = node == nullptr ? "trinary" : lower_case(scalar(*node, modes));
    if (mode == "scale") {
      settings_.mode = Mode::scale;
    } else if (mode == "raw") {
      settings_.mode = Mode::raw;
      if (settings_.negate) warn("negate changes nothing in raw mode");
    } else if (mode != "trinary") {
      reject(node->line, modes, shown(*node));
    }
  }

  double threshold(const char* key, double otherwise, double high, const char* what) {
    if (const YamlNode* const node = find(key)) return number(key, *node, 0, high, what);
    const std::string text = otherwise == 0.25 ? "0.25" : "0.65";
    if (otherwise > high) {
      throw ParseError{std::string("the key ")
                           .append(key)
                           .append(" is missing, and its default, ")
                           .append(text)
                           .append(", is above occupied_thresh")};
    }
    warn(std::string("the key ").append(key).append(" is missing: ").append(text) + " is assumed");
    return otherwise;
  }

  const YamlNode* find(const std::string& key) const {
    const auto entry = values_.find(key);
    return entry == values_.end() ? nullptr : &nodes_[entry->second.value];
  }
  const YamlNode& require(const std::string& key) const {
    const YamlNode* const node = find(key);
    if (node == nullptr) throw ParseError{"the key " + key + " is missing"};
    return *node;
  }
  static const std::string& scalar(const YamlNode& node, const std::string& expected) {
    if (node.kind != Kind::scalar) reject(node.line, expected, shown(node));
    return node.text;
  }
  /// A number in the forms of yaml-cpp that are finite.
  static double number(const std::string& key, const YamlNode& node, double low, double high,
                       const std::string& what) {
    const std::string expected = std::string(key).append(": ").append(what);
    const auto value = read_whole_text<double>(without_plus(scalar(node, expected)));
    if (!value || !(low <= *value && *value <= high)) reject(node.line, expected, shown(node));
    return *value;
  }
  static std::string_view without_plus(std::string_view text) {
    const bool has_plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
    return has_plus ? text.substr(1) : text;
  }
  /// As printf and as YAML spell it.
  static bool is_nan(const YamlNode& node) {
    if (node.kind != Kind::scalar) return false;
    std::string text = lower_case(node.text);
    if (!text.empty() && (text[0] == '-' || text[0] == '+')) text.erase(0, 1);
    return text == "nan" || text == ".nan";
  }
  static std::optional<bool> truth_of(const std::string& text) {
    const std::string lower = lower_case(text);
    std::string upper = lower, capital = lower;
    std::transform(upper.begin(), upper.end(), upper.begin(), in_upper_case);
    if (!capital.empty()) capital.front() = upper.front();
    if (text != lower && text != upper && text != capital) return std::nullopt;
    if (lower == "true" || lower == "yes" || lower == "on" || lower == "y") return true;
    if (lower == "false" || lower == "no" || lower == "off" || lower == "n") return false;
    return std::nullopt;
  }
  static char in_upper_case(char c) {
    return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  static std::string lower_case(std::string text) {
    for (char& c : text) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
  }

  /// A node in a message.
  static std::string shown(const YamlNode& node) {
    switch (node.kind) {
      case Kind::nothing:
        return "nothing";
      case Kind::list:
        return "a list of " + std::to_string(node.children.size());
      case Kind::map:
        return "a map";
      case Kind::scalar:
        break;
    }
    return shown_text(node.text);
  }
  /// A text in one line, cut short.
  static std::string shown_text(const std::string& text) {
    if (text.empty()) return "\"\"";
    const std::string line = printable_line(std::string_view(text).substr(0, 61));
    return line.size() > 60 ? line.substr(0, 60) + "..." : line;
  }
  static std::string at(std::size_t line) { return "line " + std::to_string(line) + ": "; }
  void warn(std::string text) { settings_.map.warnings.push_back(std::move(text)); }
  [[noreturn]] static void reject(std::size_t line, const std::string& expected,
                                  const std::string& found) {
    throw ParseError{at(line).append("expected ").append(expected).append(", found ") + found};
  }

  struct Entry {
    std::size_t line;   // of the key
    std::size_t value;  // its node
  };
  YamlDocument nodes_;
  std::map<std::string, Entry> values_{};
  std::vector<std::pair<std::size_t, std::string>> unknown_{};
  RosMapSettings settings_{};
};

}  // namespace tutavia::detail
