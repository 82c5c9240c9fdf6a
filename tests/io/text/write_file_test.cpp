// SPDX-License-Identifier: MIT
#include "tutavia/io/text/write_file.hpp"

#include <iterator>

#include "support/catch.hpp"

namespace {

namespace fs = std::filesystem;
using namespace tutavia;
using namespace tutavia::detail;

std::string read(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST_CASE("a file is replaced as a whole, and nothing is left beside it") {
  const fs::path folder = fs::temp_directory_path() / "tutavia_write_file_test";
  fs::remove_all(folder);
  fs::create_directories(folder);
  CHECK(write_file(folder / "a.txt", "first"));
  CHECK(write_file(folder / "a.txt", "second"));
  CHECK(read(folder / "a.txt") == "second");
  CHECK(std::distance(fs::directory_iterator(folder), fs::directory_iterator()) == 1);
  fs::remove_all(folder);
}

TEST_CASE("what cannot be written is reported with its path and the reason") {
  const fs::path nowhere = fs::temp_directory_path() / "tutavia_no_such_folder" / "a.txt";
  const auto missing = write_file(nowhere, "text");
  REQUIRE_FALSE(missing);
  CHECK(missing.error().code == PlanError::invalid_input);
  CHECK(missing.error().detail.find(nowhere.string()) != std::string::npos);
  CHECK(missing.error().detail.find("No such file") != std::string::npos);
  const auto folder = write_file(fs::temp_directory_path(), "text");
  REQUIRE_FALSE(folder);
  CHECK(folder.error().detail.find("directory") != std::string::npos);
  if (fs::exists("/dev/full")) {
    CHECK_FALSE(write_file("/dev/full", "text"));
    CHECK(fs::exists("/dev/full"));
  }
}

}  // namespace
