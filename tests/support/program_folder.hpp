// SPDX-License-Identifier: MIT
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

/// \file
/// ProgramFolder: an empty folder in which a test runs a program.

namespace tutavia::test {

/// The exit code of a program, and what it wrote to stdout and stderr.
struct Outcome {
  int code = -1;
  std::string out, err;
};

inline std::string file_text(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// A folder of its own for one test, deleted at the end.
class ProgramFolder {
 public:
  /// `name` is that of the folder, for one test at a time in each process.
  ProgramFolder(const std::string& name, std::string program)
      : path_(std::filesystem::temp_directory_path() / (name + "_" + std::to_string(::getpid()))),
        program_(std::move(program)) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~ProgramFolder() { std::filesystem::remove_all(path_); }
  ProgramFolder(const ProgramFolder&) = delete;
  ProgramFolder& operator=(const ProgramFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_),
                                                  std::filesystem::directory_iterator()));
  }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return path_ / name;
  }
  std::string read(const std::string& name) const { return file_text(path_ / name); }

  /// Runs the program in the folder, without input.
  Outcome run(const std::string& arguments) const {
    const std::filesystem::path out = path_.string() + ".out", err = path_.string() + ".err";
    const std::string command = "cd " + path_.string() + " && " + program_ + " " + arguments +
                                " > " + out.string() + " 2> " + err.string() + " < /dev/null";
    const int status = std::system(command.c_str());
    Outcome outcome{WEXITSTATUS(status), file_text(out), file_text(err)};
    std::filesystem::remove(out);
    std::filesystem::remove(err);
    return outcome;
  }

 private:
  std::filesystem::path path_;
  std::string program_;
};

}  // namespace tutavia::test
