// SPDX-License-Identifier: MIT
#include "tutavia/registry/options/option_field.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "support/catch.hpp"
#include "tutavia/registry.hpp"
#include "tutavia/registry/movement_name.hpp"

namespace tutavia::detail {

namespace {

struct Empty {};
struct Inner {
  double x = 1, y = 2;
};
struct Sample {
  enum class Kind { plain, fancy };
  double number = 0.5;
  std::optional<double> optional{};
  std::uint32_t count = 3;
  bool is_on = true;
  Kind kind = Kind::plain;
  Inner inner{};
  std::shared_ptr<const int> table{};

 private:
  [[maybe_unused]] int helper() const { return 0; }
};

static_assert(is_complete<Empty>());
static_assert(is_complete<Inner, &Inner::x, &Inner::y>());
static_assert(!is_complete<Inner, &Inner::x>());             // one is missing
static_assert(!is_complete<Inner, &Inner::x, &Inner::x>());  // one is there twice
static_assert(!is_complete<Inner>());
static_assert(is_complete<Sample, &Sample::number, &Sample::optional, &Sample::count,
                          &Sample::is_on, &Sample::kind, &Sample::inner, &Sample::table>());
// Whatever the type of the member that is missing.
static_assert(!is_complete<Sample, &Sample::number, &Sample::optional, &Sample::count,
                           &Sample::is_on, &Sample::kind, &Sample::inner>());
static_assert(!is_complete<Sample, &Sample::number, &Sample::optional, &Sample::count,
                           &Sample::is_on, &Sample::kind>());
static_assert(
    !is_complete<Sample, &Sample::number, &Sample::optional, &Sample::count, &Sample::is_on>());
static_assert(!is_complete<Sample, &Sample::number, &Sample::optional, &Sample::count>());
static_assert(!is_complete<Sample, &Sample::number, &Sample::optional>());
static_assert(!is_complete<Sample, &Sample::number>());
static_assert(!is_complete<Sample, &Sample::optional, &Sample::number, &Sample::count,
                           &Sample::is_on, &Sample::kind, &Sample::inner, &Sample::table>());

/// How the compiler spells a member or an enumerator, after the last colon.
template <auto value>
std::string spelling() {
  const std::string text = __PRETTY_FUNCTION__;  // "... value = &tutavia::Rrt::step; ..." or "...]"
  const std::size_t begin = text.find("value = ") + 8;
  const std::string spelt = text.substr(begin, text.find_first_of(";]", begin) - begin);
  return spelt.substr(spelt.rfind(':') + 1);
}

template <class T>
std::size_t check_names(const std::string& owner);

/// Whether all names are those of the members.
template <auto... members>
std::size_t check_fields(const std::string& owner, const OptionFields<members...>& fields) {
  std::size_t at = 0;
  [[maybe_unused]] const auto check = [&](const std::string& member, auto check_type) {
    const OptionField& field = fields.all[at++];
    INFO(owner << ": " << member);
    if (field.member == nullptr) return std::size_t{0};
    CHECK(field.name == member);
    return check_type();
  };
  return (std::size_t{0} + ... + check(spelling<members>(), [&] {
            return check_names<decltype(type_of(members))>(owner + "::" + spelling<members>());
          }));
}

/// Whether every name of an enum is that of its enumerator, and no enumerator has no name.
template <class E, std::size_t... is>
void check_enum(const std::string& owner, std::index_sequence<is...>) {
  const auto check = [&](std::size_t i, const std::string& spelt) {
    INFO(owner << ": value " << i << " is " << spelt);
    if (i < EnumNames<E>::names.size()) {
      CHECK(EnumNames<E>::names[i] == spelt);
    } else {
      CHECK(spelt.find_first_of("()0123456789") != std::string::npos);  // no enumerator
    }
  };
  (check(is, spelling<static_cast<E>(is)>()), ...);
}

/// Checks an option of type T, or those of an aggregate. Returns how many options there are.
template <class T>
std::size_t check_names(const std::string& owner) {
  if constexpr (requires { OptionTable<T>::fields; }) {
    return check_fields(owner, OptionTable<T>::fields);
  } else {
    if constexpr (std::is_enum_v<T>) check_enum<T>(owner, std::make_index_sequence<12>());
    return 1;
  }
}

template <class... A>
std::size_t check_all(AlgorithmList<A...>) {
  return (std::size_t{0} + ... + check_names<A>(std::string(A::name)));
}

TEST_CASE("options have the names of their members, and enumerators their own") {
  std::size_t described = 0;
  for (const auto& list : {describe_searches(), describe_smoothers()}) {
    for (const AlgorithmDescription& algorithm : list) described += algorithm.options.size();
  }
  CHECK(check_all(EverySearch{}) + check_all(EverySmoother{}) == described);
  CHECK(described > 50);
  check_names<EdgeRule>("edges");
}

TEST_CASE("every algorithm and every option is described by a phrase") {
  for (const auto& list : {describe_searches(), describe_smoothers()}) {
    for (const AlgorithmDescription& algorithm : list) {
      INFO(algorithm.name);
      CHECK_FALSE(algorithm.sentence.empty());
      CHECK(algorithm.sentence.back() != '.');
      for (const OptionDescription& option : algorithm.options) {
        INFO(option.name);
        CHECK_FALSE(option.sentence.empty());
        CHECK(option.sentence.back() != '.');
        CHECK_FALSE(option.type.empty());
        CHECK_FALSE(option.default_value.empty());
      }
    }
  }
}

}  // namespace

}  // namespace tutavia::detail
