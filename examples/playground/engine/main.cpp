// SPDX-License-Identifier: MIT
#include <cstddef>
#include <iostream>
#include <string>

#include "engine.hpp"

/// \file
/// The engine as a program of the machine it runs on, to compare it with the one in the page. Reads
/// from stdin and writes to stdout: a line with the sizes of the JSON and of the bytes, then both.

int main() {
  std::ios::sync_with_stdio(false);
  playground::Engine engine;
  std::size_t request_size = 0, bytes_size = 0;
  while (std::cin >> request_size >> bytes_size && std::cin.get() == '\n') {
    std::string request(request_size, '\0'), bytes(bytes_size, '\0');
    std::cin.read(request.data(), static_cast<std::streamsize>(request_size));
    std::cin.read(bytes.data(), static_cast<std::streamsize>(bytes_size));
    if (!std::cin) return 1;
    const playground::Reply reply = engine.call(request, bytes);
    std::cout << reply.json.size() << ' ' << reply.bytes.size() << '\n'
              << reply.json << reply.bytes << std::flush;
  }
  return std::cin.eof() ? 0 : 1;
}
