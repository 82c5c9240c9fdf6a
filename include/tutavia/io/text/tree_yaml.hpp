// SPDX-License-Identifier: MIT
#pragma once

#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <cstddef>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tutavia/io/text/grey_image.hpp"
#include "tutavia/io/text/parse_error.hpp"
#include "tutavia/io/text/source_text.hpp"
#include "tutavia/io/text/yaml_node.hpp"

/// \file
/// parse_yaml: YAML documents by yaml-cpp.

namespace tutavia::detail {

/// Keeps the nodes that yaml-cpp's parser reports.
class YamlTree : private YAML::EventHandler {
 public:
  /// Throws as `parse_yaml`.
  static YamlDocument parse(std::string_view text) { return std::move(YamlTree(text).nodes_); }

 private:
  using Kind = YamlNode::Kind;

  explicit YamlTree(std::string_view text) {
    check_characters(text);
    try {
      std::istringstream stream{std::string(text)};
      YAML::Parser parser(stream);
      parser.HandleNextDocument(*this);
      is_over_ = true;
      parser.HandleNextDocument(*this);
    } catch (const YAML::DeepRecursion& error) {
      throw ParseError{position(error.mark) + "nested too deeply"};
    } catch (const YAML::Exception& error) {
      if (error.mark.is_null()) throw ParseError{printable_line(error.msg)};
      throw ParseError{position(error.mark) + printable_line(error.msg)};
    }
    if (nodes_.empty()) nodes_.emplace_back();
  }

  static std::string position(const YAML::Mark& mark) {
    return "line " + std::to_string(mark.line + 1) + ", column " + std::to_string(mark.column + 1) +
           ": ";
  }
  /// yaml-cpp takes some control characters for the end of the text.
  static void check_characters(std::string_view text) {
    std::size_t line = 1;
    for (std::size_t i = 0; i < text.size(); ++i) {
      const auto c = static_cast<unsigned char>(text[i]);
      if (c == '\n') ++line;
      if ((c >= ' ' && c != 0x7F) || c == '\t' || c == '\n' || c == '\r') continue;
      throw ParseError{"line " + std::to_string(line) + ": expected text, found " +
                       shown_bytes(text.substr(i))};
    }
  }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (!is_over_) return;
    throw ParseError{"line " + std::to_string(mark.line + 1) +
                     ": expected the end of the file after the first document"};
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    add(Kind::nothing, mark, anchor);
  }
  void OnAlias(const YAML::Mark&, YAML::anchor_t anchor) override { attach(anchors_[anchor]); }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                const std::string& value) override {
    nodes_[add(Kind::scalar, mark, anchor)].text = value;
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open_.push_back(add(Kind::list, mark, anchor));
  }
  void OnSequenceEnd() override { open_.pop_back(); }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open_.push_back(add(Kind::map, mark, anchor));
  }
  void OnMapEnd() override { open_.pop_back(); }

  std::size_t add(Kind kind, const YAML::Mark& mark, YAML::anchor_t anchor) {
    const std::size_t index = nodes_.size();
    nodes_.push_back({kind, static_cast<std::size_t>(mark.line + 1)});
    attach(index);
    if (anchor != YAML::NullAnchor) {
      if (anchors_.size() <= anchor) anchors_.resize(anchor + 1);
      anchors_[anchor] = index;
    }
    return index;
  }
  void attach(std::size_t index) {
    if (!open_.empty()) nodes_[open_.back()].children.push_back(index);
  }

  YamlDocument nodes_{};
  std::vector<std::size_t> open_{};     // lists and maps around the current node
  std::vector<std::size_t> anchors_{};  // the node of each anchor
  bool is_over_ = false;                // the first document is
};

/// Parses one document. Throws ParseError with the line of malformed YAML, of a character that YAML
/// does not allow, and of a second document.
inline YamlDocument parse_yaml(std::string_view text) { return YamlTree::parse(text); }

}  // namespace tutavia::detail
