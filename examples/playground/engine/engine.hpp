// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <string_view>

/// \file
/// Engine: answers the requests of the page.

namespace playground {

class Stage;

/// JSON, and the bytes that come with some replies.
struct Reply {
  std::string json;
  std::string bytes{};
};

/// Keeps a scene and answers requests, both as web/src/protocol.ts describes them. Not for several
/// threads at a time.
class Engine {
 public:
  Engine();
  ~Engine();

  /// A request that cannot be met gets {"error": text}.
  Reply call(std::string_view request, std::string_view bytes);

 private:
  std::unique_ptr<Stage> stage_;  // null before the first scene
};

}  // namespace playground
