// SPDX-License-Identifier: MIT
/// \file
/// Any bytes as a PGM image: what the strict parser reads is read alike and without a warning, and
/// all else is refused or has a warning and all its pixels.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "support/strict_pgm.hpp"
#include "tutavia/io/text/pgm.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tutavia;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto image = detail::parse_pgm(bytes);
  const auto strict = test::strict_pgm(bytes);
  if (!image) {
    if (strict) std::abort();
    return 0;
  }
  const auto count =
      static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height);
  const int white = image->max_value;
  if (image->pixels.size() != count) std::abort();
  if (std::any_of(image->pixels.begin(), image->pixels.end(), [&](int p) { return p > white; })) {
    std::abort();
  }
  if (image->warnings.empty() != strict.has_value()) std::abort();
  if (!strict) return 0;
  if (strict->width != static_cast<unsigned>(image->width) ||
      strict->height != static_cast<unsigned>(image->height) ||
      strict->max_value != static_cast<unsigned>(white) ||
      !std::equal(strict->pixels.begin(), strict->pixels.end(), image->pixels.begin(),
                  image->pixels.end())) {
    std::abort();
  }
  return 0;
}
