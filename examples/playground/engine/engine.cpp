// SPDX-License-Identifier: MIT
#include "engine.hpp"

#include <exception>
#include <nlohmann/json.hpp>

#include "../../plan/usage_error.hpp"
#include "files.hpp"
#include "planning.hpp"
#include "stage.hpp"
#include "tutavia/io/text/fields_json.hpp"
#include "tutavia/io/text/parse_error.hpp"

namespace playground {

namespace {

namespace fields = tutavia::detail::json_fields;
using plan_program::UsageError;
using Json = nlohmann::ordered_json;

Stage& required(const std::unique_ptr<Stage>& stage) {
  if (stage == nullptr) throw UsageError{"there is no scene yet"};
  return *stage;
}

Reply answer(std::unique_ptr<Stage>& stage, const nlohmann::json& request, std::string_view bytes) {
  const std::string what = fields::string(fields::field(request, "do"), "do");
  if (what == "plan") return {plan(required(stage), request).dump()};
  if (what == "svg") return {draw(required(stage), request).dump()};
  if (what == "catalogue") return {catalogue().dump()};
  if (what == "builtin") return builtin_scene(request);
  if (what == "open") return open_file(request, bytes);
  if (what == "open_ros") return open_ros_map(request, bytes);
  if (what == "open_scenarios") return open_scenarios(bytes);
  if (what != "scene") throw UsageError{"no request is named " + what};
  stage.reset();  // nothing is planned on an old scene in place of one that is refused
  stage = std::make_unique<Stage>(request, bytes);
  const auto& grid = std::visit(
      [](const auto& space) -> const OccupancyGrid& { return space.grid(); }, stage->space());
  return {
      Json{{"resolution", stage->resolution()}, {"width", grid.width()}, {"height", grid.height()}}
          .dump()};
}

/// The messages of the command line, without the dashes of its options.
std::string without_dashes(const std::string& message) {
  return message.starts_with("--") ? message.substr(2) : message;
}

}  // namespace

Engine::Engine() = default;
Engine::~Engine() = default;

Reply Engine::call(std::string_view request, std::string_view bytes) {
  std::string error;
  try {
    return answer(stage_, nlohmann::json::parse(request), bytes);
  } catch (const UsageError& bad) {
    error = without_dashes(bad.message);
  } catch (const tutavia::detail::ParseError& bad) {
    error = bad.what;
  } catch (const std::exception& bad) {
    error = bad.what();
  }
  return {Json{{"error", error}}.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

}  // namespace playground
