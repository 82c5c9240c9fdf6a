// SPDX-License-Identifier: MIT
#include "tutavia/io/text/image_stb.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "tutavia/io/text/read_file.hpp"

namespace {

using namespace tutavia;
using detail::AlphaRule;

std::string image_bytes(const std::string& name) {
  return detail::read_text(std::filesystem::path(TUTAVIA_TEST_DATA) / "inputs" / "03-png" / name)
      .value();
}

detail::GreyImage image_of(const std::string& name, AlphaRule alpha = AlphaRule::ignored) {
  auto image = detail::parse_image(image_bytes(name), alpha);
  if (!image) FAIL(image.error().detail);
  return std::move(*image);
}

using Pixels = std::vector<std::uint16_t>;

TEST_CASE("an image is known by its content") {
  for (const char* name : {"colour.bmp", "top_down.bmp", "grey.bmp", "named.jpg"}) {
    CAPTURE(name);
    const auto image = image_of(name);
    CHECK(image.width == 3);
    CHECK(image.height == 2);
    REQUIRE(image.pixels.size() == 6);
    const int scale = image.max_value / 255;
    CHECK(image.max_value == 255 * scale);
    for (std::size_t i = 0; i < 6; ++i) {
      CHECK(image.pixels[i] == scale * std::vector{0, 205, 254, 255, 100, 89}[i]);
    }
    CHECK(image.warnings.empty());
  }
  CHECK(detail::parse_image("P2 1 1 9 5", AlphaRule::ignored)->pixels == Pixels{5});
}

TEST_CASE("a PNG keeps 16 bits of grey, and fewer") {
  const auto grey = image_of("grey16.png");
  CHECK(grey.max_value == 65535);
  CHECK(grey.pixels == Pixels{0, 52686, 65278, 65535, 25700, 22873});
  CHECK(image_of("bits1.png").pixels == Pixels{0, 255, 0, 255, 0, 255});
  CHECK(image_of("rgb16.png").pixels == Pixels{0, 65535});
}

TEST_CASE("colours count with their mean, and alpha as the rule says") {
  CHECK(image_of("rgb.png").pixels == Pixels{0, 615, 762, 764, 255, 255});
  CHECK(image_of("rgb.png").max_value == 765);
  CHECK(image_of("palette.png").pixels == Pixels{0, 615, 765, 765, 615, 0});
  for (const char* name : {"rgba.png", "grey_alpha.png"}) {
    CAPTURE(name);
    const int grey = std::string(name) == "rgba.png" ? 3 : 1;
    const auto ignored = image_of(name), masked = image_of(name, AlphaRule::masks);
    CHECK(ignored.max_value == 255 * grey);
    CHECK(ignored.transparent.empty());
    CHECK(masked.pixels == ignored.pixels);
    CHECK(masked.transparent == std::vector<bool>{false, false, false, true, true, false});
    const auto averaged = image_of(name, AlphaRule::averaged);
    CHECK(averaged.max_value == 4 * 255);
    CHECK(averaged.transparent.empty());
    CHECK(averaged.warnings.size() == 1);
    for (std::size_t i = 0; i < 6; ++i) {
      CHECK(averaged.pixels[i] ==
            3 / grey * ignored.pixels[i] + std::vector{255, 255, 255, 0, 128, 255}[i]);
    }
  }
}

TEST_CASE("no image that is cut short or damaged is read") {
  for (const char* name : {"grey16.png", "rgba.png", "colour.bmp", "grey.bmp", "blocks.jpg"}) {
    const std::string whole = image_bytes(name);
    for (std::size_t size = 0; size < whole.size(); ++size) {
      CAPTURE(name, size);
      REQUIRE_FALSE(detail::parse_image(whole.substr(0, size), AlphaRule::averaged));
    }
  }
  for (const char* name : {"grey16.png", "palette.png"}) {
    const std::string whole = image_bytes(name);
    for (std::size_t at = 0; at < whole.size(); ++at) {
      CAPTURE(name, at);
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ 4);
      REQUIRE_FALSE(detail::parse_image(damaged, AlphaRule::averaged));
    }
  }
}

TEST_CASE("an image that says that it is huge is refused before it is unpacked") {
  const auto image = detail::parse_image(image_bytes("huge.png"), AlphaRule::ignored);
  REQUIRE_FALSE(image);
  CHECK(image.error().detail == "PNG image: 30000 x 30000 pixels do not fit into its data");
}

}  // namespace
