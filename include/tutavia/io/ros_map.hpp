// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "tutavia/geometry/point.hpp"
#include "tutavia/grid/occupancy_grid.hpp"
#include "tutavia/io/text/read_file.hpp"
#include "tutavia/plan/failure.hpp"

/// \file
/// Maps of ROS: the YAML and PGM files of map_server and nav2_map_server, and nav2's costmaps.

namespace tutavia {

/// What becomes of cells of which a map knows nothing.
enum class UnknownCells { blocked, free };

/// A map as ROS publishes it (nav_msgs/OccupancyGrid).
struct RosMap {
  int width = 0;   ///< [cells]
  int height = 0;  ///< [cells]
  /// Row by row, row 0 is the BOTTOM of the map: -1 unknown, 0 free, ..., 100 occupied.
  std::vector<std::int8_t> values{};
  double resolution = 1;                ///< side of a cell [m]
  Point origin = Point::Zero();         ///< lower left corner of the map, in the map frame [m]
  double yaw = 0;                       ///< of the map's rows in the map frame, left positive [rad]
  std::vector<std::string> warnings{};  ///< what the reader passed over, one line each
};

/// A grey image.
struct PgmImage {
  int width = 0;
  int height = 0;
  int max_value = 0;                    ///< of a pixel: white; 0 is black
  std::vector<std::uint16_t> pixels{};  ///< row by row, row 0 is the TOP
};

namespace detail {

/// Reads both kinds of PGM (netpbm, pgm(5)). Throws an `Unexpected<Failure>` that names the byte.
class PgmReader {
 public:
  explicit PgmReader(std::string_view bytes) : bytes_(bytes) {}

  PgmImage read() {
    const bool plain = bytes_.starts_with("P2");
    if (!plain && !bytes_.starts_with("P5")) refuse("P2 or P5 (of images, only PGM is read)");
    at_ = 2;
    const std::int64_t width = number(1, too_large, "a width above 0");
    const std::int64_t height = number(1, too_large, "a height above 0");
    constexpr std::int64_t max_pixels = std::int64_t{1} << 30;
    if (width > max_pixels / height) {
      throw fail(PlanError::limit_exceeded, "PGM image of " + std::to_string(width) + " x " +
                                                std::to_string(height) + " pixels needed, " +
                                                std::to_string(max_pixels) + " pixels allowed");
    }
    const std::int64_t white = number(1, 65535, "a greatest value from 1 to 65535");
    if (!plain) {
      if (at_ == bytes_.size() || !is_blank(bytes_[at_])) refuse("a blank, then pixels");
      ++at_;
    }
    PgmImage image{static_cast<int>(width), static_cast<int>(height), static_cast<int>(white), {}};
    const auto count = static_cast<std::size_t>(width * height);
    image.pixels.reserve(std::min(count, bytes_.size()));
    const std::string what = "a pixel from 0 to " + std::to_string(white);
    while (image.pixels.size() < count) {
      const std::int64_t pixel = plain ? number(0, white, what) : raw_pixel(white, what);
      image.pixels.push_back(static_cast<std::uint16_t>(pixel));
    }
    if (plain) skip_blanks();
    if (at_ < bytes_.size()) refuse("nothing after the last pixel");
    return image;
  }

 private:
  static constexpr std::int64_t too_large = std::numeric_limits<std::int64_t>::max();

  static bool is_blank(char c) { return c == ' ' || ('\t' <= c && c <= '\r'); }
  void skip_blanks() {
    for (bool comment = false; at_ < bytes_.size(); ++at_) {
      const char c = bytes_[at_];
      comment = (comment || c == '#') && c != '\n' && c != '\r';
      if (!comment && !is_blank(c)) return;
    }
  }
  /// Steps over blanks, at least one, and a number; what 64 bits cannot hold is `too_large`.
  std::int64_t number(std::int64_t low, std::int64_t high, const std::string& what) {
    const std::size_t before = at_;
    skip_blanks();
    std::int64_t value = too_large;
    const char *const begin = bytes_.data() + at_, *const end = bytes_.data() + bytes_.size();
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (at_ == before || error == std::errc::invalid_argument || value < low || value > high) {
      refuse(what);
    }
    at_ += static_cast<std::size_t>(stop - begin);
    return value;
  }
  std::int64_t raw_pixel(std::int64_t high, const std::string& what) {
    std::int64_t value = 0;
    for (std::int64_t span = high; span > 0; span /= 256) {
      if (at_ == bytes_.size()) refuse(what);
      value = 256 * value + static_cast<unsigned char>(bytes_[at_++]);
    }
    if (value > high) {
      at_ -= high > 255 ? 2 : 1;
      refuse(what, std::to_string(value));
    }
    return value;
  }

  [[noreturn]] void refuse(const std::string& expected) const {
    std::string found(bytes_.substr(at_, 20));
    for (char& c : found) c = c < ' ' || c > '~' ? '?' : c;
    refuse(expected, at_ < bytes_.size() ? '"' + found + '"' : "the end of the file");
  }
  [[noreturn]] void refuse(const std::string& expected, const std::string& found) const {
    throw fail(PlanError::invalid_input,
               "PGM byte " + std::to_string(at_) + ": expected " + expected + ", found " + found);
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
};

/// What the YAML file of a map says; of `map`, all but what the image tells.
struct RosMapYaml {
  RosMap map{};
  std::string image{}, mode = "trinary";
  bool negate = false;
  double occupied_thresh = 0, free_thresh = 0;
};

/// Reads flat YAML: per key a scalar or a list of scalars, plain or in quotes that hold neither
/// quotes nor escapes. Throws an `Unexpected<Failure>` that names the line of anything else.
class RosYamlReader {
 public:
  explicit RosYamlReader(std::string_view text) {
    for (; !text.empty(); ++line_) {
      content_ = text.substr(0, text.find('\n'));
      text.remove_prefix(std::min(text.size(), content_.size() + 1));
      read_line();
    }
  }

  RosMapYaml read() {
    constexpr double max = std::numeric_limits<double>::max();
    RosMapYaml yaml;
    yaml.image = values("image", 1)[0];
    yaml.map.resolution = number("resolution", 5e-324, max, "a number above 0");
    yaml.map.origin = {number("origin", -max, max, "x, y and yaw", 0, 3),
                       number("origin", -max, max, "x, y and yaw", 1, 3)};
    yaml.map.yaw = number("origin", -max, max, "x, y and yaw", 2, 3);
    const std::string& negate = values("negate", 1)[0];
    yaml.negate = negate == "1" || negate == "true";
    if (!yaml.negate && negate != "0" && negate != "false") refuse("negate: 0 or 1", negate);
    yaml.occupied_thresh = number("occupied_thresh", 0, 1, "a number from 0 to 1");
    yaml.free_thresh =
        number("free_thresh", 0, yaml.occupied_thresh, "a number from 0 to occupied_thresh");
    if (find("mode") != nullptr) yaml.mode = values("mode", 1)[0];
    if (yaml.mode != "trinary" && yaml.mode != "scale" && yaml.mode != "raw") {
      refuse("mode: trinary, scale or raw", yaml.mode);
    }
    for (const Entry& entry : entries_) {
      if (entry.used) continue;
      yaml.map.warnings.push_back("line " + std::to_string(entry.line) + ": unknown key " +
                                  entry.key);
    }
    if (yaml.negate && yaml.mode == "raw") {
      yaml.map.warnings.emplace_back("negate changes nothing in raw mode");
    }
    return yaml;
  }

 private:
  static constexpr std::size_t npos = std::string_view::npos;
  struct Entry {
    std::string key{};
    std::size_t line = 0;
    std::vector<std::string> values{};
    bool is_open = false;  ///< items of a list may follow
    bool used = false;
  };

  void read_line() {
    if (content_.ends_with('\r')) content_.remove_suffix(1);
    if (content_.find_first_of(std::string_view("\r\0", 2)) != npos) refuse("text, LF or CRLF");
    for (std::size_t i = 0; i < content_.size(); ++i) {
      if (content_[i] == '#' && (i == 0 || is_blank(i - 1))) content_ = content_.substr(0, i);
    }
    const std::size_t indent = content_.find_first_not_of(" \t");
    content_ = trimmed(content_);
    if (content_.empty()) return;
    if (content_ == "---" && entries_.empty() && !std::exchange(has_marker_, true)) return;
    if (content_.front() == '-' && is_blank(1)) {
      if (entries_.empty() || !entries_.back().is_open) refuse("key: value");
      if (entries_.back().values.empty()) indent_ = indent;
      if (indent != indent_) refuse("list items one below the other");
      return add(entries_.back(), content_.substr(1));
    }
    const std::size_t colon = content_.find(':');
    Entry entry{std::string(trimmed(content_.substr(0, colon))), line_};
    const auto is_name = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
    if (indent != 0 || colon == npos || !is_blank(colon + 1) || entry.key.empty() ||
        !std::all_of(entry.key.begin(), entry.key.end(), is_name)) {
      refuse("key: value, not indented");
    }
    if (find(entry.key) != nullptr) refuse("every key once");
    std::string_view value = trimmed(content_.substr(colon + 1));
    entry.is_open = value.empty();
    if (value.starts_with('[') && value.ends_with(']')) {
      value = value.substr(1, value.size() - 2);
      if (value.find_first_of("[]{}") != npos) refuse("a list of scalars");
      for (std::size_t comma = value.find(','); comma != npos; comma = value.find(',')) {
        add(entry, value.substr(0, comma));
        value.remove_prefix(comma + 1);
      }
    }
    if (!entry.is_open) add(entry, value);
    entries_.push_back(std::move(entry));
  }

  void add(Entry& entry, std::string_view scalar) const {
    scalar = trimmed(scalar);
    const auto has = [&](std::string_view part) { return scalar.find(part) != npos; };
    if (scalar.empty()) refuse("a value");
    const char first = scalar.front();
    if (first == '"' || first == '\'') {
      if (scalar.size() < 2 || scalar.back() != first) refuse("quotes around all of a value");
      scalar = scalar.substr(1, scalar.size() - 2);
      if (scalar.find_first_of("\"'\\") != npos) refuse("no quotes or escapes in quotes");
    } else if (std::string_view("[]{}&*!|>%@`,?:").find(first) != npos ||
               scalar.starts_with("- ") || has(": ") || has(":\t") || scalar.back() == ':') {
      refuse("a plain value or a list in one line");
    }
    entry.values.emplace_back(scalar);
  }

  bool is_blank(std::size_t i) const {
    return i >= content_.size() || content_[i] == ' ' || content_[i] == '\t';
  }
  static std::string_view trimmed(std::string_view text) {
    text = text.substr(0, text.find_last_not_of(" \t") + 1);
    return text.substr(std::min(text.find_first_not_of(" \t"), text.size()));
  }

  Entry* find(std::string_view key) {
    const auto has_key = [&](const Entry& entry) { return entry.key == key; };
    const auto entry = std::find_if(entries_.begin(), entries_.end(), has_key);
    return entry == entries_.end() ? nullptr : &*entry;
  }
  const std::vector<std::string>& values(const std::string& key, std::size_t count) {
    Entry* const entry = find(key);
    if (entry == nullptr) throw fail(PlanError::invalid_input, "the key " + key + " is missing");
    entry->used = true;
    line_ = entry->line;
    const std::size_t found = entry->values.size();
    if (found != count) {
      refuse(key + " with " + std::to_string(count) + (count == 1 ? " value" : " values"),
             std::to_string(found));
    }
    return entry->values;
  }
  double number(const std::string& key, double low, double high, const std::string& what,
                std::size_t i = 0, std::size_t count = 1) {
    const std::string& text = values(key, count)[i];
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() ||
        !(low <= value && value <= high)) {
      refuse(key + ": " + what, text);
    }
    return value;
  }

  [[noreturn]] void refuse(const std::string& expected) const {
    refuse(expected, '"' + std::string(content_.substr(0, 60)) + '"');
  }
  [[noreturn]] void refuse(const std::string& expected, const std::string& found) const {
    throw fail(PlanError::invalid_input,
               "line " + std::to_string(line_) + ": expected " + expected + ", found " + found);
  }

  std::string_view content_;
  std::size_t line_ = 1, indent_ = 0;
  bool has_marker_ = false;
  std::vector<Entry> entries_;
};

/// `Reader(text).read()`, with what it throws returned.
template <class Reader>
auto read_ros(std::string_view text) -> Expected<decltype(Reader(text).read()), Failure> {
  try {
    return Reader(text).read();
  } catch (const Unexpected<Failure>& failure) {
    return failure;
  }
}

inline RosMap make_ros_map(const RosMapYaml& yaml, const PgmImage& image) {
  RosMap map = yaml.map;
  map.width = image.width;
  map.height = image.height;
  const bool raw = yaml.mode == "raw", trinary = yaml.mode == "trinary";
  const double white = image.max_value, free = yaml.free_thresh, occupied = yaml.occupied_thresh;
  const auto value = [&](int pixel) -> long {
    if (raw) {
      const long shade = std::lround(255 * pixel / white);
      return shade <= 100 ? shade : -1;
    }
    const double occupancy = (yaml.negate ? pixel : white - pixel) / white;
    if (occupancy > occupied) return 100;
    if (occupancy < free) return 0;
    if (trinary) return -1;
    return free == occupied ? 100 : std::lrint((occupancy - free) / (occupied - free) * 100);
  };
  map.values.reserve(image.pixels.size());
  for (std::ptrdiff_t row = image.height; row-- > 0;) {
    for (std::ptrdiff_t column = 0; column < image.width; ++column) {
      const auto i = static_cast<std::size_t>(row * image.width + column);
      map.values.push_back(static_cast<std::int8_t>(value(image.pixels[i])));
    }
  }
  return map;
}

/// The grid in which exactly the cells whose value `is_free` are free.
template <class Value, class IsFree>
Expected<OccupancyGrid, Failure> make_grid(std::span<const Value> values, int width, int height,
                                           IsFree is_free) {
  const auto cells = static_cast<std::int64_t>(width) * height;
  if (width >= 0 && height >= 0 && values.size() != static_cast<std::size_t>(cells)) {
    return fail(PlanError::invalid_input, "expected " + std::to_string(width) + " x " +
                                              std::to_string(height) + " values, found " +
                                              std::to_string(values.size()));
  }
  auto grid = OccupancyGrid::blocked(width, height);
  if (!grid) return grid;
  auto value = values.begin();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) grid->set({x, y}, is_free(*value++));
  }
  return grid;
}

}  // namespace detail

/// A PGM image, P2 or P5, of up to 2^30 pixels (`limit_exceeded`); P5 with a greatest value above
/// 255 has two bytes per pixel, the high one first. `invalid_input` with the byte at which
/// something else stands than expected; a file that is longer than its image is refused, too.
inline Expected<PgmImage, Failure> parse_pgm(std::string_view pgm) {
  return detail::read_ros<detail::PgmReader>(pgm);
}

/// A map from its YAML text and its image. Every key must be there but `mode`, then trinary;
/// unknown keys become warnings.
///
/// With occupancy = 1 - pixel / white, or pixel / white with `negate`:
/// - trinary: 100 above `occupied_thresh`, 0 below `free_thresh`, unknown otherwise
/// - scale: the same, but linear in between, rounded to whole numbers
/// - raw: the pixel itself, on a scale where white is 255, up to 100; unknown above. `negate`
///   changes nothing.
///
/// That is what nav2 does up to Humble, and in trinary mode ROS 1; later versions of nav2 count a
/// pixel exactly at a threshold as occupied or free where it is unknown here.
///
/// YAML is read as far as such files need it: one scalar or list per key. `invalid_input` with the
/// line of anything beyond, or the byte of the image; `limit_exceeded` as in `parse_pgm`.
inline Expected<RosMap, Failure> parse_ros_map(std::string_view yaml, std::string_view pgm) {
  const auto head = detail::read_ros<detail::RosYamlReader>(yaml);
  if (!head) return Unexpected{head.error()};
  const auto image = parse_pgm(pgm);
  if (!image) return Unexpected{image.error()};
  return detail::make_ros_map(*head, *image);
}

/// `parse_ros_map` of a YAML file and the image that it names, looked for in the YAML file's folder
/// unless its path is absolute. Details of failures begin with the file's name.
inline Expected<RosMap, Failure> read_ros_map(const std::filesystem::path& yaml_path) {
  const auto head = detail::read_file(yaml_path, detail::read_ros<detail::RosYamlReader>);
  if (!head) return Unexpected{head.error()};
  const auto image = detail::read_file(yaml_path.parent_path() / head->image, parse_pgm);
  if (!image) return Unexpected{image.error()};
  return detail::make_ros_map(*head, *image);
}

/// The map as a grid; row 0 is the map's bottom row, so cell (x, y) is the square from (x, y) to
/// (x + 1, y + 1), times the resolution, of the grid frame.
///
/// Cells are blocked from `occupied_at` on. 100 is what nav2's static layer takes; of a map in
/// scale mode it leaves all but the surest obstacles free. `invalid_option` for an `occupied_at`
/// outside 1 to 100, `invalid_input` where the values are not width x height or one is outside -1
/// to 100.
inline Expected<OccupancyGrid, Failure> to_grid(const RosMap& map, UnknownCells unknown,
                                                int occupied_at = 100) {
  if (occupied_at < 1 || occupied_at > 100) {
    return fail(PlanError::invalid_option,
                "occupied_at: expected 1 to 100, found " + std::to_string(occupied_at));
  }
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    if (map.values[i] >= -1 && map.values[i] <= 100) continue;
    return fail(PlanError::invalid_input, "values[" + std::to_string(i) +
                                              "]: expected -1 to 100, found " +
                                              std::to_string(map.values[i]));
  }
  return detail::make_grid(std::span(map.values), map.width, map.height, [&](int value) {
    return value < 0 ? unknown == UnknownCells::free : value < occupied_at;
  });
}

/// The grid frame has its origin at the lower left corner of the map's image, x along the rows to
/// the right and y upwards. This is the place in it of a point of the map frame; both in metres.
inline Point to_grid_frame(const RosMap& map, const Point& in_map) {
  const double c = std::cos(map.yaw), s = std::sin(map.yaw);
  const double dx = in_map.x() - map.origin.x(), dy = in_map.y() - map.origin.y();
  return {c * dx + s * dy, c * dy - s * dx};
}

/// The inverse of `to_grid_frame`.
inline Point to_map_frame(const RosMap& map, const Point& in_grid) {
  const double c = std::cos(map.yaw), s = std::sin(map.yaw);
  return {map.origin.x() + c * in_grid.x() - s * in_grid.y(),
          map.origin.y() + s * in_grid.x() + c * in_grid.y()};
}

/// A costmap of nav2 (nav2_costmap_2d) as a grid; row 0 is the bottom row, 255 is unknown.
///
/// Cells are blocked from cost `blocked_at` on: 254 (lethal: an obstacle) where the planner keeps a
/// safety radius of its own, 253 (inscribed: a robot centred here collides) where it keeps none.
/// `invalid_option` for a `blocked_at` outside 1 to 254, `invalid_input` where there are not
/// width x height values.
inline Expected<OccupancyGrid, Failure> grid_from_costmap(std::span<const std::uint8_t> costs,
                                                          int width, int height, int blocked_at,
                                                          UnknownCells unknown) {
  if (blocked_at < 1 || blocked_at > 254) {
    return fail(PlanError::invalid_option,
                "blocked_at: expected 1 to 254, found " + std::to_string(blocked_at));
  }
  return detail::make_grid(costs, width, height, [&](int cost) {
    return cost == 255 ? unknown == UnknownCells::free : cost < blocked_at;
  });
}

}  // namespace tutavia
