// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

#include "support/catch.hpp"
#include "tutavia/io/text/read_file.hpp"

/// \file
/// Tables of inputs and of exactly what a reader makes of them.

namespace tutavia::test {

/// A text, or the name of a file in tests/data/inputs, and what `exact_text` says of it.
struct InputRow {
  std::string_view input;
  std::string_view expected;

  bool is_refused() const { return expected.substr(0, 7) == "error: "; }
};

inline std::filesystem::path input_folder() {
  return std::filesystem::path(TUTAVIA_TEST_DATA) / "inputs";
}
inline std::string read_input(std::string_view name) {
  const auto text = detail::read_text(input_folder() / name);
  REQUIRE(text);
  return *text;
}

template <class Rows, class Read>
void check_texts(const Rows& rows, Read read) {
  for (const InputRow& row : rows) {
    INFO(row.input);
    CHECK(read(std::string(row.input)) == row.expected);
  }
}

/// The files of the table, which has all that end in one of `kinds`, but not those in the folder
/// `without`, and `more`.
template <class Rows, class Read>
void check_files(const Rows& rows, std::initializer_list<std::string_view> kinds,
                 std::initializer_list<std::string_view> more, Read read,
                 std::string_view without = {}) {
  std::size_t count = more.size();
  for (const auto& entry : std::filesystem::recursive_directory_iterator(input_folder())) {
    const std::string kind = entry.path().extension().string();
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) continue;
    if (entry.path().parent_path().filename() == without) continue;
    ++count;
  }
  CHECK(count == std::size(rows));
  for (const InputRow& row : rows) {
    INFO(row.input);
    CHECK(read(read_input(row.input)) == row.expected);
  }
}

/// Whether `refuses(text)` for exactly the inputs that the tables refuse.
template <class Files, class Texts, class Refuses>
void check_refused(const Files& files, const Texts& texts, Refuses refuses) {
  for (const InputRow& row : files) {
    INFO(row.input);
    CHECK(refuses(read_input(row.input)) == row.is_refused());
  }
  for (const InputRow& row : texts) {
    INFO(row.input);
    CHECK(refuses(std::string(row.input)) == row.is_refused());
  }
}

}  // namespace tutavia::test
