// SPDX-License-Identifier: MIT
#include "json_output.hpp"

#include <cerrno>
#include <cstring>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <variant>

#include "blocked_boxes.hpp"
#include "tutavia/io/plan_json.hpp"
#include "tutavia/io/posthoc_json.hpp"
#include "tutavia/io/text/write_file.hpp"
#include "tutavia/io/trace_json.hpp"
#include "usage_error.hpp"

namespace plan_program {

namespace {

ResultHeader header_of(const Scene& scene, const Result& result) {
  const UsedAlgorithms& used = result.algorithms;
  return {used.search,
          used.smoother,
          scene.start,
          result.goal,
          scene.workspace.safety_radius,
          used.search_options,
          used.smoother_options};
}

/// The frame of a map as map_server publishes it (nav_msgs/MapMetaData).
nlohmann::ordered_json to_json(const RosMap& map) {
  return {{"origin", {map.origin.x(), map.origin.y()}},
          {"yaw", map.yaw},
          {"resolution", map.resolution},
          {"width", map.width},
          {"height", map.height}};
}

/// One search as Posthoc reads it; the cells of a grid map are obstacles.
std::string for_posthoc(const Task& task, const Result& result, const SearchRecord& record) {
  Workspace workspace = task.scene.workspace;
  PosthocOptions options{.y_down = task.y_down};
  std::visit([&](const auto& space) { options.cell_size = space.frame().resolution; }, task.space);
  if (const auto* cells = std::get_if<CellSpace>(&task.space)) {
    add_blocked_cells(cells->cells(), cells->bounds().min, options.cell_size, task.frame,
                      workspace);
  }
  if (record.events.size() > options.max_events) {
    std::cerr << "tutavia-plan: --trace: " << record.events.size() - options.max_events
              << " events after the first " << options.max_events << " are left out\n";
  }
  const Plan* plan = result.plan ? &*result.plan : nullptr;
  return posthoc_trace(workspace, task.scene.start, result.goal, record, plan, options).dump() +
         "\n";
}

}  // namespace

void write_results(const std::string& path, const Task& task, const std::vector<Group>& groups) {
  nlohmann::ordered_json results = nlohmann::ordered_json::array();
  for (const Group& group : groups) {
    for (const Result& result : group) {
      const ResultHeader header = header_of(task.scene, result);
      results.push_back(result.plan ? result_to_json(header, *result.plan, result.optimum)
                                    : result_to_json(header, result.plan.error()));
    }
  }
  nlohmann::ordered_json file = result_file(std::move(results));
  if (task.ros_map) file["map"] = to_json(*task.ros_map);
  const std::string text = file.dump(1) + "\n";
  if (path == "-") {
    std::cout << text << std::flush;
    if (!std::cout) throw UsageError{"cannot write to stdout"};
  } else {
    throw_failure(detail::write_file(path, text));
  }
}

TraceFile::TraceFile(const std::string& path) : path_(path) {
  if (path.empty()) return;
  file_.open(path, std::ios::binary | std::ios::trunc);
  check();
}

bool TraceFile::takes(const std::string& search) {
  return !path_.empty() && searches_.insert(search).second;
}

void TraceFile::write(const Task& task, const Result& result, const SearchRecord& record) {
  if (path_.ends_with(".trace.json")) {
    if (std::exchange(has_posthoc_, true)) {
      throw UsageError{
          "--trace: a .trace.json file holds one search; give one --goal and one "
          "--search, or a file with another ending"};
    }
    file_ << for_posthoc(task, result, record);
    return check();
  }
  const std::string_view status = result.plan ? "success" : to_string(result.plan.error().code);
  std::string text;
  append_trace(text, header_of(task.scene, result), status, record);
  file_ << text;
  check();
}

void TraceFile::close() {
  if (path_.empty()) return;
  file_.close();
  check();
}

void TraceFile::check() const {
  if (!file_) throw UsageError{"cannot write " + path_ + ": " + std::strerror(errno)};
}

}  // namespace plan_program
