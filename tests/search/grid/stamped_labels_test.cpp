// SPDX-License-Identifier: MIT
#include "tutavia/search/grid/stamped_labels.hpp"

#include <cstddef>
#include <cstdint>

#include "support/catch.hpp"

namespace {

using namespace tutavia;
using namespace tutavia::detail;

struct Label {
  std::uint32_t query;
  int value;
};

TEST_CASE("a label is found in the query that wrote it, and in no other") {
  detail::StampedLabels<Label> labels;
  labels.reset(10);
  CHECK(labels.find(3) == nullptr);
  labels.set(3, {99, 7});  // whatever query it says
  REQUIRE(labels.find(3) != nullptr);
  CHECK(labels.find(3)->value == 7);
  CHECK(labels.find(4) == nullptr);
  labels.reset(10);
  CHECK(labels.find(3) == nullptr);
  CHECK(labels[3].value == 7);  // forgotten, not cleared
  labels.set(4, {0, 8});
  CHECK(labels.find(4)->value == 8);
}

TEST_CASE("more labels than ever begin with none, fewer keep their memory") {
  detail::StampedLabels<Label> labels;
  labels.reset(2);
  labels.set(1, {0, 5});
  labels.reset(1000);
  for (std::size_t i = 0; i < 1000; ++i) CHECK(labels.find(i) == nullptr);
  labels.set(999, {0, 6});
  const Label* const where = labels.find(999);
  labels.reset(2);
  labels.reset(1000);
  CHECK(labels.find(999) == nullptr);
  labels.set(999, {0, 7});
  CHECK(labels.find(999) == where);
}

}  // namespace
