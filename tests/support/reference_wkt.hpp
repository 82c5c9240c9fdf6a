// SPDX-License-Identifier: MIT
#pragma once

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "tutavia/world/workspace.hpp"

/// \file
/// reference_wkt: a second strict parser of WKT, which shares no code with the library's.

namespace tutavia::test {

/// Splits the text into tokens first, and reads numbers with strtod.
class ReferenceWkt {
 public:
  /// The obstacles of the text, or nothing for a text that must be refused.
  static std::optional<std::vector<Obstacle>> read(const std::string& text,
                                                   bool has_comments = true) {
    try {
      ReferenceWkt parser;
      parser.tokenize(text, has_comments);
      parser.all();
      return parser.out_;
    } catch (const Refused&) {
      return std::nullopt;
    }
  }

 private:
  struct Refused {};
  struct Token {
    char kind;  // w(ord), n(umber), c(omment), e(nd), or the character itself
    std::string text;
    bool glued;  // to the token before it
  };

  static bool blank(char c) { return c != 0 && std::string(" \t\n\v\f\r").find(c) < 6; }
  static bool digit(char c) { return c >= '0' && c <= '9'; }

  void tokenize(const std::string& text, bool has_comments) {
    const auto run = [&](std::size_t from, auto accepts) {
      std::size_t to = from;
      while (to < text.size() && accepts(text[to])) ++to;
      return text.substr(from, to - from);
    };
    bool glued = false;
    for (std::size_t i = 0; i < text.size();) {
      const char c = text[i];
      if (blank(c)) {
        glued = false;
        ++i;
        continue;
      }
      Token token{c, std::string(1, c), glued};
      if (has_comments && c == '#' && (i == 0 || text[i - 1] == '\n')) {
        token = {'c', run(i, [](char x) { return x != '\n'; }), glued};
        if (token.text.find('\r') < token.text.size() - 1) throw Refused{};
      } else if (digit(c) || c == '+' || c == '-' || c == '.') {
        token = {'n',
                 run(i,
                     [](char x) {
                       return digit(x) || x == '+' || x == '-' || x == '.' || x == 'e' || x == 'E';
                     }),
                 glued};
      } else if (c > 0 && std::isalpha(c) != 0) {
        token = {'w', run(i, [](char x) { return x > 0 && std::isalpha(x) != 0; }), glued};
        i += token.text.size();
        for (char& x : token.text) x = static_cast<char>(std::toupper(x));
        tokens_.push_back(token);
        glued = true;
        continue;
      }
      i += token.text.size();
      tokens_.push_back(token);
      glued = true;
    }
    tokens_.push_back({'e', "", false});
  }

  const Token& peek() const { return tokens_[at_]; }
  bool take(char kind) {
    if (peek().kind != kind) return false;
    if (kind != 'e') ++at_;
    return true;
  }
  void need(char kind) {
    if (!take(kind)) throw Refused{};
  }
  void comments() {
    while (take('c')) {
    }
  }

  void all() {
    comments();
    while (!take('e')) {
      const bool quoted = take('"');
      srid();
      geometry(0, 0);
      if (quoted) need('"');
      comments();
      if (take(',')) {
        comments();
        if (take('e')) throw Refused{};
      } else {
        take(';');
        comments();
      }
    }
  }
  void srid() {
    if (peek().text != "SRID") return;
    ++at_;
    if (!peek().glued) throw Refused{};
    need('=');
    const Token id = peek();
    need('n');
    static const std::regex whole("-?[0-9]+");
    if (!id.glued || !std::regex_match(id.text, whole)) throw Refused{};
    const double value = std::strtod(id.text.c_str(), nullptr);
    if (value > 2147483647.0 || value < -2147483648.0) throw Refused{};
    need(';');
  }

  void geometry(std::size_t outer_count, int depth) {
    std::string type = peek().text;
    need('w');
    std::size_t own = 0;
    const auto ends = [&](const char* tag) {
      const std::string end = tag;
      return type.size() > end.size() &&
             type.compare(type.size() - end.size(), end.size(), end) == 0;
    };
    if (ends("ZM")) {
      own = 4;
      type.resize(type.size() - 2);
    } else if (ends("Z") || ends("M")) {
      own = 3;
      type.pop_back();
    } else if (peek().kind == 'w' &&
               (peek().text == "Z" || peek().text == "M" || peek().text == "ZM")) {
      own = peek().text.size() + 2;
      ++at_;
    }
    if (own != 0 && outer_count != 0 && own != outer_count) throw Refused{};
    count_ = own != 0 ? own : outer_count;
    if (type == "GEOMETRYCOLLECTION") {
      if (depth == 16) throw Refused{};
      const std::size_t count = count_;
      list([&] { geometry(count, depth + 1); });
    } else if (!simple(type)) {
      throw Refused{};
    }
  }
  bool simple(const std::string& type) {
    if (type == "POINT") {
      point();
    } else if (type == "MULTIPOINT") {
      list([&] {
        if (peek().kind == 'n') {
          out_.emplace_back(Disc{vertex(), 0});
        } else {
          point();
        }
      });
    } else if (type == "LINESTRING" || type == "LINEARRING") {
      line(type == "LINEARRING");
    } else if (type == "MULTILINESTRING") {
      list([&] { line(false); });
    } else if (type == "POLYGON" || type == "TRIANGLE") {
      polygon(type == "TRIANGLE");
    } else if (type == "MULTIPOLYGON") {
      list([&] { polygon(false); });
    } else {
      return false;
    }
    return true;
  }

  bool empty() {
    if (peek().text != "EMPTY") return false;
    need('w');
    return true;
  }
  template <class Item>
  void list(Item item) {
    if (empty()) return;
    need('(');
    if (take(')')) return;
    do item();
    while (take(','));
    need(')');
  }
  void point() {
    if (empty()) return;
    need('(');
    out_.emplace_back(Disc{vertex(), 0});
    need(')');
  }
  Ring ring() {
    Ring points;
    list([&] { points.push_back(vertex()); });
    return points;
  }
  void line(bool closed) {
    const Ring points = ring();
    if (points.empty()) return;
    Ring wall = points;
    if (closed && points.front() != points.back()) wall.push_back(Point(points.front()));
    const Ring there = wall;
    for (std::size_t i = 1; i < there.size(); ++i) wall.push_back(there[there.size() - 1 - i]);
    out_.emplace_back(Polygon{wall});
  }
  void polygon(bool triangle) {
    const bool bare = peek().text == "EMPTY";
    std::vector<Ring> rings;
    list([&] { rings.push_back(ring()); });
    if (triangle && !bare && rings.size() != 1) throw Refused{};
    if (rings.empty()) return;
    if (rings[0].empty()) {
      if (rings.size() > 1) throw Refused{};
      return;
    }
    if (triangle) {
      const std::size_t n = rings[0].size();
      if (n - (rings[0].front() == rings[0].back() ? 1 : 0) != 3) throw Refused{};
    }
    Polygon polygon{rings[0]};
    for (std::size_t i = 1; i < rings.size(); ++i) {
      if (!rings[i].empty()) polygon.holes.push_back(rings[i]);
    }
    out_.emplace_back(polygon);
  }

  Point vertex() {
    std::vector<double> ordinates;
    while (peek().kind == 'n') {
      ordinates.push_back(number(peek().text));
      ++at_;
    }
    if (ordinates.size() < 2 || ordinates.size() > 4) throw Refused{};
    if (count_ == 0) count_ = ordinates.size();
    if (count_ != ordinates.size()) throw Refused{};
    return {ordinates[0], ordinates[1]};
  }
  static double number(const std::string& text) {
    static const std::regex decimal("[-+]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)?");
    if (!std::regex_match(text, decimal)) throw Refused{};
    const double value = std::strtod(text.c_str(), nullptr);
    const std::string mantissa = text.substr(0, text.find_first_of("eE"));
    if (!std::isfinite(value)) throw Refused{};
    if (value == 0 && mantissa.find_first_of("123456789") != std::string::npos) throw Refused{};
    return value;
  }

  std::vector<Token> tokens_;
  std::size_t at_ = 0, count_ = 0;
  std::vector<Obstacle> out_;
};

}  // namespace tutavia::test
