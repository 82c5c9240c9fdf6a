// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tutavia/io/text/parse_error.hpp"
#include "tutavia/io/text/source_text.hpp"

/// \file
/// parse_json_text: JSON values from a text, more strictly than nlohmann/json.

namespace tutavia::detail {

/// Iterates over bytes and notes how far anything has read.
class JsonSource {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  JsonSource(const char* at, const char*& reached) : at_(at), reached_(&reached) {}
  reference operator*() const { return *at_; }
  JsonSource& operator++() {
    *reached_ = ++at_;
    return *this;
  }
  JsonSource operator++(int) {
    JsonSource before = *this;
    ++*this;
    return before;
  }
  bool operator==(const JsonSource& other) const { return at_ == other.at_; }
  bool operator!=(const JsonSource& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  const char** reached_;
};

/// Builds nothing; throws a ParseError with line and column for malformed JSON, and for what
/// nlohmann/json lets pass: a number that is not 0 and becomes 0, and a key that an object has
/// already.
class JsonCheck : public nlohmann::json_sax<nlohmann::json> {
 public:
  /// Checks the bytes [begin, end) of a text.
  void check(std::string_view text, std::size_t begin, std::size_t end) {
    text_ = text;
    begin_ = begin;
    reached_ = text.data() + begin;
    const char* end_reached = text.data() + end;
    nlohmann::json::sax_parse(JsonSource(reached_, reached_), JsonSource(end_reached, end_reached),
                              this);
  }

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t value, const std::string& token) override {
    const std::string_view digits = std::string_view(token).substr(0, token.find_first_of("eE"));
    if (value == 0 && digits.find_first_of("123456789") != std::string_view::npos) {
      const std::size_t at = text_.rfind(token, static_cast<std::size_t>(reached_ - text_.data()));
      throw ParseError{position_text(text_, at) + "the number " + token +
                       " is too small for a double"};
    }
    return true;
  }
  bool string(std::string&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override {
    keys_.emplace_back();
    return true;
  }
  bool key(std::string& name) override {
    if (!keys_.back().insert(name).second) {
      const auto read = static_cast<std::size_t>(reached_ - text_.data());
      throw ParseError{position_text(text_, read - 1) + "the key \"" + printable_line(name) +
                       "\" stands in its object twice"};
    }
    return true;
  }
  bool end_object() override {
    keys_.pop_back();
    return true;
  }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::json::exception& exception) override {
    // "[json.exception.parse_error.101] parse error at line 3, column 4: syntax error while ..."
    std::string_view what = exception.what();
    what.remove_prefix(std::min(what.size(), what.find("] ") + 2));
    if (what.substr(0, 14) == "parse error at") what.remove_prefix(what.find(": ") + 2);
    const std::size_t last_read = begin_ + std::max<std::size_t>(position, 1) - 1;
    throw ParseError{position_text(text_, std::min(last_read, text_.size())) +
                     printable_line(what)};
  }

 private:
  std::string_view text_;
  std::size_t begin_ = 0;
  const char* reached_ = nullptr;
  std::vector<std::set<std::string>> keys_;  // of the objects that are open
};

/// The value that the bytes [begin, end) of a text are. Throws ParseError with line and column in
/// the text, also for a NUL byte, which nlohmann/json takes for the end.
inline nlohmann::json parse_json_text(std::string_view text, std::size_t begin, std::size_t end) {
  const std::string_view part = text.substr(begin, end - begin);
  if (const std::size_t nul = part.find('\0'); nul != std::string_view::npos) {
    throw ParseError{position_text(text, begin + nul) + "expected JSON, found byte 0x00"};
  }
  // Versions of nlohmann/json do not agree on what they say of nothing.
  if (part.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    throw ParseError{position_text(text, end) + "expected JSON, found nothing"};
  }
  JsonCheck{}.check(text, begin, end);
  return nlohmann::json::parse(part);
}

/// The same of a whole text; a byte order mark is skipped.
inline nlohmann::json parse_json_text(std::string_view text) {
  text = without_byte_order_mark(text);
  return parse_json_text(text, 0, text.size());
}

}  // namespace tutavia::detail
