// SPDX-License-Identifier: MIT
#include "tutavia/geometry/pose.hpp"

#include <limits>

#include "support/catch.hpp"

namespace {

using namespace tutavia;

TEST_CASE("a pose is at the origin and faces along x until it is set") {
  const Pose pose;
  CHECK(pose.position == Point(0, 0));
  CHECK(pose.heading == 0);
  CHECK(pose.is_finite());
}

TEST_CASE("a pose is finite if all its numbers are, whatever turns its heading has made") {
  CHECK(Pose{{1, -2}, 1e6}.is_finite());
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    CAPTURE(bad);
    CHECK_FALSE(Pose{{bad, 0}, 0}.is_finite());
    CHECK_FALSE(Pose{{0, bad}, 0}.is_finite());
    CHECK_FALSE(Pose{{0, 0}, bad}.is_finite());
  }
}

}  // namespace
