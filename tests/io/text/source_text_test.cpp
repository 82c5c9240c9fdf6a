// SPDX-License-Identifier: MIT
#include "tutavia/io/text/source_text.hpp"

#include <string>

#include "support/catch.hpp"

namespace {

using namespace tutavia;

TEST_CASE("positions count lines and bytes from 1") {
  const std::string text = "ab\ncd\n";
  CHECK(detail::position_text(text, 0) == "line 1, column 1: ");
  CHECK(detail::position_text(text, 2) == "line 1, column 3: ");
  CHECK(detail::position_text(text, 3) == "line 2, column 1: ");
  CHECK(detail::position_text(text, 6) == "line 3, column 1: ");
  CHECK(detail::position_text("", 0) == "line 1, column 1: ");
  CHECK(detail::line_number(text, 4) == 2);
}

TEST_CASE("messages show printable text in quotes and all other bytes in hex") {
  CHECK(detail::shown_text("") == "\"\"");
  CHECK(detail::shown_text("a b") == "\"a b\"");
  CHECK(detail::shown_text("\xC3\xA9") == "byte 0xC3");
  CHECK(detail::shown_text(std::string(1, '\0')) == "byte 0x00");
  CHECK(detail::shown_text("a\x7F"
                           "b") == "\"a\" and byte 0x7F");
  CHECK(detail::shown_text(std::string(70, 'x')) == '"' + std::string(60, 'x') + '"');
  CHECK(detail::shown_word("one two") == "\"one\"");
  CHECK(detail::shown_word(" two") == "\" \"");
  CHECK(detail::shown_word("\ntwo") == "byte 0x0A");
  CHECK(detail::shown_word(std::string(70, 'x')) == '"' + std::string(20, 'x') + '"');
  CHECK(detail::printable_line("a\xC3\nb") == "a<0xC3><0x0A>b");
}

TEST_CASE("one byte order mark is skipped at the start alone") {
  CHECK(detail::without_byte_order_mark("\xEF\xBB\xBFx") == "x");
  CHECK(detail::without_byte_order_mark("\xEF\xBB\xBF\xEF\xBB\xBF") == "\xEF\xBB\xBF");
  CHECK(detail::without_byte_order_mark("x\xEF\xBB\xBF") == "x\xEF\xBB\xBF");
  CHECK(detail::without_byte_order_mark("\xEF\xBB") == "\xEF\xBB");
}

TEST_CASE("words are compared in any case of ASCII letters alone") {
  CHECK(detail::equal_in_any_case("pOiNt", "POINT"));
  CHECK_FALSE(detail::equal_in_any_case("POINT", "POINTZ"));
  CHECK_FALSE(detail::equal_in_any_case("[", "{"));
  CHECK_FALSE(detail::equal_in_any_case("\xC3\x84", "\xC3\xA4"));
}

}  // namespace
