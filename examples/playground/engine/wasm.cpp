// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine.hpp"

/// \file
/// The engine as functions that a page calls.

namespace {

playground::Engine& engine() {
  static playground::Engine one;
  return one;
}

playground::Reply& last_reply() {
  static playground::Reply reply;
  return reply;
}

}  // namespace

extern "C" {

/// Answers a request; the reply lasts until the next one.
void tutavia_call(const char* request, const std::uint8_t* bytes, std::size_t size) {
  last_reply() = engine().call(request, {reinterpret_cast<const char*>(bytes), size});
}
const char* tutavia_reply() { return last_reply().json.c_str(); }
const std::uint8_t* tutavia_reply_bytes() {
  return reinterpret_cast<const std::uint8_t*>(last_reply().bytes.data());
}
std::size_t tutavia_reply_bytes_size() { return last_reply().bytes.size(); }

}  // extern "C"
