// SPDX-License-Identifier: MIT
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "support/catch.hpp"
#include "tutavia/core/expected.hpp"

namespace {

using namespace tutavia;

using Parsed = Expected<int, std::string>;

static_assert(std::is_convertible_v<int, Parsed>);
static_assert(!std::is_convertible_v<std::string, Parsed>, "an error has to be said to be one");
static_assert(!std::is_convertible_v<Parsed, bool>, "the test for a value is explicit");

TEST_CASE("an Expected holds the value it was made from", "[core]") {
  Parsed parsed = 7;
  CHECK(parsed.has_value());
  CHECK(static_cast<bool>(parsed));
  CHECK(*parsed == 7);
  CHECK(parsed.value() == 7);
  *parsed = 8;
  CHECK(std::as_const(parsed).value() == 8);
  parsed.value() = 9;
  CHECK(*std::as_const(parsed) == 9);
}

TEST_CASE("an Expected made from an Unexpected holds the error", "[core]") {
  Parsed parsed = Unexpected{"no digits"};  // const char* becomes the std::string
  CHECK_FALSE(parsed.has_value());
  CHECK_FALSE(static_cast<bool>(parsed));
  CHECK(parsed.error() == "no digits");
  parsed.error() += " at 3";
  CHECK(std::as_const(parsed).error() == "no digits at 3");
}

TEST_CASE("an error is passed on to an Expected of another value", "[core]") {
  const auto text = [](Parsed parsed) -> Expected<std::string, std::string> {
    if (!parsed) return std::move(parsed).unexpected();
    return std::to_string(*parsed);
  };
  CHECK(text(7).value() == "7");
  CHECK(text(Unexpected{"no digits"}).error() == "no digits");
}

TEST_CASE("value() throws where there is no value, however it is called", "[core]") {
  Parsed parsed = Unexpected{std::string("empty")};
  CHECK_THROWS_AS(parsed.value(), BadExpectedAccess);
  CHECK_THROWS_AS(std::as_const(parsed).value(), BadExpectedAccess);
  CHECK_THROWS_AS(std::move(parsed).value(), BadExpectedAccess);
  CHECK(parsed.error() == "empty");
}

TEST_CASE("value and error may be of one type and stay apart", "[core]") {
  using Same = Expected<int, int>;
  const Same value = 1, error = Unexpected{1};
  CHECK(value.has_value());
  CHECK_FALSE(error.has_value());
  CHECK(*value == error.error());
}

TEST_CASE("assignment turns a value into an error and back", "[core]") {
  Parsed parsed = 1;
  parsed = Unexpected{"gone"};
  CHECK_FALSE(parsed.has_value());
  parsed = 2;
  CHECK(parsed.value() == 2);
}

TEST_CASE("a value that can only be moved goes in and comes out", "[core]") {
  using Owner = Expected<std::unique_ptr<std::string>, int>;
  Owner owner = std::make_unique<std::string>("tram");
  CHECK(owner->get()->size() == 4);
  const std::string* address = owner->get();
  const std::unique_ptr<std::string> by_value = std::move(owner).value();
  CHECK(by_value.get() == address);
  CHECK(*owner == nullptr);

  const std::unique_ptr<std::string> by_star = *Owner(std::make_unique<std::string>("bus"));
  CHECK(*by_star == "bus");
}

TEST_CASE("an Expected<void> is success until it is given an error", "[core]") {
  using Done = Expected<void, std::string>;
  const Done success = {};
  CHECK(success.has_value());
  CHECK_NOTHROW(success.value());
  const Done failure = Unexpected{"disk full"};
  CHECK_FALSE(failure.has_value());
  CHECK(failure.error() == "disk full");
  CHECK_THROWS_AS(failure.value(), BadExpectedAccess);
}

}  // namespace
